#!/usr/bin/env bats
# fem-dem: the same bytes on any number of threads and after a stop, grains of a point taken out, and every class of error.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  cp "$BATS_TEST_DIRNAME/examples/pull.toml" elastic.toml
  # A mesh with grains instead.
  awk '/^material/ { print "material = \"grains\""; next } /^(density|young|poisson|initial_stress)/ { next }
    /^columns/ { print "columns = 2"; next } /^rows/ { print "rows = 1"; next } { print }' elastic.toml > grains.toml
  cat >> grains.toml << 'TOML'
[contact]
law = "linear"
young_modulus = "7.5 GPa"
stiffness_ratio = 0.2
friction_angle = 16
[grains]
density = 2700
[record]
points = [1]
TOML
  sed 's/^friction_angle.*/friction_angle = 0/; /^\[record\]/,$d' <(sed -n '/^\[contact\]/,$p' grains.toml) > material.toml
  pack-generate --quiet --dimension 2 --grains 40 --aspect 1 --pressure 2e4 --tolerance 1e-2 --material material.toml \
    --density 2700 -o disks.h5
  pack-generate --quiet --dimension 2 --grains 10 --aspect 1 --pressure 2e4 --tolerance 5e-2 --material material.toml \
    --density 2700 -o few.h5
  sed '/^friction_angle/s/=.*/= 16/' material.toml > bring.toml
  printf '[[stage]]\npath = "isotropic"\npressure = "20 kPa"\n' >> bring.toml
  fem-dem --quiet grains.toml disks.h5 --set time.duration=0.02 --set time.output_interval=0.01 -o run.h5
}

