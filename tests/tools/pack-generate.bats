#!/usr/bin/env bats
# pack-generate: packings from gradings and imports, the same bytes each time, and every class of error.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 -o packing.h5
  cat > open.txt << 'TXT'
1 1 1 0.5
3 1 1 0.5
1 3 1 0.4
TXT
}

setup() {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here" || return
  ln -s "$BATS_FILE_TMPDIR"/* .
}

# others STANDARDS ARGUMENT...: sets others to the options of a text, as "--grains=60 --aspect=1", that the arguments do not give.
others() {
  local option given=" ${*:2} "
  others=()
  for option in $1; do
    [[ $given == *" ${option%%=*}"[\ =]* ]] || others+=("$option")
  done
}

small() {
  others "--grains=60 --aspect=1 --pressure=1e5 --tolerance=1e-2" "$@"
  pack-generate --quiet "${others[@]}" "$@"
}

refused() {
  refuses "$1" pack-generate "$2" --quiet "${@:3}"
}

# unmade STATUS WORDS ARGUMENTS...: demands that for a small packing from nothing.
unmade() {
  others "--grains=60 --aspect=1 --tolerance=1e-2" "${@:3}"
  refused "${@:1:2}" "${others[@]}" "${@:3}"
}

@test "the same call gives the same bytes, with one thread and with four; another seed another packing" {
  local n
  for n in 1 4; do small --threads $n -o "$n.h5"; done
  same_bytes packing.h5 1.h5
  same_bytes 1.h5 4.h5
  OMP_NUM_THREADS=3 small -o variable.h5
  same_bytes 1.h5 variable.h5
  small --seed 1 -o other.h5
  other_bytes 1.h5 other.h5
}

@test "a pressure with a unit is the same pressure" {
  small --pressure 0.1MPa -o one.h5
  small --pressure "1e5 Pa" -o two.h5
  same_text <(homogenize --tsv one.h5) <(homogenize --tsv two.h5)
}

@test "the packing holds the pressure and the void ratio that were asked for" {
  small --void-ratio 0.7 -o dense.h5
  exits 0 homogenize --tsv dense.h5
  table 'NR == 2 { p = c("mean_stress"); e = c("void_ratio") } END { exit !(p > 0.98e5 && p < 1.02e5 && e > 0.698 && e < 0.702) }' \
    <<< "$output" || show "another packing"
}

@test "nobody at a terminal: quiet, and nothing but the packing on standard output" {
  local undoubted=(--grains 200 --aspect 1 --void-ratio 0.7 --pressure 1e5)
  pack-generate --quiet "${undoubted[@]}" -o file.h5
  pack-generate --quiet "${undoubted[@]}" -o - > piped.h5 2> said
  [[ ! -s said ]] || show "$(cat said)"
  pack-generate "${undoubted[@]}" -o - > loud.h5 2> said
  [[ ! -s said ]] || show "a short run needs no lines: $(cat said)"
  same_bytes file.h5 piped.h5
  same_bytes file.h5 loud.h5
}

@test "an import comes back as text, and its cell can be given" {
  pack-generate --quiet --import "$BATS_TEST_DIRNAME/examples/spheres.txt" --as-is -o imported.h5
  to-vtk --text imported.h5 | diff "$BATS_TEST_DIRNAME/examples/spheres.txt" -
  pack-generate --quiet --import open.txt --cell 4,4,4 --as-is -o closed.h5
  to-vtk --text closed.h5 | diff <(echo "##PERIODIC:: 4 4 4"; cat open.txt) -
  pack-generate --quiet --import packing.h5 --as-is -o again.h5
  same_text <(to-vtk --text packing.h5) <(to-vtk --text again.h5)
  to-vtk --history again.h5 | grep -q "command: pack-generate --grains 60"
}

# first_mass FILE: mass of the first grain over the cube of its radius.
first_mass() {
  "$PYTHON" -c 'import h5py, sys; g = h5py.File(sys.argv[1])["particles/grains"]; m, r = (g[n] for n in ("mass", "radius"))
m, r = (x["value"][-1] if hasattr(x, "keys") else x[()] for x in (m, r)); print(m.reshape(-1)[0] / r.reshape(-1)[0] ** 3)' "$1"
}

@test "an imported packing file keeps its masses, or takes the density that is asked for" {
  printf '[contact]\nlaw = "hertz-mindlin"\nyoung_modulus = "4 GPa"\npoisson_ratio = 0.33\nfriction_angle = 29\n' > m.toml
  printf '[grains]\ndensity = 2650\n' > dense.toml
  cat m.toml dense.toml > both.toml
  pack-generate --quiet --import packing.h5 --as-is --density 2650 -o option.h5
  pack-generate --quiet --import packing.h5 --as-is --material both.toml -o table.h5
  pack-generate --quiet --import packing.h5 --as-is --material m.toml -o kept.h5
  call pack-generate --import packing.h5 --as-is --density 2.65 -o light.h5
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $status -eq 0 && $stderr == *"doubt: grains have 2.65 kg/m3, where sand has 2650"* ]] || show
  near "$(first_mass option.h5)" 11100.3 1e-4
  near "$(first_mass table.h5)" 11100.3 1e-4
  near "$(first_mass kept.h5)" "$(first_mass packing.h5)" 1e-12
}

@test "a cell and grains in different units, and a --coarsest in mm, are doubted" {
  { echo "##PERIODIC:: 46 46 92"; echo "0.01 0.01 0.01 0.003"; echo "0.03 0.03 0.04 0.004"; } > mixed.txt
  call pack-generate --import mixed.txt --as-is -o mixed.h5
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $status -eq 0 && $stderr == *"doubt: the void ratio is "*"check that both have one unit of length"* ]] || show
  { echo "##PERIODIC:: 46 46 92"; echo "x [mm],y [mm],z [mm],r [mm]"; echo "10,10,10,3"; echo "30,30,40,4"; } > mm.csv
  { echo "##PERIODIC:: 0.046 0.046 0.092"; echo "0.01 0.01 0.01 0.003"; echo "0.03 0.03 0.04 0.004"; } > m.txt
  pack-generate --quiet --import mm.csv --as-is -o mm.h5
  pack-generate --quiet --import m.txt --as-is -o m.h5
  cmp <(to-vtk --text mm.h5 | awk '{ for (k = 1; k <= NF; ++k) printf "%.9s ", $k; print "" }') \
    <(to-vtk --text m.h5 | awk '{ for (k = 1; k <= NF; ++k) printf "%.9s ", $k; print "" }')
  call small --coarsest 0.15 -o all.h5
  [[ $status -eq 0 && $stderr == *"doubt: --coarsest leaves nothing out: it is 150 mm"* ]] || show
}

@test "grains as large as boulders are doubted, made or imported, as lengths in mm without their unit give" {
  call small --mean-radius 0.1 -o large.h5
  [[ $status -eq 0 && $stderr == *"doubt: the mean radius of the grains is 0.1 m, that of boulders: if 0.1 mm is meant"* ]] || show
  call small --mean-radius 0.1mm -o true.h5
  [[ $status -eq 0 && $stderr != *boulders* ]] || show "the remedy does not work"
  to-vtk --quiet --text true.h5 | awk '!/#/ { print 1e3 * $1, 1e3 * $2, 1e3 * $3, 1e3 * $4 }' > mm.txt
  call pack-generate --import mm.txt --cell 1,1,2 --as-is -o imported.h5
  [[ $status -eq 0 && $stderr == *"doubt: the mean radius of the grains is 0.1 m, that of boulders"* ]] || show
}

@test "errors: usage" {
  unmade 64 "--output is missing"
  unmade 64 "'extra' is one file too many" extra -o out.h5
  unmade 64 "-1 is out of range: must be between 0 and 1e12 Pa" --pressure -1 -o out.h5
  unmade 64 "'nan' is not a finite number" --pressure nan -o out.h5
  unmade 64 "'m' does not measure what 'Pa' measures" --pressure 5m -o out.h5
  unmade 64 "'kilo' is not a known unit" --pressure "5 kilo" -o out.h5
  unmade 64 "'' is not a number" --pressure "" -o out.h5
  unmade 64 "5 is out of range: must be from 10 to 1e8 (fewer cannot carry a load)" --grains 5 -o out.h5
  unmade 64 "'60.5' is not a whole number" --grains 60.5 -o out.h5
  unmade 64 "must be from 2 to 3" --dimension 4 -o out.h5
  unmade 64 "--void-ratio: 9 is out of range" --void-ratio 9 -o out.h5
  unmade 64 "--threads: 0 is out of range" --threads 0 -o out.h5
  unmade 64 "--seed: '-1' is not a whole number" --seed -1 -o out.h5
  refused 64 "--cell needs --import FILE" --cell 1,2,3 -o out.h5
  refused 64 "--as-is needs --import FILE" --as-is -o out.h5
  refused 64 "are of a new packing: leave them out with --import" --import open.txt --grains 500 -o out.h5
  refused 64 "--void-ratio has no effect beside --as-is: leave it out" --import packing.h5 --as-is --void-ratio 0.7 -o out.h5
  refused 64 "--cell: packing.h5 has a cell of its own" --import packing.h5 --cell 1,1,1 -o out.h5
  refused 64 "are of a new packing" --import packing.h5 --dimension 2 -o out.h5
  refused 64 "give three positive lengths, of disks two, in m" --import open.txt --cell 4 -o out.h5
  refused 64 "--dimension has no effect beside a --cell of disks: leave it out" --import open.txt --cell 4,4 --dimension 3 -o out.h5
  refused 64 "give three positive lengths, of disks two, in m" --import open.txt --cell 4,nan,4 -o out.h5
}

@test "errors: an input that is missing, a folder, damaged, or something else" {
  refused 66 "none.txt: no such file; check the path" --import none.txt -o out.h5
  unmade 66 "none.tsv: no such file" --grading none.tsv -o out.h5
  unmade 66 "none.toml: no such file" --material none.toml -o out.h5
  refused 65 ".: a directory; name a file in it" --import . -o out.h5
  unmade 65 ".: a directory; name a file in it" --grading . -o out.h5
  unmade 65 ".: a directory; name a file in it" --material . -o out.h5
  refused 65 "/dev/null: the file is empty (the spheres)" --import /dev/null -o out.h5
  head -c 3000 packing.h5 > cut.h5
  refused 65 "cut.h5: truncated: 3000 bytes of $(stat -Lc %s packing.h5)" --import cut.h5 --as-is -o out.h5
  cp open.txt words.h5
  refused 65 "words.h5: not an HDF5 file" --import words.h5 --as-is -o out.h5
  # A packing file is known by its first bytes too.
  cp packing.h5 packing.txt
  pack-generate --quiet --import packing.txt --as-is -o named.h5
  same_text <(to-vtk --text packing.h5) <(to-vtk --text named.h5)
  rm named.h5
  unmade 65 "packing.h5: an HDF5 file where a text belongs (the material)" --material packing.h5 -o out.h5
  homogenize --quiet packing.h5 -o fields.h5
  refused 65 "fields.h5: holds fields, but packing or run is needed here" --import fields.h5 --as-is -o out.h5
}

@test "errors: a file of a newer version" {
  "$PYTHON" -c 'import h5py' || skip "no Python with h5py"
  cp packing.h5 newer.h5
  "$PYTHON" -c "import h5py; h5py.File('newer.h5', 'r+').attrs['format_version'] = [2, 1]"
  refused 65 "newer.h5: has the format version 2.1, this program reads 1.3 at most" --import newer.h5 --as-is -o out.h5
}

@test "errors: sphere texts name line and column" {
  local text
  spheres() { printf '##PERIODIC:: 4 4 4\n1 1 1 0.5\n%s\n' "$1" > spheres.txt; }
  for text in nan inf -nan 1e999 x; do
    spheres "3 $text 1 0.5"
    refused 65 "spheres.txt: line 3, column 2: \"$text\" is no finite number" --import spheres.txt --as-is -o out.h5
  done
  spheres "3 1 1"
  refused 65 "spheres.txt: line 3, column 4: 3 values where 4 belong, separated by blanks" --import spheres.txt --as-is -o out.h5
  spheres "3 1 1 -0.5"
  refused 65 "spheres.txt: line 3, column 4: a radius that is not positive" --import spheres.txt --as-is -o out.h5
  printf '##PERIODIC:: 4 -4 4\n1 1 1 0.5\n' > spheres.txt
  refused 65 "line 1, column 2: a cell length that is not positive" --import spheres.txt --as-is -o out.h5
  printf '##PERIODIC:: 4 4\n1 1 1 0.5\n' > spheres.txt
  refused 65 "line 2: 4 numbers; without a header a line is x y r" --import spheres.txt --as-is -o out.h5
  printf '##PERIODIC:: 4\n1 1 1 0.5\n' > spheres.txt
  refused 65 "three cell lengths, of disks two, belong behind ##PERIODIC::" --import spheres.txt --as-is -o out.h5
}

@test "columns by name, disks and what was left out; the text comes back" {
  printf 'id,x [mm],y [mm],z [mm],diameter [mm]\r\n7,1000,1000,50,1000\r\n8,3000,1000,50,500\r\n' > rods.csv
  exits 0 pack-generate --import rods.csv --as-is -o spheres.h5
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $(without_doubts) == "pack-generate: rods.csv: columns left out: id; density and radius give the mass" ]] || show
  to-vtk --text spheres.h5 | diff <(printf '1 1 0.05 0.5\n3 1 0.05 0.25\n') -
  exits 0 pack-generate --import rods.csv --dimension 2 --cell 4,4 --as-is -o disks.h5
  [[ $stderr == *"rods.csv: read as disks, their common z left out"* ]] || show
  to-vtk --text disks.h5 > disks.txt
  diff <(printf '##PERIODIC:: 4 4\nx y r\n1 1 0.5\n3 1 0.25\n') disks.txt
  pack-generate --quiet --import disks.txt --as-is -o again.h5
  to-vtk --text again.h5 | diff disks.txt -
}

@test "what a refusal of another program's format names as a way to convert it works" {
  printf 'ITEM: TIMESTEP\n%s\nITEM: ATOMS id type x y z radius\n1 1 1 1 1 0.5\n2 1 3 1 1 0.5\n' 0 > FILE
  cat FILE FILE > twice && mv twice FILE
  converts() {
    call pack-generate --import FILE --as-is -o out.h5
    [[ $status -eq 65 && $stderr =~ by:\ (.*\>\ NEW) ]] || show
    eval "${BASH_REMATCH[1]}"
    pack-generate --quiet --import NEW --as-is --force -o out.h5
    to-vtk --text out.h5 | diff <(printf '1 1 1 0.5\n3 1 1 0.5\n') -
    rm out.h5
  }
  converts
  printf '2\nLattice="4 0 0 0 4 0 0 0 4" Properties=species:S:1:pos:R:3:radius:R:1\nA 1 1 1 0.5\nA 3 1 1 0.5\n' > FILE
  converts
  printf '%s\n' 'LSMGeometry 1.2' 'BoundingBox 0 0 0 4 4 4' BeginParticles Simple 2 '1 1 1 0.5 0 0' '3 1 1 0.5 1 0' EndParticles \
    BeginConnect '1 2 3 4 5 6' EndConnect > FILE
  converts
  printf '2 0 0 0 0 4 4 4\n1 1 1 0 0 0 0.5 0 0 0 0 0 0 0\n3 1 1 0 0 0 0.5 0 0 0 0 0 0 0\n9 9\n' > FILE
  converts
}

@test "errors: grains that overlap, that are too large for the cell, a cell that is not periodic" {
  printf '##PERIODIC:: 4 4 4\n1 1 1 0.5\n1.2 1 1 0.5\n' > deep.txt
  refused 65 "grains 0 and 1 overlap by 0.8 m, 160 % of the radius" --import deep.txt --as-is -o out.h5
  refused 65 "grains 0 and 1 overlap by 0.8 m" --import deep.txt -o out.h5
  printf '##PERIODIC:: 4 4 4\n1 1 1 0.5\n1 1 1 0.5\n' > twice.txt
  refused 65 "grains 0 and 1 overlap by 1 m" --import twice.txt --as-is -o out.h5
  printf '##PERIODIC:: 4 4 4\n1 1 1 0.5\n3 1 1 1.1\n' > large.txt
  refused 65 "(2.2 m across) is not smaller than half the cell along axis x" --import large.txt --as-is -o out.h5
  refused 65 "the packing's cell is not periodic" --import open.txt -o out.h5
}

@test "errors: too few grains for the cell they will have are told at once, with a number and a size that do" {
  local message="not less than half the cell: at least 2.03 are needed; leave out grains coarser than"
  unmade 65 "$message" --grains 20 --void-ratio 0.7 -o out.h5
  [[ $stderr =~ \(--coarsest\ ([0-9.]+mm)\),\ or\ take\ at\ least\ ([0-9]+)\ grains ]] || show "no remedy"
  local size=${BASH_REMATCH[1]} number=${BASH_REMATCH[2]}
  exits 0 small --grains "$number" --void-ratio 0.7 -o more.h5
  exits 0 small --grains 20 --void-ratio 0.7 --coarsest "$size" -o finer.h5
  unmade 65 "take at least 1600 grains (--grains)" --aspect 0.2 -o out.h5
  unmade 65 "at least 2.03 are needed; take at least 49 grains (--grains)" --grains 12 -o out.h5
  # A request for ten million steps must not wait for any of them.
  SECONDS=0
  unmade 65 "not less than half the cell" --grains 20 --void-ratio 0.7 --max-rate 1e-6 -o out.h5
  [[ $SECONDS -le 5 ]] || show "noticed after $SECONDS s"
}

@test "sand of true size packs at the first command, and the file states the stiffness that belongs to it" {
  printf 'diameter [mm]\tfiner_by_mass [1]\tdepth [m]\n0.1\t0\t2\n0.2\t0.5\t2\n0.4\t1\t2\n' > sand.tsv
  exits 0 pack-generate --grading sand.tsv --grains 200 --aspect 1 --void-ratio 0.7 --pressure 1e5 -o sand.h5
  [[ $stderr == *"pack-generate: sand.tsv: columns left out: depth"* ]] || show
  to-vtk --history sand.h5 | grep -q 'stiffness = [0-9.]*e-0[67]' || show "$(to-vtk --history sand.h5)"
  to-vtk --history packing.h5 | grep -q 'stiffness = 0.13$' || show "$(to-vtk --history packing.h5)"
}

@test "a wide grading gets the grains it needs unless a number is given" {
  printf 'diameter [mm]\tfiner_by_mass [1]\n1\t0\n1.5\t0.4\n3\t0.8\n6\t1\n' > wide.tsv
  unmade 65 "take at least" --grading wide.tsv --grains 200 --aspect 0.5 --void-ratio 0.5 -o wide.h5
  exits 1 pack-generate --grading wide.tsv --aspect 0.5 --void-ratio 2 --pressure 1e7 --tolerance 5e-2 -o wide.h5
  [[ $stderr == *"ask for at most"* ]] || show "the grains did not come together"
}

@test "what is doubtful is said and lies in the file" {
  exits 0 small -o doubtful.h5
  [[ $stderr == *"pack-generate: doubt: the coordination number is "* && $stderr == *"diameters of the largest grain wide, below 3"* ]] ||
    show "nothing said"
  to-vtk --history doubtful.h5 | grep -q "coordination number" || show "not in the file"
  printf '[contact]\nlaw = "hertz-mindlin"\nyoung_modulus = "4 GPa"\npoisson_ratio = 0.33\nfriction_angle = 29\n' > m.toml
  printf '[contact.rolling]\nstiffness = 13\nlimit = "none"\n' >> m.toml
  exits 0 small --material m.toml -o stiff.h5
  [[ $stderr == *"doubt: rolling stiffness 13 N m/rad is 1e+02 times what belongs"* ]] || show "no doubt"
}

@test "errors: what cannot come to rest is told before the first step" {
  SECONDS=0
  unmade 65 "would overlap by about" --pressure 1e9 -o out.h5
  unmade 65 "raise the rate to" --density 2650 --max-rate 1e-4 -o out.h5
  [[ $SECONDS -le 5 ]] || show "noticed after $SECONDS s"
}

@test "errors: gradings" {
  printf 'diameter [mm]\tfiner_by_mass [1]\n2\t0.5\n1\t1\n' > grading.tsv
  unmade 65 "grading.tsv: row 2: diameter 1 is not above the one before" --grading grading.tsv -o out.h5
  printf 'diameter [mm]\tfiner_by_mass [1]\n1\t0.5\n2\t0.9\n' > grading.tsv
  unmade 65 "grading.tsv: the last finer_by_mass is 0.9, not all: add the row" --grading grading.tsv -o out.h5
  printf 'diameter [mm]\tfiner_by_mass [1]\n1\tnan\n2\t1\n' > grading.tsv
  unmade 65 "grading.tsv: row 1: finer_by_mass nan must rise from 0 to 1" --grading grading.tsv -o out.h5
  printf 'diameter [inch]\tfiner_by_mass [1]\n1\t0.5\n2\t1\n' > grading.tsv
  unmade 65 "grading.tsv: column diameter: 'inch' is not a known unit; known: m, mm" --grading grading.tsv -o out.h5
  printf 'size [mm]\tfiner_by_mass [1]\n1\t0.5\n2\t1\n' > grading.tsv
  unmade 65 "grading.tsv: no column diameter among size, finer_by_mass: head the columns diameter [mm] and finer_by_mass [%]" \
    --grading grading.tsv -o out.h5
  printf 'Diameter [mm]\tfiner_by_mass [1]\n1\t0.5\n2\t1\n' > grading.tsv
  unmade 65 "did you mean diameter instead of Diameter?" --grading grading.tsv -o out.h5
  printf 'Diameter [mm]\tdiameter [m]\tfiner_by_mass [1]\n1\t1\t1\n' > grading.tsv
  unmade 65 "grading.tsv: its columns diameter and Diameter could both be meant: leave one of them out, and head the other diameter" \
    --grading grading.tsv -o out.h5
  printf 'diameter [mm],finer_by_mass [%%],finer_by_mass_upper [%%]\n1,0,10\n2,100,100\n' > grading.tsv
  unmade 65 "its columns finer_by_mass and finer_by_mass_upper could both be meant" --grading grading.tsv -o out.h5
  printf 'diameter [mm]\tfiner_by_mass [1]\n1 0.5\n' > grading.tsv
  unmade 65 "grading.tsv: line 2, column 2: 1 values where the header names 2 columns" --grading grading.tsv -o out.h5
}

@test "errors: materials" {
  material() {
    printf '[contact]\nlaw = "linear"\nyoung_modulus = "0.5 GPa"\nstiffness_ratio = 0.1\n%s\n' "$1" > m.toml
  }
  material 'friction_angle = 90'
  unmade 65 "m.toml:5: contact.friction_angle: 90 is out of range: must be from 0 to 89.9 deg (the tangent" \
    --material m.toml -o out.h5
  material 'friction_angel = 30'
  unmade 65 "unknown key 'contact.friction_angel'; did you mean 'friction_angle'?" --material m.toml -o out.h5
  material 'friction_angle = "30 Pa"'
  unmade 65 "m.toml:5: contact.friction_angle: 'Pa' does not measure what 'deg' measures" --material m.toml -o out.h5
  material $'friction_angle = 30\n[grains]\ndensity = 2650'
  unmade 64 "--density: m.toml has another grains.density: leave one of the two out" --density 1e6 --material m.toml -o out.h5
  [[ ! -e out.h5 ]]
}

@test "errors: void ratios out of reach say what was reached and why" {
  unmade 1 "without friction the packing stays at 0." --void-ratio 0.2 -o out.h5
  [[ $stderr =~ ask\ for\ one\ from\ (0\.[0-9]+) ]] || show "no range"
  exits 0 small --void-ratio "${BASH_REMATCH[1]}" -o dense.h5
  unmade 1 "at the full friction angle of 29 deg the packing is already at 0." --void-ratio 1.5 -o out.h5
}

@test "errors: an output that cannot be made; one of another run is kept" {
  unmade 73 ".: is a directory; name a file to be written" -o .
  unmade 73 "out.h5/: is a directory; name a file to be written" -o out.h5/
  unmade 73 "none/out.h5: cannot be created: none is not a directory; make it first" -o none/out.h5
  unmade 73 "/proc/out.h5: cannot be created" -o /proc/out.h5
  cp packing.h5 mine.h5
  unmade 73 "mine.h5: exists; give --force to overwrite it" --seed 7 -o mine.h5
  same_bytes packing.h5 mine.h5
  exits 0 small --seed 7 --force -o mine.h5
  other_bytes packing.h5 mine.h5
  # A later error keeps the former file too.
  cp packing.h5 mine.h5
  unmade 1 "is not reached" --void-ratio 0.2 --force -o mine.h5
  same_bytes packing.h5 mine.h5
}
