#!/usr/bin/env bash
# Hidden parameters found again. run-dem makes the observations from a twin of the packing, and noise is added. The particle
# filter looks for E and the friction angle, with the three others unknown too, in an ensemble and three resampling rounds.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make crosscheck. SETS (default 60): runs a round; LAW: cl (default) or hm. Exits with 1 where E or the friction angle ends more
# than 10 % off. WORK: folder to keep and go on with.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
BIN=$(cd "${BIN:-$here/../../build/bin}" && pwd)
export BIN PATH=$BIN:$PATH OMP_NUM_THREADS=1 LC_ALL=C.UTF-8
study=$here/../../pipelines/calibration priors=$here/../../pipelines/ch2 law=${LAW:-cl} sets=${SETS:-60}
# shellcheck source=tests/crosscheck/work.sh
source "$here/work.sh"
cd "$work"

scenario=$study/linear.toml truth=(5.2e8 0.12 0.5 0.22 30.5)
[[ $law == cl ]] || { scenario=$study/hertz-mindlin.toml truth=(3.6e9 0.2 0.12 0.25 30.5); }
strain=4
[[ -e packing.h5 ]] || pack-generate --grains 1000 --void-ratio 0.68 --pressure 1e3 --seed 1 --threads 1 --quiet -o packing.h5
KEEP_RUN=1 "$study/run.sh" hidden "$law" packing.h5 "$scenario" 0.2 $strain 0 "${truth[@]}" 7
homogenize hidden/runs/000000/run.h5 --tsv --table series > series.tsv

# Twelve stations, with the noise of a good laboratory and the scatter of twins.
deviations=(0.03 0.06 0.03)
awk -F '\t' -v radial="${deviations[0]}" -v ratio="${deviations[1]}" -v volume="${deviations[2]}" '
  function normal() { return sqrt(-2 * log(1 - rand())) * cos(6.283185307179586 * rand()) }
  NR == 1 { srand(11); for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[key] = i }
    n = split("0.1 0.2 0.3 0.5 0.7 1 1.5 2 2.5 3 3.5 4", list, " "); for (i = 1; i <= n; ++i) wanted[list[i]] = 1
    print "strain_axial [%]\tstrain_radial [%]\tstress_ratio [1]\tstrain_volumetric [%]"; next }
  $at["stage"] == 1 { x = sprintf("%.4g", 100 * $at["strain_axial"])
    if (x in wanted) printf "%s\t%.6g\t%.6g\t%.6g\n", x, 50 * ($at["strain_xx"] + $at["strain_yy"]) + radial * normal(),
      $at["stress_ratio"] + ratio * normal(), 100 * $at["strain_volumetric"] + volume * normal() }' series.tsv > observed.tsv

errors=$(printf '%s\n' "${deviations[@]}" | awk '{ printf "%s%.6g", (NR > 1 ? "," : ""), $1 * $1 }')
pf-weight draw "$priors/prior_quick_$law.toml" --samples "$sets" --first 1 --tsv --force -o round0.h5 > round0.tsv
for round in 0 1 2 3; do
  "$study/ensemble.sh" "round$round.tsv" case "$law" packing.h5 "$scenario" 0.2 $strain
  pf-weight assimilate "round$round.h5" observed.tsv --runs 'case/runs/{id:06}/series.h5' --where stage=1 --station strain_axial \
    --observe strain_radial=strain_xx,strain_yy --observe stress_ratio --observe strain_volumetric --covariance component --variance "$errors" \
    --tsv --quiet --force -o "posterior$round.h5" > "steps$round.tsv"
  tail -n 1 "steps$round.tsv" | cat <(head -n 1 "steps$round.tsv") - | awk -F '\t' -v E="${truth[0]}" -v mu="${truth[4]}" -v round="$round" '
    NR == 1 { for (i = 1; i <= NF; ++i) { key = $i; sub(/ \[.*/, "", key); at[key] = i } next }
    { e = $at["young_modulus"] / E - 1; m = $at["friction_angle"] / mu - 1
      printf "round %d: effective %.3g; E %.4g Pa (%+.1f %%), 5 to 95 %% %.4g to %.4g; friction %.2f deg (%+.1f %%), %.2f to %.2f\n", round,
        $at["effective_size"], $at["young_modulus"], 100 * e, $at["young_modulus_low"], $at["young_modulus_high"], $at["friction_angle"],
        100 * m, $at["friction_angle_low"], $at["friction_angle_high"]
      print (e * e < 0.01 && m * m < 0.01 ? 0 : 1) > "verdict" }'
  ((round == 3)) || pf-weight resample "posterior$round.h5" --keep --samples "$sets" --seed "$round" --tsv --quiet --force -o "round$((round + 1)).h5" \
    > "round$((round + 1)).tsv"
done
[[ $(cat verdict) == 0 ]] || { echo "crosscheck: hidden parameters were not found to 10 %" >&2; exit 1; }
echo "crosscheck: hidden parameters found to 10 %"
