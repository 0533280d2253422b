#!/bin/sh
# Runs every row of an ensemble's table (ensemble.py), by GNU parallel here or on the hosts of SSHLOGINFILE, or by Slurm.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin ensemble.sh TABLE.tsv FOLDER LAW PACKING SCENARIO PRESSURE_MPa STRAIN_%
# TABLE: id first, then in any order E [Pa], nu, kr, eta and mu [deg], or what pf-weight draw calls them, maybe a column twin,
# separated by tabs; ids are whole numbers, with leading zeros or without. LAW: hm (Hertz-Mindlin) or cl (linear).
# JOBS: at once (100%). ENGINE=slurm: SLURM_FLAGS, further options of sbatch; SLURM_ARRAY_SIZE, tasks at most (1000).
home=$(cd "$(dirname "$0")" && pwd) || exit 66
export LC_ALL=C.UTF-8 PYTHONDONTWRITEBYTECODE=1 PYTHONPATH="${home%/*}"
exec "${PYTHON:-/usr/bin/python3}" -P "$home/ensemble.py" "$@"
