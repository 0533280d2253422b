#!/usr/bin/env python3
"""Constants of the wrapped soil from the bags of each packing, and prediction intervals for one more packing."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import sys
import tomllib

import numpy
from own.inputs import OTHERS
from own.transfer import half_width
from study import StudyError
from study.plain_text import read_text

# Constants that cannot be negative: their logarithms are averaged, as gws-solve identify searches them. Units other than 1.
POSITIVE = ("C_t", "p_0", "kappa", "lambda", "alpha")
UNITS = {"p_0": "Pa", "alpha": "Pa"}
# Keys of a line's scatter that are no constants (lib/gws/solution/soil.cpp), and the line that the laboratory tests give.
ASIDE = ("freedom", "correlation", "exact")
OF_TESTS = "failure_line"
HEADER = ("constant", "unit", "packing_1", "packings", "middle", "low_80", "high_80", "low_95", "high_95")
SHARES = (80, 95)


def identified(path):
    """Returns the constants that bags determined, by "line.constant", from a soil's file; {} for an empty file, where no fit had a solution."""
    document = tomllib.loads(read_text(path))
    return {f"{line}.{key}": float(document[line][key]) for line, scatter in document.get("scatter", {}).items() if line != OF_TESTS
            for key in scatter if key not in ASIDE}


def ranges(key, values):
    """Returns the middle of a constant over packings, and the ends of the middle 80 and 95 % of one more packing's: NaN with fewer than two packings."""
    positive = key.rpartition(".")[2] in POSITIVE
    scaled = numpy.log(values) if positive else numpy.array(values)
    middle = float(scaled.mean())
    halves = [half_width(scaled, share) if len(values) > 1 else numpy.nan for share in SHARES]
    ends = [middle, *(middle + sign * half for half in halves for sign in (-1, 1))]
    return [float(numpy.exp(end)) for end in ends] if positive else ends


def table(out):
    """Returns the text of the table: the constants of packing 1 in soil.toml, and their ranges over it and the other packings."""
    soils = [identified(out / f"{name}.toml") for name in ("soil", *(f"soil_{k}" for k in OTHERS))]
    lines = ["\t".join(HEADER)]
    for key in dict.fromkeys(key for soil in soils for key in soil):
        values = [soil[key] for soil in soils if key in soil]
        unit = UNITS.get(key.rpartition(".")[2], "1")
        numbers = (soils[0].get(key, numpy.nan), len(values), *ranges(key, values))
        lines.append("\t".join([key, unit, *(f"{number:.6g}" for number in numbers)]))
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    try:
        print(table(pathlib.Path(sys.argv[1])), end="")
    except (StudyError, OSError) as error:
        sys.exit(f"own: {error}")
