#!/usr/bin/env bats
# homogenize: the same numbers as numpy sums, parts that add up to the whole, pipes, and every class of error.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  analysis_inputs
}

setup() {
  cd "$BATS_TEST_TMPDIR" || return
}

@test "the cell's stress, invariants and void ratio are numpy's, in space and in the plane" {
  local case
  for case in sheared disks; do
    exits 0 homogenize --quiet --tsv "$IN/$case.h5"
    printf '%s\n' "$output" > "$case.tsv"
    exits 0 "$PYTHON" "$BATS_TEST_DIRNAME/analysis_reference.py" "$IN/$case.h5" "$case.tsv"
    [[ $output == "3 states, "* ]] || show "compared too little"
  done
}

@test "the power cells fill the cell, its copies add up to it" {
  homogenize --quiet --tsv --tessellation "$IN/sheared.h5" > cell.tsv
  near "$(value cell.tsv void_ratio_tessellation 3)" "$(value cell.tsv void_ratio 3)" 1e-9
  homogenize --quiet --tsv --copies --table volumes --state last "$IN/sheared.h5" > copies.tsv
  [[ $(wc -l < copies.tsv) -eq 3 ]] || show "$(cat copies.tsv)"
  local one other stress
  one=$(value copies.tsv volume 1) other=$(value copies.tsv volume 2)
  stress=$(awk -v v="$one" -v w="$other" -v s="$(value copies.tsv mean_stress 1)" -v t="$(value copies.tsv mean_stress 2)" \
    'BEGIN { printf "%.15g", (v * s + w * t) / (v + w) }')
  near "$stress" "$(value cell.tsv mean_stress 3)" 1e-9
  near "$(awk -v v="$one" -v w="$other" 'BEGIN { printf "%.15g", v + w }')" 1e-3 1e-9
}

@test "a box around everything is the cell, two halves hold each grain once" {
  homogenize --quiet --tsv --state 0 "$IN/sheared.h5" > cell.tsv
  homogenize --quiet --tsv --state 0 --table volumes --box 0,0.1,0,0.1,0,0.1 --box 0,0.05,0,0.1,0,0.1 \
    --box 0.05,0.1,0,0.1,0,0.1 "$IN/sheared.h5" > boxes.tsv
  near "$(value boxes.tsv mean_stress 1)" "$(value cell.tsv mean_stress 1)" 1e-9
  near "$(value boxes.tsv void_ratio 1)" "$(value cell.tsv void_ratio 1)" 1e-9
  [[ $(($(value boxes.tsv grains 2) + $(value boxes.tsv grains 3))) -eq 120 ]] || show "$(cat boxes.tsv)"
}

@test "overlapping grains without contacts are doubted" {
  to-vtk --text "$IN/sheared.h5" > spheres.txt
  pack-generate --quiet --import spheres.txt --as-is -o imported.h5
  call homogenize imported.h5 --tsv --columns mean_stress
  [[ $status -eq 0 && $stderr == *"doubt: step 0: "*" pairs of grains overlap, and the stress and coordination number count none of them (0): "* ]] || show
  call homogenize imported.h5 --tsv --table grains
  [[ $status -eq 0 && $stderr == *"pairs of grains overlap"* ]] || show
}

@test "a volume of few grains is doubted, in the file too" {
  exits 0 homogenize --state 0 --box 0,0.1,0,0.1,0,0.1 -o all.h5 "$IN/sheared.h5"
  [[ -z $stderr ]] || show
  exits 0 homogenize --state 0 --box 0,0.04,0,0.1,0,0.1 -o few.h5 "$IN/sheared.h5"
  [[ $stderr == "homogenize: doubt: grains in box 0 0.04 0 0.1 0 0.1: "*", fewer than 64: its stress and void ratio are those of single grains"* ]] || show
  exits 0 to-vtk --history few.h5
  [[ $output == *"  doubt: few-grains: grains in box"* ]] || show
}

