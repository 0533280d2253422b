#!/usr/bin/env bats
# A law, a path, a container and a table from outside the library: one file each, and no other file names them.
# SPDX-License-Identifier: GPL-3.0-or-later
load ../tools/common.bash

setup_file() {
  cd "$BATS_FILE_TMPDIR" || return
  pack-generate --quiet --grains 60 --aspect 1 --pressure 1e5 --tolerance 1e-2 -o start.h5
  cat > toy.toml << 'END'
[contact]
law = "toy"
young_modulus = 5e8
stiffness_ratio = 0.1
friction_angle = 25
toy_softening = 0.02
[guards]
energy_error = 1e9
[[stage]]
path = "toy-path"
toy_pressure = 1.2e5
END
  run-dem start.h5 toy.toml -o run.h5 -q
}

setup() {
  cd "$BATS_FILE_TMPDIR" || return
}

@test "a law, a path and a container of a folder list their keys" {
  run-dem --keys | grep -E '^toy_softening .*share of the stiffness.*law = toy'
  run-dem --keys | grep -E '^toy_pressure .*pressure of the toy.*path = toy-path'
  filter-expand --keys | grep -E '^toy_radius .*radius of the ball.*shape = toy-ball'
  run-dem --keys json | grep '"toy_softening"'
}

@test "a law's own history is in the file with unit and meaning, and a run goes on from it" {
  exits 0 run-dem run.h5 toy.toml --set stage.0.toy_pressure=1.1e5 -o again.h5 -q
  "$PYTHON" - << 'END'
import h5py, numpy
def text(word):
    return word.decode() if isinstance(word, bytes) else word
for name in "run.h5", "again.h5":
    with h5py.File(name) as file:
        frames = file["contacts"]
        last = frames[sorted(frames)[-1]]
        largest, walk = last["toy_largest_overlap"], last["toy_walk"]
        assert text(largest.attrs["units"]) == "m" and "largest overlap" in text(largest.attrs["long_name"])
        assert (largest[:] >= last["overlap"][:]).all() and walk.shape == (len(largest), 3)
        along = numpy.einsum("ij,ij->i", walk[:], last["normal"][:])
        assert abs(walk[:]).max() > 0 and abs(along).max() < 1e-2 * abs(walk[:]).max()
with h5py.File("run.h5") as one, h5py.File("again.h5") as two:
    before, after = (f["contacts"][sorted(f["contacts"])[k]] for f, k in ((one, -1), (two, 0)))
    assert (before["toy_walk"][:] == after["toy_walk"][:]).all(), "the history was not taken over"
END
}

@test "a table of a folder is among the choices, and is made" {
  homogenize --help | grep toy-table
  [[ $(homogenize run.h5 --table toy-table --tsv | tail -n 1) == 60 ]]
}

@test "a container of a folder is filled" {
  cat > plan.toml << 'END'
[container]
shape = "toy-ball"
toy_radius = "20 mm"
[contact]
law = "toy"
young_modulus = 5e8
stiffness_ratio = 0.1
friction_angle = 25
END
  exits 0 filter-expand start.h5 plan.toml -o ball.h5 -q
  exits 0 homogenize ball.h5 --tsv
}
