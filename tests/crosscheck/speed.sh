#!/usr/bin/env bash
# run-dem and its peers at the same packings, law and loading, alternating in one sitting: steps per second and their
# ratios, each with its required least value.
# SPDX-License-Identifier: GPL-3.0-or-later
#
# make bench-peers, with SOILWEAVE_REFERENCE at the folder of recorded packings. Peers that are missing are skipped: YADE
# (2023.02a was used), LAMMPS with GRANULAR as `lmp`, LIGGGHTS as `liggghts`. ROUNDS (default 3), CASES (default: all of
# 1000 70000 disks). YADE has servo, stress and time step in every step, as run-dem has; the others deform the
# cell at a fixed time step. The figures hold only on two cores that nobody else uses. Exits with 1 where a bar is missed.
set -euo pipefail

here=$(cd "$(dirname "$0")" && pwd)
BIN=$(cd "${BIN:-$here/../../build/bin}" && pwd)
PATH=$BIN:$PATH
export OMP_NUM_THREADS=1 LC_ALL=C.UTF-8
rounds=${ROUNDS:-3} cases=${CASES:-1000 70000 disks}
reference=${SOILWEAVE_REFERENCE:-}/packings
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
first_core() { if command -v taskset > /dev/null; then taskset -c 0 "$@"; else "$@"; fi; }
have() { command -v "$1" > /dev/null; }

# ---- Packings: text for the peers, a file for us --------------------------------------------------------------------
packing() {
  case $1 in
    1000) zcat "$reference/hm31_0.2MPa_N1000.txt.gz" > 1000.txt ;;
    70000) zcat "$reference/hm31_eta0.13_0.2MPa_N70000_tiled7x10x1.txt.gz" > 70000.txt ;;
    disks)
      # The packing is made by the law of its loading, so that it is at rest from the first step in any engine.
      scenario disks 0 | sed '/^\[equilibrium\]/,$d' > disks_material.toml
      pack-generate --quiet --material disks_material.toml --dimension 2 --grains 400 --aspect 1 --mean-radius 0.003 \
        --density 2650 --pressure 1e5 -o disks.h5
      { h5dump -m '%.17g' -d /particles/grains/box/edges/value -y disks.h5 | tr -d ' {}' | awk -F , '/^[-0-9]/ {
          for (i = 1; i <= NF; ++i) if ($i != "" && $i + 0 > 0) edge[++n] = $i }
          END { printf "##PERIODIC:: %s %s 0.03\n", edge[1], edge[2] }'
        to-vtk --text disks.h5; } > disks.txt
      return ;;
  esac
  pack-generate --quiet --import "$1.txt" --as-is -o "$1.h5"
}

scenario() { # CASE STRAIN
  if [[ $1 == disks ]]; then
    printf '[contact]\nlaw = "linear"\nyoung_modulus = 3e10\nstiffness_ratio = 0.5\nfriction_angle = 29\n'
  else
    printf '[contact]\nlaw = "hertz-mindlin"\nyoung_modulus = 3.1e9\npoisson_ratio = 0.3\nfriction_angle = 29\n'
    printf '[contact.%s]\nstiffness = 0.13\nlimit = "none"\n' rolling twisting
  fi
  cat << TOML
[grains]
density = $([[ $1 == disks ]] && echo 2650 || echo 2650e3)
[equilibrium]
unbalanced_force = 0.9
stress_tolerance = 0.9
[record]
snapshots = "ends"
[[stage]]
path = "triaxial"
confining_pressure = $([[ $1 == disks ]] && echo 1e5 || echo 2e5)
axial_strain = $2
increment = $2
rate = 0.1
max_rate = 1.0
TOML
}

# ---- Each engine: its steps per second to a file --------------------------------------------------------------------
cost() { # SAID: steps per second of the clock beside output, and contacts
  grep ' steps/s, ' "$1" | tail -n 1 | awk '{
    for (i = 1; i <= NF; ++i) { if ($i == "steps" && !steps) steps = $(i - 1); if ($i == "s:") clock = $(i - 1)
      if ($i == "contacts" && !pairs) pairs = $(i - 1); if ($i == "output") output = $(i + 1) }
    printf "%.9g %d\n", steps / (clock * (1 - output / 100)), pairs }'
}