@test "grains: their stress, weighted by their cells, is the cell's; their strain is the motion's" {
  homogenize --quiet --tsv --state last "$IN/sheared.h5" > cell.tsv
  homogenize --quiet --tsv --state last --table grains "$IN/sheared.h5" > grains.tsv
  [[ $(wc -l < grains.tsv) -eq 121 ]] || show "rows"
  near "$(table '{ v = c("cell_volume"); sum += v * c("stress_zz"); all += v } END { printf "%.15g", sum / all }' grains.tsv)" \
    "$(value cell.tsv stress_zz 1)" 1e-9
  # The grains of this file move with the cell: x += 0.4 y, y += 0.3 z; every grain has the same strain.
  exits 0 "$PYTHON" - <<'PY'
import numpy
gradient = numpy.array([[1, 0.4, 0], [0, 1, 0.3], [0, 0, 1.0]])
values, vectors = numpy.linalg.eigh(gradient @ gradient.T)
strain = -0.5 * vectors @ numpy.diag(numpy.log(values)) @ vectors.T
names = [name.split(" [")[0] for name in open("grains.tsv").readline().rstrip("\n").split("\t")]
rows = numpy.loadtxt("grains.tsv", skiprows=1)
for i in range(3):
    for j in range(i, 3):
        column = rows[:, names.index("strain_" + "xyz"[i] + "xyz"[j])]
        assert abs(column - strain[i, j]).max() < 1e-9, (i, j, column, strain[i, j])
PY
}

@test "standard input, a file and a written file say the same" {
  homogenize --quiet --tsv "$IN/sheared.h5" > file.tsv
  homogenize --quiet --tsv - < "$IN/sheared.h5" > pipe.tsv
  same_bytes file.tsv pipe.tsv
  homogenize --quiet --grains -o one.h5 "$IN/sheared.h5"
  homogenize --quiet --grains -o - "$IN/sheared.h5" > two.h5
  same_bytes one.h5 two.h5
  exits 0 "$PYTHON" - <<'PY'
import h5py
lines = [line.rstrip("\n").split("\t") for line in open("file.tsv")]
with h5py.File("one.h5") as file:
    for place, head in enumerate(lines[0]):
        name, unit = head[:-1].split(" [")
        column = file["fields/cell/" + name]
        assert column.attrs["units"] == unit.encode() or column.attrs["units"] == unit, (head, column.attrs["units"])
        assert column[()].tolist() == [float(line[place]) for line in lines[1:]], head
    assert file["fields/grains/body_id"].shape == (360,)
PY
  exits 0 to-vtk --history one.h5
  [[ $output == *"homogenize --grains"* && $output == *"by hand"* ]] || show "history"
}

@test "the run's own series" {
  exits 0 homogenize --quiet --tsv --table series "$IN/sheared.h5"
  [[ $output == "step ["*$'\n'"0"*$'\n'"250"*$'\n'"500"* ]] || show "series"
}

@test "--list names the tables that a file can give, --columns the columns printed, in their order" {
  exits 0 homogenize --list "$IN/sheared.h5"
  local table
  while IFS=$'\t' read -r table _; do
    [[ $table == volumes ]] || homogenize --quiet --tsv --table "$table" "$IN/sheared.h5" > "$table.tsv"
  done <<< "$output"
  [[ -s cell.tsv && -s grains.tsv && -s series.tsv && ! -e yarns.tsv ]] || show "tables"
  exits 0 homogenize --list "$IN/bare.h5"
  [[ $output != *series* ]] || show "a packing has no series"
  exits 0 homogenize --quiet --tsv --columns void_ratio,step "$IN/sheared.h5"
  [[ $output == $'void_ratio [1]\tstep [1]\n'* ]] || show "columns"
  mentions 64 homogenize "--columns: no column 'void_ration'; did you mean 'void_ratio'?" --tsv --columns void_ration "$IN/sheared.h5"
  mentions 64 homogenize "step is named twice" --tsv --columns step,step "$IN/sheared.h5"
  mentions 64 homogenize "--columns belongs to --tsv" --columns step -o out.h5 "$IN/sheared.h5"
  mentions 64 homogenize "--list excludes" --list --tsv "$IN/sheared.h5"
}