setup() {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here" || return
  ln -s "$BATS_FILE_TMPDIR"/* .
}

SHORT=(--set time.duration=0.02 --set time.output_interval=0.01)

@test "the same bytes with 1, 2 and 3 threads" {
  local n
  for n in 1 2 3; do fem-dem --quiet --threads $n grains.toml disks.h5 "${SHORT[@]}" -o "$n.h5"; done
  same_bytes run.h5 1.h5
  same_bytes 1.h5 2.h5
  same_bytes 1.h5 3.h5
}

@test "stopped at any time it goes on to the same bytes" {
  local wait
  for wait in 0.05 0.13 0.29; do
    timeout --preserve-status -s TERM $wait fem-dem --quiet grains.toml disks.h5 "${SHORT[@]}" --checkpoint-every 0.02 -o stopped.h5 &&
      same_bytes run.h5 stopped.h5 && rm stopped.h5 && continue
    fem-dem --quiet grains.toml disks.h5 "${SHORT[@]}" --resume --threads 2 -o stopped.h5
    same_bytes run.h5 stopped.h5
    rm stopped.h5
  done
  # --foreground: without it timeout is killed too, and the lock may outlast it.
  timeout --foreground -s KILL 0.3 fem-dem --quiet grains.toml disks.h5 "${SHORT[@]}" --checkpoint-every 0.02 -o killed.h5 || true
  [[ -e killed.h5 ]] || fem-dem --quiet grains.toml disks.h5 "${SHORT[@]}" --resume -o killed.h5
  same_bytes run.h5 killed.h5
}

@test "an elastic soil sets the problem up in seconds, --check says what it takes" {
  exits 0 fem-dem --check elastic.toml
  [[ $output == *"36 elements of the shape triangle3"* && $output == *"stability limit"* && $output == *"about "*" s on 1 thread"* ]] ||
    show "no forecast"
  refuses 64 fem-dem "--output has no effect beside --check: leave it out" --check elastic.toml -o elastic.h5
  refuses 64 fem-dem "--resume has no effect beside --check: leave it out" --check elastic.toml --resume
  fem-dem --quiet elastic.toml -o elastic.h5
  refuses 64 fem-dem "--resume has no effect beside --take and --table: leave it out" --table series elastic.h5 --resume
  refuses 64 fem-dem "--force has no effect without a file to write: leave it out" --table series elastic.h5 --force
  exits 0 fem-dem --table series elastic.h5
  [[ $(wc -l <<< "$output") -eq 5 ]] || show "wanted a header and four states"
  # Energy: the error of the balance is below 1 % of the work.
  table '{ w = c("external_work"); e = c("energy_error") }
    END { exit !(w > 0 && e < 0.01 * w && e > -0.01 * w) }' <<< "$output"
}

@test "a rolling stiffness of grains of another size is doubted" {
  exits 0 fem-dem --check grains.toml disks.h5
  # shellcheck disable=SC2154  # set by exits
  [[ $stderr != *"rolling stiffness"* ]] || show
  exits 0 fem-dem --check grains.toml disks.h5 --set contact.rolling.stiffness=1e4 --set contact.rolling.limit=0.2
  [[ $stderr == *"fem-dem: doubt: rolling stiffness 1e+04 N m/rad is "*" times what belongs to grains of "*" mean radius: write "* ]] || show
}

@test "packings that another contact law brings to another stress are doubted, and too few or too sticky grains" {
  local words="fem-dem: doubt: the points begin at a mean stress of 200 kPa, and the packing's file has 20: the scenario has another law, stiffness or friction"
  exits 0 fem-dem --check grains.toml disks.h5 --set contact.young_modulus=7.2e9
  # shellcheck disable=SC2154  # set by exits
  [[ $stderr != *"another law"* ]] || show "a tenth is no jump"
  exits 0 fem-dem --check grains.toml disks.h5 --set contact.young_modulus=7.5e10
  [[ $stderr == *"$words"* ]] || show
  exits 0 fem-dem --quiet grains.toml disks.h5 --set contact.young_modulus=7.5e10 "${SHORT[@]}" -o stiff.h5
  [[ $stderr == *"$words"* ]] || show "wanted it of the run, too"
  [[ $(to-vtk --history stiff.h5) == *"doubt: jump: the points begin"* ]] || show "not in the file"
  # The remedy works.
  run-dem --quiet disks.h5 bring.toml --set contact.young_modulus=7.5e10 -o brought.h5
  exits 0 fem-dem --check grains.toml brought.h5 --set contact.young_modulus=7.5e10
  [[ $stderr != *doubt* ]] || show "the remedy does not do"
  exits 0 fem-dem --check grains.toml disks.h5 disks.h5 brought.h5 disks.h5
  [[ $stderr == *"fem-dem: doubt: packing 3 of 4: the points begin at a mean stress of 2 kPa, and the packing's file has 20"* ]] || show
  exits 0 fem-dem --check grains.toml disks.h5 --set 'contact.law="linear-adhesion"' --set contact.work_of_adhesion=1e-9 \
    --set contact.adhesion_range=2e-3
  [[ $stderr == *"fem-dem: doubt: adhesion acts across gaps of up to 2 mm, "* ]] || show
  exits 0 fem-dem --check grains.toml few.h5
  [[ $stderr == *"fem-dem: doubt: the cell is "*" diameters of the largest grain "*" wide along "* ]] || show
}

# starts WORDS INPUTS AND SETS: demands that --check doubts with the words how the soil starts; without words, that it does not.
starts() {
  local words=$1
  shift
  exits 0 fem-dem --check "$@"
  [[ -n $words && $stderr == *"fem-dem: doubt: $words"* || -z $words && $stderr != *"at the start balances"* ]] || show "wanted: $words"
}

@test "loads that the initial stress does not balance are doubted, and a missing kPa asked for" {
  local top='the traction on "top" is ' soil="kPa along y, and the soil's stress at the start balances "
  starts "" elastic.toml
  starts "" elastic.toml --set 'traction.0.y="-18.5 kPa"'
  starts "$top-0.02 ${soil}-20 kPa there: the soil would oscillate; if -20 kPa is meant, write \"-20 kPa\"" elastic.toml --set traction.0.y=-20
  starts "$top-20 ${soil}-0.02 kPa there: the soil would oscillate; if an initial stress of 20 kPa is meant, write \"20 kPa\"" \
    elastic.toml --set 'soil.initial_stress=[10,20,10]'
  starts "$top-25 ${soil}-20 kPa there: the soil would oscillate; make the two equal, unless a sudden load is meant" \
    elastic.toml --set 'traction.0.y="-25 kPa"'
  starts "${top}20 ${soil}-20 kPa" elastic.toml --set 'traction.0.y="20 kPa"'
  starts "${top}5 kPa along x, and the soil's stress at the start balances 0 kPa there" elastic.toml --set 'traction.0.x="5 kPa"'
  starts "the seat pressure on \"bottom\" is 0.02 ${soil}20 kPa there: the soil would oscillate; if 20 kPa is meant, write \"20 kPa\"" \
    elastic.toml --set geosynthetic.seat_pressure=20
  # Supports hold the boundary, or there is no stress at all.
  starts "" elastic.toml --set 'traction.0.on="left"' --set 'traction.0.x="90 kPa"' --set traction.0.y=0
  starts "" elastic.toml --set 'soil.initial_stress=[0,0,0]'
  # Packings have an initial stress, too.
  starts "" grains.toml disks.h5
  starts "$top-0.02 ${soil}-" grains.toml disks.h5 --set traction.0.y=-20
  starts "$top-200 ${soil}-" grains.toml disks.h5 --set 'traction.0.y="-200 kPa"'
  [[ $stderr == *"; make the two equal, as by run-dem on the packings, unless a sudden load is meant" ]] || show
  run-dem --quiet disks.h5 bring.toml --set stage.0.pressure=2e5 -o brought.h5
  starts "" grains.toml brought.h5 --set 'traction.0.y="-200 kPa"' --set 'geosynthetic.seat_pressure="200 kPa"'
  # The run says it, and its file.
  exits 0 fem-dem --quiet elastic.toml --set traction.0.y=-20 "${SHORT[@]}" -o sprung.h5
  [[ $stderr == "fem-dem: doubt: $top-0.02 "* && $(to-vtk --history sprung.h5) == *"doubt: load_unbalanced: $top-0.02 "* ]] || show
}

@test "a mesh in mm is told by its extent and by a run that is too short for it" {
  exits 0 fem-dem --check elastic.toml
  # shellcheck disable=SC2154  # set by exits
  [[ $output == *" points, 0.6 m by 0.3 m"* && $stderr != *doubt* ]] || show
  exits 0 fem-dem elastic.toml --set time.duration=0.001 -o short.h5
  [[ $stderr == *"fem-dem: the mesh is 0.6 m by 0.3 m"* ]] || show
  [[ $stderr == *"fem-dem: doubt: the mesh is 0.6 m by 0.3 m, and an elastic wave of 46.1 m/s takes 0.0065 s along its shorter side, but the run ends after 0.001 s: no load gets through the soil; "* ]] || show
  [[ $stderr == *"fem-dem: doubt: the run has "*" steps of "*", fewer than 30: no response develops; "* ]] || show
  to-vtk --history short.h5 > history
  [[ $(grep -c "  doubt: wave: \|  doubt: few_steps: " history) -eq 2 ]] || show "not in the file"
}

@test "a run ends at its duration, whatever its interval" {
  fem-dem --quiet elastic.toml --set time.output_interval=5 -o once.h5
  exits 0 fem-dem --table series --columns time once.h5
  [[ ${lines[*]} == "time [s] 0 0.3" ]] || show "wanted the start and the end"
  exits 0 fem-dem --check elastic.toml --set time.output_interval=0.2
  [[ $output == *" 2 outputs"* ]] || show "wanted one at 0.2 s and one at the end"
}

@test "the grains of a point are a run, the whole is shown by to-vtk" {
  fem-dem --take 1 run.h5 -o point.h5
  exits 0 homogenize point.h5 --tsv
  [[ $(wc -l <<< "$output") -eq 4 ]] || show "wanted a header and three states"
  exits 0 fabric point.h5 --tsv
  to-vtk --quiet run.h5 -o shown
  [[ -e shown/soil.pvd && -e shown/soil_000002.vtu && -e shown/geosynthetic_000002.vtp && -e shown/series.csv ]] || show "$(ls shown)"
  mentions 65 fem-dem "name it in record.points" --take 0 run.h5 -o point0.h5
  mentions 64 fem-dem "--take 1.5: points are whole numbers" --take 1.5 run.h5 -o point.h5
  mentions 64 fem-dem "has the tables loading, series, elements, nodes, points, bars, recorded" --table nods run.h5
}

@test "a run says how it was loaded, what a place went through, and what there was at the end" {
  exits 0 fem-dem --table loading --columns time,traction_y_bottom,interface_friction run.h5
  [[ ${lines[0]} == $'time [s]\ttraction_y_bottom [Pa]\tinterface_friction [1]' && ${#lines[@]} -eq 4 ]] || show "another table"
  exits 0 fem-dem --table points --near 0.1,0 --columns time,point run.h5
  [[ ${#lines[@]} -eq 4 && ${lines[1]} == $'0\t0' && ${lines[3]} == *$'\t0' ]] || show "not the point at the left end"
  exits 0 fem-dem --table nodes --state last --columns node run.h5
  [[ $output == $'node [1]\n0\n1\n2\n3\n4\n5' ]] || show "not the six nodes of one state"
  mentions 64 fem-dem "lies outside of the soil, which reaches from 0,0 to 0.6,0.3 m" --table points --near 0.7,0 run.h5
  mentions 64 fem-dem "--near 0.6: give x and y in m" --table points --near 0.6 run.h5
  mentions 64 fem-dem "belong to --table" --near 0.1,0 run.h5
  mentions 64 fem-dem "no column 'traction_bottom'; did you mean" --table loading --columns traction_bottom run.h5
  mentions 64 fem-dem "--table prints: leave -o out" --table loading run.h5 -o table.tsv
}

@test "what does not fit is refused before anything runs" {
  refuses 65 fem-dem 'no boundary "botom"; did you mean '"'bottom'" elastic.toml --set 'geosynthetic.along="botom"' -o out.h5
  refuses 65 fem-dem "did you mean 'left'" elastic.toml --set 'support.0.on="lefd"' -o out.h5
  refuses 65 fem-dem "is over the stable one" elastic.toml --set time.step=0.1 -o out.h5
  refuses 65 fem-dem "no packing is given" grains.toml -o out.h5
  refuses 65 fem-dem "2 packings are given for 4 points" grains.toml disks.h5 disks.h5 -o out.h5
  refuses 65 fem-dem "2 packings are given, and the soil is a continuum, which holds none: leave them out, or give soil.material = \"grains\"" \
    elastic.toml disks.h5 disks.h5 -o out.h5
  refuses 65 fem-dem "1 packing is given, and the soil is a continuum" --check elastic.toml disks.h5 --set 'soil.material="mohr-coulomb"' \
    --set soil.friction_angle=30
  refuses 64 fem-dem "--take and --table read one file of fem-dem: leave further inputs, --mesh and --set out" --table series run.h5 disks.h5
  refuses 64 fem-dem "--take and --table read one file of fem-dem" --take 1 run.h5 --set time.duration=1 -o out.h5
  refuses 65 fem-dem "did you mean 'stiffness'" elastic.toml --set geosynthetic.stifness=1 -o out.h5
  refuses 65 fem-dem 'traction.0.on: boundary "bottom-corners" has points alone' elastic.toml --set 'traction.0.on="bottom-corners"' -o out.h5
  refuses 65 fem-dem 'geosynthetic.along: boundary "bottom-corners" has points alone' elastic.toml --set 'geosynthetic.along="bottom-corners"' -o out.h5
  refuses 65 fem-dem 'move their common node at (0.6, 0) m differently along x' elastic.toml --set 'support.0.on="bottom"' --set 'support.1.x=0.1' -o out.h5
  refuses 65 fem-dem 'geosynthetic.radius: 5 m, where the boundary that the chain follows is 0.6 m long; at most 0.3 m; if 5 mm are meant, write "5 mm"' \
    elastic.toml --set geosynthetic.radius=5 -o out.h5
  refuses 65 fem-dem 'geosynthetic.spacing: 20 m, where' elastic.toml --set geosynthetic.spacing=20 -o out.h5
  refuses 65 fem-dem 'geosynthetic.overhang: 10 m, where' elastic.toml --set geosynthetic.overhang=10 -o out.h5
  refuses 65 fem-dem "this soil is a continuum" elastic.toml --set 'record.points=[1]' -o out.h5
  printf 'solid\n' > wrong.msh
  refuses 65 fem-dem "wrong.msh:1: the mesh" elastic.toml --mesh wrong.msh -o out.h5
  refuses 64 fem-dem "name the file to write with -o" elastic.toml
}

@test "a seat pressure needs guides below the whole chain: a mesh wider than them is refused, and the guide that is named carries it" {
  local wide=(--quiet elastic.toml --set mesh.width=6 --set mesh.height=3 "${SHORT[@]}")
  local none='geosynthetic.seat_pressure: the chain finds no rest on its guides before the start: no guide lies two radii below'
  mentions 65 fem-dem "$none 260 of its 300 bars, between (0.81, -0.01) and (5.99, -0.01) m; to carry the whole chain, give a [[geosynthetic.guide]] from = [0, -0.02], to = [6, -0.02], or take a mesh no wider than the guides" \
    "${wide[@]}" -o wide.h5
  exits 0 fem-dem "${wide[@]}" --set 'geosynthetic.guide.0.from=[0, -0.02]' --set 'geosynthetic.guide.0.to=[6, -0.02]' -o wide.h5
  [[ $stderr != *guide* ]] || show
  sed '/^\[\[geosynthetic.guide/,/^holds_soil/d' elastic.toml > bare.toml
  mentions 65 fem-dem "$none 30 of its 30 bars" --quiet bare.toml "${SHORT[@]}" -o bare.h5
  [[ $stderr == *"to = [0.6, -0.02]" ]] || show
  # Far below the chain.
  mentions 65 fem-dem "$none 30 of its 30 bars" --quiet elastic.toml --set 'geosynthetic.guide.0.from=[-0.1, -0.2]' --set 'geosynthetic.guide.0.to=[0.8, -0.2]' -o low.h5
  # No guide carries a chain that lies on the soil.
  mentions 65 fem-dem "the seat pressure acts against y, and its bars do not lie below the soil: leave geosynthetic.seat_pressure out" \
    --quiet elastic.toml --set 'geosynthetic.along="top"' -o top.h5
  # A part of the chain may hang over a hole.
  exits 0 fem-dem --quiet elastic.toml --set 'geosynthetic.guide.0.to=[0.3, -0.02]' "${SHORT[@]}" -o hole.h5
  [[ $stderr == *"doubt: the geosynthetic bears its seat pressure as a hanging chain, since no guide lies two radii below 15 of its 30 bars"* ]] || show
}

# mesh TRIANGLE...: prints two triangles of a unit square, by nodes counter-clockwise from (0, 0), with a word for each.
# shellcheck disable=SC2016  # Gmsh's dollars, not the shell's
mesh() {
  printf '%s\n' '$MeshFormat' '2.2 0 8' '$EndMeshFormat' '$PhysicalNames' 2 '1 1 "bottom"' '1 2 "top"' '$EndPhysicalNames' '$Nodes' 4 \
    '1 0 0 0' '2 1 0 0' '3 1 1 0' '4 0 1 0' '$EndNodes' '$Elements' $(($# + 2)) '1 1 2 1 1 1 2' '2 1 2 2 2 3 4'
  local number=3 nodes
  for nodes; do printf '%d 2 2 %d 1 %s\n' $number $(((number - 1) / 2)) "$nodes" && number=$((number + 1)); done
  printf '%s\n' '$EndElements'
}

@test "meshes of Gmsh are read as they are, and what was done to them is said" {
  sed '/^\[mesh\]/,/^rows/d; /^\[geosynthetic\]/,/^holds_soil/d; s/"\(left\|right\)"/"bottom"/; s/^x = 0/&\ny = 0/; s/^density.*/&\ndamping = 100/' elastic.toml \
    > square.toml
  mesh "1 2 3" "1 3 4" > plain.msh
  mesh "1 2 3" "1 3 4" "1 2 3" "1 3 4" > groups.msh
  mesh "3 2 1" "1 3 4" > clockwise.msh
  local file
  fem-dem --quiet square.toml --mesh plain.msh -o plain.h5
  fem-dem --table series plain.h5 > plain.tsv
  for file in groups clockwise; do
    exits 0 fem-dem --quiet square.toml --mesh $file.msh -o $file.h5
    [[ $file == groups || $stderr == "fem-dem: doubt: clockwise.msh: 1 of 2 elements, element 3 the first, are clockwise: turned round" ]] ||
      show "not said"
    fem-dem --table series $file.h5 > $file.tsv
    near "$(value $file.tsv external_work last)" "$(value plain.tsv external_work last)" 1e-9
  done
  to-vtk --history clockwise.h5 | grep -q mesh_turned || show "not in the file"
  sed 's/^4 2 2 1/4 2 2 9/' plain.msh > parted.msh
  exits 0 fem-dem --check square.toml --mesh parted.msh
  [[ $stderr == "fem-dem: doubt: parted.msh: all elements become one soil"*'"1" (1 of 2), "9" (1 of 2)'* ]] || show "not said"
  mesh "1 2 3" "1 2 4" > overlap.msh
  refuses 65 fem-dem "overlap.msh:21: element 4 and element 3 lie on the same side" square.toml --mesh overlap.msh -o out.h5
  printf '\0' >> plain.msh
  refuses 65 fem-dem "a binary Gmsh mesh" square.toml --mesh plain.msh -o out.h5
}

