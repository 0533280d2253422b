#!/usr/bin/env bats
# filter-expand, and run-dem with its bags: the same bytes each time, stopped or not; refusals.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  cp "$BATS_TEST_DIRNAME/examples/bag.toml" "$BATS_TEST_DIRNAME/examples/press.toml" .
  pack-generate --quiet --grains 300 --void-ratio 0.72 --pressure 1e4 --tolerance 1e-2 -o packing.h5
  filter-expand --quiet packing.h5 bag.toml -o bag.h5 --history growth.tsv
  run-dem --quiet bag.h5 press.toml -o run.h5
  # The preload alone takes a third of the steps.
  awk '/^\[\[stage\]\]/ && ++stages > 1 { exit } { print }' press.toml > preload.toml
}

setup() {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here" || return
  ln -s "$BATS_FILE_TMPDIR"/* .
}

@test "a bag is the same with one thread and with three, and so is what it carries" {
  filter-expand --quiet --threads 3 packing.h5 bag.toml -o three.h5
  same_bytes bag.h5 three.h5
  run-dem --quiet bag.h5 preload.toml -o one.h5
  run-dem --quiet --threads 3 bag.h5 preload.toml -o three_pressed.h5
  same_bytes one.h5 three_pressed.h5
}

@test "generation and loading that were stopped go on to the same bytes" {
  local status=0
  timeout -s TERM 0.4 filter-expand --quiet packing.h5 bag.toml -o again.h5 || status=$?
  [[ $status -eq 124 || $status -eq 0 ]]
  filter-expand --quiet --resume packing.h5 bag.toml -o again.h5
  same_bytes bag.h5 again.h5
  status=0
  timeout -s TERM 0.4 run-dem --quiet bag.h5 press.toml -o once.h5 || status=$?
  [[ $status -eq 124 || $status -eq 0 ]]
  run-dem --quiet --resume bag.h5 press.toml -o once.h5
  same_bytes run.h5 once.h5
}

@test "the tables of a bag have its plates, its yarns and its soil" {
  homogenize run.h5 --table series --tsv > series.tsv
  # The second row is the one under the plates' load of 20 N.
  near "$(value series.tsv force_top_z 2)" 20 0.02
  near "$(value series.tsv force_bottom_z 2)" -20 0.02
  # After that row the bag carries the compression.
  holds 'last > 40' last="$(value series.tsv force_top_z last)"
  local column
  for column in yarn_tension_face soil_stress_zz soil_volume; do
    holds 'x > 0' x="$(value series.tsv $column 2)"
  done
  homogenize run.h5 --table bag --tsv | grep -q soil_void_ratio
  # Each yarn of 12 x 12 x 6 cells has a row; those of the faces have the mean tension of the series.
  homogenize run.h5 --state last --table yarns --tsv > yarns.tsv
  [[ $(wc -l < yarns.tsv) -eq $((1 + 2 * 2 * 12 * 13 + 4 * 12 * 5 + 4 * 12 * 6)) ]] || show "$(wc -l < yarns.tsv) rows"
  near "$(table 'c("family") == 0 { sum += c("tension"); ++n } END { printf "%.15g", sum / n }' yarns.tsv)" "$(value series.tsv yarn_tension_face last)" 1e-9
  # On request they are in a file too.
  homogenize --quiet run.h5 --state last --yarns -o fields.h5
  exits 0 "$PYTHON" - << 'PY'
import h5py
lines = [line.rstrip("\n").split("\t") for line in open("yarns.tsv")]
with h5py.File("fields.h5") as file:
    for place, head in enumerate(lines[0]):
        column = file["fields/yarns/" + head.split(" [")[0]]
        assert column[()].tolist() == [float(line[place]) for line in lines[1:]], head
PY
  # Nodes have no cell and thus no stress; yarns and grains belong to the same time.
  homogenize run.h5 --state last --table grains --tsv > grains.tsv
  [[ $(value grains.tsv time 1) == "$(value yarns.tsv time 1)" ]] || show "times differ"
  # shellcheck disable=SC2016  # awk's dollar
  table 'tolower($0) ~ /inf/ || (c("cell_volume") == 0) != (text("mean_stress") ~ /nan/) { bad = 1 }
    c("cell_volume") == 0 { ++none } END { exit bad || !none }' grains.tsv || show "stress of grains without a cell"
  homogenize --quiet run.h5 -o fields.h5 --force
  exits 0 "$PYTHON" -c 'import h5py; assert "yarns" not in h5py.File("fields.h5")["fields"]'
  [[ $(head -1 growth.tsv) == *delaunay_volume* ]]
}

@test "a soil is identified from runs of bags as they are, as from the tables of their loading" {
  sed '/^yarn_tension/d; s/^yarn_strain.*/curve = "1.3PE"\nmultiple = 1/' press.toml > named.toml
  run-dem --quiet bag.h5 named.toml -o named.h5
  exits 0 gws-solve identify run.h5 named.h5
  # The stiffness is the secant of the run's curve over the yarns' distance: 1.3 times the stiffness in the file of PE.
  [[ $output == *"run.h5: rows 2 to 4 of 4, up to the last; tensile stiffness "*" kN/m, the secant to failure"* ]] || show
  [[ $output == *"named.h5: rows 2 to 4 of 4, up to the last; tensile stiffness 68.9 kN/m, of geotextile 1.3PE"* ]] || show
  near "$(sed -n 's/^run.h5: .*stiffness \([0-9.]*\) kN.*/\1/p' <<< "$output")" 52.45 1e-3
  local options=(--geotextile PE --geotextile 1.3PE --tsv --table increments)
  gws-solve identify run.h5 named.h5 "${options[@]}" > runs.tsv
  homogenize run.h5 --table loading --tsv > loading.tsv
  homogenize --quiet named.h5 -o loading.h5
  gws-solve identify loading.tsv loading.h5 "${options[@]}" > tables.tsv
  gws-solve identify run.h5 loading.h5 "${options[@]}" > mixed.tsv
  same_bytes runs.tsv tables.tsv
  same_bytes runs.tsv mixed.tsv
  gws-solve identify run.h5 named.h5 --toml > soil.toml
  grep -q "^# named.h5: rows 2 to 4 of 4" soil.toml || show "$(cat soil.toml)"
  # The data sheet does not tell the stiffness of a fabric whose tensions are multiplied.
  "$PYTHON" - <<'PY'
import h5py
with h5py.File("named.h5", "r+") as file:
    text = file["scenario"][()]
    other = text.replace(b"multiple = 1", b"multiple = 2")
    assert len(other) == len(text) and other != text, text
    file["scenario"][()] = other
PY
  exits 65 gws-solve identify named.h5
  # shellcheck disable=SC2154  # set by exits
  [[ $stderr == *"named.h5: its yarns are "*" mm apart, with multiple = 2, and its fabric has 1.88"*" times the strength of 1.3PE: give --geotextile FILE"* ]] || show
  exits 65 gws-solve identify bag.h5
  [[ $stderr == "gws-solve identify: bag.h5: has no series: it is a packing"* ]] || show
  refuses 65 homogenize "bag.h5: has no series: it is a packing" --table loading --tsv bag.h5
}