# All engines count processor time on one thread, because other work on the machine takes less of it than of the
# clock's.
# Output and start, once per run, are left out for every engine.
ours() { # CASE THREADS TO
  scenario "$1" "${strain[$1]}" > scenario.toml
  local pin=(first_core) TIMEFORMAT='%R %U %S'
  [[ $2 == 1 ]] || pin=()
  { time "${pin[@]}" run-dem "$1.h5" scenario.toml --threads "$2" --force -o run.h5 2> said.txt; } 2> time.txt
  cost said.txt | awk -v threads="$2" -v took="$(tail -n 1 time.txt)" '{
    split(took, t, " "); share = threads == 1 && t[2] + t[3] < t[1] ? (t[2] + t[3]) / t[1] : 1
    printf "%.6g %d\n", $1 / share, $2 }' > "$3"
}

# Two runs side by side, one per core, show the most that this machine gives two threads that share nothing.
side_by_side() { # CASE TO
  scenario "$1" "${strain[$1]}" > scenario.toml
  for core in 0 1; do
    taskset -c $core run-dem "$1.h5" scenario.toml --threads 1 --force -o run.$core.h5 2> said.$core.txt &
  done
  wait
  { cost said.0.txt; cost said.1.txt; } | awk '{ sum += $1 } END { print sum }' > "$2"
}

yade_speed() { # CASE TO
  ORDER="{\"packing\": \"$1.txt\", \"disks\": $([[ $1 == disks ]] && echo true || echo false), \"pressure\": ${peer_pressure[$1]},
    \"warm_up\": ${peer_warm_up[$1]}, \"steps\": ${peer_steps[$1]}, \"output\": \"$2\"}" \
    first_core yade -n -x -j1 "$here/speed_yade.py" > peer.log 2>&1 < /dev/null || true
  [[ -s $2 ]] || { tail -n 5 peer.log >&2; echo "bench-peers: YADE did not finish" >&2; exit 1; }
}

# Prints the grains of the text for LAMMPS; the step is 0.3 r_min sqrt(density/E).
grains() {
  awk '/^##/ { lx = $2; ly = $3; lz = $4; next } { ++n; line[n] = sprintf("%d 1 %.10g 2650e3 %.10g %.10g %.10g", n, 2 * $4, $1, $2, $3) }
    END { printf "packing\n\n%d atoms\n1 atom types\n0 %.10g xlo xhi\n0 %.10g ylo yhi\n0 %.10g zlo zhi\n\nAtoms\n\n", n, lx, ly, lz
      for (i = 1; i <= n; ++i) print line[i] }' "$1.txt" > "$1.data"
  step=$(awk '/^##/ { next } !r || $4 < r { r = $4 } END { printf "%.6g", 0.3 * r * sqrt(2650e3 / 3.1e9) }' "$1.txt")
}

lammps_speed() { # CASE TO PROGRAM
  grains "$1"
  { printf 'units si\natom_style %s\n' "$([[ $3 == lmp ]] && echo sphere || echo granular)"
    printf 'atom_modify map array\nboundary p p p\nnewton off\n'
    if [[ $3 == lmp ]]; then
      printf 'comm_modify vel yes\nread_data %s.data\nneighbor 0.0003 bin\nneigh_modify delay 0\npair_style granular\n' "$1"
      printf 'pair_coeff * * hertz/material 3.1e9 0 0.3 tangential mindlin NULL 0 0.554 rolling sds 14444 0 0.26 %s\n' \
        'twisting sds 0.13 0 4e-4 damping velocity'
    else
      printf 'hard_particles yes\ncommunicate single vel yes\nread_data %s.data\nneighbor 0.0003 bin\nneigh_modify delay 0\n' "$1"
      printf 'fix %s all property/global %s\n' a 'youngsModulus peratomtype 3.1e9' b 'poissonsRatio peratomtype 0.3' \
        c 'coefficientRestitution peratomtypepair 1 0.9' d 'coefficientFriction peratomtypepair 1 0.554' \
        e 'coefficientRollingFriction peratomtypepair 1 0.26'
      printf 'pair_style gran model hertz tangential history rolling_friction epsd2\npair_coeff * *\n'
    fi
    printf 'fix motion all nve/sphere\nfix cell all deform 1 x erate 0.05 y erate 0.05 z erate -0.1 remap v\ntimestep %s\n' "$step"
    printf 'thermo 1000000\nrun %s\nrun %s\n' "${peer_warm_up[$1]}" "$((8 * ${peer_steps[$1]}))"; } > peer.in
  first_core "$3" -in peer.in > peer.log 2>&1 < /dev/null || { tail -n 3 peer.log >&2; echo "bench-peers: $3 did not finish" >&2; exit 1; }
  awk '/^Loop time/ { speed = $9 / $4 } / CPU use with/ { speed *= 100 / $1 } END { print speed }' peer.log > "$2"
}