@test "what breaks is named, and left to be looked at" {
  mentions 70 fem-dem "of the geosynthetic broke: its tension of" --quiet elastic.toml --set "geosynthetic.strength=500 N/m" -o out.h5
  # shellcheck disable=SC2154  # set by mentions
  [[ $stderr == *"step "* && $stderr == *"out.h5.part/stopped.h5 shows it"* ]] || show "no state to look at"
  to-vtk --quiet out.h5.part/stopped.h5 -o broken
  [[ -e broken/soil_000001.vtu || -e broken/soil_000000.vtu ]]
  exits 70 fem-dem --quiet grains.toml disks.h5 --set 'traction.0.y="-500 MPa"' -o crushed.h5
  [[ $(without_doubts) == "fem-dem: "*"element 0, point 0 at"* ]] || show "no element or no point"
  exits 70 fem-dem --quiet grains.toml few.h5 --set 'record.points=[]' --set 'traction.0.y="-5 MPa"' -o narrow.h5
  [[ $(without_doubts) == "fem-dem: "*": element "*", point "*"the largest grain is"*"half of it or more"*"narrow.h5.part/stopped.h5 shows it"* ]] || show "no element or no state"
}

@test "a quasi-static run comes to rest at every output" {
  fem-dem --quiet elastic.toml --set quasi_static.kinetic_energy=1e-4 --set quasi_static.soil_damping=100 \
    --set 'geosynthetic.end.x="5 cm/s"' -o quiet.h5
  exits 0 fem-dem --table series quiet.h5
  table 'NR > 2 && c("soil_kinetic_energy") > 1e-4 { bad = 1 } END { exit bad || NR < 3 }' <<< "$output"
  mentions 1 fem-dem "not at rest after 2 steps" --quiet elastic.toml --set quasi_static.kinetic_energy=1e-12 \
    --set quasi_static.steps=2 -o never.h5
}