# stops_when_full HISTORY VOID_RATIO LARGEST_COORDINATION_NUMBER: demands that grains grow until the first measurement that
# meets all criteria (steady volume, overlap, contacts, void ratio), and then come to rest. The last state is the first one
# at rest that meets the criteria too, with no more contacts than requested.
stops_when_full() {
  table '
    ended { fault("the row before misses nothing and is at rest") }
    full && c("round") != round { fault("the grains grew, though the row before misses nothing") }
    {
      at_rest = full
      if (!at_rest) stand(c("growth"), c("delaunay_volume"))
      full = standing && c("mean_overlap") >= 1e-4 && c("coordination_number") >= 2.5 && c("void_ratio") <= loosest
      ended = at_rest && full && c("coordination_number") <= most
      round = c("round")
    }
    # Held grains carry less than 0.9 of the volume that free grains would; while none grow, nothing is learnt.
    function stand(growth, now,    free) {
      free = growth_before ? 3 * log(growth / growth_before) : 0
      if (free > 0) standing = log(now / volume) < 0.9 * free
      growth_before = growth
      volume = now
    }
    END { if (!ended) fault("the last one misses something") }' loosest="$2" most="$3" "$1" 2> fault || show "$1: $(cat fault)" "$(tail -n 5 "$1")"
}

