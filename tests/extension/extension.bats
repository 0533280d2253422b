#!/usr/bin/env bats
# A law, a path, energy terms, a container and a table from outside the library: one file each, and no other file names
# them.
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

@test "an energy term of a folder is a column, enters the balance by its role, and goes on from a checkpoint" {
  cat > balance.py << 'END'
import h5py
with h5py.File("run.h5") as file:
    row = {name: data[:] for name, data in file["series"].items()}
    place = {name: int(data.attrs["column"]) for name, data in file["series"].items() if "column" in data.attrs}
    drag = file["series/toy_drag"].attrs
    assert drag["units"] in (b"J", "J") and "drag of the toy" in str(drag["long_name"])
assert place["damping_dissipation"] < place["toy_drag"] < place["boundary_work"], "its role places it"
assert place["toy_rotational_energy"] == max(place.values()), "only some runs have it"
spin, kinetic = row["toy_rotational_energy"], row["kinetic_energy"]
assert spin[-1] > 0 and (spin <= 1.1 * kinetic).all(), "a share is part of its whole"
gain = {name: values[-1] - values[0] for name, values in row.items()}
held = sum(gain[name] for name in ("kinetic_energy", "elastic_energy", "frictional_dissipation", "rolling_dissipation",
                                   "viscous_dissipation", "damping_dissipation", "law_energy"))
error = gain["boundary_work"] + gain["gravity_work"] - held - gain["toy_drag"]
assert abs(error - gain["energy_error"]) < 1e-6 * gain["toy_drag"], (error, gain)
END
  exits 0 "$PYTHON" balance.py
  # A killed run goes on to the same bytes; without the term's number it does not. Small steps leave the time to kill it.
  local long=(--quiet --checkpoint-every 0.002 --set numerics.time_step_safety=0.1 start.h5 toy.toml)
  run-dem "${long[@]}" -o long.h5
  run-dem "${long[@]}" -o cut.h5 &
  local run=$! tries=0
  until compgen -G 'cut.h5.part/state-*.h5' > there || ((++tries > 500)); do sleep 0.01; done
  kill -s KILL $run
  wait $run || true
  cp -r cut.h5.part less.h5.part
  exits 0 run-dem --resume "${long[@]}" -o cut.h5
  same_bytes long.h5 cut.h5
  "$PYTHON" -c 'import glob, h5py
for name in glob.glob("less.h5.part/*.h5"):
    with h5py.File(name, "r+") as file: del file["checkpoint/energy_toy_drag"]'
  mentions 65 run-dem "keeps no energy_toy_drag" --resume "${long[@]}" -o less.h5
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

@test "the points of fem-dem take a law of a folder, and keep its history" {
  local pull=$BATS_TEST_DIRNAME/../tools/examples/pull.toml
  cat > sand.toml << 'END'
[contact]
law = "toy"
young_modulus = "7.5 GPa"
stiffness_ratio = 0.2
friction_angle = 16
toy_softening = 0.02
[grains]
density = 2700
END
  awk '/^material/ { print "material = \"grains\""; next } /^(density|young|poisson|initial_stress)/ { next } { print }' "$pull" |
    cat - sand.toml > pull.toml
  printf '[record]\npoints = [1]\n' >> pull.toml
  pack-generate --quiet --dimension 2 --grains 40 --aspect 1 --pressure 2e4 --tolerance 1e-2 --density 2700 \
    --material <(sed 's/^friction_angle.*/friction_angle = 0/' sand.toml) -o disks.h5
  fem-dem --quiet pull.toml disks.h5 --set mesh.columns=2 --set mesh.rows=1 --set time.duration=0.02 \
    --set time.output_interval=0.01 -o pull.h5
  fem-dem --take 1 pull.h5 -o point.h5
  "$PYTHON" - << 'END'
import h5py
with h5py.File("point.h5") as file:
    frames = file["contacts"]
    last = frames[sorted(frames)[-1]]
    assert (last["toy_largest_overlap"][:] >= last["overlap"][:]).all() and last["toy_largest_overlap"][:].max() > 0
END
}
