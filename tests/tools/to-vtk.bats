#!/usr/bin/env bats
# to-vtk: VTK's own readers open what it writes; histories, text, and every class of error.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  local case
  export IN=$BATS_FILE_TMPDIR
  [ -z "${NO_VTK:-}" ] || return 0
  for case in sheared disks box bare one-step fields; do
    "$PYTHON" "$BATS_TEST_DIRNAME/vtk_states.py" "$case" "$IN/$case.h5"
  done
}

setup() {
  [ -z "${NO_VTK:-}" ] || skip "built without VTK"
  cd "$BATS_TEST_TMPDIR" || return
}

readers() {
  "$PYTHON" "$BATS_TEST_DIRNAME/vtk_readers.py" "$@"
}

@test "a run in a sheared cell: grains, contacts split at the faces, cell, times" {
  to-vtk --quiet "$IN/sheared.h5" -o out
  run -0 readers "$IN/sheared.h5" out
  [ "$output" = "3 states, 120 grains, $(contacts_in sheared) contacts, some through the faces" ]
}

contacts_in() {
  "$PYTHON" -c 'import h5py, sys; print(len(h5py.File(sys.argv[1])["contacts/000002/bodies"]))' "$IN/$1.h5"
}

@test "disks, and grains in a box of planes" {
  local case
  for case in disks box; do
    to-vtk --quiet "$IN/$case.h5" -o "$case"
    readers "$IN/$case.h5" "$case"
  done
  [ ! -e disks/planes.pvd ]
  [ -e box/planes.pvd ]
  "$PYTHON" - <<'PY'
from vtk import vtkXMLPolyDataReader
reader = vtkXMLPolyDataReader()
reader.SetFileName("box/planes_000000.vtp")
reader.Update()
assert reader.GetOutput().GetNumberOfPolys() == 2
PY
}

@test "one state, the last state, grains where they have travelled to, compressed" {
  to-vtk --quiet "$IN/sheared.h5" -o one --state 1
  readers "$IN/sheared.h5" one --states 1
  [ "$(ls one/grains_*)" = one/grains_000001.vtp ]
  to-vtk --quiet "$IN/sheared.h5" -o last --state last --unwrapped
  readers "$IN/sheared.h5" last --states 2 --unwrapped
  to-vtk --quiet "$IN/sheared.h5" -o small --state last --compress
  readers "$IN/sheared.h5" small --states 2
  [ "$(stat -c %s small/grains_000002.vtp)" -lt "$(stat -c %s last/grains_000002.vtp)" ]
}

@test "files are raw appended VTK XML with 64-bit headers" {
  to-vtk --quiet "$IN/bare.h5" -o out
  grep -aq 'header_type="UInt64"' out/grains_000000.vtp
  grep -aq 'AppendedData encoding="raw"' out/grains_000000.vtp
  run -1 grep -aq compressor out/grains_000000.vtp
}

@test "the force scale sets the tubes" {
  to-vtk --quiet "$IN/sheared.h5" -o out --state 0 --force-scale 1e-4
  "$PYTHON" - <<'PY'
from vtk import vtkXMLPolyDataReader
reader = vtkXMLPolyDataReader()
reader.SetFileName("out/contacts_000000.vtp")
reader.Update()
data = reader.GetOutput()
for line in range(data.GetNumberOfCells()):
    force = data.GetCellData().GetArray("normal_force").GetValue(line)
    assert abs(data.GetPointData().GetArray("tube_radius").GetValue(2 * line) - 1e-4 * force) < 1e-15
PY
}

@test "a packing without contacts says so and writes none" {
  run -0 --separate-stderr to-vtk "$IN/bare.h5" -o out
  # shellcheck disable=SC2154
  [[ $stderr == *"holds no contacts"* ]]
  [ "$(cd out && ls)" = $'cell.pvd\ncell_000000.vtu\ngrains.pvd\ngrains_000000.vtp\nshow.py' ]
}

@test "fields: rows with a place become points, the others tables; grain fields join the grains" {
  to-vtk --quiet "$IN/fields.h5" -o fields
  [ "$(head -2 fields/global.csv)" = $'step,mean_stress\n0,1e+05' ]
  [ -e fields/volumes_000002.vtp ]
  to-vtk --quiet "$IN/sheared.h5" --fields "$IN/fields.h5" -o joined
  "$PYTHON" - <<'PY'
from vtk import vtkXMLPolyDataReader
from vtk.util.numpy_support import vtk_to_numpy

def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()

volume = read("fields/volumes_000002.vtp")
assert volume.GetPoint(0) == (0.0, 1.0, 2.0)
assert volume.GetFieldData().GetArray("TimeValue").GetValue(0) == 0.025
stress = volume.GetPointData().GetArray("stress").GetTuple(0)
assert stress == (500, 501, 503, 501, 502, 504, 503, 504, 505), stress
grains = read("joined/grains_000001.vtp").GetPointData()
ids, joined = (vtk_to_numpy(grains.GetArray(name)) for name in ("body_id", "void_ratio"))
assert (joined == 120 + (ids - 1000)).all()
PY
}