@test "a bag is full when its grains press at rest, as dense and with as few contacts as asked for" {
  local finely=(--set growth.void_ratio=0.8 --set growth.factor=1.001 --set growth.measure_every=2)
  filter-expand --quiet packing.h5 bag.toml "${finely[@]}" --set growth.largest_coordination_number=2.9 -o denser.h5 --history denser.tsv
  stops_when_full growth.tsv 100 20
  stops_when_full denser.tsv 0.8 2.9
  # The void ratio equals the one in the bag's tables.
  homogenize denser.h5 --table bag --tsv > bag.tsv
  near "$(value bag.tsv soil_void_ratio last)" "$(value denser.tsv void_ratio last)" 1e-3
  near "$(value bag.tsv soil_delaunay_void_ratio last)" "$(value denser.tsv delaunay_void_ratio last)" 1e-3
  # A void ratio by the Delaunay volume is reached by that measure; the bag at its densest would miss it.
  filter-expand --quiet packing.h5 bag.toml "${finely[@]:2}" --set growth.delaunay_void_ratio=0.4 -o hull.h5 --history hull.tsv
  holds 'reached <= 0.4 && alone > 0.4' reached="$(value hull.tsv delaunay_void_ratio last)" \
    alone="$(value growth.tsv delaunay_void_ratio last)"
  refuses 1 filter-expand "without friction the grains press" --quiet packing.h5 bag.toml --set growth.factor=1.005 --set growth.delaunay_void_ratio=0.2 -o out.h5
  # A single contact bears nothing, so at rest fewer than one grain in a hundred has just one.
  filter-expand --quiet packing.h5 bag.toml --set growth.unbalanced_force=1e-5 -o rested.h5
  fabric rested.h5 --table histogram --tsv > rested.tsv
  [[ $(value rested.tsv contacts 2) -eq 1 && $(value rested.tsv grains 2) -le 4 ]] || show "$(cat rested.tsv)"
  refuses 1 filter-expand "the grains do not fill the container" --quiet packing.h5 bag.toml --set growth.rounds=10 -o out.h5
  exits 1 filter-expand --quiet packing.h5 bag.toml --set growth.rounds=1 --set growth.unbalanced_force=0.5 -o out.h5
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $stderr == *"doubt: growth.unbalanced_force is 0.5, which is 50 %: states are recorded that are not at rest"* ]] || show
  # The requested overlap is more than is left at rest, and less than there was before.
  local round between
  read -r round between < <(table '{ before = rest; rest = c("mean_overlap"); round = c("round") }
    END { printf "%d %.9g\n", round, (before + rest) / 2 }' growth.tsv)
  refuses 1 filter-expand "fall apart as they come to rest" --quiet packing.h5 bag.toml --set growth.overlap="$between" --set growth.rounds="$round" -o out.h5
  refuses 1 filter-expand "without friction the grains press" --quiet packing.h5 bag.toml --set growth.factor=1.005 --set growth.void_ratio=0.6 -o out.h5
  exits 0 filter-expand --quiet packing.h5 bag.toml --set growth.factor=1.005 --set growth.void_ratio=1.5 -o loose.h5
  [[ $stderr == "filter-expand: doubt: the full container has a void ratio of "*", and growth.void_ratio asks for 1.5: "* ]] || show "wanted a doubt"
}

@test "openings through which grains may slip out are doubted before grains grow" {
  call filter-expand --quiet packing.h5 bag.toml --set 'geotextile_mesh.cells=[4,4,2]' --set growth.rounds=1 -o out.h5
  [[ $stderr == *"doubt: openings between the nodes of the geotextile are some "*" grains are narrower: "* ]] || show "wanted a doubt"
  call filter-expand --quiet packing.h5 bag.toml --set growth.rounds=1 -o out.h5
  [[ $stderr != *"openings"* ]] || show "the example's mesh holds its grains"
}

# stl FILE OFFSET...: writes cubes of 40 mm around these points on the diagonal; LEAVE_OUT triangles are missing.
stl() {
  local file=$1
  shift
  printf '%s\n' "$@" | awk -v out="${LEAVE_OUT:-0}" 'BEGIN {
      split("0 1 3 0 3 2 4 6 7 4 7 5 0 4 5 0 5 1 2 3 7 2 7 6 0 2 6 0 6 4 1 5 7 1 7 3", corner, " "); print "solid cube" }
    { for (k = 1; k <= 36 - 3 * out; ++k) {
        if (k % 3 == 1) print "facet normal 0 0 0\nouter loop"
        c = corner[k]
        print "vertex", $1 + 0.02 * (c >= 4 ? 1 : -1), $1 + 0.02 * (int(c / 2) % 2 ? 1 : -1), $1 + 0.02 * (c % 2 ? 1 : -1)
        if (k % 3 == 0) print "endloop\nendfacet"
      } }
    END { print "endsolid cube" }' > "$file"
}

