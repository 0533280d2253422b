"""Plots of the command `plot`: each kind shows one or several runs or tables beside each other."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import pathlib
import re
import tomllib

import h5py
import numpy

from . import figures
from .errors import StudyError
from .kinds import KINDS
from .tables import Table

DASHES = ("-", "--", ":", "-.", (0, (5, 1, 1, 1, 1, 1)), (0, (1, 3)))


# Quantities of a series that volumes of interest have too.
OF_VOLUMES = ("mean_stress", "deviatoric_stress", "void_ratio", "strain_axial", "strain_volumetric")
PLANES = {1: ("x", "y"), 2: ("x", "z")}


def is_hdf5(path):
    """Returns whether a file begins as HDF5 files do, or is a folder, as runs under way are."""
    path = pathlib.Path(path)
    if path.is_dir():
        return True
    try:
        with path.open("rb") as file:
            return file.read(8) == b"\x89HDF\r\n\x1a\n"
    except OSError as error:
        raise StudyError(f"{path}: cannot be read: {error.strerror}") from error


def _demand_rows(table):
    if len(table) == 0:
        raise StudyError(f"{table.where}: has no rows below its header")


def stage_of(table, stage, kind):
    """Returns the rows of a stage: its number, "all", "last", or "" for what the kind shows by default.

    A bag is by default shown from the row where its settlement is 0 to its end.
    """
    _demand_rows(table)
    if not stage and kind.table[1:] == ("loading",) and table.has("settlement"):
        return table.rows(numpy.maximum.accumulate(table("settlement", "m") == 0))
    wanted = stage or ("all" if kind.whole else "last")
    if wanted == "all" or not (table.has("stage") or stage):
        return table
    if not table.has("stage"):
        raise StudyError(f"{table.where}: has no column stage by which to choose one; leave --stage out")
    stages = table("stage", "1")
    chosen = stages[-1] if wanted == "last" else float(wanted)
    if chosen not in stages:
        raise StudyError(f"{table.where}: has no stage {wanted}; give one that it has: {', '.join(f'{known:g}' for known in numpy.unique(stages))}")
    return table.rows(stages == chosen)


def bag_series(kind, series, loading):
    """Returns the table of a bag between plates that has the columns of a kind: its loading, or else its series.

    The cell of a bag is open and has no strain, so that the series takes the strain of the loading, row by row.
    """
    if all(any(loading.has(line.column) for line in _choices(entry)) for panel in kind.panels for entry in panel.each):
        return loading
    return series.replace("strain_axial", loading("strain_axial", "1"))


def during(states, series):
    """Returns the rows of a table of states whose steps lie within those of a series."""
    step = series("step", "1")
    return states.rows((states("step", "1") >= step[0]) & (states("step", "1") <= step[-1]))


def strained(fabric, series):
    """Returns a table of states with the axial strain that the run's series has at their steps, in the rows of its stage.

    A state at the end of a stage has the strain of that stage; the series counts it anew in the next one.
    """
    fabric = during(fabric, series)
    strain = series("strain_axial", "1", missing=True)
    return fabric.replace("strain_axial", numpy.interp(fabric("step", "1"), series("step", "1"), strain))


def _choices(entry):
    """Returns an entry of Panel.each, alternatives of which one is drawn, as a tuple."""
    return entry if isinstance(entry, tuple) else (entry,)


def _chosen(tables, beside, entry):
    """Returns the curve that all tables have; of several such curves, the one that the most tables in `beside` have."""
    common = [line for line in _choices(entry) if all(table.has(line.column) for _, table in tables)]
    return max(common or _choices(entry)[:1], key=lambda line: sum(table.has(line.column) for _, table in beside))


def _column(table, line, remedy=""):
    values = table(line.column, line.unit, missing=True)
    if numpy.isnan(values).all():
        raise StudyError(f"{table.where}: column {line.column} has no value{remedy}")
    return values


def _over(table, panel):
    """Returns the abscissae of a panel. Raises StudyError for a cell that is not periodic, with a table that has them."""
    of_volumes = all(any(line.column in OF_VOLUMES for line in _choices(entry)) for entry in panel.each)
    instead = ("draw the text of a volume among its grains: homogenize RUN --table volumes --box=X0,X1,Y0,Y1,Z0,Z1 --tsv (of disks --box=X0,X1,Y0,Y1)"
               if of_volumes else "see the columns of its plates: homogenize RUN --table series --tsv")
    return _column(table, panel.abscissa, f"; a cell that is not periodic has none: {instead}")


def _demand_data(table, kind):
    """Raises StudyError for test data without rows, or without a value to be drawn over: no other table of a run mends them."""
    _demand_rows(table)
    for panel in kind.panels:
        if table.has(panel.abscissa.column):
            _column(table, panel.abscissa, "; give test data that have one")


def _abscissae(table, panel):
    """Returns the abscissae of a table, NaN where a logarithmic axis has no place for them."""
    values = _over(table, panel)
    if not panel.log:
        return values
    if not (values > 0).any():
        raise StudyError(f"{table.where}: column {panel.abscissa.column} has no value above 0, and its axis is logarithmic: "
                         "give rows under pressure")
    return numpy.where(values > 0, values, numpy.nan)


def _left_out(label, table, panel):
    """Returns a note, in a list, about the rows that a logarithmic axis leaves out."""
    count = int((_over(table, panel) <= 0).sum()) if panel.log else 0
    why = f"{panel.abscissa.column} is not above 0 there, and its axis is logarithmic"
    return [f"{label}: {count} of {len(table)} rows left out, since {why}"] if count else []


def _pairs(table, panel, line):
    """Returns abscissae and ordinates of a curve, NaN where a row has no value. Raises StudyError where no row has both."""
    x, y = _abscissae(table, panel), _column(table, line)
    if numpy.isnan(x + y).all():
        raise StudyError(f"{table.where}: no row has a value of both {panel.abscissa.column} and {line.column}")
    return x, y


def _gaps(label, table, panel, line):
    """Returns a note, in a list, about the rows without a value, where a curve has gaps."""
    count = int(numpy.isnan(_column(table, line)).sum())
    words = f"{label}: {count} of {len(table)} rows have no {line.column}"
    return [f"{words}, and the curve over {panel.abscissa.column} has gaps there"] if count else []


def _disks(table):
    """Returns whether a series is that of disks, which bear nothing along z; None for a table that does not say."""
    if not all(table.has(name) for name in ("stress_yy", "stress_zz", "strain_zz")):
        return None
    along, across, strain = (table(name, unit, missing=True) for name, unit in (("stress_yy", "Pa"), ("stress_zz", "Pa"), ("strain_zz", "1")))
    return bool((across == 0).all() and (strain == 0).all() and (along != 0).any())


def _mixed(tables):
    """Returns a doubt, in a list, where tables of disks and of spheres are drawn beside each other."""
    disks, spheres = ([label for label, table in tables if _disks(table) is flat] for flat in (True, False))
    both = f"doubt: {disks[0]} is a run of disks, and {spheres[0]} of spheres" if disks and spheres else ""
    return [f"{both}: their void ratios and coordination numbers do not compare, nor stresses at one stiffness"] if both else []


def _dots(x, y):
    """Returns matplotlib's options that mark points without a neighbour, which a line alone would not show."""
    known = numpy.pad(~numpy.isnan(x + y), 1)
    alone = numpy.flatnonzero(known[1:-1] & ~known[:-2] & ~known[2:])
    return {"marker": "o", "markersize": 3.5, "markevery": list(alone)} if len(alone) else {}


