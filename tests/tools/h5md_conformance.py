# Checks files of ours with plain h5py: H5MD 1.1 with its module units, and units and long_name on every dataset.
# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: h5md_conformance.py FILE...   Prints what it met; exit status 1 and one line a fault otherwise."""
import re
import sys

import h5py
import numpy

# As the module "units" of H5MD has them: units and powers, separated by blanks.
UNIT = re.compile(r"^[A-Za-z]+[+-]?\d*( [A-Za-z]+[+-]?\d*)*$")


class Faults:
    def __init__(self, name):
        self.name, self.count = name, 0

    def demand(self, good, *words):
        if not good:
            print(f"{self.name}:", *words)
            self.count += 1
        return good


def text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def check_versions(group, wanted, faults):
    version = group.attrs.get("version")
    faults.demand(version is not None and version.dtype.kind == "i" and list(version) == wanted, group.name,
                  "has the version", version, "where", wanted, "belongs")


def check_words(file, faults):
    """The attributes that H5MD defines are texts of variable length, which h5py gives as str."""
    grains = file["particles/grains"]
    words = [file["h5md/author"].attrs["name"], file["h5md/creator"].attrs["name"], *grains["box"].attrs["boundary"],
             grains["position/time"].attrs["unit"], grains["velocity/value"].attrs["unit"]]
    faults.demand(all(isinstance(word, str) for word in words), "not all words are str:", words)
    faults.demand(grains["position/time"].attrs["unit"] == "s", "time is not in s")
    # MDAnalysis knows no metre, and opens no file whose positions have a unit that it does not know.
    faults.demand("unit" not in grains["position/value"].attrs, "positions have a unit that MDAnalysis refuses")


def check_head(file, faults):
    if not faults.demand("h5md" in file, "no group /h5md"):
        return
    check_versions(file["h5md"], [1, 1], faults)
    for path, names in {"author": ["name"], "creator": ["name", "version"]}.items():
        for name in names:
            faults.demand(text(file["h5md"][path].attrs.get(name, "")), f"/h5md/{path} has no {name}")
    units = file["h5md/modules/units"]
    check_versions(units, [1, 0], faults)
    faults.demand(text(units.attrs["system"]) == "SI", "units are not SI")


def check_clock(group, frames, faults):
    step, time = group["step"], group["time"]
    faults.demand(step.dtype.kind == "i" and step.shape == (frames,), step.name, "is no row of integers")
    faults.demand(time.dtype.kind == "f" and time.shape == (frames,), time.name, "is no row of numbers")
    faults.demand((numpy.diff(step[:]) >= 0).all(), step.name, "decreases")
    faults.demand((numpy.diff(time[:]) >= 0).all(), time.name, "decreases")


def check_element(element, shape, kind, faults):
    """shape: without frames. Returns the number of frames, None for a value that lasts."""
    frames, values = None, element
    if isinstance(element, h5py.Group):
        values = element["value"]
        frames = values.shape[0]
        check_clock(element, frames, faults)
    faults.demand(values.shape[0 if frames is None else 1:] == shape, values.name, "has the shape", values.shape)
    faults.demand(values.dtype.kind == kind, values.name, "has the type", values.dtype)
    return frames


def check_box(group, faults):
    box = group["box"]
    dimension = int(box.attrs["dimension"])
    boundary = [text(b) for b in box.attrs["boundary"]]
    faults.demand(len(boundary) == dimension and set(boundary) <= {"periodic", "none"}, box.name, "boundary", boundary)
    frames = check_element(box["edges"], (dimension, dimension), "f", faults)
    faults.demand(frames == group["position/value"].shape[0], "edges have other frames than positions")
    for name in ("step", "time"):
        faults.demand(box["edges"][name] == group["position"][name], f"box/edges/{name} is not that of the positions")
    return dimension


def check_particles(file, faults):
    for name, group in file["particles"].items():
        dimension = check_box(group, faults)
        grains = group["position/value"].shape[1]
        elements = {"position": ((grains, dimension), "f"), "velocity": ((grains, dimension), "f"),
                    "mass": ((grains,), "f"), "species": ((grains,), "i"), "id": ((grains,), "i"),
                    "radius": ((grains,), "f"), "copy_id": ((grains,), "i"), "orientation": ((grains, 4), "f"),
                    "angular_velocity": ((grains, 3), "f")}
        for element, (shape, kind) in elements.items():
            if faults.demand(element in group, f"no {element} in {group.name}"):
                check_element(group[element], shape, kind, faults)
        faults.demand("image" not in group, "image belongs to wrapped positions")
        for element in ("velocity", "angular_velocity"):
            faults.demand(group[element].attrs["time_offset"] == -0.5, group[element].name, "has no time_offset")
        faults.demand(text(group["orientation"].attrs["order"]) == "wxyz", "orientation has no order")
        identity = group["id/value" if isinstance(group["id"], h5py.Group) else "id"][...].reshape(-1, grains)
        faults.demand(all(len(set(row)) == grains for row in identity), "id names grains twice")
        norm = numpy.linalg.norm(group["orientation/value"][:], axis=-1)
        faults.demand((abs(norm - 1) < 1e-6).all(), "orientations are no unit quaternions")


def check_observables(file, faults):
    for name, group in file.get("observables", {}).items():
        frames = group["value"].shape[0]
        check_clock(group, frames, faults)
        # Readers of H5MD take observables frame by frame: as many as the trajectory has, on its own clock.
        clock = file["particles/grains/position"]
        faults.demand(group["step"] == clock["step"] and group["time"] == clock["time"], group.name, "has another clock")
        series = dict(zip(file["series/step"][:], file["series"][name][:]))
        wanted = numpy.array([series[step] for step in clock["step"][:]])
        faults.demand(numpy.array_equal(group["value"][:], wanted, equal_nan=True), group.name, "is not the series' values")


def check_datasets(file, faults):
    """Reads every dataset; returns how many there are."""
    count = 0

    def visit(path, item):
        nonlocal count
        if not isinstance(item, h5py.Dataset):
            return
        count += 1
        item[...]
        for name in ("units", "long_name"):
            faults.demand(text(item.attrs.get(name, "")), f"/{path} has no {name}")
        unit = text(item.attrs.get("unit", "m"))
        faults.demand(UNIT.match(unit), f"/{path} has the unit {unit!r}")
        faults.demand("unit" not in item.attrs or unit == text(item.attrs["units"]), f"/{path}: unit is not units")

    file.visititems(visit)
    return count


def check(name):
    faults = Faults(name)
    with h5py.File(name, "r") as file:
        kind = text(file.attrs["kind"])
        faults.demand(text(file.attrs["format"]) == "soilweave", "no attribute format")
        faults.demand(list(file.attrs["format_version"]) == [1, 3], "format_version is not 1.3")
        faults.demand(len(file["provenance"]) > 0, "no provenance")
        if kind in ("packing", "run"):
            check_head(file, faults)
            check_words(file, faults)
            check_particles(file, faults)
            check_observables(file, faults)
            frames = file["particles/grains/position/value"].shape[0]
            wanted = [f"{frame:06}" for frame in range(frames)]
            faults.demand(sorted(file["contacts"]) == wanted, "contacts are not one group a frame")
        datasets = check_datasets(file, faults)
    print(f"{name}: {kind}, {datasets} datasets, {faults.count} faults")
    return faults.count == 0


if __name__ == "__main__":
    if not sys.argv[1:]:
        sys.exit(__doc__)
    sys.exit(0 if all([check(name) for name in sys.argv[1:]]) else 1)
