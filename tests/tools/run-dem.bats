#!/usr/bin/env bats
# run-dem: scenarios checked whole, the same bytes each time, pipes, restarts, and every class of error.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  cat "$BATS_TEST_DIRNAME/sand.toml" - > short.toml << 'TOML'
[equilibrium]
unbalanced_force = 1e-2

[[stage]]
path = "triaxial"
confining_pressure = "100 kPa"
axial_strain = 0.002
increment = 0.001
rate = 0.5
TOML
  pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 -o packing.h5
  run-dem --quiet packing.h5 short.toml -o run.h5
}

setup() {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here" || return
  ln -s "$BATS_FILE_TMPDIR"/* .
}

# refused STATUS WORDS ARGUMENTS...: demands what refuses() does, for a run of the packing along the scenario.
refused() {
  refuses "$1" run-dem "$2" --quiet packing.h5 short.toml "${@:3}"
}

# off WORDS KEY=VALUE...: demands that the scenario with these values is refused with the words.
off() {
  local words=$1 value
  shift
  local sets=()
  for value in "$@"; do sets+=(--set "$value"); done
  refused 65 "$words" "${sets[@]}" -o out.h5
}

@test "the same call gives the same bytes, with one thread and with four, from a file and through a pipe" {
  local n
  for n in 1 4; do run-dem --quiet --threads $n packing.h5 short.toml -o "$n.h5"; done
  same_bytes run.h5 1.h5
  same_bytes 1.h5 4.h5
  OMP_NUM_THREADS=3 run-dem --quiet - short.toml -o - < packing.h5 > piped.h5
  same_bytes 1.h5 piped.h5
}

@test "twins: the same seed the same, another seed another, no perturbation no seed" {
  twin() { run-dem --quiet --perturb 1e-6 --seed "$1" packing.h5 short.toml -o "$2"; }
  twin 1 one.h5
  twin 1 again.h5
  twin 2 two.h5
  same_bytes one.h5 again.h5
  other_bytes one.h5 two.h5
  other_text <(homogenize --tsv one.h5) <(homogenize --tsv run.h5)
  refuses 64 run-dem "--seed has no effect without --perturb R" --quiet --seed 2 packing.h5 short.toml -o out.h5
}

@test "the pipe through all tools gives the numbers of the files, and says nothing but doubts" {
  local generate=(pack-generate --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2)
  exits 0 bash -c "set -o pipefail; ${generate[*]} -o - | run-dem - short.toml -o - | homogenize - --tsv"
  [[ -z $(without_doubts) ]] || show "wanted nothing on standard error but doubts"
  same_text <(homogenize run.h5 --tsv) <(echo "$output")
  [[ $(wc -l <<< "$output") -eq 3 ]] || show "wanted a header and two states"
}

@test "the history names every step, its input, its scenario as run" {
  run-dem --quiet run.h5 short.toml --set stage.0.axial_strain=0.001 -o further.h5
  exits 0 to-vtk --history further.h5
  [[ $(grep '^[0-9]' <<< "$output") == $'0. pack-generate 0.1.0\n1. run-dem 0.1.0\n2. run-dem 0.1.0' ]] || show "steps"
  [[ $output == *"made by 0, sha256 $(sha256sum packing.h5 | cut -d ' ' -f 1)"* ]] || show "the packing"
  [[ $output == *"made by 1, sha256 $(sha256sum run.h5 | cut -d ' ' -f 1)"* ]] || show "the first run"
  [[ $output == *"scenario, from outside, sha256 $(sha256sum short.toml | cut -d ' ' -f 1)"* ]] || show "the scenario"
  [[ $output == *"axial_strain = 0.001"* ]] || show "the override is not in the scenario as run"
  [[ $output != *"--threads"* ]] || show "threads change nothing and belong in no history"
}

@test "a run goes on where it stopped" {
  exits 0 homogenize --tsv --state last run.h5
  run-dem --quiet run.h5 short.toml --set stage.0.axial_strain=0.001 -o further.h5
  same_text <(homogenize --tsv --state last run.h5 | cut -f 6-12) <(homogenize --tsv --state first further.h5 | cut -f 6-12)
}

@test "the table begins with zeros, not minus zeros" {
  exits 0 homogenize --tsv --table series run.h5
  [[ $output != *$'\t-0\t'* ]] || show "minus zero"
}

@test "units: the same pressure, modulus and angle in other units are the same run" {
  run-dem --quiet packing.h5 short.toml -o other.h5 --set 'contact.young_modulus=4000 MPa' \
    --set 'stage.0.confining_pressure=0.1MPa' --set "contact.friction_angle=29 deg" --set 'stage.0.rate=5e-1 1/s'
  same_text <(homogenize --tsv --table series run.h5) <(homogenize --tsv --table series other.h5)
}

@test "errors: usage" {
  refuses 64 run-dem "--output is missing: give '-o FILE'" packing.h5 short.toml
  refuses 64 run-dem "SCENARIO is missing" packing.h5 -o out.h5
  refused 64 "is one file too many" short.toml -o out.h5
  refused 64 "--perturb: 2 is out of range: must be from 0 to 1 (more would make another packing)" --perturb 2 -o out.h5
  refused 64 "--threads: 0 is out of range" --threads 0 -o out.h5
  refused 64 "--seed: '-1' is not a whole number" --seed -1 -o out.h5
  refused 64 "--set nothing: write KEY=VALUE" --set nothing -o out.h5
  refused 64 "--set =5: write KEY=VALUE" --set =5 -o out.h5
  refused 64 "'1' is no entry of the list; it has 1, counted from 0" --set stage.1.path=free -o out.h5
  refused 64 "is a value and holds no keys" --set contact.law.name=free -o out.h5
}

@test "errors: an input that is missing, a folder, damaged, or something else" {
  refuses 66 run-dem "none.h5: no such file; check the name" none.h5 short.toml -o out.h5
  refuses 66 run-dem "none.toml: no such file; check the name" packing.h5 none.toml -o out.h5
  refuses 65 run-dem ".: a directory; name a file in it" . short.toml -o out.h5
  refuses 65 run-dem ".: a directory; name a file in it" packing.h5 . -o out.h5
  refuses 65 run-dem "/dev/null: empty" /dev/null short.toml -o out.h5
  refuses 65 run-dem "short.toml: not an HDF5 file" short.toml short.toml -o out.h5
  refuses 65 run-dem "packing.h5: an HDF5 file where a text belongs (the scenario)" packing.h5 packing.h5 -o out.h5
  head -c 3000 packing.h5 > cut.h5
  refuses 65 run-dem "truncated: 3000 bytes of" cut.h5 short.toml -o out.h5
  homogenize --quiet packing.h5 -o fields.h5
  refuses 65 run-dem "fields.h5: holds fields, but packing or run is needed here" fields.h5 short.toml -o out.h5
  call bash -c 'run-dem --quiet - short.toml -o out.h5 < /dev/null'
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $status -eq 65 && $stderr == "run-dem: standard input: empty"* && ! -e out.h5 ]] || show "empty standard input"
}

@test "errors: a file of a newer version, of another material, with a number that is none" {
  "$PYTHON" -c 'import h5py' || skip "no Python with h5py"
  edit() {
    cp packing.h5 edited.h5
    "$PYTHON" -c "import h5py; f = h5py.File('edited.h5', 'r+'); g = f['particles/grains']; $1"
  }
  edit 'f.attrs["format_version"] = [2, 1]'
  refuses 65 run-dem "has the format version 2.1, this program reads 1.3 at most" edited.h5 short.toml -o out.h5
  edit 'g["position/value"][0, 5, 1] = float("nan")'
  refuses 65 run-dem "/particles/grains/position/value holds nan" edited.h5 short.toml -o out.h5
  edit 'g["species"][3] = 1'
  refuses 65 run-dem "grains of material 1, the scenario describes 1: add [[material]] tables" edited.h5 short.toml \
    -o out.h5
  edit 'g["position/value"][0, 5] = g["position/value"][0, 9] + 1e-3'
  refuses 65 run-dem "branch_vector does not join the grains' centres" edited.h5 short.toml -o out.h5
  edit 'g["radius"][:] *= 1.3'
  refuses 65 run-dem "of the radius: too deep for a contact of stiff grains" edited.h5 short.toml -o out.h5
  edit 'g["radius"][:] *= 3'
  refuses 65 run-dem "is not smaller than half the cell along axis" edited.h5 short.toml -o out.h5
}

@test "errors: a stage that loads an axis that is not periodic" {
  printf '1 1 1 0.5\n3 1 1 0.5\n' > open.txt
  pack-generate --quiet --import open.txt --as-is -o open.h5
  refuses 65 run-dem 'stage "triaxial" loads axis x' --quiet open.h5 short.toml -o out.h5
}

@test "errors: plates in a cell whose grains go on through its faces, gravity without a floor" {
  local touching=() k
  for k in 0 1 2 3 4 5; do touching+=(--set "plane.$k.point=touch"); done
  refuses 65 run-dem "along which the cell is periodic and grains touch their images through its faces" --quiet packing.h5 \
    "$BATS_TEST_DIRNAME/../../pipelines/recipes/oedometer.toml" "${touching[@]}" -o out.h5
  printf '1 1 1 0.5\n3 1 1 0.5\n' > open.txt
  pack-generate --quiet --import open.txt --as-is -o open.h5
  cat "$BATS_TEST_DIRNAME/sand.toml" - > fall.toml <<< $'[numerics]\ngravity = [0, 0, -9.81]\n[[stage]]\npath = "free"'
  refuses 65 run-dem "along z, along which no plane stops the grains: the grains would fall for ever" --quiet open.h5 fall.toml -o out.h5
  printf '[[plane]]\npoint = "touch"\nnormal = [0, 0, 1]\n' >> fall.toml
  exits 0 run-dem --quiet --check open.h5 fall.toml
}

@test "errors: TOML that is none names line and column" {
  printf '[contact]\nlaw = \n' > bad.toml
  refuses 65 run-dem "bad.toml:2:7: " packing.h5 bad.toml -o out.h5
  printf '[contact\nlaw = "linear"\n' > bad.toml
  refuses 65 run-dem "bad.toml:1:9: " packing.h5 bad.toml -o out.h5
  sed 's/^rate/increment/' short.toml > bad.toml
  refuses 65 run-dem "bad.toml:16:" packing.h5 bad.toml -o out.h5
}

@test "errors: unknown and misspelt keys are told with line and nearest known key" {
  misspelt() {
    sed "s/^$1\\b/$2/" short.toml > slip.toml
    refuses 65 run-dem "slip.toml:$3: unknown key '$4$2'; did you mean '$1'?" packing.h5 slip.toml -o out.h5
  }
  misspelt young_modulus youngs_modulus 5 contact.
  misspelt friction_angle frictoin_angle 7 contact.
  misspelt confining_pressure confing_pressure 13 stage.0.
  misspelt unbalanced_force unbalanced_forces 9 equilibrium.
  sed 's/^\[contact\]/[contakt]/' short.toml > slip.toml
  refuses 65 run-dem "slip.toml:3: unknown key 'contakt'; did you mean 'contact'?" packing.h5 slip.toml -o out.h5
  sed 's/^\[\[stage\]\]/[[stages]]/' short.toml > slip.toml
  refuses 65 run-dem "slip.toml:11: unknown key 'stages'; did you mean 'stage'?" packing.h5 slip.toml -o out.h5
  off "--set numerics.dampning=0.2: unknown key 'numerics.dampning'; did you mean 'damping'?" numerics.dampning=0.2
  off "--set numeric.damping=0.2: unknown key 'numeric'; did you mean 'numerics'?" numeric.damping=0.2
  off "unknown key 'contact.colour'; known: " contact.colour=1
}

@test "errors: every mistake of a scenario is told at once, a line each" {
  sed 's/^poisson_ratio.*/poisson_ratio = 0.7/; s/^rate.*/rate = "fast"/' short.toml > three.toml
  exits 65 run-dem packing.h5 three.toml --set numerics.damping=2 -o out.h5
  [[ $(wc -l <<< "$stderr") -eq 3 && $(grep -c '^run-dem: ' <<< "$stderr") -eq 3 ]] || show "wanted three lines"
  [[ $stderr == *"--set numerics.damping=2: "*"three.toml:6: "*"three.toml:16: "* ]] || show "wanted their places"
  [[ ! -e out.h5 ]]
}