def _colours(names):
    """Returns a colour for each name: the geotextile's, if a word of the name is a geotextile, or else the next free colour."""
    given = []
    for name in names:
        textile = next((word for word in re.split(r"[^0-9A-Za-z.]+|\.(?=[A-Za-z])", name) if word in figures.GEOTEXTILE), None)
        given.append(figures.GEOTEXTILE[textile] if textile else None)
    if len(set(given)) < len(given):  # two of one geotextile, or none of any: colours would not tell them apart
        given = [None] * len(given)
    spare = (c for c in (*figures.SERIES, figures.GREY, figures.INK) * len(names) if c not in given)
    return [colour or next(spare) for colour in given]


def draw(name, tables, beside=()):
    """Returns the figure of a kind, and notes about what it leaves out.

    tables: pairs of a name for the legend and its Table, drawn as lines. beside: such pairs, drawn as points in the panels whose
    columns they have. Raises StudyError where a column is missing.
    """
    for _, table in beside:
        _demand_data(table, KINDS[name])
    if name == "rose":
        return _rose(tables)
    if name == "posterior":
        return _posterior(tables), []
    kind, notes, drawn = KINDS[name], _mixed(tables), []
    figure, axes = figures.panels(len(kind.panels), width=4.8 * len(kind.panels) + (1 if len(kind.panels) == 1 else 0))
    for a, panel in zip(axes, kind.panels, strict=True):
        lines = [_chosen(tables, beside, entry) for entry in panel.each]
        drawn += [line.column for line in lines]
        notes += [note for label, table in (*tables, *beside)
                  if table.has(panel.abscissa.column) for note in _left_out(label, table, panel)]
        _curves(a, panel, lines, tables)
        notes += [note for label, table in tables for line in lines for note in _gaps(label, table, panel, line)]
        notes += _beside(a, panel, lines, beside)
        notes += [note for note in _strains(panel, lines, (*tables, *beside)) if note not in notes]
        label = panel.label or lines[0].axis
        figures.label(a, panel.abscissa.axis, label, pure=[label] if all(line.unit == "1" for line in lines) else ())
        if panel.log:
            a.set_xscale("log")
        if len(tables) + len(beside) + len(lines) > 2:
            a.legend()
    for label, table in beside:
        if not any(map(table.has, drawn)):
            own = [line.column for panel in kind.panels for entry in panel.each for line in _choices(entry) if table.has(line.column)]
            raise StudyError(f"{label}: has {own[0]}, but {drawn[0]} is drawn of the other tables; draw it without them" if own else
                             f"{label}: has none of the columns that {name} draws")
    return figure, notes


