# Writes small files with plain h5py, as lib/files/FORMAT.md specifies them: inputs for to-vtk that no tool of ours made.
# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: vtk_states.py sheared|disks|box|bare|fields|one-step OUT.h5"""
import sys

import h5py
import numpy

TEXT = h5py.string_dtype()


def root(file, kind):
    file.attrs["format"], file.attrs["kind"] = "soilweave", kind
    file.attrs["format_version"] = numpy.array([1, 0])
    file.attrs["creator"], file.attrs["creator_version"] = "by hand", "0"
    record = file.create_group("provenance/0")
    record.attrs["tool"], record.attrs["version"] = "by hand", "0"
    record.attrs["command"], record.attrs["seed"] = "vtk_states.py", numpy.uint64(5)
    file.create_group("provenance/0/inputs")


def labelled(file, path, values, units="1"):
    file[path] = values
    file[path].attrs["units"] = file[path].attrs["unit"] = units
    file[path].attrs["long_name"] = path.rsplit("/", 1)[-1]


def contacts_of(position, radius, cell, periodic, planes):
    """All overlapping pairs between nearest images, with forces drawn from the overlap; then planes."""
    inverse, rows = numpy.linalg.inv(cell), []
    for i, centre in enumerate(position):
        for j in range(i + 1, len(position)):
            image = numpy.where(periodic, numpy.round(inverse @ (centre - position[j])), 0)
            branch = position[j] + cell @ image - centre
            overlap = radius[i] + radius[j] - numpy.linalg.norm(branch)
            if overlap > 0:
                rows.append((i, j, image, branch, overlap))
        for k, (point, normal) in enumerate(planes):
            depth = (centre - point) @ normal
            if depth < radius[i]:
                rows.append((i, -1 - k, numpy.zeros(3), -depth * normal, radius[i] - depth))
    return sorted(rows, key=lambda row: row[:2])


def write_contacts(file, frame, rows, disks):
    branch = numpy.array([row[3] for row in rows]).reshape(-1, 3)
    normal = branch / numpy.linalg.norm(branch, axis=1, keepdims=True)
    overlap = numpy.array([row[4] for row in rows])
    third = numpy.array([0, 0, 1.0]) if disks else numpy.array([0.2, 0.3, 1.0])
    shear = 300 * overlap[:, None] * numpy.cross(normal, third)
    group = f"contacts/{frame:06d}/"
    labelled(file, group + "bodies", numpy.array([row[:2] for row in rows], "i4").reshape(-1, 2))
    labelled(file, group + "image", numpy.array([row[2] for row in rows], "i4").reshape(-1, 3))
    labelled(file, group + "normal", normal)
    labelled(file, group + "branch_vector", branch, "m")
    labelled(file, group + "overlap", overlap, "m")
    labelled(file, group + "normal_force", 1000 * overlap, "N")
    labelled(file, group + "shear_force", shear, "N")
    labelled(file, group + "rolling_moment", numpy.zeros_like(normal), "N m")
    labelled(file, group + "twisting_moment", numpy.zeros(len(rows)), "N m")
    labelled(file, group + "sliding", (overlap > numpy.median(overlap)).astype("u1") if rows else numpy.zeros(0, "u1"))


def write_trajectory(file, position, cells, radius, boundary, dimension):
    frames, count = position.shape[:2]
    grains = "particles/grains/"
    file.create_group("h5md").attrs["version"] = numpy.array([1, 1])
    for part in ("author", "creator"):
        file.create_group("h5md/" + part).attrs["name"] = "by hand"
    file["h5md/creator"].attrs["version"] = "0"
    units = file.create_group("h5md/modules/units")
    units.attrs["version"], units.attrs["system"] = numpy.array([1, 0]), "SI"
    velocity = numpy.linspace(-1e-3, 1e-3, frames * count * dimension).reshape(frames, count, dimension)
    spin = numpy.zeros((frames, count, 3))
    spin[:, :, 2] = numpy.linspace(-2, 2, count)
    quaternion = numpy.tile([1.0, 0, 0, 0], (frames, count, 1))
    labelled(file, grains + "position/step", 250 * numpy.arange(frames))
    labelled(file, grains + "position/time", 0.0125 * numpy.arange(frames), "s")
    labelled(file, grains + "position/value", position[:, :, :dimension], "m")
    labelled(file, grains + "box/edges/value", cells[:, :dimension, :dimension].transpose(0, 2, 1), "m")
    for name, value, unit in (("orientation", quaternion, "1"), ("velocity", velocity, "m s-1"),
                              ("angular_velocity", spin, "rad s-1")):
        labelled(file, grains + name + "/value", value, unit)
    for name in ("box/edges", "orientation", "velocity", "angular_velocity"):
        for axis in ("step", "time"):
            file[grains + name + "/" + axis] = file[grains + "position/" + axis]
    file[grains + "orientation"].attrs["order"] = "wxyz"
    for name in ("velocity", "angular_velocity"):
        file[grains + name].attrs["time_offset"] = -0.5
    labelled(file, grains + "radius", radius, "m")
    labelled(file, grains + "mass", 2650 * 4 / 3 * numpy.pi * radius**3, "kg")
    labelled(file, grains + "species", numpy.zeros(count, "i4"))
    labelled(file, grains + "id", 1000 + numpy.arange(count)[::-1])
    labelled(file, grains + "copy_id", numpy.arange(count, dtype="i4") % 2)
    box = file[grains + "box"]
    box.attrs["dimension"] = dimension
    box.attrs.create("boundary", ["periodic" if b else "none" for b in boundary[:dimension]], dtype=TEXT)


