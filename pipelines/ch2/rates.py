"""Compares what chapter 2 identifies at its rate of loading with what it identifies at a tenth of the rate.

usage: python3 -m ch2.rates FOLDER SLOW ROUNDS CASE... > table; rates.mk calls it. FOLDER and SLOW hold the cases at either rate.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import sys

import numpy
from study import Folder, StudyError, Table
from study.quantities import quantity

from .inputs import LAWS, PARAMETERS

STRAINS = (1.02, 2.975, 5.95)  # stations of the laboratory (%) at which the response of one set is compared
OBSERVED = {"stress_ratio": ("stress ratio", "1"), "strain_volumetric": ("volumetric strain", "%")}
SHOWN = {"Pa": ("GPa", 1e-9)}  # unit shown for a unit of the tables, and its factor
HEADS = ["contact law", "quantity", "unit", "study's rate", "± at the study's rate", "a tenth of it", "± at a tenth of it"]


def identified(steps):
    """Returns the weighted mean and deviation of each parameter over all sets, at the last station, as (words, unit, mean, deviation) rows."""
    rows = []
    for name, unit in PARAMETERS.items():
        shown, factor = SHOWN.get(unit, (unit, 1))
        rows.append((f"identified {quantity(name).words}", shown, factor * steps(name, unit)[-1], factor * steps(f"{name}_deviation", unit)[-1]))
    return rows


def responses(curves):
    """Returns what the set that the study's rate identified bears at STRAINS: mean and deviation over its twins, as rows.

    curves: the table of its runs at one rate. Ids below ten are its twins (ch2.inputs.sets).
    """
    own = curves.rows(curves("id", "1") < 10)
    rows = []
    for name, (words, unit) in OBSERVED.items():
        for strain in STRAINS:
            at = own.rows(numpy.isclose(own("strain_axial", "%"), strain))
            if len(at) < 2:
                raise StudyError(f"{curves.where}: at {strain} % of axial strain there are {len(at)} runs of the identified set; two twins give a deviation")
            values = at(name, unit)
            rows.append((f"{words} at {strain} %, set of the study's rate", unit, values.mean(), values.std(ddof=1)))
    return rows


def figures(mean, deviation):
    """Returns a mean and its deviation as words. The deviation is 0 if one set has all the weight, but for rounding."""
    return f"{mean:.3g}", f"{deviation if deviation > 1e-6 * abs(mean) else 0:.2g}"


def table(study, slow, rounds, cases):
    """Returns the table as text. study, slow: folders of the cases at either rate; rounds: number of rounds of a calibration."""
    lines = [HEADS]
    for case in cases:
        at_either_rate = []
        for of in (study, slow):
            folder = Folder(pathlib.Path(of) / case)
            at_either_rate.append(identified(folder(f"round{rounds}_steps")) + responses(folder("check_curves")))
        for (words, unit, *fast), (_, _, *slower) in zip(*at_either_rate, strict=True):
            lines.append([LAWS[case.split("_")[0]], words, unit, *figures(*fast), *figures(*slower)])
    return "".join("\t".join(line) + "\n" for line in lines)


if __name__ == "__main__":
    try:
        sys.stdout.write(table(sys.argv[1], sys.argv[2], int(sys.argv[3]), sys.argv[4:]))
    except (StudyError, OSError) as error:
        print(f"study: {error}", file=sys.stderr)
        sys.exit(65)
