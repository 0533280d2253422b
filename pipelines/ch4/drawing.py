"""Figures of chapter 4: the two assemblies, the response of the cells and of their reinforced soil, stress paths, void ratios, sections."""
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib
import itertools

import numpy
from matplotlib.collections import EllipseCollection
from study import Drawn, NotMade, figures, panel

from .cells import FORMS, GEOTEXTILES, GROUPS, MIDDLING

LINES = {"wrapped": "-", "layered": "--"}
PARTS = ((0, "#b98d4f"), (1, "#d9d5cb"), (2, "#33475b"))  # reinforced soil, fill, nodes: numbers of the column "part"
EDGE = "#00000050"  # edge of a grain among grains of one colour
STATES = (("least", "densest"), ("greatest", "loosest"))
MOST_STRAIN = 0.6  # deviatoric strain at the end of the scale of colours


def of_cells(runs):
    """Returns the cells that there are as they are drawn: wrapped ones solid, layered ones dashed. Raises NotMade for none."""
    runs.cells()
    drawn = []
    for g, form in itertools.product(GEOTEXTILES, FORMS):
        with contextlib.suppress(NotMade):
            drawn.append(Drawn(f"{g}, {form}", runs.cell(form, g), figures.GEOTEXTILE[g], LINES[form]))
    return drawn


def soil(runs):
    """Returns the cell of soil alone as it is drawn."""
    return Drawn("soil alone", runs.soil, figures.INK, ":")


def draw_response(study, runs):
    """Draws Fig. 4.4: above the cells, below their reinforced soil."""
    cells = of_cells(runs)
    study.curves("response", panel("strain", "ratio", [*cells, soil(runs)], legend=False),
                 panel("strain", "contraction", [*cells, soil(runs)], legend=False), panel("strain", "broken", cells, legend=False),
                 panel("strain", "inside_lateral", cells, legend=False), panel("strain", "inside_axial", cells, legend=False),
                 columns=3, width=11)


def draw_paths(study, runs):
    """Draws Fig. 4.5: a panel for each geotextile, in which each group of both forms has a colour."""
    figure, axes = figures.panels(len(GEOTEXTILES), width=11)
    for a, g in zip(axes, GEOTEXTILES, strict=True):
        for form in FORMS:
            cell = runs.cell(form, g)
            rows = slice(cell.peak + 1)
            for name, colour in zip(("", *GROUPS), (figures.INK, *figures.SERIES), strict=False):
                a.plot(cell[f"p{name}"][rows], cell[f"q{name}"][rows], LINES[form], color=colour, linewidth=1.2,
                       label=f"#{name}" if name and form == "wrapped" else "all" if form == "wrapped" else None)
        most = a.get_xlim()[1]
        slope = runs.soil.last("q") / runs.soil.last("p")
        a.plot([0, most], [0, slope * most], ":", color=figures.GREY, label="soil alone")
        a.set(title=g, xlim=(0, most), ylim=(0, None))
        a.legend()
        figures.label(a, "mean stress p (kPa)", "deviatoric stress q (kPa)")
    study.figure("paths", figure)


def draw_volumes(study, runs):
    """Draws Fig. 4.6 a, b."""
    cells = [Drawn(form, runs.cell(form, MIDDLING), figures.GEOTEXTILE[MIDDLING], LINES[form]) for form in FORMS]
    study.curves("volumes", panel("strain", "e", cells), panel("strain", "e_inside", cells))


def circles(axes, x, y, radius, **colours):
    """Draws circles in the units of the axes, and returns them."""
    marks = EllipseCollection(2 * radius, 2 * radius, numpy.zeros(len(x)), units="xy", offsets=numpy.column_stack([x, y]),
                              offset_transform=axes.transData, **{"linewidths": 0} | colours)
    axes.add_collection(marks)
    return marks


def draw_sections(study, runs):
    """Draws Fig. 4.6 c to f, as a picture, since there are too many marks for a drawing."""
    figure, axes = figures.panels(2, rows=2, width=11, height=5.4)
    for a, ((which, words), form) in zip(axes, ((state, form) for state in STATES for form in FORMS), strict=True):
        cut = runs.folder(f"section_{form}_{MIDDLING}_{which}")
        x, z, radius, part = (cut(name, unit) for name, unit in (("x", "mm"), ("z", "mm"), ("radius", "mm"), ("part", "1")))
        for number, colour in PARTS[1:]:
            there = part == number
            circles(a, x[there], z[there], radius[there], facecolors=colour)
        there = part == PARTS[0][0]
        strain = cut("strain_deviatoric", "1")[there]
        strains = circles(a, x[there], z[there], radius[there], array=strain, cmap="viridis", clim=(0, MOST_STRAIN))
        a.set(title=f"{form}, {words} inside", xlim=(x.min(), x.max()), ylim=(z.min(), z.max()), aspect="equal")
        a.grid(False)
        figures.label(a, "x (mm)", "z (mm)")
    figure.colorbar(strains, ax=axes, label="deviatoric strain (1)")
    path = study.out / "sections.png"
    figures.png(figure, path)
    study.picture(path, name="sections")


def draw_assemblies(study, runs):
    """Draws Fig. 4.3, as a picture: both cells from above one corner, without the fill and the nodes in front of their middle."""
    figure, axes = figures.panels(2, width=11, height=4.2)
    for a, form in zip(axes, FORMS, strict=True):
        grains = runs.folder(f"grains_{form}")
        place = numpy.column_stack([grains(f"position_{axis}", "mm") for axis in "xyz"])
        part, radius = grains("part", "1"), grains("radius", "mm")
        place = place - (place.max(axis=0) + place.min(axis=0)) / 2
        shown = ~((place[:, 0] > 0) & (place[:, 1] < 0) & (part != PARTS[0][0]))
        # Directions in the cell that point right, up, and towards the viewer in the drawing.
        right, up, near = numpy.array([1, 1, 0]) / 2**0.5, numpy.array([-0.35, 0.35, 0.87]), numpy.array([0.61, -0.61, 0.5])
        order = numpy.argsort(place[shown] @ near)
        colours = numpy.empty((len(part), 3))
        for number, colour in PARTS:
            colours[part == number] = [int(colour[k:k + 2], 16) / 255 for k in (1, 3, 5)]
        depth = place @ near
        colours *= (0.65 + 0.35 * (depth - depth.min()) / numpy.ptp(depth))[:, None]
        x, y = place[shown] @ right, place[shown] @ up
        circles(a, x[order], y[order], radius[shown][order], facecolors=colours[shown][order], edgecolors=EDGE, linewidths=0.2)
        reach = radius.max()
        a.set(title=form, xlim=(x.min() - reach, x.max() + reach), ylim=(y.min() - reach, y.max() + reach), aspect="equal")
        a.set_axis_off()
    path = study.out / "assemblies.png"
    figures.png(figure, path)
    study.picture(path, name="assemblies")


# OF_ALL: figures of this run and of the kept full-size runs. OF_RUNS: figures of this run alone.
OF_ALL = (draw_response, draw_paths, draw_volumes)
OF_RUNS = (draw_assemblies, draw_sections)