@test "the stress, strain and void ratio of a run's states are what the engine recorded" {
  pack-generate --quiet --grains 60 --aspect 1 --void-ratio 0.7 --pressure 1e5 -o packing.h5
  run-dem --quiet packing.h5 "$BATS_TEST_DIRNAME/examples/triaxial.toml" -o run.h5
  homogenize --quiet --tsv run.h5 > states.tsv
  homogenize --quiet --tsv --table series run.h5 > series.tsv
  local column row last
  row=$(($(wc -l < states.tsv) - 1)) last=$(($(wc -l < series.tsv) - 1))
  [[ $(value states.tsv step $row) == "$(value series.tsv step $last)" ]] || show "the last state is not the last record"
  for column in stress_zz stress_xy mean_stress deviatoric_stress strain_zz strain_volumetric void_ratio \
    coordination_number; do
    near "$(value states.tsv $column $row)" "$(value series.tsv $column $last)" 1e-9
  done
}

@test "boxes of disks have no z, which may be taken for the height" {
  mentions 65 homogenize "disks.h5: --box 0,0.05,-1,1,0,0.05: has 6 numbers, and the grains are disks, which have no z: give X0,X1,Y0,Y1, where y is up" \
    --tsv --table volumes --box 0,0.05,-1,1,0,0.05 "$IN/disks.h5"
  mentions 65 homogenize "--box 0,1,0,1: has 4 numbers, and the grains are spheres: give X0,X1,Y0,Y1,Z0,Z1" \
    --tsv --table volumes --box 0,1,0,1 "$IN/sheared.h5"
  mentions 65 homogenize "the extent of the state, which is 0.1 and 0.1 m along x and y: coordinates are in metres" \
    --tsv --table volumes --box 0,50,0,50 "$IN/disks.h5"
  pack-generate --quiet --dimension 2 --grains 60 --pressure 1e5 -o packed.h5
  exits 0 homogenize --quiet --tsv --table volumes --box 0,0.03,0,0.03 packed.h5
  [[ ${#lines[@]} -eq 2 ]] || show
}

@test "errors: usage" {
  complains 64 homogenize "--box 0,1,0,1,0,1 is given twice, and would be two volumes: give it once" --tsv --table volumes --box 0,1,0,1,0,1 \
    --box 0,1,0,1,0,1 "$IN/sheared.h5"
  complains 64 homogenize "nothing to do: give --tsv, --list or -o FILE" "$IN/sheared.h5"
  mentions 64 homogenize "both write to standard output" --tsv -o - "$IN/sheared.h5"
  mentions 64 homogenize "all, first, last or a number" --tsv --state middle "$IN/sheared.h5"
  mentions 64 homogenize "3 states, 0 to 2" --tsv --state 3 "$IN/sheared.h5"
  mentions 64 homogenize "from low to high" --tsv --table volumes --box 0,1,0,1,1,0 "$IN/sheared.h5"
  mentions 64 homogenize "from low to high" --tsv --table volumes --box 0,1,0,1,0 "$IN/sheared.h5"
  mentions 64 homogenize "from low to high" --tsv --table volumes --box 0,1,1,0 "$IN/disks.h5"
  mentions 64 homogenize "from low to high" --tsv --table volumes --box nan,1,0,1,0,1 "$IN/sheared.h5"
  mentions 64 homogenize "from low to high" --tsv --table volumes --box=-inf,1,0,1,0,1 "$IN/sheared.h5"
  mentions 64 homogenize "from low to high" --tsv --table volumes --box 0,1,0,x,0,1 "$IN/sheared.h5"
  mentions 64 homogenize "needs --box, --copies or --groups" --tsv --table volumes "$IN/sheared.h5"
  mentions 64 homogenize "--table" --tsv --table cells "$IN/sheared.h5"
  mentions 64 homogenize "--state 0: --table series has a row for each station of the whole run: leave --state out" \
    --tsv --table series --state 0 "$IN/sheared.h5"
  mentions 64 homogenize "--table loading has a row" --tsv --table loading --state last "$IN/sheared.h5"
  mentions 64 homogenize "--state first: --table broken is of the last state" --tsv --table broken --state first "$IN/sheared.h5"
  mentions 64 homogenize "belongs to --table volumes" --tsv --box 0,1,0,1,0,1 "$IN/sheared.h5"
  mentions 64 homogenize "--grains belongs to --table grains" --tsv --grains "$IN/sheared.h5"
  mentions 64 homogenize "belongs to --table cell" --tsv --table grains --tessellation "$IN/sheared.h5"
  mentions 64 homogenize "--list prints names alone: leave --state and the flags of tables out" --list --state last "$IN/sheared.h5"
  mentions 64 homogenize "--table bag: chooses the table that --tsv prints: give --tsv too, or leave it out" --table bag -o out.h5 "$IN/sheared.h5"
  exits 0 homogenize --quiet --table grains -o out.h5 "$IN/sheared.h5"
}

@test "errors: input missing, truncated, of another kind, without what was asked" {
  mentions 66 homogenize "none.h5" --tsv none.h5
  head -c 5000 "$IN/sheared.h5" > half.h5
  mentions 65 homogenize "half.h5" --tsv half.h5
  echo words > words.h5
  mentions 65 homogenize "words.h5" --tsv words.h5
  mentions 65 homogenize "fields" --tsv "$IN/fields.h5"
  mentions 65 homogenize "series" --tsv --table series "$IN/bare.h5"
  mentions 65 homogenize "no yarns" --tsv --table yarns "$IN/sheared.h5"
  mentions 65 homogenize "no yarns" --tsv --table bag "$IN/sheared.h5"
  mentions 65 homogenize "no yarns" --yarns -o out.h5 "$IN/sheared.h5"
  mentions 65 homogenize "no groups along x" --groups -o out.h5 "$IN/sheared.h5"
  # Millimetres and centimetres for metres; a box may be too large along some axes.
  mentions 65 homogenize "sheared.h5: --box 0,50,0,100,0,100: an edge has 1000 times the extent of the state, which is 0.1, 0.1 and 0.1 m along x, y and z: coordinates are in metres, as 0.015 for 15 mm" \
    --box 0,50,0,100,0,100 -o out.h5 "$IN/sheared.h5"
  mentions 65 homogenize "coordinates are in metres" --tsv --table volumes --box 0,2.5,0,10,0,10 "$IN/sheared.h5"
  mentions 65 homogenize "coordinates are in metres" --tsv --table volumes --box 0,100,0,100,0,1 "$IN/sheared.h5"
  exits 0 homogenize --quiet --tsv --table volumes --box 0,0.05,-3,3,-1,1 "$IN/sheared.h5"
  mentions 65 homogenize "no grain lies in box" --box 5,6,5,6,5,6 -o out.h5 "$IN/sheared.h5"
  [[ ! -e out.h5 ]]
}

@test "errors: a grain inside another is told by its number" {
  cp "$IN/bare.h5" hidden.h5
  "$PYTHON" - <<'PY'
import h5py
with h5py.File("hidden.h5", "r+") as file:
    position, radius = file["particles/grains/position/value"], file["particles/grains/radius"]
    position[:, 5] = position[:, 9] + [1e-4, 0, 0]
    radius[5] = 1e-3
PY
  mentions 70 homogenize "grain 1114 has no power cell" --grains -o out.h5 hidden.h5
}

@test "errors: output that cannot be made or written" {
  mentions 73 homogenize "none/out.h5" -o none/out.h5 "$IN/sheared.h5"
  echo mine > out.h5
  mentions 73 homogenize "--force" -o out.h5 "$IN/sheared.h5"
  [[ $(cat out.h5) == mine ]] || show "the file was touched"
  exits 0 homogenize --quiet --force -o out.h5 "$IN/sheared.h5"
  exits 74 bash -c "homogenize --quiet --tsv '$IN/sheared.h5' > /dev/full"
  exits 74 bash -c "homogenize --quiet -o - '$IN/sheared.h5' > /dev/full"
}