@test "a closed surface is cut to; one that is open, cuts itself or is none is refused" {
  cat > cut.toml <<'TOML'
[container]
shape = "surface"
file = "cube.stl"
[contact]
law = "hertz-mindlin"
young_modulus = "4 GPa"
poisson_ratio = 0.33
friction_angle = 29
TOML
  stl cube.stl 0
  filter-expand --quiet packing.h5 cut.toml -o cut.h5
  to-vtk --text cut.h5 | awk '{ for (i = 1; i <= 3; ++i) { x = $i < 0 ? -$i : $i; if (!(x + $4 <= 0.02 + 1e-12)) bad = 1 } } END { exit bad || NR < 20 }' ||
    show "grains outside"
  to-vtk --history cut.h5 | grep -q surface || show "the surface is not among the inputs"
  LEAVE_OUT=1 stl open.stl 0
  stl twice.stl 0 0.01
  echo hello > not.stl
  refuses 65 filter-expand "is open: 3 edges" packing.h5 cut.toml --set container.file=open.stl -o out.h5
  refuses 65 filter-expand "cuts itself" packing.h5 cut.toml --set container.file=twice.stl -o out.h5
  refuses 65 filter-expand "is no surface" packing.h5 cut.toml --set container.file=not.stl -o out.h5
  refuses 65 filter-expand "convert it" packing.h5 cut.toml --set container.file=cut.toml -o out.h5
  refuses 66 filter-expand "none.stl" packing.h5 cut.toml --set container.file=none.stl -o out.h5
}

