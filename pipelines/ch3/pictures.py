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


def laid_out(axes, y, height):
    """Sets limits and labels of a view of the bag, mm. height: half of what is seen along y, "y" or "z"."""
    axes.set(xlim=(-280, 280), ylim=(-height, height), aspect="equal")
    figures.label(axes, "x (mm)", f"{y} (mm)")


def draw_breaks(study, runs, _):
    """Draws Fig. 3.6."""
    figure, axes = figures.panels(2, height=4.6)
    for a, name, words in zip(axes, ("uc_PE_breaks", "uc_PE_rough_breaks"), ("smooth plates", "rough plates"), strict=True):
        table = runs.table(name)
        a.plot(table("x", "mm"), table("y", "mm"), "o", markersize=1.5, color=COLOURS["PE"], rasterized=True)
        a.set_title(words)
        laid_out(a, "y", 280)
    study.figure("breaks", figure)


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
    laid_out(axes, "z", 65)
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
    laid_out(axes, "y", 280)
    return lines


def draw_bag(study, runs, kept):
    """Draws Figs. 3.12 and 3.14, as a picture, since there are too many marks for a drawing."""
    bag = runs.bag("uc_PE")
    figure, axes = figures.panels(len(STATES), rows=2, width=11, height=5.4)
    for k, above, below in zip(STATES, axes[:len(STATES)], axes[len(STATES):], strict=True):
        yarns = runs.table(f"uc_PE_yarns_{k}")
        strains, tensions = section(above, runs.table(f"uc_PE_grains_{k}")), face(below, yarns)
        above.set_title(f"compressed by {bag['strain_axial'][bag['step'] == yarns['step'][0]][0]:.0f} %")
        figure.colorbar(strains, ax=above, orientation="horizontal", label="deviatoric strain (1)")
        figure.colorbar(tensions, ax=below, label="tension of the upper yarns (N)")
        for a in (above, below):
            a.grid(False)
    path = study.out / "bag.png"
    figures.png(figure, path)
    study.picture(path, name="bag")
    study.picture(HERE / "bag3d.jpg", name="bag3d")
    if kept:
        study.picture(HERE / "bag.png", name="bag_full_size")
