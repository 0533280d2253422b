"""Pictures of the bag of PE: where its yarns broke, and three of its states, cut in the middle and from above."""
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy
from matplotlib.collections import EllipseCollection, LineCollection
from study import figures

from .bag import HERE
from .breaks import FACE
from .drawing import COLOURS

STATES = (1, 2, 3)  # after the preload, at 12 %, the last
MOST_STRAIN = 0.4  # deviatoric strain at the end of the scale of colours
BROKEN = "#e31a1c"


def seen_from_above(axes):
    """Sets the limits of a view of the bag from above, mm."""
    axes.set(xlim=(-280, 280), ylim=(-280, 280), aspect="equal")
    figures.label(axes, "x (mm)", "y (mm)")


def draw_breaks(study, runs, _):
    """Fig. 3.6."""
    figure, axes = figures.panels(2, height=4.6)
    for a, name, words in zip(axes, ("uc_PE_breaks", "uc_PE_rough_breaks"), ("smooth plates", "rough plates"), strict=True):
        table = runs.table(name)
        a.plot(table("x", "mm"), table("y", "mm"), "o", markersize=1.5, color=COLOURS["PE"], rasterized=True)
        a.set_title(words)
        seen_from_above(a)
    study.figure("breaks", figure, "Where yarns of PE are broken at the end, seen from above.", "Fig. 3.6", "between smooth plates the bag "
                 "ruptures in the middle, between rough ones along the seams.", ["breaks_smooth", "breaks_rough"])


def section(axes, grains):
    """Draws the grains that the plane y = 0 cuts, coloured by their deviatoric strain; nodes of the geotextile are grey."""
    x, y, z, radius = (grains(name, "mm") for name in ("position_x", "position_y", "position_z", "radius"))
    cut = abs(y) < radius
    places, width = numpy.column_stack([x, z])[cut], 2 * numpy.sqrt(radius[cut]**2 - y[cut]**2)
    node, strain = grains("copy", "1")[cut] < 0, grains("strain_deviatoric", "1", missing=True)[cut]
    for which, colours in ((node, {"facecolors": figures.GREY}), (~node, {"array": strain[~node], "cmap": "viridis", "clim": (0, MOST_STRAIN)})):
        circles = EllipseCollection(width[which], width[which], numpy.zeros(which.sum()), units="xy", offsets=places[which],
                                    offset_transform=axes.transData, linewidths=0, **colours)
        axes.add_collection(circles)
    axes.set(xlim=(-280, 280), ylim=(-65, 65), aspect="equal")
    figures.label(axes, "x (mm)", "z (mm)")
    return circles


def face(axes, yarns):
    """Draws the yarns of the upper face from above, coloured by their tension; broken ones are red points."""
    upper = yarns.rows((yarns("family", "1") == FACE) & (yarns("position_z", "mm") > 0))
    middle = numpy.column_stack([upper("position_x", "mm"), upper("position_y", "mm")])
    half = upper("length", "mm")[:, None] / 2 * numpy.column_stack([upper("direction_x", "1"), upper("direction_y", "1")])
    broken = upper("broken", "1") == 1
    lines = LineCollection(numpy.stack([middle - half, middle + half], axis=1)[~broken], array=upper("tension", "N")[~broken],
                           cmap="viridis", linewidths=0.8)
    axes.add_collection(lines)
    axes.plot(*middle[broken].T, "o", markersize=1.5, color=BROKEN)
    seen_from_above(axes)
    return lines


def draw_bag(study, runs, kept):
    """Figs. 3.12 and 3.14: there are too many marks for a drawing."""
    bag = runs.bag("uc_PE")
    figure, axes = figures.panels(len(STATES), rows=2, width=11, height=5.4)
    for k, above, below in zip(STATES, axes[:len(STATES)], axes[len(STATES):], strict=True):
        yarns = runs.table(f"uc_PE_yarns_{k}")
        strains, tensions = section(above, runs.table(f"uc_PE_grains_{k}")), face(below, yarns)
        above.set_title(f"compressed by {bag.strain_at(yarns):.0f} %")
        figure.colorbar(strains, ax=above, orientation="horizontal", label="deviatoric strain (1)")
        figure.colorbar(tensions, ax=below, label="tension of the upper yarns (N)")
        for a in (above, below):
            a.grid(False)
    path = study.out / "bag.png"
    figures.png(figure, path)
    study.picture(path, "The bag of PE before it is compressed, near its greatest load and ruptured: deviatoric strain of the grains that "
                  "the plane in its middle cuts, tension of the yarns on its upper face, in red where they broke.", "Figs. 3.12 and 3.14",
                  "strain localises early; at the end the geotextile is worn out in the middle.")
    study.picture(HERE / "bag3d.jpg", "The bag of PE of a quick run in three dimensions, a quarter of it cut out (pipelines/ch3/render.py draws it).")
    if kept:
        study.picture(HERE / "bag.png", "The same of our run at full size.", "Figs. 3.12 and 3.14")