def _curves(axes, panel, lines, tables):
    """Draws each line of each table. Lines of one table differ in colour. With several tables, colours show the table, dashes the column."""
    several = len(tables) > 1
    colours = _colours([label for label, _ in tables]) if several or len(lines) == 1 else figures.SERIES
    for t, (label, table) in enumerate(tables):
        for k, line in enumerate(lines):
            words = (label if k == 0 else None) if several or len(lines) == 1 else line.words
            x, y = _pairs(table, panel, line)
            axes.plot(x, y, color=colours[t if several or len(lines) == 1 else k], linestyle=DASHES[k] if several else "-", label=words,
                      **_dots(x, y))
    if several and len(lines) > 1:
        for k, line in enumerate(lines):
            axes.plot([], [], color=figures.GREY, linestyle=DASHES[k], label=line.words)


def _beside(axes, panel, lines, beside):
    """Draws test data as points; returns a note for each line without a column in them."""
    notes = []
    inks = (figures.INK, figures.GREY, figures.RED)
    for t, (label, table) in enumerate(beside):
        for line in lines:
            if not table.has(line.column):
                notes.append(f"{label}: has no column {line.column}; {line.words} is without it")
                continue
            words = label if len(lines) == 1 else f"{label}: {line.words}"
            figures.points(axes, *_pairs(table, panel, line), inks[t % len(inks)], words)
    return notes


def _strains(panel, lines, tables):
    """Returns a doubt for each drawn strain without "%" in its header that exceeds 1: perhaps it is in per cent."""
    doubts = []
    for label, table in tables:
        for line in (panel.abscissa, *lines):
            if line.unit != "%" or not table.has(line.column) or table.unit(line.column) not in ("", "-", "1"):
                continue
            most = numpy.nanmax(numpy.abs(table(line.column, "1", missing=True)), initial=0)
            if most > 1:
                doubts.append(f"doubt: {label}: {line.column} reaches {most:.4g}, which is {100 * most:.4g} %; "
                              f"if {most:.4g} % is meant, head it {line.column} [%]")
    return doubts