@test "a surface may be binary, in millimetres, and lies beside its plan; one for more grains than memory holds is refused" {
  mkdir plans
  stl plans/cube.stl 0
  printf '%s\n' '[container]' 'shape = "surface"' 'file = "cube.stl"' '[contact]' 'law = "hertz-mindlin"' 'young_modulus = "4 GPa"' \
    'poisson_ratio = 0.33' 'friction_angle = 29' > plans/cut.toml
  filter-expand --quiet packing.h5 plans/cut.toml -o text.h5
  to-vtk --text text.h5 > text.txt
  awk '$1 == "vertex" { $2 *= 1000; $3 *= 1000; $4 *= 1000 } { print }' plans/cube.stl > mm.stl
  "$PYTHON" - plans/cube.stl binary.STL << 'PYTHON'
import struct, sys
corners = [[float(x) for x in line.split()[1:]] for line in open(sys.argv[1]) if line.startswith("vertex")]
with open(sys.argv[2], "wb") as file:
    file.write(b"solid, though binary".ljust(80) + struct.pack("<I", len(corners) // 3))
    for k in range(0, len(corners), 3):
        file.write(struct.pack("<12fH", 0, 0, 0, *sum(corners[k:k + 3], []), 0))
PYTHON
  # A file that --set names is searched in the working folder.
  filter-expand --quiet packing.h5 plans/cut.toml --set container.file=binary.STL -o binary.h5
  filter-expand --quiet packing.h5 plans/cut.toml --set container.file=mm.stl --set container.scale=0.001 -o mm.h5
  local file
  for file in binary mm; do cmp text.txt <(to-vtk --text $file.h5) || show "$file: other grains"; done
  # A file that only the plan names is an input too.
  refuses 73 filter-expand "binary.STL: is read by this command and would be lost" packing.h5 plans/cut.toml \
    --set container.file=binary.STL --force -o binary.STL
  head -c 400 binary.STL > short.stl
  refuses 65 filter-expand "counts 12 triangles, which take 684 bytes, but it has 400" packing.h5 plans/cut.toml --set container.file=short.stl -o out.h5
  refuses 65 filter-expand "are these millimetres? give container.scale = 0.001" packing.h5 plans/cut.toml --set container.file=mm.stl -o out.h5
  sed '/^file/d; s/surface/box/' plans/cut.toml > box.toml
  refuses 65 filter-expand "the container of 100 x 100 x 40 m is covered by" packing.h5 box.toml \
    --set 'container.low=[-50,-50,-20]' --set 'container.high=[50,50,20]' -o out.h5
  refuses 66 filter-expand 'no such file; container.file names "none.stl", looked for in the working folder' packing.h5 plans/cut.toml \
    --set container.file=none.stl -o out.h5
  rm plans/cube.stl
  refuses 66 filter-expand 'plans/cube.stl: no such file; container.file names "cube.stl", looked for beside plans/cut.toml' packing.h5 \
    plans/cut.toml -o out.h5
  (ulimit -v 4000000 && refuses 65 pack-generate "100000000 grains take about 100 GB of memory, and 4.1 GB are at hand" --grains 100000000 -o out.h5)
}

@test "a curve that a scenario names lies beside it" {
  mkdir loads
  sed 's/^yarn_strain.*/curve = "yarn.toml"/; /^yarn_tension/d' press.toml > loads/press.toml
  refuses 66 run-dem 'loads/yarn.toml: no such file; geotextile.0.curve names "yarn.toml", looked for beside loads/press.toml' bag.h5 \
    loads/press.toml -o out.h5
  grep '^yarn_' press.toml > loads/yarn.toml
  run-dem --check bag.h5 loads/press.toml > /dev/null
  mv loads/yarn.toml .
  run-dem --check bag.h5 loads/press.toml --set geotextile.0.curve=yarn.toml > /dev/null
  # The file's numbers for the analytical model do not contradict the curve.
  contradicts() {
    { cat yarn.toml; echo "$2"; } > other.toml
    refuses 65 run-dem "$1" bag.h5 loads/press.toml --set geotextile.0.curve=other.toml -o out.h5
  }
  contradicts 'yarn_strain: ends at 17.04 %, where failure_strain is 10 %: correct one of them' 'failure_strain = "10 %"'
  contradicts 'yarn_tension: ends at 47.5 N, which is the strength of a yarn 5000 mm wide' 'strength = "9.5 N/m"'
  # The number of a strength in kN/m that was copied as the tension of a yarn in N.
  contradicts 'yarn_tension: ends at 47.5 N, which is the strength of a yarn 1 mm wide' 'strength = "47.5 kN/m"'
  printf 'failure_strain = 0.16\nstrength = "9.5 kN/m"\nstiffness = "53 kN/m"\n' >> yarn.toml
  exits 0 run-dem --quiet --check bag.h5 loads/press.toml --set geotextile.0.curve=yarn.toml
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $stderr != *"yarns of geotextile"* ]] || show "the curve is that of yarns so far apart"
  # The curve of yarns three times as far apart makes the fabric stronger than its file says. The remedy that is told helps.
  sed -i 's/9.5 kN/3.2 kN/' yarn.toml
  exits 0 run-dem --quiet --check bag.h5 loads/press.toml --set geotextile.0.curve=yarn.toml
  [[ $stderr == *"doubt: yarns of geotextile 0 are some "*" where their file has a strength of 3.2 kN/m: give the tensions of yarns so far apart, or multiple = "* ]] || show
  local multiple=${stderr##*multiple = }
  exits 0 run-dem --quiet --check bag.h5 loads/press.toml --set geotextile.0.curve=yarn.toml --set "geotextile.0.multiple=${multiple%%$'\n'*}"
  [[ $stderr != *"yarns of geotextile"* ]] || show "the remedy fails"
  refuses 65 run-dem 'geotextile.0.yarn_strain: ends at 17, more than twice the length; per cent are written "17 %"' bag.h5 press.toml \
    --set 'geotextile.0.yarn_strain=[2,6,17]' -o out.h5
  run-dem --check bag.h5 press.toml --set 'geotextile.0.yarn_strain=["2 %","6 %","17 %"]' > /dev/null
}

@test "tensions of yarns that no geotextile bears are doubted, as those of a metre of it are" {
  exits 0 run-dem --quiet --check bag.h5 press.toml
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $stderr != *"yarns of geotextile"* && $stderr != *"has no effect"* ]] || show "these yarns are used, and bear what yarns do"
  exits 0 run-dem --quiet --check bag.h5 press.toml --set 'geotextile.0.yarn_tension=[8400,20600,47500]'
  [[ $stderr == *"doubt: yarns of geotextile 0 are some "*" mm apart and bear 4.75e+04 N at most, which is "*"a curve gives the tension of one yarn, in N"* ]] ||
    show
  exits 0 run-dem --quiet --check bag.h5 press.toml --set geotextile.0.multiple=1e-3
  [[ $stderr == *"doubt: yarns of geotextile 0 are some "*" and bear 0.0475 N at most"* ]] || show
}

