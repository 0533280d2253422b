# Opens every file to-vtk wrote with VTK's own readers and compares it with the HDF5 file it was made from.
# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: vtk_readers.py RUN.h5 FOLDER [--states 0,2] [--unwrapped]"""
import argparse
import os
import xml.etree.ElementTree

import h5py
import numpy
from vtk import vtkXMLPolyDataReader, vtkXMLUnstructuredGridReader
from vtk.util.numpy_support import vtk_to_numpy

ROUNDING = 1e-12  # relative to the cell's size: a few operations in double precision


def opened(path):
    reader = vtkXMLUnstructuredGridReader() if path.endswith(".vtu") else vtkXMLPolyDataReader()
    reader.SetFileName(path)
    reader.Update()
    assert reader.GetErrorCode() == 0, path
    data = reader.GetOutput()
    assert data.GetPoints().GetDataType() == 11, f"{path}: positions are not Float64"
    return data


def array(attributes, name):
    found = attributes.GetArray(name)
    assert found is not None, f"no array {name}"
    return vtk_to_numpy(found)


def points(data):
    return vtk_to_numpy(data.GetPoints().GetData())


def frames(folder, group):
    tree = xml.etree.ElementTree.parse(os.path.join(folder, group + ".pvd"))
    return [(float(entry.get("timestep")), os.path.join(folder, entry.get("file"))) for entry in tree.iter("DataSet")]


class State:
    """One frame of the HDF5 file."""

    def __init__(self, file, frame):
        grains = file["particles/grains"]
        self.time = grains["position/time"][frame]
        self.step = grains["position/step"][frame]
        self.position = three(grains["position/value"][frame])
        self.dimension = grains["position/value"].shape[2]
        self.radius = element(grains["radius"], frame)
        self.body_id = element(grains["id"], frame)
        self.velocity = three(grains["velocity/value"][frame])
        self.angular_velocity = grains["angular_velocity/value"][frame]
        edges = grains["box/edges/value"][frame].T  # stored one cell vector a row
        self.cell = numpy.eye(3)
        self.cell[: self.dimension, : self.dimension] = edges
        boundary = [str(b.decode() if isinstance(b, bytes) else b) for b in grains["box"].attrs["boundary"]]
        self.periodic = numpy.array([b == "periodic" for b in boundary] + [False] * (3 - len(boundary)))
        group = file[f"contacts/{frame:06d}"]
        self.contacts = {name: group[name][...] for name in group}


def three(vectors):
    return numpy.pad(vectors, ((0, 0), (0, 3 - vectors.shape[1])))


def element(item, frame):
    return item["value"][frame] if isinstance(item, h5py.Group) else item[...]


def check_time(data, time, state):
    assert time == state.time, ".pvd disagrees with the run's time"
    assert array(data.GetFieldData(), "TimeValue")[0] == state.time
    assert array(data.GetFieldData(), "step")[0] == state.step


def check_grains(data, state, unwrapped):
    count = len(state.radius)
    assert data.GetNumberOfPoints() == data.GetNumberOfVerts() == count
    arrays = data.GetPointData()
    for name in ("radius", "body_id", "velocity", "angular_velocity"):
        numpy.testing.assert_array_equal(array(arrays, name), getattr(state, name), name)
    for name, components in (("material_id", 1), ("copy_id", 1), ("orientation", 4)):
        assert array(arrays, name).size == components * count, name
    bodies = state.contacts["bodies"]
    coordination = numpy.bincount(bodies[bodies >= 0], minlength=count)
    numpy.testing.assert_array_equal(array(arrays, "coordination"), coordination)
    cells = (state.position - points(data)) @ numpy.linalg.inv(state.cell).T
    assert numpy.abs(cells - numpy.round(cells)).max() < 1e-9, "grains moved by a fraction of the cell"
    inside = points(data) @ numpy.linalg.inv(state.cell).T
    if unwrapped:
        numpy.testing.assert_array_equal(points(data), state.position)
    else:
        assert (inside[:, state.periodic] > -1e-9).all() and (inside[:, state.periodic] < 1 + 1e-9).all()
    if len(bodies):
        check_stress(array(arrays, "stress").reshape(-1, 3, 3), state)


def check_stress(stress, state):
    """Grain stresses times volumes add up to the sum of f l^T over the contacts."""
    volume = 4 / 3 * numpy.pi * state.radius**3 if state.dimension == 3 else numpy.pi * state.radius**2
    contacts = state.contacts
    force = contacts["normal_force"][:, None] * contacts["normal"] + contacts["shear_force"]
    love_weber = numpy.einsum("ci,cj->ij", force, contacts["branch_vector"])
    total = numpy.einsum("g,gij->ij", volume, stress)
    assert numpy.abs(total - love_weber).max() <= 1e-9 * numpy.abs(love_weber).max()