def _rose(tables):
    """Draws the last state's contact normals, a panel for each plane, as a closed line around the circle of isotropy.

    Returns the figure, and a note for each plane that a table has not.
    """
    planes = [p for p in PLANES if any((t("plane", "1") == p).any() for _, t in tables)]
    notes = []
    if not planes:
        raise StudyError(f"{tables[0][1].where}: has none of the planes {', '.join(map(str, PLANES))}")
    figure, axes = figures.panels(len(planes), width=4.8 * len(planes))
    colours = _colours([label for label, _ in tables])
    circle = numpy.linspace(0, 2 * numpy.pi, 361)
    for _, table in tables:
        last = table.rows(table("step", "1") == table("step", "1")[-1])
        if numpy.isnan(last("density", "1", missing=True)).any():
            raise StudyError(f"{table.where}: has no contacts in its last state, and so no rose; give a state under load")
    for a, plane in zip(axes, planes, strict=True):
        a.plot(numpy.cos(circle), numpy.sin(circle), color=figures.GREY, linewidth=1, linestyle="--", label="isotropic")
        for (label, table), colour in zip(tables, colours, strict=True):
            there = (table("plane", "1") == plane) & (table("step", "1") == table("step", "1")[-1])
            if not there.any():
                notes.append(f"{label}: has no contacts in the plane {''.join(PLANES[plane])}; that panel is without it")
                continue
            own = table.rows(there)
            if len(own) < 2:
                raise StudyError(f"{table.where}: has one direction alone in plane {plane}; a rose needs several")
            angle, density = numpy.radians(own("angle", "deg")), own("density", "1")
            half = (angle[1] - angle[0]) / 2
            around = numpy.repeat(angle, 2) + numpy.tile([-half, half], len(angle))
            x, y = numpy.repeat(density, 2) * numpy.cos(around), numpy.repeat(density, 2) * numpy.sin(around)
            a.fill(x, y, color=colour, alpha=0.2 if len(tables) > 1 else 0.5, linewidth=0)
            a.plot(numpy.append(x, x[0]), numpy.append(y, y[0]), color=colour, linewidth=1.1, label=label)
        a.set_aspect("equal")
        labels = [f"density along {axis}" for axis in PLANES[plane]]
        figures.label(a, *labels, pure=labels)
    axes[0].legend(loc="upper right", fontsize=8)
    return figure, notes


@dataclasses.dataclass(frozen=True)
class Posterior:
    """Marginal densities, step by step, and (words, unit, whether on a log scale) of each parameter, by its number."""

    table: Table
    parameters: list


def read_posterior(path):
    """Returns the Posterior of a file that pf-weight assimilate wrote."""
    if not is_hdf5(path):
        raise StudyError(f"{path}: is no posterior; give the file that pf-weight assimilate writes with -o")
    columns = ("step", "parameter", "value", "density")
    try:
        with h5py.File(path) as file:
            if "fields/density" not in file:
                raise StudyError(f"{path}: holds no densities; pf-weight assimilate writes them with -o")
            table = {name: file["fields/density"][name][()] for name in columns}
            prior = tomllib.loads(file["prior"][()].decode())["parameter"]
        names = [(p.get("long_name", p["name"]), p.get("unit", "1"), p.get("scale", "linear") == "log") for p in prior]
    except (OSError, KeyError, ValueError, AttributeError) as error:
        raise StudyError(f"{path}: is no whole posterior; make it again with pf-weight assimilate") from error
    rows = [[repr(float(table[c][k])) for c in columns] for k in range(len(table["step"]))]
    return Posterior(Table(rows, dict.fromkeys(columns, "1"), path), names)


def _posterior(tables):
    """Draws the marginal densities at the last step: a panel for each parameter, in its unit; per decade on a log scale."""
    names = tables[0][1].parameters
    for label, posterior in tables:
        if posterior.parameters != names:
            raise StudyError(f"{label}: has other parameters than {tables[0][0]}")
    figure, axes = figures.panels(min(3, len(names)), rows=-(-len(names) // 3), width=3.4 * min(3, len(names)),
                                  height=2.8 * -(-len(names) // 3))
    colours = _colours([label for label, _ in tables])
    for a in axes[len(names):]:
        a.remove()
    for k, (words, unit, log) in enumerate(names):
        for (label, posterior), colour in zip(tables, colours, strict=True):
            table = posterior.table
            last = table("step", "1") == table("step", "1").max()
            own = table.rows(last & (table("parameter", "1") == k))
            axes[k].plot(own("value", "1"), own("density", "1"), color=colour, label=label, **_dots(own("value", "1"), own("density", "1")))
            axes[k].fill_between(own("value", "1"), own("density", "1"), color=colour, alpha=0.15, linewidth=0)
        x = words if unit == "1" else f"{words} ({unit})"
        y = "density (1/decade)" if log else "density" if unit == "1" else f"density (1/{unit})"
        figures.label(axes[k], x, y, pure=(x, y) if unit == "1" else ())
        axes[k].set_ylim(bottom=0)
        if log:
            axes[k].set_xscale("log")
    if len(tables) > 1:
        axes[0].legend()
    return figure