def write_states(path, case):
    random = numpy.random.default_rng(11)
    dimension, frames = (2 if case == "disks" else 3), (1 if case == "bare" else 3)
    count = 120 if dimension == 3 else 60
    periodic = numpy.array([case != "box"] * dimension + [False] * (3 - dimension))
    fraction = random.random((count, 3)) * (1 if case == "box" else 4) - (0 if case == "box" else 1.5)
    fraction[:, dimension:] = 0
    radius = random.uniform(0.008, 0.012, count) * (1 if dimension == 3 else 0.6)
    planes = [(numpy.array([0.0, 0, 0]), numpy.array([0.0, 0, 1])),
              (numpy.array([0.1, 0, 0]), numpy.array([-0.6, 0, 0.8]))] if case == "box" else []
    cells = numpy.array([0.1 * (numpy.eye(3) + f * numpy.eye(3, k=1) * [0, 0.2, 0 if dimension == 2 else 0.15])
                         for f in range(frames)])
    position = numpy.einsum("fij,gj->fgi", cells, fraction)
    with h5py.File(path, "w") as file:
        root(file, "packing" if frames == 1 else "run")
        write_trajectory(file, position, cells, radius, periodic, dimension)
        labelled(file, "cell/velocity_gradient", numpy.zeros((frames, 3, 3)), "s-1")
        labelled(file, "cell/deformation_gradient", numpy.tile(numpy.eye(3), (frames, 1, 1)))
        if dimension == 2:
            labelled(file, "cell/thickness", numpy.ones(frames), "m")
        for frame in range(frames):
            rows = [] if case == "bare" else contacts_of(position[frame], radius, cells[frame], periodic, planes)
            write_contacts(file, frame, rows, dimension == 2)
        if planes:
            for name, values, unit in (("point", [p for p, _ in planes], "m"), ("normal", [n for _, n in planes], "1"),
                                       ("velocity", numpy.zeros((2, 3)), "m s-1")):
                labelled(file, "planes/" + name, numpy.tile(values, (frames, 1, 1)), unit)
            labelled(file, "planes/material_id", numpy.ones((frames, 2), "i4"))
        if frames > 1:
            labelled(file, "scenario", "law = \"linear\"\n")
            for place, (name, values) in enumerate((("step", 250 * numpy.arange(frames)),
                                                    ("time", 0.0125 * numpy.arange(frames)))):
                labelled(file, "series/" + name, values)
                file["series/" + name].attrs["column"] = place


def write_fields(path, states):
    """Grain fields for some states of `sheared`, a table without places, one with places alone, one with both."""
    count, steps = 120, 250.0 * numpy.arange(states)
    groups = {
        "global": {"step": steps, "mean_stress": steps + 1e5},
        "places": {"x": steps, "y": steps},
        "volumes": {"step": steps, "time": 0.0125 * numpy.arange(states), "x": steps * 0, "y": steps * 0 + 1,
                    "z": steps * 0 + 2, "stress_xx": steps, "stress_xy": steps + 1, "stress_yy": steps + 2,
                    "stress_xz": steps + 3, "stress_yz": steps + 4, "stress_zz": steps + 5},
        "grains": {"step": numpy.repeat(steps, count), "body_id": numpy.tile(1000.0 + numpy.arange(count), states),
                   "void_ratio": numpy.arange(float(states * count))},
    }
    with h5py.File(path, "w") as file:
        root(file, "fields")
        for order, (group, columns) in enumerate(groups.items()):
            file.create_group("fields/" + group).attrs["long_name"] = group
            file["fields/" + group].attrs["order"] = order
            for place, (name, values) in enumerate(columns.items()):
                labelled(file, f"fields/{group}/{name}", values.astype(float))
                file[f"fields/{group}/{name}"].attrs["column"] = place


if sys.argv[1] in ("fields", "one-step"):
    write_fields(sys.argv[2], 3 if sys.argv[1] == "fields" else 1)
else:
    write_states(sys.argv[2], sys.argv[1])
