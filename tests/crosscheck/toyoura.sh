#!/usr/bin/env bash
# Toyoura sand through make own: from its two laboratory tests to a bag of the thesis's geotextile PP. The constants that the chain finds
# lie beside Table 5.2 of the thesis, its surcharges and its chart beside those of the model with that table's constants.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make crosscheck-toyoura. PROFILE: quick (default) or thesis. WORK: a folder to keep and go on with. Exits with 1 where a constant lies
# outside the 95 % of one more packing, or a surcharge or a point of the chart outside the chain's middle 80 %.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
root=$(cd "$here/../.." && pwd)
BIN=$(cd "${BIN:-$root/build/bin}" && pwd)
profile=${PROFILE:-quick} settlement=0.05 surcharge='200 kPa'
export BIN LC_ALL=C.UTF-8
# shellcheck source=tests/crosscheck/work.sh
source "$here/work.sh"

soil=$work/toyoura
mkdir -p "$soil"
cp "$root/data/gradings/toyoura.tsv" "$soil/grading.tsv"
{
  printf 'name = "Toyoura sand"\ngrading = "grading.tsv"\nvoid_ratio = 0.68\ngeotextile = "PP"\nsurcharge = "%s"\nsettlement = %s\n' "$surcharge" "$settlement"
  printf 'bag = {width = "400 mm", height = "80 mm"}\n'
  for MPa in 0.2 0.5; do
    printf '[[test]]\ntable = "%s"\nconfining_pressure = "%s MPa"\nstrains = "natural"\n' "drained_${MPa}MPa.tsv" "$MPa"
    cp "$root/data/laboratory/toyoura_drained_triaxial_${MPa}MPa.tsv" "$soil/drained_${MPa}MPa.tsv"
  done
} > "$soil/own.toml"

make -s -C "$root" PROFILE="$profile" SOIL="$soil" OUT="$work/out" own
own=$work/out/own/toyoura
[[ $profile != thesis ]] || own=$own/thesis
"$BIN/gws-solve" respond --soil toyoura-gws --geotextile PP --points 400 --tsv --quiet > "$work/table_response.tsv"
"$BIN/gws-solve" design --soil toyoura-gws --geotextile PP --settlement "$settlement" --surcharge "$surcharge" --chart --from 46400 --to 1160e3 --tsv \
  --quiet > "$work/table_chart.tsv"
PYTHONPATH=$root/pipelines /usr/bin/python3 -P "$here/toyoura.py" "$own" "$work/table_response.tsv" "$work/table_chart.tsv" "$settlement"
