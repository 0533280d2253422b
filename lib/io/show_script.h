// The ParaView script that to-vtk lays beside its files.
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

namespace soilweave::io {

inline constexpr std::string_view show_script = R"script(# Shows the files beside it in ParaView.
# Grains are spheres, contacts tubes (thickness: normal force, colour: shear force), cell and rigid planes outlines.
#   paraview --script=show.py          interactive
#   pvpython show.py picture.png       a picture of the last state
import os
import sys

from paraview.simple import (ColorBy, GetActiveViewOrCreate, GetAnimationScene, GetColorTransferFunction, GetScalarBar,
                             Glyph, PVDReader, Render, ResetCamera, SaveScreenshot, Show, TensorGlyph, Tube)

FOLDER = os.path.dirname(os.path.abspath(globals().get("__file__", "show.py")))
BLACK = [0.0, 0.0, 0.0]


def load(name):
    path = os.path.join(FOLDER, name + ".pvd")
    return PVDReader(registrationName=name, FileName=path) if os.path.exists(path) else None


def colour(display, view, association, array, title):
    ColorBy(display, (association, array))
    display.RescaleTransferFunctionToDataRange(True, False)
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(GetColorTransferFunction(array), view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = BLACK


def show_grains(view, grains, among_contacts):
    spheres = Glyph(registrationName="spheres", Input=grains, GlyphType="Sphere")
    spheres.OrientationArray = ["POINTS", "No orientation array"]
    spheres.ScaleArray = ["POINTS", "radius"]
    spheres.ScaleFactor = 2.0  # the source sphere has radius 0.5
    spheres.GlyphMode = "All Points"
    spheres.GlyphType.ThetaResolution = 16
    spheres.GlyphType.PhiResolution = 16
    display = Show(spheres, view)
    if among_contacts:
        display.Opacity = 0.2
        display.ColorArrayName = ["POINTS", ""]
        display.AmbientColor = display.DiffuseColor = [0.7, 0.65, 0.55]
    else:
        colour(display, view, "POINTS", "radius", "radius (m)")


def show_contacts(view, contacts):
    tubes = Tube(registrationName="force chains", Input=contacts)
    tubes.Scalars = ["POINTS", "tube_radius"]
    tubes.VaryRadius = "By Absolute Scalar"
    tubes.NumberofSides = 8
    colour(Show(tubes, view), view, "CELLS", "shear_force_magnitude", "shear force (N)")


def show_outline(view, name):
    """Returns whether the outline has a depth (it has none in 2D)."""
    outline = load(name)
    if outline is None:
        return False
    display = Show(outline, view)
    display.Representation = "Wireframe"
    display.LineWidth = 2.0
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = BLACK
    low, high = outline.GetDataInformation().GetBounds()[4:]
    return high > low


def show_yarns(view):
    yarns = load("yarns")
    if yarns is not None:
        display = Show(yarns, view)
        display.LineWidth = 2.0
        colour(display, view, "CELLS", "tension", "tension of yarns (N)")


def show_places(view, places):
    """Points with fields; where there is a stress, as ellipsoids along its principal directions."""
    Show(places, view).ColorArrayName = ["POINTS", ""]
    bounds = places.GetDataInformation().GetBounds()
    stresses = [array.GetName() for array in places.PointData if array.GetNumberOfComponents() == 9]
    if not stresses:
        return
    size = sum((high - low) ** 2 for low, high in zip(bounds[::2], bounds[1::2])) ** 0.5 or 1.0
    greatest = max(map(abs, places.PointData[stresses[0]].GetRange(-1))) or 1.0
    ellipsoids = TensorGlyph(registrationName=stresses[0], Input=places, GlyphType="Sphere")
    ellipsoids.Tensors = ["POINTS", stresses[0]]
    ellipsoids.ScaleFactor = 0.1 * size / greatest
    display = Show(ellipsoids, view)
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = [0.7, 0.65, 0.55]


def main():
    view = GetActiveViewOrCreate("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    contacts = load("contacts")
    scene = GetAnimationScene()
    grains = load("grains")
    if grains is not None:
        if "radius" in grains.PointData.keys():
            show_grains(view, grains, contacts is not None)
        else:
            show_places(view, grains)
    if contacts is not None:
        show_contacts(view, contacts)
    deep = show_outline(view, "cell")
    show_outline(view, "planes")
    show_yarns(view)
    for file in sorted(os.listdir(FOLDER)):
        name, extension = os.path.splitext(file)
        if extension == ".pvd" and name not in ("grains", "contacts", "cell", "planes", "yarns"):
            show_places(view, load(name))
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    if deep:
        view.CameraViewUp = [0.0, 0.0, 1.0]
        view.CameraPosition, view.CameraFocalPoint = [-1.0, -2.5, 1.0], [0.0, 0.0, 0.0]
    ResetCamera(view)
    Render(view)
    if sys.argv[1:] and sys.argv[-1].endswith(".png"):
        SaveScreenshot(sys.argv[-1], view, ImageResolution=[1600, 1200])


main()
)script";

}  // namespace soilweave::io
