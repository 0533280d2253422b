#!/bin/sh
# One triaxial test of the ensemble: load, then write what the figures read.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin OUT=out/quickstart run.sh PACKING SCENARIO PRESSURE_MPa TWIN
set -eu
packing=$1 scenario=$2 pressure=$3 twin=$4
here=$(dirname "$0")
folder=$OUT/runs/${pressure}MPa_$twin
mkdir -p "$folder"
[ "$twin" -eq 0 ] && perturb=0 || perturb=1e-6
"$BIN/run-dem" "$packing" "$scenario" --set "stage.0.pressure=${pressure}e6" \
  --set "stage.1.confining_pressure=${pressure}e6" --perturb "$perturb" --seed "$twin" --quiet --force -o "$folder/run.h5"
"$BIN/homogenize" "$folder/run.h5" --tsv --table series > "$folder/series.tsv"
"$BIN/fabric" "$folder/run.h5" --tsv > "$folder/fabric.tsv"
awk -f "$here/shear.awk" "$folder/series.tsv" > "$folder/shear.tsv"
awk -f "$here/shear.awk" "$folder/series.tsv" "$folder/fabric.tsv" > "$folder/shear_fabric.tsv"
