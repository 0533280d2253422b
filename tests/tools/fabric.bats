#!/usr/bin/env bats
# fabric: the same numbers as numpy sums, tables that count every contact, pipes, and every class of error.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  analysis_inputs
}

setup() {
  cd "$BATS_TEST_TMPDIR" || return
}

@test "fabric tensors, anisotropies and coordination are numpy's, in space, in the plane and beside planes" {
  local case
  for case in sheared disks box; do
    exits 0 fabric --quiet --tsv "$IN/$case.h5"
    printf '%s\n' "$output" > "$case.tsv"
    exits 0 "$PYTHON" "$BATS_TEST_DIRNAME/analysis_reference.py" "$IN/$case.h5" "$case.tsv"
    [[ $output == "3 states, "* ]] || show "compared too little"
  done
}

@test "the histogram counts every grain, the rose every direction, chains only strong contacts" {
  fabric --quiet -o out.h5 --state last --classes 24 "$IN/sheared.h5"
  exits 0 "$PYTHON" - "$IN/sheared.h5" <<'PY'
import sys
import h5py
import numpy
with h5py.File(sys.argv[1]) as file:
    contacts = {name: data[()] for name, data in file["contacts/000002"].items()}
    ids = file["particles/grains/id"][()]
with h5py.File("out.h5") as file:
    table = {name: {column: data[()] for column, data in group.items()} for name, group in file["fields"].items()}
ends = numpy.bincount(contacts["bodies"].ravel(), minlength=120)
histogram = table["histogram"]
assert histogram["grains"].tolist() == numpy.bincount(ends).tolist()
rose = table["rose"]
polar = rose["plane"] == 0
edges = numpy.cos(numpy.radians(numpy.linspace(0, 90, 7)))
height = abs(contacts["normal"][:, 2])
share = numpy.histogram(height, edges[::-1])[0][::-1] / len(height) / -numpy.diff(edges)
assert abs(rose["density"][polar] - share).max() < 1e-12
for plane in (1, 2):
    assert abs(rose["density"][rose["plane"] == plane].mean() - 1) < 1e-12
    assert (rose["plane"] == plane).sum() == 24
chains = table["chains"]
assert (chains["normal_force"] > contacts["normal_force"].mean()).all()
pairs = {tuple(ids[list(pair)]) for pair in contacts["bodies"]}
assert all(pair in pairs for pair in zip(chains["first"], chains["second"]))
PY
}

@test "each table can be printed; standard input and a file say the same" {
  local table
  for table in fabric histogram rose chains; do
    fabric --quiet --tsv --table "$table" "$IN/sheared.h5" > file.tsv
    fabric --quiet --tsv --table "$table" - < "$IN/sheared.h5" > pipe.tsv
    same_bytes file.tsv pipe.tsv
    [[ $(head -1 file.tsv) == "step ["* ]] || show "$table: $(head -1 file.tsv)"
  done
  fabric --quiet -o one.h5 "$IN/sheared.h5"
  fabric --quiet -o - - < "$IN/sheared.h5" > two.h5
  same_bytes one.h5 two.h5
}

@test "grains without contacts have no fabric and are rattlers" {
  exits 0 fabric --quiet --tsv "$IN/bare.h5"
  exits 0 fabric --quiet -o out.h5 "$IN/bare.h5"
  exits 0 "$PYTHON" - <<'PY'
import h5py
import numpy
with h5py.File("out.h5") as file:
    assert file["fields/fabric/rattlers"][0] == 120
    assert numpy.isnan(file["fields/fabric/a_c"][0]) and numpy.isnan(file["fields/rose/density"][0])
    assert "chains" not in file["fields"]
PY
  exits 0 fabric --quiet --tsv --table chains --columns chain,first "$IN/bare.h5"
  [[ $output == $'chain [1]\tfirst [1]' && -z $stderr ]] || show "$output"
}