@test "volumes of interest show their principal axes where they are" {
  homogenize --quiet --copies --state last "$IN/sheared.h5" -o volumes.h5
  to-vtk --quiet volumes.h5 -o axes
  "$PYTHON" - <<'PY'
from vtk import vtkXMLPolyDataReader

def read(path):
    reader = vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    return reader.GetOutput()

places, axes = read("axes/volumes_000000.vtp"), read("axes/volumes_axes_000000.vtp")
number = [axes.GetCellData().GetArray("principal").GetValue(k) for k in range(axes.GetNumberOfCells())]
assert number == [1, 2, 3] * places.GetNumberOfPoints() and number
for k in range(axes.GetNumberOfCells()):
    middle = [(a + b) / 2 for a, b in zip(axes.GetPoint(2 * k), axes.GetPoint(2 * k + 1))]
    assert max(abs(m - p) for m, p in zip(middle, places.GetPoint(k // 3))) < 1e-12
PY
}

@test "two runs write the same bytes, whatever the number of threads" {
  to-vtk --quiet "$IN/sheared.h5" -o one
  OMP_NUM_THREADS=4 to-vtk --quiet "$IN/sheared.h5" -o two
  diff -r one two
}

@test "the ParaView script compiles" {
  to-vtk --quiet "$IN/bare.h5" -o out
  "$PYTHON" -m py_compile out/show.py
}

@test "an output folder in use is refused, replaced with --force; files of others stay" {
  to-vtk --quiet "$IN/sheared.h5" -o out
  echo mine > out/notes.txt
  mentions 73 to-vtk "--force" "$IN/sheared.h5" -o out
  to-vtk --quiet --force "$IN/sheared.h5" -o out --state 1
  [ "$(ls out/grains_*)" = out/grains_000001.vtp ]
  [ "$(cat out/notes.txt)" = mine ]
}

@test "--history tells how a file came to be" {
  run -0 to-vtk --history "$IN/sheared.h5"
  [[ $output == *"vtk_states.py"* ]]
}

@test "--text writes x y z r of the last state" {
  run -0 --separate-stderr to-vtk --text "$IN/bare.h5"
  # shellcheck disable=SC2154
  [[ ${lines[0]} == "##PERIODIC:: 0.1 0.1 0.1" ]]
  [ "$(grep -vc '#' <<< "$output")" -eq 120 ]
  to-vtk --text "$IN/bare.h5" -o packing.txt
  diff packing.txt <(printf '%s\n' "$output")
  to-vtk --text --state last "$IN/sheared.h5" -o last.txt
  to-vtk --text "$IN/sheared.h5" -o default.txt
  to-vtk --text --state 0 "$IN/sheared.h5" -o first.txt
  same_bytes last.txt default.txt
  mentions 64 to-vtk "--state has no effect as all beside --text, which prints one state: leave it out" --text --state all "$IN/sheared.h5"
  if cmp -s first.txt last.txt; then show "--state is not followed"; fi
}

@test "a packing comes through a pipe" {
  to-vtk --quiet - -o out < "$IN/sheared.h5"
  readers "$IN/sheared.h5" out
}

@test "errors: input missing, truncated, of another kind, a folder" {
  mentions 66 to-vtk "none.h5" none.h5 -o out
  head -c 5000 "$IN/sheared.h5" > half.h5
  mentions 65 to-vtk "half.h5" half.h5 -o out
  echo "no HDF5 at all" > words.h5
  mentions 65 to-vtk "words.h5" words.h5 -o out
  mentions 65 to-vtk "" . -o out
  mentions 65 to-vtk "fields" "$IN/sheared.h5" --fields "$IN/bare.h5" -o out
  mentions 65 to-vtk "step 250" "$IN/sheared.h5" --fields "$IN/one-step.h5" -o out
  mentions 65 to-vtk "" --text "$IN/fields.h5"
  [ ! -e out ]
}

@test "errors: states of equal time are told before anything is written" {
  cp "$IN/sheared.h5" same.h5
  "$PYTHON" -c 'import h5py; f = h5py.File("same.h5", "r+"); f["particles/grains/position/time"][2] = 0
f["particles/grains/position/time"][1] = 0'
  mentions 65 to-vtk "the states of grains do not advance in time: 0 s after 0 s" same.h5 -o out
  [ ! -e out ]
  exits 0 to-vtk --quiet same.h5 -o out --state 1
}

@test "errors: output that cannot be made" {
  mentions 73 to-vtk "/proc/none" "$IN/bare.h5" -o /proc/none
  : > file
  mentions 73 to-vtk "file" "$IN/bare.h5" -o file
  mentions 73 to-vtk "folder" "$IN/bare.h5" --force -o file
}

@test "errors: usage" {
  mentions 64 to-vtk "-o" "$IN/bare.h5"
  mentions 64 to-vtk "--state" "$IN/bare.h5" -o out --state none
  mentions 64 to-vtk "1 state, number 0" "$IN/bare.h5" -o out --state 1
  mentions 64 to-vtk "1 state, number 0" "$IN/fields.h5" -o out --state 1
  mentions 64 to-vtk "--text has no effect beside --history: leave it out" --history --text "$IN/bare.h5"
  local option
  for option in --fields=fields.h5 --unwrapped --compress --force-scale=1; do
    mentions 64 to-vtk "${option%=*} has no effect beside --text and --history: leave it out" --text "$option" "$IN/bare.h5"
    mentions 64 to-vtk "${option%=*} has no effect beside --text and --history: leave it out" --history "$option" "$IN/bare.h5"
  done
  mentions 64 to-vtk "--state has no effect beside --history: leave it out" --history --state last "$IN/bare.h5"
  fabric --quiet --state last -o tables.h5 "$IN/sheared.h5"
  mentions 64 to-vtk "--state has no effect without places: leave it out" tables.h5 --state last -o out
  mentions 64 to-vtk "for packings and runs" --unwrapped "$IN/fields.h5" -o fields-vtk
  mentions 64 to-vtk "--force-scale" "$IN/bare.h5" -o out --force-scale -1
  [ ! -e out ]
}
