"""The figures of chapter 6: responses over the pull, fields of the last state, what points A and B went through."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math

import numpy
from matplotlib.collections import LineCollection, PolyCollection
from study import figures

from .runs import label, squares

# Column, unit that it is drawn in, name on the page.
FIELDS = (("mean_stress", "kPa", "p (kPa)"), ("deviatoric_stress", "kPa", "q (kPa)"), ("strain_shear", "%", "ε_q (%)"),
          ("rotation", "rad", "rotation of the rods (rad)"), ("anisotropy", "1", "F_a"), ("strain_volumetric", "%", "ε_v (%)"))
EMPTY = "#d5d8dc"  # points without contacts, which have no fabric


def draw_curves(runs, kept):
    """Returns Fig. 6.2: the response of every run; beside a kept set of full size this run's main one alone, dashed."""
    figure, axes = figures.panels(2)
    friction = "friction ratio at the bottom"
    for a, example, words in zip(axes, ("shape", "pullout"), ("vertical stress at the bottom (kPa)", friction), strict=True):
        whole = kept or runs
        for case, colour in zip(whole.size.cases, figures.SERIES, strict=False):
            curve = whole.curve(example, case)
            a.plot(curve.pull, curve.value, color=colour, linewidth=1.2, label=label(case))
        if kept:
            curve = runs.curve(example)
            a.plot(curve.pull, curve.value, "--", color=figures.GREY, linewidth=1.2, label=f"this run: {label(runs.size.main)}")
        figures.label(a, "pulled (cm)", words, [friction])
        a.set_xlim(0, 25)
        a.set_ylim(bottom=0)
        a.legend()
    return figure


def draw_fields(field):
    """Returns Fig. 6.3 or 6.4: six quantities of the points, in the first panel how the nodes have moved, and the sheet.

    Returns the figure and by how much displacements are magnified in it.
    """
    figure, axes = figures.panels(2, rows=3, width=8.0, height=10.2)
    corners = field.position[field.corners]
    line = numpy.stack([field.bars("x_0", "m"), field.bars("y_0", "m")], axis=1)
    tension = field.bars("tension_ratio", "1")
    low = numpy.minimum(field.position.min(axis=0), 0) - 0.08
    high = field.position.max(axis=0) + 0.08
    for a, (name, unit, words) in zip(axes, FIELDS, strict=True):
        values = field.points(name, unit)
        if name == "anisotropy":
            values = numpy.ma.masked_less(values, 0)
        soil = PolyCollection(corners, array=values, cmap="viridis", edgecolor="face", linewidth=0.3)
        soil.cmap.set_bad(EMPTY)
        soil.set_clim(0 if name == "anisotropy" else None, None)
        a.add_collection(soil)
        if name == "deviatoric_stress":
            # The sheet is the thicker the more of its strength it carries.
            widths = 0.8 + 2.2 * tension[:-1].clip(0) / max(tension.max(), 1e-12)
            a.add_collection(LineCollection(numpy.stack([line[:-1], line[1:]], axis=1), colors=figures.ORANGE, linewidths=widths))
        else:
            a.plot(*line.T, color=figures.ORANGE, linewidth=0.8)
        figure.colorbar(soil, ax=a, shrink=0.85)
        a.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal", title=words)
        a.title.set_fontsize(10)
        a.grid(False)
        figures.label(a, "x (m)", "y (m)")
    most = numpy.linalg.norm(field.displacement, axis=1).max()
    magnified = 10**math.floor(math.log10(0.2 / most)) if 0 < most < 0.05 else 1
    moved = magnified * field.displacement
    axes[0].quiver(*field.start.T, *moved.T, angles="xy", scale_units="xy", scale=1, width=0.007, color="white", zorder=3)
    return figure, magnified


def draw_histories(runs, kept, example):
    """Returns Fig. 6.5 or 6.6: the point's q/p and volume, stress path, anisotropy; solid at full size, else dashed."""
    figure, axes = figures.panels(4, width=11, height=3.0)
    pure = ["q/p", "F_a"]
    for whole, dashes, colour in ((kept, "-", figures.BLUE), (runs, "--" if kept else "-", figures.GREY if kept else figures.BLUE)):
        if whole is None:
            continue
        h = whole.history(example)
        loaded, touching = h.p > 1e-3, h.anisotropy >= 0  # kPa: q/p of nothing says nothing; F_a is -1 without contacts
        words = f"{2 * squares(whole.size.main)**2} elements, {whole.size.grains} rods a point"
        for a, x, y in ((axes[0], h.shear[loaded], h.q[loaded] / h.p[loaded]), (axes[1], h.shear, h.volumetric), (axes[2], h.p, h.q),
                        (axes[3], h.shear[touching], h.anisotropy[touching])):
            a.plot(x, y, dashes, color=colour, linewidth=1.1, label=words)
    figures.label(axes[0], "ε_q (%)", pure[0], pure)
    figures.label(axes[1], "ε_q (%)", "ε_v, contraction positive (%)")
    figures.label(axes[2], "p (kPa)", "q (kPa)")
    figures.label(axes[3], "ε_q (%)", pure[1], pure)
    axes[2].legend(fontsize=7)
    return figure
