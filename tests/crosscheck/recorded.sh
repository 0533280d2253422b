#!/usr/bin/env bash
# Whole drained triaxial tests of 1000 grains against the peer's recorded ensembles and the laboratory, and what sets
# them apart: the servo and the loading rate, each shown by switching it.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make crosscheck, with SOILWEAVE_REFERENCE at the folder of recorded curves. TWINS (default 4): runs of each test.
# Exits with 1 where a bound is missed.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
BIN=$(cd "${BIN:-$here/../../build/bin}" && pwd)
PATH=$BIN:$PATH
export OMP_NUM_THREADS=1 LC_ALL=C.UTF-8
twins=${TWINS:-4} jobs=${JOBS:-$(nproc)}
reference=${SOILWEAVE_REFERENCE:-}
[[ -d $reference/peer/triaxial ]] || { echo "crosscheck: no recorded curves (SOILWEAVE_REFERENCE); skipped"; exit 0; }
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"

{ echo "##PERIODIC:: 0.0462201 0.0461205 0.0921203"; tail -n +2 "$reference/ch2/toyoura_rv_1000.csv" | tr , ' '; } > packing.txt
pack-generate --quiet --import packing.txt --as-is -o packing.h5

cat > hm.toml << 'TOML'
[contact]
law = "hertz-mindlin"
young_modulus = 4e9
poisson_ratio = 0.33
friction_angle = 29
[contact.rolling]
stiffness = 0.13
limit = "none"
[contact.twisting]
stiffness = 0.13
limit = "none"
[equilibrium]
stress_tolerance = 1e-3
TOML
cat > cl.toml << 'TOML'
[contact]
law = "linear"
young_modulus = 5.449e8
stiffness_ratio = 0.08032
friction_angle = 30.2028
[contact.rolling]
stiffness = 0.56393
scale = "contact"
limit = 0.19357
arm = "smaller-radius"
[contact.twisting]
stiffness = 0.56393
scale = "contact"
limit = 0.19357
arm = "smaller-radius"
[equilibrium]
stress_tolerance = 1e-4
TOML
stages='
[grains]
density = 2650e3
[[stage]]
path = "isotropic"
pressure = "0.2 MPa"
[[stage]]
path = "triaxial"
confining_pressure = "0.2 MPa"
axial_strain = 0.10
increment = 0.001
rate = 0.1
reset_strain = true'
for law in hm cl; do echo "$stages" >> $law.toml; done

# one LAW SERVO RATE TWIN: prints a test as a table.
one() {
  local law=$1 servo=$2 rate=$3 twin=$4 perturb=1e-6
  [[ $twin -eq 0 ]] && perturb=0
  local name=$law.$servo.$rate.$twin
  run-dem --quiet packing.h5 "$law.toml" --set "servo.kind=$servo" --set "stage.1.rate=$rate" --perturb "$perturb" \
    --seed "$twin" -o "$name.h5"
  homogenize --quiet --tsv --table series "$name.h5" > "$name.tsv"
}
SHELL=$(command -v bash)
export SHELL
export -f one
{
  for law in hm cl; do
    for ((twin = 0; twin < twins; ++twin)); do
      for servo in stiffness inertia; do echo "$law $servo 0.1 $twin"; done
    done
    echo "$law stiffness 0.01 0"
  done
} | parallel --will-cite --jobs "$jobs" --colsep ' ' 'one {1} {2} {3} {4}'

/usr/bin/env python3 "$here/recorded.py" "$reference/peer/triaxial" \
  "$here/../../data/laboratory/toyoura_drained_triaxial_0.2MPa.tsv" "$twins"
