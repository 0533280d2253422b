# Opens what to-vtk wrote in ParaView and holds it against the HDF5 file it was made from.
# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: python3 paraview_check.py expect FILE.h5 [--fields FIELDS.h5] > EXPECTED.json
       pvpython paraview_check.py open FOLDER EXPECTED.json
       python3 paraview_check.py look PICTURE.png PANELS_IN_ROW,... [--red PANEL]

expect and look are for Debian's own interpreter: ParaView's HDF5 and that of h5py do not go into one process.
EXPECTED: for every group the states, each with its time, its numbers of points and cells, and for each array the
number of values, the least, the greatest and their sum."""
import argparse
import glob
import json
import os

import numpy

GRAIN_ARRAYS = {"body_id": "id", "copy_id": "copy_id", "radius": "radius", "mass": "mass"}


def summary(values):
    values = numpy.asarray(values, dtype=float).ravel()
    known = values[~numpy.isnan(values)]
    ends = [known.min(), known.max(), known.sum()] if known.size else [0, 0, 0]
    return [int(values.size), int(known.size)] + [float(end) for end in ends]


def state(time, points, cells, point=(), cell=()):
    return {"time": float(time), "points": points, "cells": cells,
            "point": {name: summary(values) for name, values in dict(point).items()},
            "cell": {name: summary(values) for name, values in dict(cell).items()}}


# ---- What the HDF5 file says ----------------------------------------------------------------------------------------
def at(item, frame):
    return item["value"][frame] if hasattr(item, "keys") else item[...]


def table_states(table):
    """A group of columns as a dictionary of arrays for each of its steps."""
    columns = {name: table[name][...] for name in table}
    for step in sorted(set(columns["step"])):
        yield {name: values[columns["step"] == step] for name, values in columns.items()}


def components(rows, names):
    """Returns the arrays of these rows: vectors and tensors by their components, as in the table."""
    return {name: rows[name] for name in names if name in rows}


def expect_run(file, fields):
    grains = file["particles/grains"]
    count = grains["radius"].shape[0] if hasattr(grains["radius"], "shape") else grains["radius/value"].shape[1]
    expected = {}
    for frame, time in enumerate(grains["position/time"][...]):
        point = {shown: at(grains[name], frame) for shown, name in GRAIN_ARRAYS.items()}
        if fields:
            joined = list(table_states(fields["fields/grains"]))[frame]
            point.update(components(joined, ("strain_deviatoric", "strain_volumetric", "cell_volume", "mean_stress")))
        expected.setdefault("grains", []).append(state(time, count, count, point))
        expected.setdefault("cell", []).append(state(time, 8, 1))
        contacts = file[f"contacts/{frame:06d}"]
        if any(kind in (b"periodic", "periodic") for kind in grains["box"].attrs["boundary"]):
            lines = None  # those through the faces are drawn twice
            shown = {}
        else:
            lines = contacts["normal_force"].shape[0]
            shown = {"normal_force": contacts["normal_force"][...],
                     "shear_force_magnitude": numpy.linalg.norm(contacts["shear_force"][...], axis=1),
                     "sliding": contacts["sliding"][...]}
        expected.setdefault("contacts", []).append(state(time, None if lines is None else 2 * lines, lines, (), shown))
        if "planes" in file:
            planes = file["planes/material_id"][frame]
            expected.setdefault("planes", []).append(
                state(time, 4 * len(planes), len(planes), (), {"material_id": planes}))
        if "yarns" in file:
            yarns = {name: file["yarns/" + name][frame] for name in file["yarns"]}
            whole, broken = yarns["broken"] == 0, yarns["broken"] != 0
            expected.setdefault("yarns", []).append(
                state(time, 2 * int(whole.sum()), int(whole.sum()), (),
                      {name: yarns[name][whole] for name in ("tension", "family", "fabric")}))
            gone = {"yarn": numpy.flatnonzero(broken), "break_time": yarns["break_time"][broken]}
            expected.setdefault("broken", []).append(
                state(time, int(broken.sum()), int(broken.sum()), gone if broken.any() else ()))
    return expected


def expect_fields(file):
    expected = {}
    for name in set(file["fields"]) & {"grains", "yarns", "broken"}:
        for rows in table_states(file["fields/" + name]):
            count, time = len(rows["step"]), rows["time"][0]
            if name == "yarns":
                cell = components(rows, ("tension", "strain", "length", "broken", "family"))
                expected.setdefault(name, []).append(state(time, 2 * count, count, (), cell))
            else:
                point = components(rows, ("radius", "copy", "strain_deviatoric", "cell_volume", "yarn", "break_time"))
                expected.setdefault(name, []).append(state(time, count, count, point))
    return expected


def expect_multiscale(file):
    expected = {}
    elements = file["fields/elements/element"].shape[0]
    corners = sum(name.startswith("node_") for name in file["fields/elements"])
    for rows in table_states(file["fields/points"]):
        one_each = len(rows["element"]) == elements
        cell = components(rows, ("mean_stress", "deviatoric_stress", "strain_volumetric")) if one_each else {}
        expected.setdefault("soil", []).append(state(rows["time"][0], corners * elements, elements, (), cell))
    for rows in table_states(file["fields/bars"]) if "bars" in file["fields"] else ():
        count = len(rows["bar"])
        cell = components(rows, ("tension", "normal_force", "shear_force", "broken"))
        expected.setdefault("geosynthetic", []).append(state(rows["time"][0], 2 * count, count, (), cell))
    return expected


def expect(path, fields):
    import h5py
    with h5py.File(path) as file:
        if "nodes" in file.get("fields", {}):
            return expect_multiscale(file)
        if "particles" not in file:
            return expect_fields(file)
        if not fields:
            return expect_run(file, None)
        with h5py.File(fields) as more:
            return expect_run(file, more)


# ---- What ParaView shows --------------------------------------------------------------------------------------------
def compare(where, attributes, wanted):
    from vtk.util.numpy_support import vtk_to_numpy
    for name, (size, known, low, high, total) in wanted.items():
        found = attributes.GetArray(name)
        assert found is not None, f"{where}: no array {name}"
        seen = summary(vtk_to_numpy(found))
        assert seen[:2] == [size, known], f"{where}: {name} has {seen[:2]} values (known), not {[size, known]}"
        numpy.testing.assert_allclose(seen[2:4], [low, high], rtol=1e-14, err_msg=f"{where}: range of {name}")
        scale = max(abs(low), abs(high)) * max(known, 1)
        assert abs(seen[4] - total) <= 1e-12 * scale, f"{where}: sum of {name} is {seen[4]}, not {total}"


def open_all(folder, expected):
    from paraview import servermanager
    from paraview.simple import CSVReader, Delete, PVDReader
    groups = {os.path.basename(path)[:-4]: path for path in glob.glob(os.path.join(folder, "*.pvd"))}
    assert groups.keys() == expected.keys(), f"{sorted(groups)} were written, not {sorted(expected)}"
    for name, path in groups.items():
        reader = PVDReader(FileName=path)
        times = list(numpy.atleast_1d(reader.TimestepValues))
        assert times == [wanted["time"] for wanted in expected[name]], f"{name}: times are {times}"
        for k, wanted in enumerate(expected[name]):
            reader.UpdatePipeline(wanted["time"])
            data, where = servermanager.Fetch(reader), f"{name}, state {k}"
            for what, number in (("points", data.GetNumberOfPoints()), ("cells", data.GetNumberOfCells())):
                assert wanted[what] in (None, number), f"{where}: {number} {what}, not {wanted[what]}"
            compare(where, data.GetPointData(), wanted["point"])
            compare(where, data.GetCellData(), wanted["cell"])
        Delete(reader)
    for path in glob.glob(os.path.join(folder, "*.csv")):
        reader = CSVReader(FileName=[path])
        data = servermanager.Fetch(reader)
        with open(path) as text:
            names, rows = text.readline().rstrip("\n").split(","), len(text.readlines())
        assert [data.GetColumnName(k) for k in range(data.GetNumberOfColumns())] == names, f"{path}: columns"
        assert data.GetNumberOfRows() == rows, f"{path}: {data.GetNumberOfRows()} rows, not {rows}"
        Delete(reader)


# ---- The picture ----------------------------------------------------------------------------------------------------
def pixels(path):
    from vtk import vtkPNGReader
    from vtk.util.numpy_support import vtk_to_numpy
    reader = vtkPNGReader()
    reader.SetFileName(path)
    reader.Update()
    width, height, _ = reader.GetOutput().GetDimensions()
    values = vtk_to_numpy(reader.GetOutput().GetPointData().GetScalars())
    return values.reshape(height, width, -1)[::-1, :, :3].astype(int)  # rows from the top


def look(path, rows, red):
    """Each panel shows something of many colours besides its scalar bar, its outlines and its axes."""
    image = pixels(path)
    panels = []
    for r, count in enumerate(rows):
        strip = image[image.shape[0] * r // len(rows): image.shape[0] * (r + 1) // len(rows)]
        panels += [strip[:, strip.shape[1] * c // count: strip.shape[1] * (c + 1) // count] for c in range(count)]
    for number, shown in enumerate(panels):
        height, width = shown.shape[:2]
        middle = shown[height // 8: -height // 8, width // 5: -width // 4].reshape(-1, 3)
        coloured = middle[numpy.ptp(middle, axis=1) > 40]
        share, colours = len(coloured) / len(middle), len(numpy.unique(coloured // 16, axis=0))
        print(f"panel {number}: {100 * share:.1f} % coloured, {colours} colours")
        assert share > 0.002 and colours >= 8, f"panel {number} shows nothing"
        if number == red:
            marks = (abs(middle - [227, 25, 28]) < 40).all(axis=1).sum()
            assert marks >= 20, f"panel {number}: no red points"


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("verb", choices=("expect", "open", "look"))
    parser.add_argument("path")
    parser.add_argument("argument", nargs="?")
    parser.add_argument("--fields")
    parser.add_argument("--red", type=int)
    arguments = parser.parse_args()
    if arguments.verb == "expect":
        print(json.dumps(expect(arguments.path, arguments.fields)))
    elif arguments.verb == "open":
        with open(arguments.argument) as text:
            open_all(arguments.path, json.load(text))
    else:
        look(arguments.path, [int(count) for count in arguments.argument.split(",")], arguments.red)


main()
