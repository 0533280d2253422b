"""Finds the broken yarns in a table of all yarns: their places, and how near the seam they lie.

Nearness is 0 in the middle of the face or side of a yarn, and 1 on its edge, the seam.

usage: homogenize RUN --state last --table yarns --tsv | python3 -m ch3.breaks > table
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import sys

import numpy
from study import StudyError, Table
from study.tables import write_table

FACE = 0  # family of the yarns on the faces; the others are on the sides


def breaks(yarns):
    """Returns the columns of the table of broken yarns. The outermost yarn, whole or broken, marks the edge."""
    x, y, z = (yarns(f"position_{axis}", "mm") for axis in "xyz")
    face, broken = yarns("family", "1") == FACE, yarns("broken", "1") == 1
    out = numpy.where(face, numpy.maximum(abs(x), abs(y)), abs(z))
    edge = numpy.where(face, out[face].max(), out[~face].max())
    return {"x [mm]": x[broken], "y [mm]": y[broken], "z [mm]": z[broken], "seam [1]": (out / edge)[broken]}


if __name__ == "__main__":
    try:
        sys.stdout.write(write_table(breaks(Table.read("/dev/stdin"))))
    except StudyError as error:
        print(f"study: {error}", file=sys.stderr)
        sys.exit(65)
