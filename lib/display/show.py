# Shows the files beside it in ParaView, each kind in a panel of its own:
#   grains, fill around reinforced soil faint; force chains (thickness: normal force, colour: shear force);
#   yarns by tension, broken ones as red points;
#   principal stresses of volumes, lengths in proportion, red the greatest, blue the medium, green the least;
#   deviatoric strain of the grains cut by the plane in the middle (fields joined by to-vtk --fields); fields of a mesh.
#   paraview --script=show.py              interactive
#   pvpython show.py picture.png           a picture of the last state; without a display: xvfb-run -a pvpython ...
# SPDX-License-Identifier: GPL-3.0-or-later
import glob
import math
import os
import sys

from paraview.simple import (CSVReader, Calculator, ColorBy, CreateLayout, CreateView, GetAnimationScene,
                             GetColorTransferFunction, GetScalarBar, Glyph, PVDReader, Render, ResetCamera,
                             SaveScreenshot, Show, TensorGlyph, Threshold, ThresholdTable, Tube)
from paraview.servermanager import Fetch

BLACK, GREY, SAND, RED = [0.0, 0.0, 0.0], [0.5, 0.5, 0.5], [0.7, 0.65, 0.55], [0.89, 0.1, 0.11]
BLUE, GREEN = [0.12, 0.35, 0.8], [0.1, 0.6, 0.2]
# Fields of the elements of two scales, and the columns over which tables without a place are drawn.
MESH = {"mean_stress": "p (Pa)", "deviatoric_stress": "q (Pa)", "strain_shear": "shear strain",
        "rotation": "rotation (rad)", "anisotropy": "anisotropy", "strain_volumetric": "volumetric strain"}
CHARTS = {"series": ("strain_axial", ["stress_ratio", "strain_volumetric"]),
          "fabric": ("strain_axial", ["a_c", "a_n", "a_t"]),
          "histogram": ("contacts", ["grains"]), "rose": ("x", ["y"])}
panels = []  # views, each with whether it looks along y and what is drawn around what it shows


def folder():
    """Returns the folder of this script. ParaView keeps the path after --script to itself, so the command line of the process tells it."""
    script = globals().get("__file__")
    if script is None and os.path.exists("/proc/self/cmdline"):
        with open("/proc/self/cmdline") as line:
            words = [word.removeprefix("--script=") for word in line.read().split("\0")]
        script = next((word for word in words if os.path.basename(word) == "show.py"), None)
    return os.path.dirname(os.path.abspath(script or "show.py"))


def files(extension):
    paths = sorted(glob.glob(os.path.join(glob.escape(folder()), "*" + extension)))
    return {os.path.basename(path)[: -len(extension)]: path for path in paths}


def panel(along_y=False, outlines=()):
    view = CreateView("RenderView")
    view.UseColorPaletteForBackground = 0
    view.Background = [1.0, 1.0, 1.0]
    view.OrientationAxesLabelColor = BLACK
    panels.append((view, along_y, outlines))
    return view


def look(view, along_y, outlines, deep):
    if deep:
        view.CameraViewUp, view.CameraFocalPoint = [0.0, 0.0, 1.0], [0.0, 0.0, 0.0]
        view.CameraPosition = [0.0, -1.0, 0.0] if along_y else [-1.0, -2.5, 1.5]
    view.CameraParallelProjection = int(along_y or not deep)
    ResetCamera(view)
    for outline in outlines:
        display = Show(outline, view)
        display.Representation = "Wireframe"
        display.LineWidth = 2.0
        plain(display, BLACK)


def plain(display, hue):
    display.ColorArrayName = ["POINTS", ""]
    display.AmbientColor = display.DiffuseColor = hue


def colour(display, view, association, array, title, low=None, most=None):
    ColorBy(display, (association, array))
    display.RescaleTransferFunctionToDataRange(False, True)
    function = GetColorTransferFunction(array)
    function.ApplyPreset("Viridis (matplotlib)", True)
    function.NanColor = GREY
    first, last = function.RGBPoints[0], function.RGBPoints[-4]
    first, last = first if low is None else low, last if most is None else min(last, most)
    if first < last:
        function.RescaleTransferFunction(first, last)
    display.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(function, view)
    bar.Title, bar.ComponentTitle = title, ""
    bar.TitleColor = bar.LabelColor = BLACK


def glyphs(source, view, radius, kind="Sphere"):
    """Drawn from one shape, which is not copied: an assembly may have a hundred thousand grains."""
    display = Show(source, view)
    display.SetRepresentationType("3D Glyphs")
    display.GlyphType = kind
    display.Scaling, display.ScaleMode, display.SelectScaleArray = 1, "Magnitude", radius
    display.ScaleFactor = 2.0  # of a shape of radius 0.5
    if kind == "Sphere":
        display.GlyphType.ThetaResolution = display.GlyphType.PhiResolution = 16
    else:
        display.GlyphType.Resolution, display.GlyphType.Height = 24, 0.01
    return display


