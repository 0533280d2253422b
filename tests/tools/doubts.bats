#!/usr/bin/env bats
# Doubts on standard error and in files, and remedies: each that is followed here works.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  cat "$BATS_TEST_DIRNAME/sand.toml" - > short.toml << 'TOML'
[equilibrium]
unbalanced_force = 1e-2
[[stage]]
path = "isotropic"
pressure = "100 kPa"
[[stage]]
name = "shear"
path = "triaxial"
confining_pressure = "100 kPa"
axial_strain = 0.002
increment = 0.001
rate = 0.5
reset_strain = true
TOML
  pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 -o packing.h5
}

setup() {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here" || return
  ln -s "$BATS_FILE_TMPDIR"/* .
}

@test "doubts are said once at the end, with --quiet too, and kept in the file; --check says what is known before" {
  local said="run-dem: doubt: stage \"shear\" at 0.5 1/s: inertial number "
  exits 0 run-dem --quiet packing.h5 short.toml -o run.h5
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $(grep -c "^$said" <<< "$stderr") -eq 1 && $stderr == *"above 1e-04 the response depends on the rate; a rate of 0.0"* ]] ||
    show "wanted the inertial number"
  [[ $stderr == *"run-dem: doubt: the cell is "*" diameters of the largest grain "* ]] || show "wanted the cell"
  ! grep -qv '^run-dem: doubt: ' <<< "$stderr" || show "wanted doubts alone"
  exits 0 to-vtk --history run.h5
  [[ $(grep -c '  doubt: inertia: stage "shear" at 0.5 1/s' <<< "$output") -eq 1 ]] || show "wanted it in the history"
  exits 0 run-dem --check packing.h5 short.toml
  [[ $stderr == *"$said"* && $output == *"time step "* ]] || show "wanted it beforehand"
  # The suggested rate works.
  local rate=${stderr##*a rate of }
  exits 0 run-dem --check packing.h5 short.toml --set "stage.1.rate=${rate%% *}"
  [[ $stderr != *"inertial number"* ]] || show "the rate does not do"
}

@test "a run with doubts that is stopped and goes on ends in the same bytes" {
  run-dem --quiet packing.h5 short.toml -o whole.h5
  run-dem --quiet packing.h5 short.toml --checkpoint-every 0 -o out.h5 &
  local run=$!
  until ls out.h5.part/state-* > going 2>&1; do sleep 0.02; done
  kill -TERM "$run"
  wait "$run" || true
  exits 0 run-dem --quiet packing.h5 short.toml --resume -o out.h5
  same_bytes whole.h5 out.h5
  # A finished run is recognised as finished, even with doubts.
  exits 0 run-dem packing.h5 short.toml --resume -o out.h5
  [[ $stderr == "run-dem: out.h5 is finished already" ]] || show
}

@test "a run that begins at another stress than its packing has is doubted, with the cause" {
  cat "$BATS_TEST_DIRNAME/sand.toml" - > undrained.toml << 'TOML'
[[stage]]
path = "constant-volume"
axial_strain = 0.0002
increment = 0.0001
TOML
  local words="run-dem: doubt: the run begins at a mean stress of "
  exits 0 run-dem --check packing.h5 undrained.toml --perturb 1e-4
  [[ $stderr != *"$words"* ]] || show "such twins are fine"
  exits 0 run-dem --check packing.h5 undrained.toml --perturb 0.01
  [[ $stderr == *"$words"*"take a --perturb of 1e-4 or less"* ]] || show
  exits 0 run-dem --check packing.h5 undrained.toml --set contact.young_modulus=70e9
  [[ $stderr == *"$words"*": the scenario has another law, stiffness or friction than the packing was made with"* ]] || show
  exits 0 run-dem --quiet packing.h5 undrained.toml --set contact.young_modulus=70e9 -o stiff.h5
  [[ $stderr == *"$words"* ]] || show "wanted it after the run too"
  exits 0 run-dem --check packing.h5 short.toml --set contact.young_modulus=70e9
  [[ $stderr != *"$words"* ]] || show "its first stage brings it to its stress"
}

# shellcheck disable=SC2030  # each test is a shell of its own
@test "packings whose material numbers nothing describes are refused by every tool that steps them" {
  "$PYTHON" - << 'PY'
import h5py, shutil
for name, number in (("two.h5", 1), ("huge.h5", 2000000000)):
    shutil.copyfile("packing.h5", name)
    with h5py.File(name, "r+") as file: file["particles/grains/species"][5] = number
PY
  local file
  for file in two.h5 huge.h5; do
    refuses 65 pack-generate "add [[material]] tables" --quiet --import $file --pressure 2e5 -o out.h5
    refuses 65 pack-generate "add [[material]] tables" --quiet --import $file --as-is -o out.h5
    refuses 65 run-dem "add [[material]] tables" --quiet $file short.toml -o out.h5
    refuses 65 run-dem "add [[material]] tables" --check $file short.toml
  done
}

# follows WORDS CALL -- SETS: demands that run-dem with the sets of CALL fails with the words, and that adding SETS
# mends it.
follows() {
  local words=$1 broken=() mended=() all=()
  shift
  while [[ $1 != -- ]]; do broken+=(--set "$1"); shift; done
  shift
  for set in "$@"; do mended+=(--set "$set"); done
  all=("${broken[@]}" "${mended[@]}")
  call run-dem --quiet --force packing.h5 short.toml "${broken[@]}" -o broken.h5
  # shellcheck disable=SC2031  # status is set by call
  [[ $status -ne 0 && $stderr == *"$words"* ]] || show "wanted a failure: $words"
  exits 0 run-dem --quiet --force packing.h5 short.toml "${all[@]}" -o mended.h5
  rm -rf broken.h5.part
}

@test "remedies of run-dem that are followed mend" {
  call run-dem packing.h5 short.toml --set numerics.time_step=1e-3 -o broken.h5
  local limit=${stderr##*over the stable one of }
  follows "lower numerics.time_step, or leave it out" numerics.time_step=1e-3 -- numerics.time_step="${limit%% *}" \
    stage.0.pressure=1e5 equilibrium.unbalanced_force=0.05
  follows "the grains would fall for ever; leave it out" 'numerics.gravity=[0,0,-9.81]' -- 'numerics.gravity=[0,0,0]'
  follows "0.0015 (the nearest is 0.001): no station has this axial strain" record.snapshots=list 'record.strains=[0.0015]' \
    -- 'record.strains=[0.001]'
  follows "is held back by its largest rate: raise max_rate" equilibrium.steps=3000 stage.0.pressure=2e5 stage.0.max_rate=1e-5 \
    -- stage.0.max_rate=1
  follows "raise equilibrium.steps" equilibrium.steps=5 -- equilibrium.steps=100000
  follows "too high for grains of this stiffness; lower it, or raise contact.young_modulus" contact.young_modulus=2e5 \
    -- contact.young_modulus=4e9
  follows "the grains do not come to rest: raise numerics.damping" numerics.damping=0 equilibrium.steps=4000 \
    equilibrium.unbalanced_force=1e-4 -- numerics.damping=0.3 equilibrium.steps=100000
}

@test "options and keys that messages name exist" {
  local root=$BATS_TEST_DIRNAME/../.. tool verb word
  {
    for tool in "$BIN"/*; do
      "$tool" --help
      for verb in respond identify design draw assimilate resample; do "$tool" "$verb" --help || true; done
    done
  } > help.txt 2> /dev/null
  # Only words of string literals count, because comments name other programs too.
  grep -rhoE '"([^"\\]|\\.)*"' "$root"/lib "$root"/tools --include='*.cpp' --include='*.h' > literals.txt
  while read -r word; do
    grep -q -- "$word" help.txt || [[ $word == --man || $word == --completion || $word == --bind-to ]] || show "no tool has $word"
  done < <(grep -oE '(^|[^-a-z])--[a-z][-a-z]+' literals.txt | grep -oE -- '--[-a-z]+' | sort -u)
  local keys='(numerics|equilibrium|guards|servo|contact|container|growth|record|geosynthetic|quasi_static|time|grains)'
  while read -r word; do
    grep -qE "${word##*.}" "$root"/lib/*/*.md || show "no page has the key $word"
  done < <(grep -oE "[^a-z_.]$keys\.[a-z_]+(\.[a-z_]+)?" literals.txt | grep -oE '[a-z_.]+' | sort -u)
}