def check_contacts(data, state, grain_points, unwrapped):
    contacts = state.contacts
    assert data.GetNumberOfCells() == data.GetNumberOfLines()
    arrays = data.GetCellData()
    index, copies = array(arrays, "contact"), array(arrays, "copies")
    numpy.testing.assert_array_equal(numpy.bincount(index, minlength=len(contacts["bodies"])),
                                     [copies[index == c].max() for c in range(len(contacts["bodies"]))])
    for name in ("normal_force", "shear_force", "overlap", "sliding"):
        numpy.testing.assert_array_equal(array(arrays, name), contacts[name][index], name)
    numpy.testing.assert_allclose(array(arrays, "shear_force_magnitude"),
                                  numpy.linalg.norm(contacts["shear_force"][index], axis=1), rtol=1e-14)
    ends = points(data)[vtk_to_numpy(data.GetLines().GetConnectivityArray())].reshape(-1, 2, 3)
    lines = ends[:, 1] - ends[:, 0]
    size = numpy.abs(state.cell).max()
    assert numpy.abs(lines - contacts["branch_vector"][index]).max() < ROUNDING * size
    across = numpy.linalg.norm(numpy.linalg.inv(state.cell), axis=1) ** -1.0  # between opposite faces
    if state.periodic.any():
        assert numpy.linalg.norm(lines, axis=1).max() < 0.5 * across[state.periodic].min(), "a line crosses the cell"
    tube = array(data.GetPointData(), "tube_radius").reshape(-1, 2)
    assert (tube[:, 0] == tube[:, 1]).all() and (tube >= 0).all()
    pushing = array(arrays, "normal_force") > 0
    scale = tube[pushing, 0] / array(arrays, "normal_force")[pushing]
    assert scale.size == 0 or numpy.ptp(scale) < 1e-9 * scale.max(), "tubes not in proportion to the force"
    check_ends(ends, index, copies, contacts, grain_points, size)
    if not unwrapped:
        check_images(ends, index, copies, state)


def check_ends(ends, index, copies, contacts, grain_points, size):
    """A whole line joins its two shown grains, a copy touches exactly one of them."""
    for (start, end), c, number in zip(ends, index, copies):
        first, second = contacts["bodies"][c]
        at_first = numpy.abs(start - grain_points[first]).max() < ROUNDING * size
        at_second = second < 0 or numpy.abs(end - grain_points[second]).max() < ROUNDING * size
        assert int(at_first) + int(at_second) == (2 if number == 1 else 1), f"contact {c} hangs in the air"


def check_images(ends, index, copies, state):
    """The two copies of a contact are a whole number of cell vectors apart, and not in the same place."""
    inverse = numpy.linalg.inv(state.cell)
    for c in numpy.unique(index[copies == 2]):
        one, two = ends[index == c]
        cells = inverse @ (one[0] - two[0])
        assert numpy.abs(cells - numpy.round(cells)).max() < 1e-9 and numpy.abs(numpy.round(cells)).max() >= 1


def check_cell(data, state):
    assert data.GetNumberOfCells() == 1
    cell = data.GetCell(0)
    corners = points(data)
    if state.dimension == 2:
        assert cell.GetNumberOfEdges() == 4
        first, last = corners[1] - corners[0], corners[3] - corners[0]
        volume = abs(first[0] * last[1] - first[1] * last[0])
    else:
        assert cell.GetClassName() == "vtkHexahedron" and cell.GetNumberOfEdges() == 12
        volume = numpy.linalg.det(numpy.array([corners[1], corners[3], corners[4]]) - corners[0])
    if state.periodic[: state.dimension].all():
        expected = numpy.linalg.det(state.cell[: state.dimension, : state.dimension])
        assert abs(volume - expected) < 1e-12 * expected
    assert abs(array(data.GetCellData(), "volume")[0] - volume) < 1e-12 * volume


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("run")
    parser.add_argument("folder")
    parser.add_argument("--states")
    parser.add_argument("--unwrapped", action="store_true")
    arguments = parser.parse_args()
    with h5py.File(arguments.run) as file:
        count = file["particles/grains/position/value"].shape[0]
        states = [State(file, int(f)) for f in (arguments.states or ",".join(map(str, range(count)))).split(",")]
    for group in ("grains", "contacts", "cell"):
        assert len(frames(arguments.folder, group)) == len(states), f"{group}.pvd: wrong number of states"
    for number, state in enumerate(states):
        opened_frames = {}
        for group in ("grains", "contacts", "cell"):
            time, path = frames(arguments.folder, group)[number]
            opened_frames[group] = opened(path)
            check_time(opened_frames[group], time, state)
        check_grains(opened_frames["grains"], state, arguments.unwrapped)
        check_contacts(opened_frames["contacts"], state, points(opened_frames["grains"]), arguments.unwrapped)
        check_cell(opened_frames["cell"], state)
    split = sum((array(opened_frames["contacts"].GetCellData(), "copies") == 2).any() for _ in (0,))
    print(f"{len(states)} states, {len(states[-1].radius)} grains, {len(states[-1].contacts['bodies'])} contacts, "
          f"{'some' if split else 'none'} through the faces")


main()
