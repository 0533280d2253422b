"""One style for all figures: colours that colour-blind readers can distinguish, units on every axis, reproducible bytes."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import io
import re

import numpy

from .errors import StudyError

# Okabe and Ito's colours (2008), which stay apart for readers with any of the usual colour deficiencies.
BLUE, ORANGE, GREEN, RED, PURPLE, SKY, GREY = "#0072b2", "#d55e00", "#009e73", "#a3263f", "#8f5b8c", "#56b4e9", "#667080"
SERIES = (BLUE, ORANGE, GREEN, PURPLE, RED, SKY)
INK = "#303840"  # published and laboratory values, where no series has its own colour
# Each geotextile has one colour on all pages.
GEOTEXTILE = {"PE": BLUE, "0.5PP": GREY, "PP": ORANGE, "2PP": RED, "3PP": GREEN, "4PP": PURPLE, "5PP": SKY}

_STYLE = {
    "font.family": "sans-serif",
    "font.size": 10,
    "svg.fonttype": "none",
    "svg.hashsalt": "soilweave",
    "axes.spines.top": False,
    "axes.spines.right": False,
    "axes.edgecolor": "#505860",
    "axes.grid": True,
    "axes.axisbelow": True,
    "axes.titlesize": 10,
    "grid.color": "#e3e6ea",
    "grid.linewidth": 0.7,
    "lines.linewidth": 1.7,
    "legend.frameon": False,
    "legend.fontsize": 9,
    "figure.facecolor": "white",
    "figure.constrained_layout.use": True,
}
_LABEL = re.compile(r".*\(.+\)$|.*\[.+\]$")


@functools.cache
def pyplot():
    """Returns matplotlib's pyplot with this style. It is imported here, since that takes most of a second and some programs draw nothing."""
    import matplotlib
    matplotlib.use("svg")
    from matplotlib import pyplot as module  # the backend has to be chosen before
    matplotlib.rcParams.update(_STYLE)
    return module


def panels(columns, rows=1, width=None, height=4.4):
    """Returns a figure of so many panels and the list of their axes, row by row.

    width, height: in inches; without a width 6 for one column, which a narrow page does not cut apart, and 9 for more.
    """
    width = width or (6.0 if columns == 1 else 9.0)
    figure, axes = pyplot().subplots(rows, columns, figsize=(width, height), squeeze=False)
    return figure, list(axes.flat)


def label(axes, x, y, pure=()):
    """Labels both axes. Each label ends in its unit, as in "axial strain (%)"; those named in `pure` have none."""
    for text in (x, y):
        if text not in pure and not _LABEL.match(text):
            raise StudyError(f"axis '{text}': has no unit; write \"name (unit)\" or name it among the pure numbers")
    axes.set_xlabel(x)
    axes.set_ylabel(y)


def points(axes, x, y, colour, name=None):
    """Draws published or laboratory values: open circles, never joined by a line."""
    return axes.plot(x, y, "o", markersize=3.5, markerfacecolor="none", markeredgewidth=0.9, color=colour, label=name)


def svg(figure):
    """Returns the figure as SVG text, equal for equal figures, and closes it."""
    text = _saved(figure)
    pyplot().close(figure)
    return text


def png(figure, path):
    """Writes the figure as a PNG file, for pictures of more marks than a drawing should have, and closes it."""
    figure.savefig(path, format="png", dpi=110, bbox_inches="tight", metadata={"Software": None})
    pyplot().close(figure)


def panes(figure):
    """Returns the panels of a figure as SVG texts of their own, which a narrow page can put below each other.

    Twin axes and colour bars stay with their panel. A figure with a title or a legend of its own stays whole.
    """
    if figure.legends or figure._suptitle is not None or len(figure.axes) < 2:  # pylint: disable=protected-access
        return [_saved(figure)]
    from matplotlib import transforms
    figure.draw_without_rendering()
    groups = _groups(figure)
    # Boxes are in inches, since saving changes the dots per inch.
    boxes = [transforms.Bbox.union([a.get_tightbbox() for a in group]).transformed(figure.dpi_scale_trans.inverted()).padded(0.05)
             for group in groups]
    texts = []
    for group, box in zip(groups, boxes, strict=True):
        row = [b for b in boxes if b.y0 < (box.y0 + box.y1) / 2 < b.y1]
        crop = transforms.Bbox.from_extents(box.x0, min(b.y0 for b in row), box.x1, max(b.y1 for b in row))
        for axes in figure.axes:
            axes.set_visible(axes in group)
        figure.set_layout_engine("none")  # saving sets it back, and would lay out anew what is visible
        texts.append(_saved(figure, crop))
    for axes in figure.axes:
        axes.set_visible(True)
    figure.set_layout_engine("constrained")
    return texts


def _groups(figure):
    """Returns lists of axes that belong together: those in one place, and a colour bar with the axes of its picture."""
    groups = []
    for axes in figure.axes:
        bar = getattr(axes, "_colorbar", None)
        home = bar.mappable.axes if bar is not None else None
        for group in groups:
            if home in group or any(numpy.allclose(axes.get_position().bounds, a.get_position().bounds) for a in group):
                group.append(axes)
                break
        else:
            groups.append([axes])
    return groups


def _saved(figure, box=None):
    text = io.StringIO()
    figure.savefig(text, format="svg", bbox_inches=box, metadata={"Date": None, "Creator": None})
    return text.getvalue()