# surface FILE SHAPE: writes an egg, or a ring, of triangles, as STL or VTP.
surface() {
  "$PYTHON" - "$1" "$2" << 'PY'
import sys
from vtkmodules.vtkCommonComputationalGeometry import vtkParametricEllipsoid, vtkParametricTorus
from vtkmodules.vtkFiltersCore import vtkCleanPolyData, vtkTriangleFilter
from vtkmodules.vtkFiltersSources import vtkParametricFunctionSource
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOXML import vtkXMLPolyDataWriter
path, shape = sys.argv[1:]
if shape == "egg":
    form = vtkParametricEllipsoid()
    form.SetXRadius(0.03), form.SetYRadius(0.025), form.SetZRadius(0.016)
else:
    form = vtkParametricTorus()
    form.SetRingRadius(0.02), form.SetCrossSectionRadius(0.008)
source = vtkParametricFunctionSource()
source.SetParametricFunction(form)
source.SetUResolution(60), source.SetVResolution(40)
clean = vtkCleanPolyData()
clean.SetInputConnection(source.GetOutputPort())
clean.SetTolerance(1e-6)
triangles = vtkTriangleFilter()
triangles.SetInputConnection(clean.GetOutputPort())
writer = vtkSTLWriter() if path.endswith("stl") else vtkXMLPolyDataWriter()
writer.SetInputConnection(triangles.GetOutputPort())
writer.SetFileName(path)
writer.Write()
PY
}

# vtp FILE POLYGONS OFFSETS [STRIPS OFFSETS]: writes an L-shaped prism to ell.vtp or turned.vtp, and else a cube.
vtp() {
  local points="-0.03 -0.03 -0.03 0.03 -0.03 -0.03 0.03 0 -0.03 0 0 -0.03 0 0.03 -0.03 -0.03 0.03 -0.03 \
-0.03 -0.03 0.03 0.03 -0.03 0.03 0.03 0 0.03 0 0 0.03 0 0.03 0.03 -0.03 0.03 0.03"
  [[ $1 == ell.vtp || $1 == turned.vtp ]] || points="-0.03 -0.03 -0.03 0.03 -0.03 -0.03 0.03 0.03 -0.03 -0.03 0.03 -0.03 \
-0.03 -0.03 0.03 0.03 -0.03 0.03 0.03 0.03 0.03 -0.03 0.03 0.03"
  local array='<DataArray type="Int64" Name="%s" format="ascii">%s</DataArray>'
  # shellcheck disable=SC2059  # the format is above
  {
    printf '<?xml version="1.0"?>\n<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian"><PolyData>\n'
    printf '<Piece NumberOfPoints="%d" NumberOfVerts="0" NumberOfLines="0" NumberOfStrips="%d" NumberOfPolys="%d">\n' \
      $(($(wc -w <<< "$points") / 3)) "$(wc -w <<< "${5:-}")" "$(wc -w <<< "$3")"
    printf '<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">%s</DataArray></Points>\n<Polys>' "$points"
    printf "$array" connectivity "$2" offsets "$3"
    [[ ${4:-} == "" ]] || { printf '</Polys><Strips>' && printf "$array" connectivity "$4" offsets "$5"; }
    [[ ${4:-} == "" ]] && printf '</Polys>' || printf '</Strips>'
    printf '</Piece></PolyData></VTKFile>\n'
  } > "$1"
}

