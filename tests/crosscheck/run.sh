#!/usr/bin/env bash
# Equal contacts and packings here and in YADE: contact paths of a lattice, a triaxial test of 1000 grains.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make crosscheck. Needs YADE (2023.02a was used) as `yade`. TWINS (default 4): runs of each triaxial test, their
# positions moved at random by 1e-6 r. Exits with 1 where the two disagree.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
BIN=$(cd "${BIN:-$here/../../build/bin}" && pwd)
PATH=$BIN:$PATH
export OMP_NUM_THREADS=1 LC_ALL=C.UTF-8
twins=${TWINS:-4}

command -v yade > /dev/null || { echo "crosscheck: no yade here (Debian package yade); skipped"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

# peer NAME JSON: lets YADE carry out an order, with output to NAME.
peer() {
  ORDER=$2 yade -n -x -j1 "$here/peer.py" > peer.log 2>&1 < /dev/null || true
  [[ -s $1.speed ]] || { tail -5 peer.log >&2; echo "crosscheck: YADE did not finish $1" >&2; exit 1; }
}

# law NAME FORM: prints the parameters of a law as TOML or as JSON.
law() {
  case $1-$2 in
    lattice-hertz-mindlin-toml)
      printf '[contact]\nlaw = "hertz-mindlin"\nyoung_modulus = 4e9\npoisson_ratio = 0.33\nfriction_angle = 29\n' ;;
    lattice-hertz-mindlin-json)
      echo '{"law": "hertz-mindlin", "young_modulus": 4e9, "poisson_ratio": 0.33, "friction_angle": 29}' ;;
    lattice-linear-toml)
      printf '[contact]\nlaw = "linear"\nyoung_modulus = 5e8\nstiffness_ratio = 0.8\nfriction_angle = 20\n' ;;
    lattice-linear-json)
      echo '{"law": "linear", "young_modulus": 5e8, "stiffness_ratio": 0.8, "friction_angle": 20}' ;;
    triaxial-hertz-mindlin-toml)
      law lattice-hertz-mindlin toml
      printf '[contact.%s]\nstiffness = 0.13\nlimit = "none"\n' rolling twisting ;;
    triaxial-hertz-mindlin-json)
      law lattice-hertz-mindlin json | sed 's/}/, "rolling_stiffness": 0.13}/' ;;
    triaxial-linear-toml)
      printf '[contact]\nlaw = "linear"\nyoung_modulus = 5.449e8\nstiffness_ratio = 0.08032\nfriction_angle = 30.2028\n'
      printf '[contact.%s]\nstiffness = 0.56393\nscale = "contact"\nlimit = 0.19357\narm = "smaller-radius"\n' \
        rolling twisting ;;
    triaxial-linear-json)
      echo '{"law": "linear", "young_modulus": 5.449e8, "stiffness_ratio": 0.08032, "friction_angle": 30.2028,
        "rolling_stiffness": 0.56393, "rolling_limit": 0.19357}' ;;
  esac
}

# columns FILE NAME...: prints these columns of our table, without the header.
columns() {
  awk -F '\t' -v names="${*:2}" '
    NR == 1 { for (i = 1; i <= NF; ++i) { split($i, part, / \[/); at[part[1]] = i }; n = split(names, name, " "); next }
    { for (k = 1; k <= n; ++k) printf "%s%s", $at[name[k]], k < n ? "\t" : "\n" }' "$1"
}

# ---- Contact paths --------------------------------------------------------------------------------------------------
# Grains at the sites of a face-centred cubic lattice feel equal and opposite forces: they move with the cell whatever
# the law, and the stress is that of a few contacts on prescribed paths. The cell is compressed, relaxed, compressed
# again, sheared at constant volume until the contacts slide, and sheared back.
lattice() {
  awk 'BEGIN {
    r = 0.005; a = 2 * sqrt(2) * r * (1 + 1e-6); n = 3
    printf "##PERIODIC:: %.17g %.17g %.17g\n", n * a, n * a, n * a
    split("0 0 0 0.5 0.5 0 0.5 0 0.5 0 0.5 0.5", site, " ")
    for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) for (k = 0; k < n; ++k) for (s = 1; s < 12; s += 3)
      printf "%.17g %.17g %.17g %.17g\n", (i + site[s]) * a, (j + site[s + 1]) * a, (k + site[s + 2]) * a, r
  }' > lattice.txt
  pack-generate --quiet --import lattice.txt --as-is -o lattice.h5
}

# Ends of the stages: strain along x and y, along z, and the rates, 1/s.
path=("2e-3 2e-3 1e-2 1e-2" "1e-3 1e-3 1e-2 1e-2" "2e-3 2e-3 1e-2 1e-2" "1e-3 4e-3 5e-3 1e-2" "2.5e-3 1e-3 5e-3 1e-2")
parts=4

