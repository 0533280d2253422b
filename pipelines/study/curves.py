"""Figures of curves from a short description: columns over a column, for runs and published points."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses

from . import figures

_LINE = {"linewidth": 1.3, "markersize": 2.5}


@dataclasses.dataclass(frozen=True)
class Drawn:
    """A run as figures draw it: its name and a note for the legend, its Series, its colour and line; "o" are published points.

    spread: a Series of the deviations of its values, drawn as a band. ends: two Series, of the lower and upper ends of its values,
    drawn as bars.
    """

    name: str
    of: object
    colour: str
    line: str = "-"
    note: str = ""
    spread: object = None
    ends: object = None

    def words(self, line=None):
        """Returns the entry in a legend: the words of `line` if it is given, else the name of the run."""
        return ", ".join(text for text in (line.words if line else self.name, self.note) if text)


@dataclasses.dataclass(frozen=True)
class Panel:
    """Columns over one column. y: its name, or names of several, each of which has then a colour and words of its own; `label`
    is what their axis is called. xlim, ylim, xscale, yscale, title: as matplotlib has them; an axis begins at 0 with ylim=(0, None).
    """

    x: str
    y: object
    runs: list
    label: str = ""
    how: dict = dataclasses.field(default_factory=dict)
    legend: bool = True


def panel(x, y, runs, label="", legend=True, **how):
    """Returns a Panel of the runs. Each is a Drawn; published points may stand among them."""
    return Panel(x, y, list(runs), label, how, legend)


def draw(axes, one):
    """Draws a panel."""
    names = one.y if isinstance(one.y, tuple) else (one.y,)
    for k, name in enumerate(names):
        for run in one.runs:
            several = run.of.line(name) if len(names) > 1 else None
            colour = figures.SERIES[k] if several else run.colour
            if run.line == "o":
                figures.points(axes, run.of[one.x], run.of[name], colour, run.words(several))
            else:
                if run.spread:
                    middle, half = run.of[name], run.spread[name]
                    axes.fill_between(run.of[one.x], middle - half, middle + half, color=colour, alpha=0.2, linewidth=0)
                if run.ends:
                    axes.vlines(run.of[one.x], *(end[name] for end in run.ends), color=colour, linewidth=3, alpha=0.35)
                axes.plot(run.of[one.x], run.of[name], run.line, color=colour, label=run.words(several), **_LINE)
    first = one.runs[0].of
    x, y = first.line(one.x), first.line(names[0])
    label = one.label or y.axis
    figures.label(axes, x.axis, label, [line.axis for line in (x, y) if line.unit == "1"] + [label] * (y.unit == "1"))
    axes.set(**one.how)
    for axis, limits in ((axes.xaxis, axes.get_xlim), (axes.yaxis, axes.get_ylim)):
        if axis.get_scale() == "log":
            _plain(axis, *limits())
    if one.legend and axes.get_legend_handles_labels()[1]:
        axes.legend()


def _plain(axis, low, high):
    """Labels a logarithmic axis with plain numbers, also between the powers of ten if it spans less than a decade."""
    axis.set_major_formatter("{x:g}")
    axis.set_minor_formatter("{x:g}" if high < 10 * low else "")


def figure(panels, columns=None, width=None, height=None):
    """Returns a figure of panels, in rows of so many columns; without a number all are in one row.

    If no panel has a legend and a place is left, the legend of the first panel goes there.
    """
    columns = columns or len(panels)
    rows = -(-len(panels) // columns)
    drawn, axes = figures.panels(columns, rows, width or (6.4 if columns == 1 else None), height or (4.4 if rows == 1 else 3.8 * rows))
    for a, one in zip(axes, panels, strict=False):
        draw(a, one)
    spare = axes[len(panels):]
    if spare and not any(one.legend for one in panels):
        spare.pop(0).legend(*axes[0].get_legend_handles_labels(), loc="center")
        axes[len(panels)].set_axis_off()
    for a in spare:
        a.remove()
    return drawn