@test "values that contacts would give are missing without them, and this is said, also in the file" {
  local table said="no contacts, and so no fabric and no anisotropy (nan); the file keeps no contacts of grains that overlap, "
  for table in fabric rose; do
    exits 0 fabric --quiet --tsv --table $table "$IN/bare.h5"
    [[ $output == *nan* && $output != *-nan* && $stderr == "fabric: doubt: step "*": $said"* ]] || show "$table"
  done
  exits 0 fabric --quiet --tsv --columns backbone_coordination_number,force_chain_length "$IN/bare.h5"
  [[ ${lines[1]} == $'nan\tnan' ]] || show
  fabric --quiet -o out.h5 "$IN/bare.h5"
  [[ $(to-vtk --history out.h5) == *"no_contacts: step "*"$said"* ]] || show "no doubt in the file"
  exits 0 fabric --quiet --tsv --table rose --classes 360 --state last "$IN/sheared.h5"
  [[ $output != *-nan* && $stderr == *" classes of the rose hold no contact, and have no mean force (nan); give --classes "* ]] || show
  local fewer=${stderr#*--classes }
  exits 0 fabric --quiet --tsv --table rose --classes "${fewer%%,*}" --state last "$IN/sheared.h5"
  [[ $output != *nan* && -z $stderr ]] || show "the remedy fails"
  exits 0 fabric --quiet --tsv --table rose --classes 360 "$IN/sheared.h5"
  [[ $stderr == *"; this concerns "*" more of the states" ]] || show "the other states are silent"
}

@test "options that change nothing are refused" {
  mentions 64 fabric "--classes 40: --table fabric has none: give --table rose, or leave it out" --tsv --classes 40 "$IN/sheared.h5"
  mentions 64 fabric "--classes 40: --table chains has none" --tsv --table chains --classes 40 "$IN/sheared.h5"
  exits 0 fabric --quiet --tsv --table chains --classes 40 -o out.h5 "$IN/sheared.h5"
  mentions 64 fabric "--table rose: chooses the table that --tsv prints: give --tsv too, or leave it out" --table rose -o rose.h5 "$IN/sheared.h5"
  mentions 65 fabric "sheared.h5: holds no geotextile and no fill, so that --soil has no effect: leave it out" --tsv --soil "$IN/sheared.h5"
}

@test "errors: usage" {
  complains 64 fabric "nothing to do: give --tsv or -o FILE" "$IN/sheared.h5"
  mentions 64 fabric "both write to standard output" --tsv -o - "$IN/sheared.h5"
  mentions 64 fabric "all, first, last or a number" --tsv --state 1.5 "$IN/sheared.h5"
  mentions 64 fabric "1 state, number 0" --tsv --state 1 "$IN/bare.h5"
  mentions 64 fabric "--classes" --tsv --classes 2 "$IN/sheared.h5"
  # A quarter of the circle had two classes of 45 degrees beside ten of 36.
  mentions 64 fabric "which has no whole number of these classes: give --classes 12" --tsv --table rose --classes 10 "$IN/sheared.h5"
  mentions 64 fabric "--state is given twice: first and last; give one" --tsv --state first --state last "$IN/sheared.h5"
  mentions 64 fabric "--output is given twice: one.h5 and two.h5; give one" -o one.h5 -o two.h5 "$IN/sheared.h5"
  mentions 64 fabric "--table" --tsv --table roses "$IN/sheared.h5"
}

@test "errors: input missing, truncated, of another kind" {
  mentions 66 fabric "none.h5" --tsv none.h5
  head -c 5000 "$IN/sheared.h5" > half.h5
  mentions 65 fabric "half.h5" --tsv half.h5
  mentions 65 fabric "fields" --tsv "$IN/fields.h5"
}

@test "errors: output that cannot be made or written" {
  mentions 73 fabric "none/out.h5" -o none/out.h5 "$IN/sheared.h5"
  echo mine > out.h5
  mentions 73 fabric "--force" -o out.h5 "$IN/sheared.h5"
  exits 74 bash -c "fabric --quiet --tsv '$IN/sheared.h5' > /dev/full"
}
