#!/bin/bash
# One twin at one confining pressure. Usage: run-one.sh SCENARIO PACKING DIRECTORY PRESSURE_MPA TWIN
# SPDX-License-Identifier: GPL-3.0-or-later
set -euo pipefail
scenario=$1 packing=$2 directory=$3 pressure=$4 twin=$5

run=$directory/run_${pressure}_$twin
run-dem "$packing" "$scenario" --set "stage.0.pressure=\"$pressure MPa\"" --set "stage.1.confining_pressure=\"$pressure MPa\"" \
  --perturb 1e-6 --seed "$twin" --threads 1 --quiet --force -o "$run.h5"
homogenize "$run.h5" --table series --tsv > "$run.tsv.tmp"
mv "$run.tsv.tmp" "$run.tsv"