@test "surfaces of concave polygons and of strips are read" {
  [[ -z ${NO_VTK:-} ]] || skip "built without VTK"
  printf '%s\n' '[container]' 'shape = "surface"' 'file = "solid.vtp"' > solid.toml
  sed -n '/^\[contact\]/,/^\[growth\]/p' bag.toml | sed '/^\[growth\]/d' >> solid.toml
  local sides="0 1 7 6 1 2 8 7 2 3 9 8 3 4 10 9 4 5 11 10 5 0 6 11"
  # The hollow corner of the L is the third, or the first, of its polygon.
  vtp ell.vtp "5 4 3 2 1 0 6 7 8 9 10 11 $sides" "6 12 16 20 24 28 32 36"
  vtp turned.vtp "4 3 2 1 0 5 7 8 9 10 11 6 $sides" "6 12 16 20 24 28 32 36"
  local file
  for file in ell turned; do filter-expand --quiet packing.h5 solid.toml --set "container.file=\"$file.vtp\"" -o $file.h5; done
  same_text <(to-vtk --text ell.h5) <(to-vtk --text turned.h5)
  vtp cube.vtp "3 2 1 0 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6 3 0 4 7" "4 8 12 16 20 24"
  vtp strip.vtp "3 2 1 0 4 5 6 7 0 1 5 4 1 2 6 5 2 3 7 6" "4 8 12 16 20" "0 4 3 7" "4"
  for file in cube strip; do filter-expand --quiet packing.h5 solid.toml --set "container.file=\"$file.vtp\"" -o $file.h5; done
  same_text <(to-vtk --text cube.h5) <(to-vtk --text strip.h5)
}

@test "a geotextile is laid on any surface that is seen whole from its middle" {
  [[ -z ${NO_VTK:-} ]] || skip "built without VTK"
  sed '/^width/d; /^half_height/d; /^corner_radius/d; s/^shape.*/shape = "surface"\nfile = "egg.vtp"/; s/^cells.*/spacing = "4 mm"/' bag.toml > egg.toml
  surface egg.vtp egg
  filter-expand --quiet packing.h5 egg.toml -o egg.h5
  filter-expand --quiet --threads 2 packing.h5 egg.toml -o again.h5
  same_bytes egg.h5 again.h5
  # Nodes half a node outside, yarns of one length, as many as the hoops of the egg ask for: 163 and 146 mm around.
  "$PYTHON" - << 'PY'
import h5py, numpy
with h5py.File("egg.h5") as file:
    nodes = file["particles/grains/position/value"][-1][file["particles/grains/copy_id"][()] < 0]
    lengths = file["yarns/rest_length"][-1]
ring = [(nodes[:, a] / r) ** 2 for a, r in enumerate((0.0325, 0.0275, 0.0185))]
assert abs(sum(ring) - 1).max() < 0.02, abs(sum(ring) - 1).max()
assert abs(lengths.mean() / 0.004 - 1) < 0.06 and lengths.std() / lengths.mean() < 0.1, (lengths.mean(), lengths.std())
assert lengths.max() < 1.3 * lengths.mean() and lengths.min() > 0.7 * lengths.mean(), (lengths.min(), lengths.max())
PY
  run-dem --quiet egg.h5 preload.toml -o egg_run.h5
  homogenize --table series --tsv egg_run.h5 > egg.tsv
  holds 'tension > 0' tension="$(value egg.tsv yarn_tension_face 1)"
  surface egg.stl egg
  filter-expand --quiet packing.h5 egg.toml --set container.file=egg.stl -o stl.h5
  # The surface from STL has single-precision numbers and gives the same yarns.
  "$PYTHON" - << 'PY'
import h5py, numpy
with h5py.File("egg.h5") as one, h5py.File("stl.h5") as other:
    lengths = [file["yarns/rest_length"][-1] for file in (one, other)]
assert lengths[0].shape == lengths[1].shape, [of.shape for of in lengths]
assert abs(lengths[1] / lengths[0] - 1).max() < 1e-4, abs(lengths[1] / lengths[0] - 1).max()
PY
  surface ring.stl ring
  refuses 65 filter-expand "is not seen whole from its middle" packing.h5 egg.toml --set container.file=ring.stl -o out.h5
  refuses 65 filter-expand "are given beside spacing" packing.h5 egg.toml --set 'geotextile_mesh.cells=[8,8,4]' -o out.h5
  head -c 3000 egg.vtp > cut_off.vtp
  refuses 65 filter-expand "is no VTK file of polygons" packing.h5 egg.toml --set container.file=cut_off.vtp -o out.h5
  sed '/^\[growth\]/,$d; /^file/d; s/^shape.*/shape = "none"/' egg.toml > bare.toml
  refuses 65 filter-expand "has no container to wrap" packing.h5 bare.toml -o out.h5
}

