#!/usr/bin/env python3
"""Parameter sets of a posterior for the runs after it: draws for the bags, the heaviest one for checks, as options of the tools."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import pathlib
import sys

import numpy
from calibration.ensemble import PARAMETERS
from study import StudyError, Table

NAMES = [name for name, _, _ in PARAMETERS]


def drawn(sets, weights, count):
    """Returns `count` rows that represent the weighted sets: in the order of friction angle, the middles of equal parts of the weight.

    Neighbours in friction are put apart, so that the angle does not rise with the number of the bag.
    """
    weight = dict(zip(weights("id", "1"), weights("weight", "1"), strict=True))
    share = numpy.array([weight.get(i, 0) for i in sets("id", "1")])
    order = numpy.argsort(sets("friction_angle", "deg"), kind="stable")
    sums = numpy.cumsum(share[order]) / share.sum()
    rows = [int(order[numpy.argmax(sums >= (k + 0.5) / count)]) for k in range(count)]
    return rows[1::2] + rows[::2]


def table(sets, rows, twins):
    """Returns an ensemble's table of these rows, each with so many twins; ids count from 0."""
    columns = [sets(name, unit) for name, _, unit in PARAMETERS]
    lines = ["\t".join(["id [1]", *(f"{name} [{unit}]" for name, _, unit in PARAMETERS), "twin [1]"])]
    for row in rows:
        for twin in range(twins):
            lines.append("\t".join([str(len(lines) - 1), *(repr(float(column[row])) for column in columns), str(twin)]))
    return "\n".join(lines) + "\n"


def options(sets, row, scale):
    """Returns the contact parameters of a row as --set options. scale: size of the grains over their size in the calibration.

    Grains of another size have the same rolling resistance if the rolling stiffness (N m/rad) grows with the cube of the size.
    """
    value = {name: float(sets(name, unit)[row]) for name, _, unit in PARAMETERS}
    rolling = value["rolling_stiffness"] * scale**3
    limit = value["rolling_limit"] if value["rolling_limit"] > 0 else "none"
    given = {"young_modulus": value["young_modulus"], "poisson_ratio": value["poisson_ratio"], "friction_angle": value["friction_angle"],
             "rolling.stiffness": rolling, "twisting.stiffness": rolling, "rolling.limit": limit, "twisting.limit": "none"}
    return " ".join(f"--set contact.{key}={word}" for key, word in given.items())


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("what", choices=["draw", "heaviest", "options"])
    parser.add_argument("folder", type=pathlib.Path, help="of the calibration (draw, heaviest), or a table of sets (options)")
    parser.add_argument("numbers", nargs="+", type=float, help="draws; twins; or row and scale")
    given_ = parser.parse_args()
    try:
        if given_.what == "options":
            print(options(Table.read(given_.folder), int(given_.numbers[0]), given_.numbers[1]))
        else:
            sets_, weights_ = (Table.read(given_.folder / f"{name}.tsv") for name in ("sets", "weights"))
            count = int(given_.numbers[0])
            heaviest = [int(numpy.flatnonzero(sets_("id", "1") == weights_("id", "1")[weights_("weight", "1").argmax()])[0])]
            print(table(sets_, *((drawn(sets_, weights_, count), 1) if given_.what == "draw" else (heaviest, count))), end="")
    except StudyError as error:
        sys.exit(f"own: {error}")