def within(source, association, name, low, high):
    part = Threshold(Input=source)
    part.Scalars = [association, name]  # sets the thresholds to the array's range
    part.LowerThreshold, part.UpperThreshold = low, high
    return part


def parts(grains):
    """The grains that are soil, those that are fill around it and those that are nodes of a geotextile, or none."""
    if "part" in grains.PointData.keys():
        last = grains.PointData["part"].GetRange()[1]
        return [within(grains, "POINTS", "part", k, k) if k <= last else None for k in (0, 1, 2)]
    copy = next((name for name in ("copy_id", "copy") if name in grains.PointData.keys()), None)
    first, last = grains.PointData[copy].GetRange() if copy else (0, 0)
    if first >= 0:
        return grains, None, None
    nodes = within(grains, "POINTS", copy, first, -1)
    return (within(grains, "POINTS", copy, 0, last) if last >= 0 else None), None, nodes


def show_grains(sources, outlines):
    view = panel(outlines=outlines)
    soil, fill, nodes = parts(sources["grains"])
    if fill and "strain_deviatoric" in sources["grains"].PointData.keys():
        colour(glyphs(soil, view, "radius"), view, "POINTS", "strain_deviatoric", "deviatoric strain", 0.0, 0.4)
    else:
        colour(glyphs(soil or nodes, view, "radius"), view, "POINTS", "radius", "radius (m)")
    if fill:
        faint = glyphs(fill, view, "radius")
        faint.Opacity = 0.05
        plain(faint, SAND)
    if soil and nodes and "yarns" not in sources:
        plain(glyphs(nodes, view, "radius"), GREY)
    if "yarns" in sources:
        plain(Show(whole(sources["yarns"]), view), GREY)


def show_cut(grains, deep):
    """The grains as the plane in the middle cuts them; in 2D all of them."""
    view, (soil, fill, nodes) = panel(along_y=True), parts(grains)
    low, high = grains.GetDataInformation().GetBounds()[2:4]
    middle = 0.5 * (low + high)

    def cut(part):
        if not deep:
            return glyphs(part, view, "radius")
        half = Calculator(Input=part, ResultArrayName="cut_radius",
                          Function=f"sqrt(max(0, radius^2 - (coordsY - ({middle!r}))^2))")
        some = within(half, "POINTS", "cut_radius", 1e-6 * (high - low), high - low)
        flat = Calculator(Input=some, CoordinateResults=1,
                          Function=f"coordsX*iHat + ({middle!r})*jHat + coordsZ*kHat")
        return glyphs(flat, view, "cut_radius", "Cylinder")

    if nodes:
        plain(cut(nodes), GREY)
    if fill:
        plain(cut(fill), SAND)
    if soil:
        colour(cut(soil), view, "POINTS", "strain_deviatoric", "deviatoric strain", 0.0, 0.4)


def show_contacts(contacts, outlines):
    view = panel(outlines=outlines)
    tubes = Tube(registrationName="force chains", Input=contacts)
    tubes.Scalars = ["POINTS", "tube_radius"]
    tubes.VaryRadius = "By Absolute Scalar"
    tubes.NumberofSides = 8
    colour(Show(tubes, view), view, "CELLS", "shear_force_magnitude", "shear force (N)", 0.0)


def whole(yarns):
    return within(yarns, "CELLS", "broken", 0, 0) if "broken" in yarns.CellData.keys() else yarns


def show_yarns(sources, outlines):
    view = panel(outlines=outlines)
    display = Show(whole(sources["yarns"]), view)
    display.LineWidth = 2.0
    colour(display, view, "CELLS", "tension", "tension of yarns (N)", 0.0)
    if "broken" in sources:
        broken = Show(sources["broken"], view)
        broken.PointSize = 6.0
        plain(broken, RED)


def show_mesh(soil, bars):
    """The elements by what they bear, with the ways of the nodes; the geosynthetic by tension."""
    greatest = soil.PointData["displacement"].GetRange(-1)[1]
    bounds = soil.GetDataInformation().GetBounds()
    for array in [name for name in MESH if name in soil.CellData.keys()]:
        least, most = soil.CellData[array].GetRange()
        if least > most:  # a soil without grains has no fabric
            continue
        view = panel()
        colour(Show(soil, view), view, "CELLS", array, MESH[array], 0.0 if array == "anisotropy" else None)
        if greatest > 0:
            arrows = Glyph(Input=soil, GlyphType="Arrow", GlyphMode="All Points")
            arrows.OrientationArray = arrows.ScaleArray = ["POINTS", "displacement"]
            arrows.ScaleFactor = 0.15 * (bounds[1] - bounds[0]) / greatest
            plain(Show(arrows, view), BLACK)
        if bars:
            display = Show(bars, view)
            display.LineWidth = 3.0
            plain(display, RED)
    if bars:
        view = panel()
        outline = Show(soil, view)
        outline.Representation = "Wireframe"
        plain(outline, GREY)
        display = Show(bars, view)
        display.LineWidth = 6.0
        colour(display, view, "CELLS", "tension", "tension (N/m)")


