#!/usr/bin/env python3
"""Compares loadings of one cell: prints axial over lateral stress by axial strain, or the steps of each run.

usage: python3 -m ch4.loading stresses|steps NAME=series.tsv ...   Runs named `study` and `slow` have to be among them.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import sys

from ch4.cells import Soil
from study import StudyError, Table


def stresses(runs):
    """Returns lines of the stress ratio at each whole per cent of strain, and the difference of `study` from `slow`."""
    strains = next(iter(runs.values()))["strain"].round(3)
    if any(len(run["strain"]) != len(strains) or (run["strain"].round(3) != strains).any() for run in runs.values()):
        raise StudyError("the runs do not have the same stations")
    lines = ["axial strain [%]\t" + "".join(f"{name} [1]\t" for name in runs) + "difference of study from slow [%]"]
    for k, strain in enumerate(strains):
        if strain > 0:
            ratios = {name: run.table("stress_ratio", "1")[k] for name, run in runs.items()}
            lines.append(f"{strain:.3g}\t" + "".join(f"{r:.4g}\t" for r in ratios.values()) + f"{100 * (ratios['study'] / ratios['slow'] - 1):+.2f}")
    return lines


def steps(runs):
    """Returns lines of the steps that each run took and of the steps among them that waited for rest."""
    return ["loading\tsteps [1]\twaiting for rest [1]", *(
        f"{name}\t{run.table('step', '1')[-1]:.0f}\t{run.table('steps_waiting', '1')[-1]:.0f}" for name, run in runs.items())]


def told(what, words):
    """Returns the lines of a table of `words`, NAME=PATH each. Raises StudyError for another table and for missing runs."""
    tables = {"stresses": stresses, "steps": steps}
    paths = {name: path for name, equals, path in (word.partition("=") for word in words) if equals}
    if what not in tables or len(paths) != len(words) or not {"study", "slow"} <= paths.keys():
        raise StudyError("give stresses or steps, then NAME=series.tsv for each run, study and slow among them")
    return tables[what]({name: Soil(Table.read(path)) for name, path in paths.items()})


if __name__ == "__main__":
    try:
        print("\n".join(told(sys.argv[1] if len(sys.argv) > 1 else "", sys.argv[2:])))
    except StudyError as error_:
        print(f"ch4.loading: {error_}", file=sys.stderr)
        sys.exit(65)
