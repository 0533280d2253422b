#!/bin/sh
# One row of an ensemble: isotropic compression, then drained triaxial compression with the row's contact parameters. What
# the filter reads is kept in the row's folder; a row that has it already, with the same parameters, is not run again, and one
# that was stopped goes on.
# SPDX-License-Identifier: GPL-3.0-or-later
# usage: BIN=build/bin run.sh FOLDER LAW PACKING SCENARIO PRESSURE_MPa STRAIN_% ID E NU KR ETA MU [TWIN]
# TWIN: number of a twin whose grains start 1e-6 of a radius apart; 0, the packing itself.
# Leaves FOLDER/runs/ID/series.h5, or `failed` with the reason where these parameters will fail each time (out of range, not
# settled, physics broken); any other trouble is this script's exit status, and the row is tried again.
set -u
export LC_ALL=C.UTF-8
folder=$1 law=$2 packing=$3 scenario=$4 pressure=$5 strain=$6
id=$7 modulus=$8 ratio=$9
shift 9
rolling=$1 limit=$2 friction=$3 twin=${4:-0}
case $id in
  '' | *[!0-9]*) echo "run.sh: id \"$id\" is no whole number" >&2; exit 65 ;;
esac
case $law in
  hm | cl) ;;
  *) echo "run.sh: \"$law\" is no law; give hm (Hertz-Mindlin) or cl (linear)" >&2; exit 64 ;;
esac
# printf reads a number with leading zeros as octal.
id=${id#"${id%%[!0]*}"}
row=$folder/runs/$(printf %06d "${id:-0}")

parameters="$law $pressure $strain $modulus $ratio $rolling $limit $friction $twin"
if [ "$(cat "$row/parameters" 2>/dev/null)" = "$parameters" ]; then
  [ -e "$row/series.h5" ] || [ -e "$row/failed" ] && exit 0
else
  rm -rf "$row"
  mkdir -p "$row" && printf '%s\n' "$parameters" > "$row/parameters" || exit 73
fi

# In the author's scripts a limit of 0 in Hertz-Mindlin contacts is none, and twisting has none; nu of linear ones is
# k_s/k_n.
ratio_key=poisson_ratio twisting_limit=none perturb=0
[ "$law" = cl ] && ratio_key=stiffness_ratio twisting_limit=$limit
[ "$twin" = 0 ] || perturb=1e-6
[ "$law" = hm ] && [ "$(printf %g "$limit")" = 0 ] && limit=none

OMP_NUM_THREADS=1 "$BIN/run-dem" "$packing" "$scenario" --set "contact.young_modulus=$modulus" --set "contact.$ratio_key=$ratio" \
  --set "contact.rolling.stiffness=$rolling" --set "contact.twisting.stiffness=$rolling" --set "contact.rolling.limit=$limit" \
  --set "contact.twisting.limit=$twisting_limit" --set "contact.friction_angle=$friction" \
  --set "stage.0.pressure=${pressure}e6" --set "stage.1.confining_pressure=${pressure}e6" \
  --set "stage.1.axial_strain=${strain}e-2" --perturb "$perturb" --seed "$twin" --threads 1 --quiet --resume -o "$row/run.h5" 2> "$row/log"
status=$?
case $status in
  0) ;;
  1 | 65 | 70) rm -rf "$row/run.h5.part"; mv "$row/log" "$row/failed"; exit 0 ;;
  *) cat "$row/log" >&2; exit $status ;;
esac

# The series is kept with the history of the run. The run itself is large and can be made again; KEEP_RUN=1 keeps it.
"$BIN/homogenize" "$row/run.h5" --force -o "$row/series.part" --quiet && rm -f "$row/log" && mv "$row/series.part" "$row/series.h5" || exit 74
[ -n "${KEEP_RUN:-}" ] || rm -f "$row/run.h5"