@test "a friction angle in radians is doubted wherever packings are made" {
  local radians="doubt: a friction angle of 0.5 degrees is nearly zero; if radians are meant, write 28.65"
  cat > material.toml << 'TOML'
[contact]
law = "hertz-mindlin"
young_modulus = "4 GPa"
poisson_ratio = 0.33
friction_angle = 0.5
TOML
  exits 0 pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 --material material.toml -o slippery.h5
  [[ $stderr == *"pack-generate: $radians"* ]] || show "wanted: $radians"
  printf '[container]\nshape = "box"\nlow = [-0.01, -0.01, -0.01]\nhigh = [0.01, 0.01, 0.01]\n' | cat - material.toml > box.toml
  exits 0 filter-expand --quiet packing.h5 box.toml -o box.h5
  [[ $stderr == *"filter-expand: $radians"* ]] || show "wanted: $radians"
}

@test "stresses of a few hundred pascals without a unit are doubted, with a unit they are not" {
  local doubt="is 50 without a unit, which is 50 Pa: if 50 kPa is meant, write \"50 kPa\", else \"50 Pa\""
  exits 0 pack-generate --quiet --grains 60 --aspect 1 --tolerance 1e-2 -o loose.h5
  exits 0 run-dem --check loose.h5 short.toml --set stage.0.pressure=50 --set 'stage.1.confining_pressure="50 Pa"'
  [[ $stderr == *"doubt: stage.0.pressure $doubt"* && $stderr != *"stage.1.confining"* ]] || show "wanted: $doubt"
  exits 0 run-dem --check loose.h5 short.toml --set 'stage.0.pressure="50 Pa"' --set 'stage.1.confining_pressure="50 Pa"'
  [[ $stderr != *"without a unit"* ]] || show "a unit was given"
  exits 0 pack-generate --quiet --grains 60 --aspect 1 --tolerance 1e-2 --pressure 100 -o unit.h5
  [[ $stderr == *"doubt: the packing bears "*" Pa: if "*" kPa was meant, write --pressure "*"kPa"* ]] || show "wanted a doubt"
}

