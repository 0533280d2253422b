#!/bin/sh
# One triaxial test of the ensemble: load, then write what the figures read.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin OUT=out/quickstart run.sh SEED SCENARIO PRESSURE_MPa
set -eu
seed=$1 scenario=$2 pressure=$3
here=$(dirname "$0")
folder=$OUT/runs/${pressure}MPa_$seed
mkdir -p "$folder"
"$BIN/run-dem" "$OUT/packing_$seed.h5" "$scenario" --set "stage.0.pressure=${pressure}e6" \
  --set "stage.1.confining_pressure=${pressure}e6" --quiet --force -o "$folder/run.h5"
"$BIN/homogenize" "$folder/run.h5" --tsv --table series > "$folder/series.tsv"
"$BIN/fabric" "$folder/run.h5" --tsv > "$folder/fabric.tsv"
awk -f "$here/shear.awk" "$folder/series.tsv" > "$folder/shear.tsv"
awk -f "$here/shear.awk" "$folder/series.tsv" "$folder/fabric.tsv" > "$folder/shear_fabric.tsv"
