"""Excerpts of the grains of a state: the grains cut by the plane in the middle, or counts of sheared grains by distance from it.

usage: homogenize RUN --table grains --tsv | python3 -m ch4.sections cut|bands > table
       homogenize RUN --table cell --columns step --tsv | python3 -m ch4.sections least|greatest LOADING

The commands least and greatest print the number of the state in which the reinforced soil is the densest or the loosest.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import sys

import numpy
from study import StudyError, Table
from study.tables import write_table

from .cells import Cell

SOIL = 0  # number of the reinforced soil in the column "part"
CLASSES = 10  # number of classes of distances


def cut(grains):
    """Returns the circles in which the plane through the middle of y cuts the grains: place, radius, part and deviatoric strain."""
    x, y, z, radius = (grains(name, "mm") for name in ("position_x", "position_y", "position_z", "radius"))
    part, strain = grains("part", "1"), grains("strain_deviatoric", "1", missing=True)
    away = y - middle(y[part == SOIL])
    there = abs(away) < radius
    return {"x [mm]": (x - middle(x[part == SOIL]))[there], "z [mm]": (z - middle(z[part == SOIL]))[there],
            "radius [mm]": numpy.sqrt(radius**2 - away**2, where=there, out=numpy.zeros_like(radius))[there], "part [1]": part[there],
            "strain_deviatoric [1]": numpy.nan_to_num(strain[there])}


def bands(grains):
    """Returns counts of the reinforced soil's grains, and of those sheared above twice the mean, by distance from the middle in plan.

    The distance is the greater of |x| and |y| from the middle, over the farthest grain's. Each class is named by its upper end.
    """
    soil = grains.rows(grains("part", "1") == SOIL)
    x, y, strain = soil("position_x", "mm"), soil("position_y", "mm"), soil("strain_deviatoric", "1", missing=True)
    away = numpy.maximum(abs(x - middle(x)), abs(y - middle(y)))
    known = ~numpy.isnan(strain)
    number = numpy.minimum((CLASSES * away / away.max()).astype(int), CLASSES - 1)
    much = known & (strain > 2 * strain[known].mean())
    return {"distance [1]": (numpy.arange(CLASSES) + 1) / CLASSES, "grains [1]": numpy.bincount(number[known], minlength=CLASSES),
            "sheared [1]": numpy.bincount(number[much], minlength=CLASSES)}


def middle(values):
    """Returns the middle between the least and the greatest value."""
    return (values.min() + values.max()) / 2


def state(steps, loading, which):
    """Returns the index of the state, in a list of recorded steps, in which the reinforced soil is the densest or the loosest."""
    cell = Cell(loading)
    e = cell["e_inside"]
    step = cell["step"][e.argmin() if which == "least" else e.argmax()]
    there = numpy.flatnonzero(steps == step)
    if not len(there):
        raise StudyError(f"{loading.where}: the state at step {step:.0f} was not recorded; record \"stations\"")
    return int(there[-1])


def main(arguments):
    """Answers one of the four commands on a table from standard input."""
    table = Table.read("/dev/stdin")
    if arguments[0] in ("least", "greatest"):
        print(state(table("step", "1"), Table.read(arguments[1]), arguments[0]))
    else:
        sys.stdout.write(write_table({"cut": cut, "bands": bands}[arguments[0]](table)))


if __name__ == "__main__":
    try:
        main(sys.argv[1:])
    except StudyError as error:
        print(f"study: {error}", file=sys.stderr)
        sys.exit(65)
