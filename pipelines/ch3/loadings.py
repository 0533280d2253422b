"""Compares the loading of the study with slower and faster plates, on bags of several representative volumes.

usage: python3 -m ch3.loadings stresses|start|steps FOLDER VOLUME... > table; loadings.mk calls it. The loads of a bag are in
FOLDER/VOLUME/GEOTEXTILE_LOADING.tsv.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import statistics
import sys

from study import NotMade, Table

from . import compression
from .bag import GEOTEXTILES, Bag
from .variants import as_text, main

LOADINGS = ("fast", "study")  # beside slow plates
STRAINS = (1, 2, 3, 4, 5)  # %
COUNTED_TO = 12  # % of strain up to which steps are counted


def bags(folder, volumes, geotextile):
    """Returns the bags of each loading in the order of the volumes, by loading. Raises StudyError where some are missing."""
    def absent(_):
        raise NotMade("not recorded")
    paths = {of: [folder / volume / f"{geotextile}_{of}.tsv" for volume in volumes] for of in ("slow", *LOADINGS)}
    return {of: [Bag(Table.read(path), absent) for path in each] for of, each in paths.items()}


def load(bag, strain):
    """Returns the load at an axial strain (%), or the greatest load, kPa. Raises NotMade for one that the run does not reach."""
    return bag["plate_pressure"][compression.peak(bag, "plate_pressure") if strain == "greatest" else bag.row_at(strain)]


def loads(each, strain):
    """Returns the loads of those volumes that have one under every loading, by loading, and says which volumes are left out and why.

    A torn bag may bear more and more as it is flattened. It has no greatest load before its end.
    """
    found = {of: [] for of in each}
    for bags_of_volume in zip(*each.values(), strict=True):
        try:
            values = [load(bag, strain) for bag in bags_of_volume]
        except NotMade as error:
            where = pathlib.Path(bags_of_volume[0].table.where).parent.name
            print(f"study: volume {where} is left out of the {'greatest loads' if strain == 'greatest' else f'loads at {strain} %'}: {error}",
                  file=sys.stderr)
            continue
        for of, value in zip(each, values, strict=True):
            found[of].append(value)
    if not found["slow"]:
        raise NotMade("no volume has all loads: give the runs a greater strain, C3L_END in loadings.mk")
    return found


def scattered(values):
    """Returns the mean and its standard error as words, %. One value has no error."""
    error = statistics.stdev(values) / len(values)**0.5 if len(values) > 1 else None
    return [f"{statistics.mean(values):+.2f}", f"{error:.2f}" if error is not None else "none"]


def stresses(folder, volumes, geotextiles=GEOTEXTILES, strains=(*STRAINS, "greatest")):
    """Returns the table of loads at axial strains (%) as text: the mean over the volumes under slow plates, and the differences from it.

    A difference is the mean over pairs of bags of one volume. Behind it stands the standard error of this mean.
    """
    rows = [["geotextile", "axial strain [%]", "volumes", "slow plates [kPa]",
             *(head for of in LOADINGS for head in (f"{of} [%]", f"standard error of {of} [%]"))]]
    for geotextile in geotextiles:
        each = bags(folder, volumes, geotextile)
        for strain in strains:
            found = loads(each, strain)
            slow = found["slow"]
            differences = [scattered([100 * (one / beside - 1) for one, beside in zip(found[of], slow, strict=True)]) for of in LOADINGS]
            rows.append([geotextile, str(strain), str(len(slow)), f"{statistics.mean(slow):.1f}", *(word for pair in differences for word in pair)])
    return as_text(rows)


def steps(folder, volumes):
    """Returns the table of the steps of loading to COUNTED_TO as text: the mean over the volumes of each loading, and its share of fast plates'."""
    rows = [["geotextile", "loading", f"steps to {COUNTED_TO} % [1]", "over those of fast plates [1]"]]
    for geotextile in GEOTEXTILES:
        mean = {of: statistics.mean(bag.step_at(COUNTED_TO) - bag["step"][0] for bag in each)
                for of, each in bags(folder, volumes, geotextile).items()}
        rows += [[geotextile, of, f"{value:.0f}", f"{value / mean['fast']:.3f}"] for of, value in mean.items()]
    return as_text(rows)


COMMANDS = {"stresses": lambda folder, *volumes: stresses(pathlib.Path(folder), volumes),
            "start": lambda folder, *volumes: stresses(pathlib.Path(folder), volumes, ["PP"], (1, 2)),
            "steps": lambda folder, *volumes: steps(pathlib.Path(folder), volumes)}

if __name__ == "__main__":
    main(COMMANDS, __doc__)