@test "a soil that still swings at the end of a run is doubted, and the remedies work" {
  sed '/^\[geosynthetic\]/,/^holds_soil/d; s/^on = "right"/on = "bottom"/; s/^columns.*/columns = 2/; s/^rows.*/rows = 1/
    /^initial_stress/d' elastic.toml | awk '/^on = "bottom"/ { print; getline; print "y = 0"; next } { print }' > pressed.toml
  local words="fem-dem: doubt: the soil is not at rest at the end: it swings by about " remedy time
  exits 0 fem-dem --quiet pressed.toml -o whole.h5
  # shellcheck disable=SC2154  # set by exits
  [[ $stderr == "$words"*" % of the change that its loads cause, so that stresses and displacements vary in time; to bring it to rest, give quasi_static.kinetic_energy = "*", or soil.damping = "* ]] || show
  [[ $(to-vtk --history whole.h5) == *"doubt: unrest: the soil is not at rest"* ]] || show "not in the file"
  remedy=${stderr##*give }
  # Every phase is doubted.
  for time in 0.29 0.294 0.298 0.302 0.306; do
    exits 0 fem-dem --quiet pressed.toml --set time.duration=$time --force -o phase.h5
    [[ $stderr == "$words"* ]] || show "nothing at $time s"
  done
  local -a mended
  for time in "${remedy%%, or*}" "${remedy##*, or }"; do
    mended=(--set "${time// = /=}")
    exits 0 fem-dem --quiet pressed.toml "${mended[@]}" --force -o rest.h5
    [[ -z $stderr ]] || show "$time does not do"
    fem-dem --table series rest.h5 > rest.tsv
    near "$(value rest.tsv reaction_y_bottom last)" 12000 0.01
  done
  exits 0 fem-dem --quiet pressed.toml --set quasi_static.kinetic_energy=1 -o loose.h5
  [[ $stderr == "$words"*"to bring it to rest, give quasi_static.kinetic_energy = "* ]] || show
  # A run that goes on ends in the same bytes, also beside packings.
  local -a swinging=(grains.toml disks.h5 --set geosynthetic.end.x=0 --set 'traction.0.y="-30 kPa"' --set time.duration=0.05)
  exits 0 fem-dem --quiet "${swinging[@]}" -o swung.h5
  [[ $stderr == *"$words"* ]] || show
  timeout --preserve-status -s TERM 0.1 fem-dem --quiet "${swinging[@]}" --checkpoint-every 0 -o stopped.h5 ||
    fem-dem --quiet "${swinging[@]}" --resume -o stopped.h5
  same_bytes swung.h5 stopped.h5
  # Where something is driven, forces out of balance are told instead. Nothing is said where the loads are balanced.
  exits 0 fem-dem --quiet pressed.toml --set support.1.y=-0.001 -o driven.h5
  [[ $stderr == "fem-dem: doubt: the soil does not follow what drives it: forces of inertia and damping are "*" % of its internal forces at the end; where slow loading is meant, damp it by soil.damping, or give [quasi_static]" ]] || show
  exits 0 fem-dem --quiet pressed.toml --set support.1.y=-0.001 "${mended[@]}" --force -o driven.h5
  [[ -z $stderr ]] || show
  exits 0 fem-dem --quiet elastic.toml --set geosynthetic.end.x=0 -o still.h5
  [[ -z $stderr ]] || show
}

@test "spread over 2 and 4 processes it gives the same bytes" {
  local mpi=$BIN/../mpi/fem-dem n
  [[ -x $mpi ]] && command -v mpirun > /dev/null || skip "not built: make mpi"
  for n in 2 4; do
    mpirun --allow-run-as-root --oversubscribe -n $n "$mpi" --quiet grains.toml disks.h5 "${SHORT[@]}" -o "$n.h5"
    same_bytes run.h5 "$n.h5"
  done
}

@test "stresses without a unit are doubted where kPa may be meant" {
  cat > bare.toml << 'TOML'
[mesh]
width = 1
height = 1
columns = 2
rows = 2
[soil]
material = "elastic"
density = 2000
young_modulus = "4 MPa"
poisson_ratio = 0.25
[[support]]
on = "bottom"
x = 0
y = 0
[[traction]]
on = "top"
y = -20
[time]
duration = 0.05
output_interval = 0.05
TOML
  exits 0 fem-dem --check bare.toml
  [[ $stderr == *'fem-dem: doubt: traction.0.y is -20 without a unit, which is -20 Pa: if -20 kPa is meant, write "-20 kPa", else "-20 Pa"'* ]] ||
    show "wanted a doubt"
  for traction in '"-20 kPa"' '"-20 Pa"' -20e3; do
    exits 0 fem-dem --check bare.toml --set "traction.0.y=$traction"
    [[ $stderr != *"without a unit"* ]] || show "$traction is clear"
  done
}

@test "densities, moduli and geosynthetics in another unit are doubted" {
  local key value words
  exits 0 fem-dem --check elastic.toml
  [[ $stderr != *", as no "* ]] || show "these are clear"
  while read -r key value words; do
    # A strength that is far too small breaks bars in the trial steps.
    call fem-dem --check elastic.toml --set "$key=$value"
    [[ $stderr == *"fem-dem: doubt: $key is $value $words, convert it, else write its unit"* ]] || show "wanted a doubt about $key"
  done << 'TABLE'
soil.density 2.254 kg/m3, as no soil has: if it is in g/cm3 or kN/m3
soil.density 22.5 kg/m3, as no soil has: if it is in g/cm3 or kN/m3
soil.young_modulus 4000 Pa, as no soil has: if it is in kPa or MPa
geosynthetic.areal_density 350 kg/m2, as no geosynthetic has: if it is in g/m2
geosynthetic.stiffness 222.8 N/m, as no geosynthetic has: if it is in kN/m
geosynthetic.strength 31.75 N/m, as no geosynthetic has: if it is in kN/m
TABLE
}
