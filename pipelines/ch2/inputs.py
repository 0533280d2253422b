#!/usr/bin/env python3
"""Makes tables for the runs, the filter and the page: the observed peak of a test, the sets to be checked, or the numbers of sets."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import sys

import numpy
from study import StudyError, Table

LAWS = {"cl": "linear", "hm": "Hertz–Mindlin"}
PARAMETERS = {"young_modulus": "Pa", "poisson_ratio": "1", "rolling_stiffness": "1", "rolling_limit": "1", "friction_angle": "deg"}


def peak(path, pressure):
    """Returns the greatest stress ratio (3 + 2 q/p)/(3 - q/p) at a confining pressure in MPa, from q/p at failure."""
    table = Table.read(path)
    row = table.rows(numpy.isclose(table("confining_pressure", "MPa"), pressure))
    obliquity = row("obliquity_at_failure", "1")[0]
    return f"confining_pressure [kPa]\tstress_ratio_peak [1]\n{1000 * pressure:g}\t{(3 + 2 * obliquity) / (3 - obliquity):.6g}\n"


def sets(paths, twins):
    """Returns an ensemble's table: the parameters in the last row of each table, with so many twins.

    id: ten times the number of the table, from 0, plus the number of the twin.
    """
    lines = ["\t".join(["id [1]", *(f"{name} [{unit}]" for name, unit in PARAMETERS.items()), "twin [1]"])]
    for k, path in enumerate(paths):
        table = Table.read(path)
        values = [repr(float(table(name, unit)[-1])) for name, unit in PARAMETERS.items()]
        lines += ["\t".join([str(10 * k + twin), *values, str(twin)]) for twin in range(twins)]
    return "\n".join(lines) + "\n"


def rounds(paths):
    """Returns a table of the rounds: the sets drawn so far, and those of them whose run failed. paths: the filter's table of runs of each round."""
    lines = ["round [1]\tsets [1]\tfailed [1]"]
    for k, path in enumerate(paths, start=1):
        fate = Table.read(path)("fate", "1")
        lines.append(f"{k}\t{len(fate)}\t{(fate != 0).sum()}")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tables", nargs="+", metavar="TABLE", help="q/p at failure (--peak), tables whose last rows are sets (--twins), or of runs (--rounds)")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--peak", type=float, metavar="MPa", help="confining pressure")
    what.add_argument("--twins", type=int, choices=range(1, 11), metavar="N", help="runs of each set, 1 to 10")
    what.add_argument("--rounds", action="store_true", help="sets and failed runs of each round")
    given = parser.parse_args()
    try:
        made = rounds(given.tables) if given.rounds else sets(given.tables, given.twins) if given.twins else peak(given.tables[0], given.peak)
        print(made, end="")
    except StudyError as error:
        sys.exit(f"study: {error}")