def show_places(places):
    """Points with fields; where there is a stress, as ellipsoids along its principal directions."""
    view = panel()
    plain(Show(places, view), BLACK)
    bounds = places.GetDataInformation().GetBounds()
    stresses = [array.GetName() for array in places.PointData if array.GetNumberOfComponents() == 9]
    if not stresses:
        return
    size = sum((high - low) ** 2 for low, high in zip(bounds[::2], bounds[1::2])) ** 0.5 or 1.0
    greatest = max(map(abs, places.PointData[stresses[0]].GetRange(-1))) or 1.0
    ellipsoids = TensorGlyph(registrationName=stresses[0], Input=places, GlyphType="Sphere")
    ellipsoids.Tensors = ["POINTS", stresses[0]]
    ellipsoids.ScaleFactor = 0.1 * size / greatest
    plain(Show(ellipsoids, view), SAND)


def show_axes(axes):
    """Principal stresses as lines in their directions (thesis Fig. 5.4)."""
    view = panel()
    for number, hue in ((1, RED), (2, BLUE), (3, GREEN)):
        display = Show(within(axes, "CELLS", "principal", number, number), view)
        display.LineWidth = 4.0
        plain(display, hue)


def polar(table):
    for name, function in (("x", "cos"), ("y", "sin")):
        table = Calculator(Input=table, AttributeType="Row Data", ResultArrayName=name,
                           Function=f"density*{function}(angle*{math.pi / 180!r})")
    return table


def show_table(name, path):
    """A table as curves; the rose of the last plane, which is upright, as polygon."""
    table = CSVReader(registrationName=name, FileName=[path])
    last = {"histogram": ["step"], "rose": ["step", "plane"]}.get(name, [])
    rows = Fetch(table).GetRowData()
    for column in last:
        table = ThresholdTable(Input=table)
        table.Column = ["ROWS", column]
        table.MinValue = table.MaxValue = rows.GetArray(column).GetRange()[1]
    if name == "rose":
        table = polar(table)
    over, columns = CHARTS[name]
    rows = Fetch(table).GetRowData()
    if not all(map(rows.HasArray, [over] + columns)) or len(set(rows.GetArray(over).GetRange())) == 1:
        return
    view = CreateView("XYChartView")
    view.BottomAxisTitle = over
    panels.append((view, None, ()))
    display = Show(table, view)
    display.UseIndexForXAxis, display.XArrayName, display.SeriesVisibility = 0, over, columns


def arrange(cell, items, split, place):
    """Halves the cell of a layout until there is one an item; its halves are cells 2 cell + 1 and 2 cell + 2."""
    if len(items) == 1:
        return place(cell, items[0])
    half = (len(items) + 1) // 2
    split(cell, half / len(items))
    arrange(2 * cell + 1, items[:half], split, place)
    arrange(2 * cell + 2, items[half:], split, place)


def main():
    sources = {name: PVDReader(registrationName=name, FileName=path) for name, path in files(".pvd").items()}
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.GoToLast()
    for source in sources.values():
        source.UpdatePipeline(scene.TimeKeeper.Time)
    boxes = [source.GetDataInformation().GetBounds() for source in sources.values()]
    deep = any(low < high for low, high in (box[4:] for box in boxes))
    grains = sources.get("grains")
    outlines = [sources[name] for name in ("cell", "planes") if name in sources]
    known = set(grains.PointData.keys()) if grains else set()
    if "radius" in known:
        show_grains(sources, outlines)
    if "contacts" in sources:
        show_contacts(sources["contacts"], outlines)
    if "yarns" in sources:
        show_yarns(sources, outlines)
    if {"radius", "strain_deviatoric"} <= known:
        show_cut(grains, deep)
    if "soil" in sources:
        show_mesh(sources["soil"], sources.get("geosynthetic"))
    shown = {"grains", "contacts", "cell", "planes", "yarns", "broken", "soil", "geosynthetic"}
    for name in sorted(sources.keys() - shown):
        if name.endswith("_axes"):
            show_axes(sources[name])
        elif name + "_axes" not in sources:
            show_places(sources[name])
    for name, path in files(".csv").items():
        if name in CHARTS:
            show_table(name, path)
    if not panels:
        print("nothing here has a place; the .csv files open as tables")
        return
    views, columns = [view for view, *_ in panels], math.ceil(math.sqrt(len(panels)))
    layout = CreateLayout(name="Soilweave")
    rows = [views[k: k + columns] for k in range(0, len(views), columns)]
    arrange(0, rows, layout.SplitVertical,
            lambda cell, row: arrange(cell, row, layout.SplitHorizontal, layout.AssignView))
    picture = next((argument for argument in sys.argv[1:] if argument.endswith(".png")), None)
    if picture:
        layout.SetSize(1600, 1200)
    for view, along_y, outlines in panels:
        Render(view)  # a camera knows what is shown once it is drawn
        if along_y is not None:
            look(view, along_y, outlines, deep)
            Render(view)
    if picture:
        SaveScreenshot(picture, layout, ImageResolution=[1600, 1200])


main()