@test "sheets of two geotextiles are laid, and imported as they are" {
  printf '%s\n' '[container]' 'shape = "none"' '[[sheet]]' 'cells = [4, 4, 1]' '[[sheet]]' 'cells = [4, 4, 1]' 'height = 0.02' \
    'geotextile_id = 1' > two.toml
  sed -n '/^\[contact\]/,/^\[growth\]/p' bag.toml | sed '/^\[growth\]/d' >> two.toml
  filter-expand --quiet packing.h5 two.toml -o two.h5
  printf '[[geotextile]]\ncurve = "%s"\n' PE PP >> two.toml
  filter-expand --quiet packing.h5 two.toml -o described.h5
  sed '/^\[container\]/,/^geotextile_id/d; /^\[\[geotextile\]\]/,$d' two.toml > material.toml
  pack-generate --quiet --import two.h5 --as-is --material material.toml -o again.h5
  refuses 65 pack-generate "has a geotextile, which is not compacted here: give --as-is" --import two.h5 --material material.toml -o out.h5
}

@test "a sheet within soil leaves out the grains that it cuts" {
  printf '%s\n' '[container]' 'shape = "box"' 'low = [-0.02, -0.02, -0.02]' 'high = [0.02, 0.02, 0.02]' '[[sheet]]' 'cells = [8, 8, 1]' > cut.toml
  sed -n '/^\[contact\]/,/^\[growth\]/p' bag.toml | sed '/^\[growth\]/d' >> cut.toml
  filter-expand --quiet packing.h5 cut.toml -o cut.h5
  homogenize cut.h5 --table grains --tsv --columns position_z,radius,copy > grains.tsv
  # shellcheck disable=SC2016  # awk's own
  table '{ z = c("position_z"); if (z < 0) z = -z; gap = z - c("radius") - 0.0025 }
    c("copy") >= 0 { if (++soil == 1 || gap < least) least = gap }
    END { printf "soil\tleast\n%d\t%.9g\n", soil, least }' grains.tsv > gap.tsv
  holds 'soil > 20 && least >= -1e-9' soil="$(value gap.tsv soil 1)" least="$(value gap.tsv least 1)"
}

@test "keys and options that have no effect are refused" {
  refuses 65 filter-expand "is given beside [growth], which has a damping of its own: give growth.damping" packing.h5 bag.toml \
    --set numerics.damping=0.4 -o out.h5
  local set
  for set in 'container.copies=[1,1,1]' grains.scale=0.9 grains.density=2650; do
    printf '%s\n' '[container]' 'shape = "none"' '[[sheet]]' 'cells = [4, 4, 1]' > bare.toml
    sed -n '/^\[contact\]/,/^\[growth\]/p' bag.toml | sed '/^\[growth\]/d' >> bare.toml
    refuses 65 filter-expand "is given beside container.shape = \"none\"" packing.h5 bare.toml --set "$set" -o out.h5
  done
  refuses 64 filter-expand "has no [growth], so that nothing is measured: leave it out" packing.h5 bare.toml --history h.tsv -o out.h5
  refuses 73 filter-expand "is finished and holds no measurements: leave out --history" --quiet packing.h5 bag.toml --resume --history h.tsv \
    -o bag.h5
}

@test "what cannot be is refused" {
  refuses 65 filter-expand "raise container.copies" packing.h5 bag.toml --set 'container.copies=[1,1,1]' -o out.h5
  refuses 65 filter-expand "is more than half the width" packing.h5 bag.toml --set container.corner_radius=1 -o out.h5
  refuses 65 filter-expand "is less than half_height" packing.h5 bag.toml --set 'container.side_radius="1 mm"' -o out.h5
  refuses 65 filter-expand "round the faces more" packing.h5 bag.toml --set 'container.side_radius="20 mm"' -o out.h5
  refuses 65 filter-expand "the sides cut each other" packing.h5 bag.toml --set 'container.side_radius="0.1 m"' -o out.h5
  refuses 65 filter-expand "is more than node_radius" packing.h5 bag.toml --set 'geotextile_mesh.offset="3 mm"' -o out.h5
  refuses 65 filter-expand "leave one of the two out" packing.h5 bag.toml --set growth.void_ratio=0.7 --set growth.delaunay_void_ratio=0.7 -o out.h5
  refuses 65 run-dem "starts inside the grains" bag.h5 press.toml --set 'plane.0.point=[0,0,0.015]' -o out.h5
  refuses 65 run-dem "growing strain" bag.h5 press.toml --set 'geotextile.0.yarn_strain=[0.02,0.01,0.17]' -o out.h5
  refuses 65 run-dem "no [[plane]] or [[clamp]] is called so" bag.h5 press.toml --set stage.1.upper=lid -o out.h5
}