@test "errors: laws and their parameters" {
  off "contact.law: 'hertz' is not one of hertz-mindlin, linear, linear-adhesion; did you mean 'hertz-mindlin'?" contact.law=hertz
  off "contact.law: 'lineer' is not one of hertz-mindlin, linear, linear-adhesion; did you mean 'linear'?" contact.law=lineer
  off "contact.law: 3 is not a text" contact.law=3
  off "young_modulus: -1 is out of range: must be from 1000 to 1e13 Pa" contact.young_modulus=-1
  off "'nan' is not a finite number" contact.young_modulus=nan
  off "'inf' is not a finite number" contact.young_modulus=inf
  off "poisson_ratio: 0.7 is out of range: must be from 0 to 0.5" contact.poisson_ratio=0.7
  off "friction_angle: 95 is out of range: must be from 0 to 89.9 deg" contact.friction_angle=95
  off "restitution: 0 is out of range: must be between 0 and 1" contact.restitution=0
  off "contact.rolling: 1 is not a table" contact.rolling=1
  off "contact.rolling.limit: is missing; give \"none\" or" contact.rolling.stiffness=0.13
  off "'some' is not a number; or give \"none\"" contact.rolling.stiffness=0.1 contact.rolling.limit=some
  off "contact.rolling.scale: 'contcat' is not one of absolute, contact; did you mean 'contact'?" \
    contact.rolling.stiffness=0.1 contact.rolling.limit=none contact.rolling.scale=contcat
  sed 's/hertz-mindlin/linear/' short.toml > linear.toml
  exits 65 run-dem packing.h5 linear.toml -o out.h5
  [[ $stderr == *"unknown key 'contact.poisson_ratio'"* ]] || show "a key of another law"
  [[ $stderr == *"stiffness_ratio: is missing"* ]] || show "a key that is missing"
}