# ---- Tables ---------------------------------------------------------------------------------------------------------
median() { sort -g "$@" | awk '{ v[NR] = $1 } END { print NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2 }'; }

tell() { # CASE ENGINE
  sort -g "$1.$2".* | awk -v name="$2" '{ v[NR] = $1; if ($2) pairs = $2 }
    END { m = NR % 2 ? v[(NR + 1) / 2] : (v[NR / 2] + v[NR / 2 + 1]) / 2
      printf "  %-12s %10.4g steps/s (%.4g to %.4g)%s\n", name, m, v[1], v[NR], pairs ? sprintf(", %d contacts", pairs) : "" }'
}

bar() { # WORDS CASE NUMERATOR DENOMINATOR BAR
  awk -v words="$1" -v a="$(median "$2.$3".*)" -v b="$(median "$2.$4".*)" -v bar="$5" 'BEGIN {
    met = a / b >= bar; printf "  %s: %.3g times, at least %s: %s\n", words, a / b, bar, met ? "met" : "MISSED"; exit !met }' || missed=1
}

# A packing of 70,000 grains runs so many steps that the set-up of the simulation counts little. The peers' warm-up
# includes their set-up.
declare -A strain=([1000]=0.05 [70000]=0.006 [disks]=0.05) peer_steps=([1000]=1000 [70000]=30 [disks]=8000)
# Disks get the same force per side, over YADE's thickness of 0.03 m.
declare -A peer_pressure=([1000]=2e5 [70000]=2e5 [disks]=3.333e6)
declare -A peer_warm_up=([1000]=200 [70000]=10 [disks]=1000)
missed=0
for case in $cases; do
  [[ $case == disks || -d $reference ]] || { echo "$case grains: no recorded packings (SOILWEAVE_REFERENCE); skipped"; continue; }
  packing "$case"
  for ((round = 1; round <= rounds; ++round)); do
    ours "$case" 1 "$case.run-dem.$round"
    if have yade; then yade_speed "$case" "$case.YADE.$round"; fi
    if [[ $case == 70000 ]]; then
      ours "$case" 2 "$case.two-threads.$round"
      if have taskset; then side_by_side "$case" "$case.side-by-side.$round"; fi
      for peer in lmp liggghts; do if have $peer; then lammps_speed "$case" "$case.$peer.$round" $peer; fi; done
    fi
  done
  echo "$case grains, $rounds rounds, medians (least to most):"
  for engine in run-dem two-threads side-by-side YADE lmp liggghts; do if [[ -e $case.$engine.1 ]]; then tell "$case" "$engine"; fi; done
  floor=20
  [[ $case == 70000 ]] && floor=35
  if [[ -e $case.YADE.1 ]]; then bar "run-dem over YADE" "$case" run-dem YADE "$floor"; fi
  if [[ -e $case.lmp.1 ]]; then bar "run-dem over LAMMPS" "$case" run-dem lmp 4; fi
  if [[ -e $case.two-threads.1 ]]; then bar "two threads over one" "$case" two-threads run-dem 1.7; fi
done
exit "$missed"