@test "grains that an earlier run has scaled in mass are doubted under gravity" {
  cat "$BATS_TEST_DIRNAME/sand.toml" - > fall.toml << 'TOML'
[numerics]
gravity = [0, 0, -9.81]
[equilibrium]
unbalanced_force = 0.9
[[plane]]
point = "touch"
normal = [0, 0, 1]
[[stage]]
path = "free"
TOML
  exits 0 pack-generate --quiet --grains 60 --density 2650 --pressure 1e4 --tolerance 1e-2 --seed 3 -o volume.h5
  printf '[container]\nshape = "box"\nlow = [-0.015, -0.015, -0.015]\nhigh = [0.015, 0.015, 0.015]\n%s\n' "$(cat "$BATS_TEST_DIRNAME/sand.toml")" > box.toml
  exits 0 filter-expand --quiet volume.h5 box.toml -o open.h5
  exits 0 run-dem --quiet --check open.h5 fall.toml
  [[ $stderr != *"grains of one material have"* ]] || show "nothing has changed their masses"
  sed '/gravity/d' fall.toml > rest.toml
  exits 0 run-dem --quiet open.h5 rest.toml --set grains.mass_scaling=equal-step -o scaled.h5
  exits 0 run-dem --quiet --check scaled.h5 fall.toml
  [[ $stderr == *"doubt: numerics.gravity acts, and grains of one material have "*"give their true density, as in grains.density = 2650"* ]] ||
    show "wanted the weights"
  exits 0 run-dem --quiet --check scaled.h5 fall.toml --set grains.density=2650
  [[ $stderr != *"grains of one material have"* ]] || show "the remedy does not work"
}

@test "materials and geotextiles that nothing in the packing has are doubted, with their numbers" {
  { cat short.toml; printf '[[material]]\nyoung_modulus = "8 GPa"\npoisson_ratio = 0.33\nfriction_angle = 21\n'; } > second.toml
  { cat short.toml; printf '[[geotextile]]\ncurve = "PE"\n'; } > wrapped.toml
  exits 0 run-dem --quiet --check packing.h5 short.toml
  [[ $stderr != *"has no effect"* ]] || show "all is used"
  exits 0 run-dem --quiet --check packing.h5 second.toml
  [[ $stderr == *"doubt: no grain, node or plane has material 1, so that [[material]] 1 has no effect: material 0 is [contact]"* ]] || show
  exits 0 run-dem --quiet --check packing.h5 wrapped.toml
  [[ $stderr == *"doubt: no yarn has geotextile 0, so that [[geotextile]] 0 has no effect"* ]] || show
  # A plane counts, too.
  { cat second.toml; printf '[[plane]]\npoint = [0, 0, -9]\nnormal = [0, 0, 1]\nmaterial = 1\n'; } > plane.toml
  printf '[container]\nshape = "box"\nlow = [-0.015, -0.015, -0.015]\nhigh = [0.015, 0.015, 0.015]\n%s\n' "$(cat "$BATS_TEST_DIRNAME/sand.toml")" > box.toml
  exits 0 filter-expand --quiet packing.h5 box.toml -o open.h5
  sed '/^\[\[stage\]\]/,/^reset/d' plane.toml > fall.toml
  printf '[[stage]]\npath = "free"\n' >> fall.toml
  exits 0 run-dem --quiet --check open.h5 fall.toml
  [[ $stderr != *"has no effect"* ]] || show "the plane has the material"
}

@test "tolerances of more than a tenth are doubted, since stations are not at rest there" {
  exits 0 run-dem --quiet --check packing.h5 short.toml --set equilibrium.stress_tolerance=0.1
  [[ $stderr != *"doubt: equilibrium."* ]] || show
  exits 0 run-dem --quiet --check packing.h5 short.toml --set equilibrium.stress_tolerance=0.5
  [[ $stderr == *"doubt: equilibrium.stress_tolerance is 0.5, which is 50 %: states are recorded that are not at rest"* ]] || show
  exits 0 run-dem --quiet --check packing.h5 short.toml --set equilibrium.unbalanced_force=0.9
  [[ $stderr == *"doubt: equilibrium.unbalanced_force is 0.9, which is 90 %"* ]] || show
}

@test "densities in g/cm3 or kN/m3 are doubted, with and without gravity" {
  local density
  for density in 2.65 26.5; do
    exits 0 run-dem --quiet --check packing.h5 short.toml --set "grains.density=$density"
    [[ $stderr == *"doubt: grains have $density kg/m3, where sand has 2650 and scaled grains more"* ]] || show
  done
  exits 0 run-dem --quiet --check packing.h5 short.toml --set grains.density=2650
  [[ $stderr != *"doubt: grains have"* ]] || show "sand has this density"
  exits 0 pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 --density 26.5 -o light.h5
  [[ $stderr == *"doubt: grains have 26.5 kg/m3"* ]] || show
}
