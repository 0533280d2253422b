#!/bin/sh
# Calibration of contact parameters to triaxial tests, round after round (calibration/calibrate.py tells all; --help its options).
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin calibrate.sh --prior PRIOR.toml --packing PACKING.h5 --test TABLE.tsv "100 kPa" engineering [OPTION]... FOLDER
# Runs go on this machine, on the hosts of SSHLOGINFILE, or on a Slurm cluster with ENGINE=slurm (study/jobs.py).
home=$(cd "$(dirname "$0")" && pwd) || exit 66
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="$home" BIN="${BIN:-${home%/*}/build/bin}"
exec "${PYTHON:-/usr/bin/python3}" -P -m calibration.calibrate "$@"