@test "errors: stages, steps and tolerances out of range; units of another kind" {
  off "stage.0.path: 'triaxal' is not one of constant-p, constant-volume, drive, free, isotropic, k0, triaxial, uniaxial; did you mean" \
    stage.0.path=triaxal
  off "stage: is not a list of tables; write [[stage]]" stage=1
  off "confining_pressure: -5 is out of range: must be between 0 and 1e12 Pa" stage.0.confining_pressure=-5
  off "'mm' does not measure what 'Pa' measures" "stage.0.confining_pressure=5 mm"
  off "'kilo' is not a known unit" "stage.0.confining_pressure=5 kilo"
  off "axial_strain: 3 is out of range: must be from -2 to 2" stage.0.axial_strain=3
  off "increment: 0 is out of range: must be between 0 and 1" stage.0.increment=0
  off "increment: is 0.5, beyond the strain of 0.002, so that the end alone would be recorded: if 0.5 % is meant, write \"0.5 %\"" \
    stage.0.increment=0.5
  off "rate: 1000 is out of range: must be between 0 and 1000 1/s" stage.0.rate=1000
  off "density: 0 is out of range: must be between 0 and 1e12 kg/m3" grains.density=0
  off "damping: 1 is out of range: must be from 0 to 0.999 (at 1 nothing would move)" numerics.damping=1
  off "time_step_safety: 1.2 is out of range" numerics.time_step_safety=1.2
  off "gravity: has 2 components; a vector has 3" "numerics.gravity=[0, 1]"
  off "unbalanced_force: 0 is out of range" equilibrium.unbalanced_force=0
  off "steps: 1.5 is not a whole number" equilibrium.steps=1.5
  off "'all' is not one of ends, stations, list" record.snapshots=all
  echo '# a scenario without stages' > empty.toml
  exits 65 run-dem packing.h5 empty.toml -o out.h5
  [[ $stderr == *"stage: is missing: a scenario has at least one [[stage]] with a path"* ]] || show "no stage"
}

