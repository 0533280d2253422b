#!/usr/bin/python3 -P
"""Pictures of a bag in three dimensions: intact, near its greatest load and ruptured, with a quarter cut out of it.

usage: [xvfb-run -a] pipelines/study/render.py out/ch3/uc_PE.h5 bag3d.jpg
Yarns show their tension, broken ones are missing; grains show their deviatoric strain. VTK draws (python3-vtk9); Debian's needs
a display for it, which xvfb-run gives where there is none. BIN: folder of the tools, build/bin.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import io
import os
import pathlib
import subprocess
import sys

import matplotlib
import numpy
import vtk
from vtk.util.numpy_support import numpy_to_vtk, vtk_to_numpy

sys.dont_write_bytecode = True
sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
from study import StudyError, Table, figures  # noqa: E402  (after its place is known)

SIZE = (1500, 1000)  # pixels of a scene
# From light to dark, and apart in hue for all readers.
GRAINS, YARNS = matplotlib.colormaps["PuBu"], matplotlib.colormaps["YlOrRd"]
STRAIN = 40.0  # %, end of the scale


def table(run, state, *arguments):
    """Returns a table of homogenize for a state of the run."""
    tool = os.path.join(os.environ.get("BIN", "build/bin"), "homogenize")
    printed = subprocess.run([tool, run, "--state", str(state), "--tsv", *arguments], capture_output=True, text=True, check=False)
    if printed.returncode:
        raise StudyError(printed.stderr.strip())
    return Table.parse(printed.stdout, run)


def states(run):
    """Returns number, axial strain (%) and words of three states: the first under load, the greatest pressure, the last."""
    loading, recorded = table(run, "all", "--table", "loading"), table(run, "all", "--columns", "step")("step", "1")
    step, strain = loading("step", "1"), loading("strain_axial", "%")
    pressure = numpy.interp(recorded, step, loading("plate_pressure", "kPa"))
    chosen = [(1, "intact"), (int(pressure.argmax()), "near its greatest load"), (len(recorded) - 1, "ruptured")]
    return [(k, float(numpy.interp(recorded[k], step, strain)), words) for k, words in chosen]


def away(x, y):
    """Returns whether places lie outside of the quarter that is cut out."""
    return ~((x > 0) & (y < 0))


def points(rows, colours):
    """Returns points of VTK with a colour each: rows of N×3, m, and N×3 from 0 to 255."""
    data = vtk.vtkPolyData()
    places = vtk.vtkPoints()
    places.SetData(numpy_to_vtk(numpy.ascontiguousarray(rows), deep=True))
    data.SetPoints(places)
    shades = numpy_to_vtk(numpy.ascontiguousarray(colours.astype(numpy.uint8)), deep=True)
    shades.SetName("colour")
    data.GetPointData().SetScalars(shades)
    return data


def grains(state):
    """Returns the actor of the grains that are not cut away."""
    x, y, z, radius = (state(name, "m") for name in ("position_x", "position_y", "position_z", "radius"))
    soil = (state("copy", "1") >= 0) & away(x, y)
    share = numpy.clip(state("strain_deviatoric", "%", missing=True) / STRAIN, 0, 1)
    data = points(numpy.c_[x, y, z][soil], 255 * GRAINS(numpy.nan_to_num(share))[soil, :3])
    sizes = numpy_to_vtk(radius[soil], deep=True)
    sizes.SetName("radius")
    data.GetPointData().AddArray(sizes)
    sphere = vtk.vtkSphereSource()
    sphere.SetRadius(1)
    sphere.SetThetaResolution(14)
    sphere.SetPhiResolution(10)
    glyphs = vtk.vtkGlyph3D()
    glyphs.SetInputData(data)
    glyphs.SetSourceConnection(sphere.GetOutputPort())
    glyphs.SetScaleModeToScaleByScalar()
    glyphs.SetColorModeToColorByScalar()
    glyphs.SetInputArrayToProcess(0, 0, 0, 0, "radius")
    glyphs.SetInputArrayToProcess(3, 0, 0, 0, "colour")
    return actor(glyphs)


def yarns(state, greatest):
    """Returns the actor of the yarns that neither broke nor are cut away. greatest: tension (N) at the end of the scale."""
    middle = numpy.c_[[state(f"position_{a}", "m") for a in "xyz"]].T
    half = numpy.c_[[state(f"direction_{a}", "1") for a in "xyz"]].T * state("length", "m")[:, None] / 2
    kept = (state("broken", "1") == 0) & away(middle[:, 0], middle[:, 1])
    ends = numpy.stack([middle - half, middle + half], axis=1)[kept].reshape(-1, 3)
    shades = 255 * YARNS(numpy.clip(state("tension", "N")[kept] / greatest, 0, 1))[:, :3]
    data = points(ends, numpy.repeat(shades, 2, axis=0))
    count = len(ends) // 2
    cells = vtk.vtkCellArray()
    cells.SetData(numpy_to_vtk(numpy.arange(0, 2 * count + 1, 2), deep=True, array_type=vtk.VTK_ID_TYPE),
                  numpy_to_vtk(numpy.arange(2 * count), deep=True, array_type=vtk.VTK_ID_TYPE))
    data.SetLines(cells)
    tubes = vtk.vtkTubeFilter()
    tubes.SetInputData(data)
    tubes.SetRadius(0.0013)
    tubes.SetNumberOfSides(8)
    return actor(tubes)


def actor(source):
    """Returns an actor that draws a source in the colours of its points."""
    mapper = vtk.vtkPolyDataMapper()
    mapper.SetInputConnection(source.GetOutputPort())
    mapper.SetScalarModeToUsePointData()
    drawn = vtk.vtkActor()
    drawn.SetMapper(mapper)
    drawn.GetProperty().SetAmbient(0.35)
    drawn.GetProperty().SetDiffuse(0.75)
    drawn.GetProperty().SetSpecular(0.12)
    return drawn


def render(actors):
    """Returns the picture of a scene as an array, height×width×3."""
    scene = vtk.vtkRenderer()
    scene.SetBackground(1, 1, 1)
    for drawn in actors:
        scene.AddActor(drawn)
    occlusion = vtk.vtkSSAOPass()
    occlusion.SetRadius(0.03)
    occlusion.SetBias(0.001)
    occlusion.SetKernelSize(96)
    occlusion.BlurOn()
    occlusion.SetDelegatePass(vtk.vtkRenderStepsPass())
    smooth = vtk.vtkSSAAPass()
    smooth.SetDelegatePass(occlusion)
    scene.SetPass(smooth)
    camera = scene.GetActiveCamera()
    camera.SetFocalPoint(0, 0, -0.012)
    camera.SetPosition(0.62, -1.0, 0.62)
    camera.SetViewUp(0, 0, 1)
    camera.SetViewAngle(22)
    window = vtk.vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetSize(*SIZE)
    window.AddRenderer(scene)
    scene.ResetCameraClippingRange()
    window.Render()
    grab = vtk.vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    grab.Update()
    image = grab.GetOutput()
    width, height, _ = image.GetDimensions()
    return vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, -1)[::-1]


def trimmed(pictures):
    """Returns pictures of equal size without the white around what any of them shows."""
    shown = numpy.any([(picture < 250).any(axis=2) for picture in pictures], axis=0)
    rows, columns = (numpy.flatnonzero(shown.any(axis=axis)) for axis in (1, 0))
    return [picture[rows[0]:rows[-1] + 1, columns[0]:columns[-1] + 1] for picture in pictures]


def compose(pictures, titles, greatest):
    """Returns a figure: the bags beside each other, and the scales of both colours."""
    figure = figures.pyplot().figure(figsize=(13.2, 3.55), layout="constrained")
    axes = figure.subplots(1, len(pictures))
    for a, picture, title in zip(axes, pictures, titles, strict=True):
        a.imshow(picture)
        a.set_title(title, fontsize=12)
        a.axis("off")
    for shades, most, label, place in ((YARNS, greatest, "tension of the yarns (N)", axes[0]), (GRAINS, STRAIN, "deviatoric strain of the grains (%)", axes[2])):
        scale = matplotlib.cm.ScalarMappable(matplotlib.colors.Normalize(0, most), shades)
        bar = figure.colorbar(scale, ax=place, location="bottom", shrink=0.8, aspect=32, pad=0.02)
        bar.set_label(label)
        bar.outline.set_visible(False)
    figure.colorbar(scale, ax=axes[1], location="bottom", shrink=0.8, aspect=32, pad=0.02, label=" ").ax.set_visible(False)
    return figure


def main():
    """Draws the run named first into the file named second."""
    run, target = sys.argv[1:3]
    chosen = states(run)
    fabrics = [table(run, k, "--table", "yarns") for k, _, _ in chosen]
    greatest = 5 * numpy.ceil(max(numpy.quantile(f("tension", "N"), 0.98) for f in fabrics) / 5)
    pictures = [render([grains(table(run, k, "--grains", "--table", "grains")), yarns(fabric, greatest)])
                for (k, _, _), fabric in zip(chosen, fabrics, strict=True)]
    figure = compose(trimmed(pictures), [f"{words}, {strain:.0f} %" for _, strain, words in chosen], greatest)
    content = io.BytesIO()
    figures.pyplot().switch_backend("agg")
    figure.savefig(content, format=pathlib.Path(target).suffix[1:], dpi=150, bbox_inches="tight", pad_inches=0.05,
                   pil_kwargs={"quality": 88} if target.endswith(".jpg") else {})
    pathlib.Path(target).write_bytes(content.getvalue())


if __name__ == "__main__":
    if len(sys.argv) != 3:
        print(__doc__.split("\n\n", 1)[1].splitlines()[0], file=sys.stderr)
        sys.exit(64)
    try:
        main()
    except StudyError as error:
        print(f"render: {error}", file=sys.stderr)
        sys.exit(65)
