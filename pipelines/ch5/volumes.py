"""Compares the constants identified from bags of several representative volumes with thesis Table 5.2.

usage: python3 -m ch5.volumes constants FILE... > table; volumes.mk calls it. Each file has the constants of one volume.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import statistics

from ch3.variants import as_text, main
from study import StudyError, Table

from .measures import OWN

SCALES = {"alpha": ("MPa", 1e-6)}  # unit shown, and its factor to SI; other constants are pure numbers


def table(constants):
    """Returns the table as text: each constant in Table 5.2, and its mean, standard deviation and extremes over the volumes.

    constants: the tables of `gws-solve identify --table constants`, one a volume; at least two.
    """
    if len(constants) < 2:
        raise StudyError("constants of one volume have no scatter: give at least two files, C5V_VOLUMES in volumes.mk")
    rows = [["constant", "unit", "Table 5.2", "mean", "standard deviation", "least", "greatest", "volumes"]]
    for name in OWN:
        unit, factor = SCALES.get(name, ("1", 1))
        of = "Pa" if name in SCALES else "1"
        values = [factor * each(name, of)[0] for each in constants]
        given = factor * constants[0](f"{name}_given", of)[0]
        figures = (given, statistics.mean(values), statistics.stdev(values), min(values), max(values))
        rows.append([name, unit, *(f"{value:.3g}" for value in figures), str(len(values))])
    return as_text(rows)


COMMANDS = {"constants": lambda *paths: table([Table.read(path) for path in paths])}

if __name__ == "__main__":
    main(COMMANDS, __doc__)