# broken STATUS WORDS ARGUMENTS...: a guard ends the run with the words, says where the state and the last good one are,
# and the state can be looked at.
broken() {
  mentions "$1" run-dem "$2" --quiet packing.h5 short.toml "${@:3}" -o broken.h5
  [[ $stderr == *"; broken.h5.part/stopped.h5 shows it (to-vtk); broken.h5.part/state-000000000000.h5 is the last good state" ]] ||
    show "what is left"
  [[ ! -e broken.h5 ]] || show "an output all the same"
  exits 0 to-vtk --quiet --force broken.h5.part/stopped.h5 -o broken
  rm -r broken broken.h5.part
}

@test "a time step over the stable one is refused before it is taken, by --check too" {
  off "s is over the stable one of " numerics.time_step=1
  refuses 65 run-dem "lower numerics.time_step, or leave it out" --check packing.h5 short.toml --set numerics.time_step=1
}

@test "the servo of a packing with dashpots stays stable where steps are short" {
  run-dem --quiet packing.h5 short.toml --set contact.restitution=0.2 --set numerics.time_step_safety=0.1 -o short_steps.h5
}

@test "guards: what breaks says the step, who, how much and why, and leaves a state to look at" {
  broken 1 'stage "triaxial", station 1: not settled after 5 steps' --set equilibrium.steps=5
  broken 1 "is held back by its largest rate: raise max_rate" --set equilibrium.steps=50 --set stage.0.max_rate=1e-9 \
    --set 'stage.0.confining_pressure=300 kPa'
  broken 70 "% of guards.overlap" --set guards.overlap=0.02 --set 'stage.0.confining_pressure=1 MPa'
  broken 70 "of guards.energy_error" --set guards.energy_error=1e-12
  broken 70 "half of it or more: it would touch itself; strain it less" --set stage.0.axial_strain=1.5 \
    --set stage.0.increment=0.5 --set stage.0.rate=999 --set stage.0.max_rate=999 --set 'contact.friction_angle=0' \
    --set guards.overlap=1.9 --set guards.energy_error=1e9
}