contact_path() {
  local name=$1 stage x z rate_x rate_z sx sz x0=0 z0=0 k stations=()
  { law "lattice-$name" toml
    printf '[numerics]\ntime_step = 1e-4\n[equilibrium]\nunbalanced_force = 1e-6\n'; } > lattice.toml
  for stage in "${path[@]}"; do
    read -r x z rate_x rate_z <<< "$stage"
    read -r sx sz < <(awk -v a="$x0" -v b="$x" -v c="$z0" -v d="$z" 'BEGIN { printf "%.12g %.12g\n", b - a, d - c }')
    printf '[[stage]]\npath = "free"\nparts = %s\n' "$parts" >> lattice.toml
    printf '[stage.%s]\nstrain = %s\nmax_rate = %s\n' \
      x "$sx" "$rate_x" y "$sx" "$rate_x" z "$sz" "$rate_z" >> lattice.toml
    for ((k = 1; k <= parts; ++k)); do
      read -r sx sz < <(awk -v a="$x0" -v b="$x" -v c="$z0" -v d="$z" -v s="$k/$parts" 'BEGIN {
        split(s, f, "/"); printf "%.12g %.12g\n", a + (b - a) * f[1] / f[2], c + (d - c) * f[1] / f[2] }')
      stations+=("[[$sx, $sx, $sz], [$rate_x, $rate_x, $rate_z]]")
    done
    x0=$x z0=$z
  done
  run-dem --quiet lattice.h5 lattice.toml -o lattice-run.h5 --force
  homogenize --quiet --tsv --table series lattice-run.h5 > series.tsv
  columns series.tsv strain_xx strain_yy strain_zz stress_xx stress_yy stress_zz | tail -n +2 > ours.tsv
  peer theirs.tsv "{\"test\": \"lattice\", \"law\": $(law "lattice-$name" json), \"density\": 2650e3,
    \"time_step\": 1e-4, \"packing\": \"lattice.txt\", \"output\": \"theirs.tsv\", \"stations\": [$(IFS=,; echo "${stations[*]}")]}"
  python3 "$here/compare.py" lattice "$name" ours.tsv theirs.tsv
}

# ---- Triaxial compression -------------------------------------------------------------------------------------------
packing() {
  local reference=${SOILWEAVE_REFERENCE:-}/ch2/toyoura_rv_1000.csv
  if [[ -e $reference ]]; then
    { echo "##PERIODIC:: 0.0462201 0.0461205 0.0921203"; tail -n +2 "$reference" | tr , ' '; } > packing.txt
    echo "packing: toyoura_rv_1000"
  else
    pack-generate --quiet --void-ratio 0.68 -o generated.h5
    to-vtk --text generated.h5 > packing.txt
    echo "packing: pack-generate --void-ratio 0.68"
  fi
  pack-generate --quiet --import packing.txt --as-is -o packing.h5
}

triaxial() {
  local name=$1 twin began
  { law "triaxial-$name" toml
    printf '[servo]\nkind = "inertia"\n'  # YADE's servo oscillates, which shifts the stress ratio by a per cent
    printf '[[stage]]\npath = "isotropic"\npressure = 2e5\n'
    printf '[[stage]]\npath = "triaxial"\nreset_strain = true\nconfining_pressure = 2e5\naxial_strain = 0.02\n'
    printf 'increment = 1e-3\nrate = 0.1\n'; } > triaxial.toml
  for ((twin = 0; twin < twins; ++twin)); do
    began=$(date +%s.%N)
    run-dem --quiet packing.h5 triaxial.toml --perturb "$([[ $twin = 0 ]] && echo 0 || echo 1e-6)" --seed "$twin" \
      -o run.h5 --force
    homogenize --quiet --tsv --table series run.h5 > series.tsv
    awk -v from="$began" -v to="$(date +%s.%N)" -v steps="$(columns series.tsv step | tail -1)" \
      'BEGIN { print steps / (to - from) }' > "ours.$twin.speed"
    columns series.tsv stage strain_axial strain_volumetric stress_ratio void_ratio |
      awk -F '\t' '$1 == 1' | cut -f 2- > "ours.$twin"
    peer "theirs.$twin" "{\"test\": \"triaxial\", \"law\": $(law "triaxial-$name" json), \"density\": 2650e3,
      \"packing\": \"packing.txt\", \"output\": \"theirs.$twin\", \"pressure\": 2e5, \"increment\": 1e-3,
      \"stations\": 20, \"rate\": 0.1, \"seed\": $twin, \"perturb\": $([[ $twin = 0 ]] && echo 0 || echo 1e-6)}"
  done
  python3 "$here/compare.py" triaxial "$name" "$twins"
}

agree=0
lattice
for name in hertz-mindlin linear; do contact_path $name || agree=1; done
packing
for name in hertz-mindlin linear; do triaxial $name || agree=1; done
[[ $agree -eq 0 ]] && echo "crosscheck: agreed" || echo "crosscheck: DISAGREED"
exit $agree
