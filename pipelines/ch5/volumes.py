"""Compares the constants identified from bags of several representative volumes with thesis Table 5.2.

usage: python3 -m ch5.volumes constants KEPT FOLDER... > table; volumes.mk calls it. KEPT has the tables of the full-size bags, each FOLDER those of
one volume, whose number is its name.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import statistics

from ch3.variants import as_text, main
from study import StudyError, Table

from .grains import RECORDED, Bag, Grains
from .measures import OWN, preload_obliquity

SCALES = {"alpha": ("MPa", 1e-6)}  # unit shown, and its factor to SI; other constants are pure numbers
SOFTEST_AND_STIFFEST = (RECORDED[0], RECORDED[-1])  # geotextiles whose state under the preload is shown


def constants_of(folder):
    """Returns a row (quantity, unit, published value, value) for each quantity of one volume.

    folder: has own_constants.tsv of `gws-solve identify`, and the table of each bag, uc_GEOTEXTILE.tsv.
    """
    rows = []
    for g in SOFTEST_AND_STIFFEST:
        record = Grains(folder, folder).record[g]
        bag = Bag(Table.read(folder / f"uc_{g}.tsv"), 0)
        rows.append((f"q/p under the preload, {g}", "1", preload_obliquity(record), bag["obliquity"][0]))
    identified = Table.read(folder / "own_constants.tsv")
    for name in OWN:
        unit, factor = SCALES.get(name, ("1", 1))
        of = "Pa" if name in SCALES else "1"
        rows.append((name, unit, factor * identified(f"{name}_given", of)[0], factor * identified(name, of)[0]))
    return rows


def table(kept, folders):
    """Returns the table as text: each quantity as published, at full size, of each volume, and its mean and standard deviation over the volumes.

    Published are Table 5.2 and, for q/p under the preload, the recorded series. kept: folder of the full-size bags. folders: one a volume, at
    least two.
    """
    folders = [pathlib.Path(folder) for folder in folders]
    if len(folders) < 2:
        raise StudyError("constants of one volume have no scatter: give at least two folders, C5V_VOLUMES in volumes.mk")
    lines = [["quantity", "unit", "published", "full size", *(f"volume {folder.name}" for folder in folders), "mean", "standard deviation"]]
    for (words, unit, published, full), *same in zip(*map(constants_of, (pathlib.Path(kept), *folders)), strict=True):
        values = [row[-1] for row in same]
        figures = (published, full, *values, statistics.mean(values), statistics.stdev(values))
        lines.append([words, unit, *(f"{value:.3g}" for value in figures)])
    return as_text(lines)


COMMANDS = {"constants": lambda kept, *folders: table(kept, folders)}

if __name__ == "__main__":
    main(COMMANDS, __doc__)