@test "guards: of standard output nothing is kept, and the message says no more than is true" {
  call run-dem --quiet packing.h5 short.toml --set equilibrium.steps=5 -o -
  [[ $status -eq 1 && -z $output && $stderr != *part* && $stderr == *"not settled after 5 steps"* ]] || show
}

@test "errors: an output that cannot be made; one of another run is kept" {
  refused 73 ".: is a directory; name a file to be written" -o .
  refused 73 "out.h5/: is a directory; name a file to be written" -o out.h5/
  refused 73 "none/out.h5: cannot be created: none is not a directory; make it first" -o none/out.h5
  refused 73 "/proc/out.h5: cannot be created" -o /proc/out.h5
  cp packing.h5 mine.h5
  refused 73 "mine.h5: exists; give --force to overwrite it" -o mine.h5
  same_bytes packing.h5 mine.h5
  mentions 1 run-dem "not settled" --quiet packing.h5 short.toml --force --set equilibrium.steps=5 -o mine.h5
  same_bytes packing.h5 mine.h5
  exits 0 run-dem --quiet --force packing.h5 short.toml -o mine.h5
  same_bytes run.h5 mine.h5
  exits 74 bash -c 'run-dem --quiet packing.h5 short.toml -o - > /dev/full'
  said=$(without_doubts)
  [[ $said == "run-dem: standard output: "* && $said != *$'\n'* ]] || show "a full disk"
}

@test "a law with adhesion runs a triaxial test: contacts pull across gaps, and the soil is stronger" {
  for work in 0 20; do
    cat > "$work.toml" << TOML
[contact]
law = "linear-adhesion"
young_modulus = 5e8
stiffness_ratio = 0.1
friction_angle = 30
work_of_adhesion = $work
adhesion_range = "0.05 mm"
[equilibrium]
unbalanced_force = 1e-2
[[stage]]
path = "isotropic"
pressure = "100 kPa"
[[stage]]
path = "triaxial"
confining_pressure = "100 kPa"
axial_strain = 0.02
increment = 0.02
rate = 0.5
TOML
    exits 0 run-dem --quiet packing.h5 "$work.toml" -o "$work.h5"
  done
  "$PYTHON" - << 'END'
import h5py
with h5py.File("0.h5") as dry, h5py.File("20.h5") as moist:
    q = [f["series/deviatoric_stress"][-1] for f in (dry, moist)]
    assert q[1] > 1.02 * q[0], q
    last = moist["contacts"][sorted(moist["contacts"])[-1]]
    gap = last["overlap"][:] < 0
    assert gap.any() and (last["normal_force"][:][gap] < 0).all() and last["overlap"][:].min() > -5e-5 * (1 + 1e-9)
    assert abs(last["shear_force"][:][gap]).max() == 0
    error = abs(moist["series/energy_error"][-1])
    assert error < 1e-2 * abs(moist["series/boundary_work"][-1]), error
END
}
