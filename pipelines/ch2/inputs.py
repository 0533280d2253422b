#!/usr/bin/env python3
"""Makes tables for the runs and the filter: prints the observed peak of a test, or the sets to be checked."""
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


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("tables", nargs="+", metavar="TABLE", help="q/p at failure (--peak), or tables whose last rows are sets (--twins)")
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--peak", type=float, metavar="MPa", help="confining pressure")
    what.add_argument("--twins", type=int, choices=range(1, 11), metavar="N", help="runs of each set, 1 to 10")
    given = parser.parse_args()
    try:
        print(sets(given.tables, given.twins) if given.twins else peak(given.tables[0], given.peak), end="")
    except StudyError as error:
        sys.exit(f"study: {error}")
