"""Compares the response of the same sets under the loading of chapter 2, and under it without its masses and its drag, with slow loading.

usage: python3 -m ch2.loading FOLDER CASE... > table; loading.mk calls it. FOLDER/CASE holds a table of curves, and the runs, of each loading.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import sys

import h5py
import numpy
from study import Folder, StudyError

from .inputs import LAWS

STRAINS = (1.02, 1.955, 3.995)  # stations of the laboratory (%)
LOADINGS = {"study": "10 %/s, equal steps, drag (the study)", "plain": "10 %/s, without", "slow": "1 %/s, without"}
# The quantity, its words, its unit, and whether differences are relative (%).
COMPARED = (("stress_ratio", "stress ratio", "1", True), ("strain_volumetric", "volumetric strain", "%", False))


def values(curves, name, unit):
    """Returns the values of each set at STRAINS, by its id. Sets whose run ended before the last of them are left out."""
    found = {}
    for number in numpy.unique(curves("id", "1")):
        own = curves.rows(curves("id", "1") == number)
        at = [own(name, unit)[numpy.isclose(own("strain_axial", "%"), strain)] for strain in STRAINS]
        if all(len(value) == 1 and numpy.isfinite(value[0]) for value in at):
            found[int(number)] = numpy.array([value[0] for value in at])
    return found


def steps_of(folder, number):
    """Returns the steps of the run of a set. Raises StudyError where its series cannot be read."""
    path = folder / f"runs/{number:06d}/series.h5"
    try:
        with h5py.File(path) as file:
            return int(file["fields/series/step"][-1])
    except (OSError, KeyError) as error:
        raise StudyError(f"{path}: has no series; remove its folder and make it again") from error


def compared(folder, loading):
    """Returns the number of sets that ran under every loading, the mean steps of a run, and for each of COMPARED the mean difference from
    slow loading at each strain with its standard error, in %.
    """
    differences = []
    for name, _, unit, relative in COMPARED:
        of = {each: values(Folder(folder)(each), name, unit) for each in LOADINGS}
        common = sorted(set.intersection(*(set(found) for found in of.values())))
        if len(common) < 2:
            raise StudyError(f"{folder}: {len(common)} sets ran under every loading; two give a standard error. Raise C2L_SETS")
        own, slow = (numpy.array([of[each][number] for number in common]) for each in (loading, "slow"))
        change = 100 * (own / slow - 1) if relative else own - slow
        differences.append((change.mean(axis=0), change.std(axis=0, ddof=1) / len(common) ** 0.5))
    return len(common), numpy.mean([steps_of(folder / loading, number) for number in common]), differences


def table(folder, cases):
    """Returns the table as text: a row for each contact law and loading."""
    lines = [["contact law", "loading", "sets", "steps of a run",
              *(f"{words} at {strain} %, difference from slow (%{' of it' if relative else ''})" for _, words, _, relative in COMPARED for strain in STRAINS)]]
    for case in cases:
        for loading, words in LOADINGS.items():
            sets, steps, differences = compared(pathlib.Path(folder) / case, loading)
            cells = ["0" if loading == "slow" else f"{mean:+.2g} ± {error:.1g}" for of in differences for mean, error in zip(*of, strict=True)]
            lines.append([LAWS[case.split("_")[0]], words, f"{sets}", f"{steps:.0f}", *cells])
    return "".join("\t".join(line) + "\n" for line in lines)


if __name__ == "__main__":
    try:
        sys.stdout.write(table(sys.argv[1], sys.argv[2:]))
    except (StudyError, OSError) as error_:
        print(f"study: {error_}", file=sys.stderr)
        sys.exit(65)
