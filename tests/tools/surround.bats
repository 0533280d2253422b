#!/usr/bin/env bats
# filter-expand's [surround]: a bag in a cell of soil, compacted; the same bytes each time, stopped or not; refusals.
# SPDX-License-Identifier: GPL-3.0-or-later

load common

setup_file() {
  load common
  cd "$BATS_FILE_TMPDIR" || return
  cp "$BATS_TEST_DIRNAME/examples/bag.toml" .
  # The plan is the one in the documentation, as it is pasted.
  awk '/^```toml/ { on = 1; next } /^```/ { on = 0 } on' "$BATS_TEST_DIRNAME/../../lib/packing/PLAN.md" > around.toml
  pack-generate --quiet --grains 300 --void-ratio 0.72 --pressure 1e4 --tolerance 1e-2 -o packing.h5
  pack-generate --quiet --grains 60 --aspect 1 --pressure 1e4 --tolerance 1e-2 -o one.h5 2> doubts
  filter-expand --quiet packing.h5 bag.toml -o bag.h5
  echo 'surround.representative_volume=one.h5 surround.void_ratio=0.65 surround.unbalanced_force=1e-2 surround.max_rate=0.3 surround.height_tolerance=0.02' |
    tr ' ' '\n' | sed 's/^/--set\n/' > options
  mapfile -t around < options
  # The little bag holds less than its own pressure, so it gives way by more than a large one may.
  filter-expand --quiet bag.h5 around.toml "${around[@]}" --history shape.tsv -o cell.h5 2> missed || echo $? > status
}

setup() {
  mkdir "$BATS_TEST_TMPDIR/here"
  cd "$BATS_TEST_TMPDIR/here" || return
  ln -s "$BATS_FILE_TMPDIR"/* .
  mapfile -t around < options
}

@test "a bag in a cell of soil has the void ratio asked for, and the fill bears the pressure" {
  near "$(value shape.tsv void_ratio last)" 0.65 0.004
  near "$(value shape.tsv fill_stress last)" 1e4 0.2
  homogenize cell.h5 --table cell --tsv > cell.tsv
  near "$(value cell.tsv stress_xx last)" 1e4 0.01
  near "$(value cell.tsv stress_zz last)" 1e4 0.01
}

@test "a surrounded bag is the same with two threads, and after a kill" {
  filter-expand --quiet --threads 2 bag.h5 around.toml "${around[@]}" -o two.h5 2> again || true
  cmp again missed
  same_bytes cell.h5 two.h5
  local wait status
  for wait in 0.4 0.7; do
    status=0
    timeout --foreground -s KILL $wait filter-expand --quiet --resume --checkpoint-every 0.1 bag.h5 around.toml "${around[@]}" \
      -o again.h5 2> again || status=$?
    [[ $status -eq 137 || $status -eq 1 ]]
  done
  filter-expand --quiet --resume bag.h5 around.toml "${around[@]}" -o again.h5 2> again || true
  same_bytes cell.h5 again.h5
}

@test "what a compaction missed is named, after the cell was written" {
  [[ $(cat status) -eq 1 && -s cell.h5 ]]
  grep -q "the reinforced part is .* more than surround.height_tolerance" missed
  grep -q "the geotextile is crumpled" missed
  [[ $(wc -l < missed) -eq 1 ]] || show "$(cat missed)"
}

@test "a finished cell that missed something says so again, and is a result with doubts where the plan accepts it" {
  run filter-expand --quiet --resume bag.h5 around.toml "${around[@]}" -o cell.h5
  [[ $status -eq 1 && "$output" == "$(cat missed)" ]] || show "$output"
  filter-expand --quiet bag.h5 around.toml "${around[@]}" --set surround.missed=doubt -o accepted.h5 2> said
  grep -q "^filter-expand: doubt: the reinforced part is .* more than surround.height_tolerance" said
  grep -q "^filter-expand: doubt: the geotextile is crumpled" said
  to-vtk --history accepted.h5 | grep -q "the geotextile is crumpled"
}

@test "plans that put nothing around anything are refused in a line, with nothing written" {
  local plan=(bag.h5 around.toml "${around[@]}" -o out.h5)
  refuses 65 filter-expand "has no geotextile" --quiet packing.h5 "${plan[@]:1}"
  refuses 65 filter-expand "the fill has no room" --quiet "${plan[@]}" --set surround.void_ratio=0.25
  refuses 65 filter-expand "more than twice the reinforced part" --quiet "${plan[@]}" --set surround.scale=9
  refuses 65 filter-expand "raise surround.copies" --quiet "${plan[@]}" --set 'surround.copies=[1,1,1]'
  refuses 65 filter-expand "cannot be reached by lowering friction" --quiet "${plan[@]}" --set material.1.friction_angle=0
  refuses 65 filter-expand "give surround.scale" --quiet "${plan[@]}" --set grains.scale=0.9
  refuses 65 filter-expand "wrapped" --quiet "${plan[@]}" --set surround.form=rapped
  refuses 65 filter-expand "describes 3" --quiet "${plan[@]}" --set surround.material=3
  refuses 65 filter-expand "is one that the file's grains have" --quiet "${plan[@]}" --set surround.material=0
  refuses 65 filter-expand "takes a file that has its geotextile already" --quiet "${plan[@]}" --set container.shape=box
  # The representative volume is an input too, though only the plan names it.
  cp one.h5 volume.h5 && ln -s volume.h5 link.h5
  local name
  for name in volume.h5 link.h5; do
    refuses 73 filter-expand "$name: is read by this command and would be lost; name another file with --output" --quiet --force \
      "${plan[@]:0:${#plan[@]}-1}" "$name" --set surround.representative_volume=volume.h5
    refuses 73 filter-expand "$name: is read by this command and would be lost; name another file with --history" --quiet --force "${plan[@]}" \
      --set surround.representative_volume=volume.h5 --history "$name"
  done
  cmp one.h5 volume.h5
  refuses 66 filter-expand "surround.representative_volume names" --quiet "${plan[@]}" --set surround.representative_volume=none.h5
  refuses 1 filter-expand "ask for at most" --quiet "${plan[@]}" --set surround.void_ratio=1.2 \
    --set surround.first_friction_angle=28
  [[ ! -e out.h5 ]]
}

@test "a pressure of some pascals without a unit, and a loose tolerance, are doubted before the soil is compacted" {
  # The time step is refused before the first step.
  call filter-expand --quiet bag.h5 around.toml "${around[@]}" --set surround.pressure=10 --set surround.unbalanced_force=0.2 \
    --set numerics.time_step=1 -o out.h5
  # shellcheck disable=SC2154  # stderr is set by call
  [[ $status -ne 0 && $stderr == *"doubt: surround.pressure is 10 without a unit, which is 10 Pa: if 10 kPa is meant, write \"10 kPa\""* ]] || show
  [[ $stderr == *"doubt: surround.unbalanced_force is 0.2, which is 20 %: "* ]] || show
  call filter-expand --quiet bag.h5 around.toml "${around[@]}" --set 'surround.pressure="10 Pa"' --set numerics.time_step=1 -o out.h5
  [[ $status -ne 0 && $stderr != *"without a unit"* ]] || show
}
