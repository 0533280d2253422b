#!/usr/bin/env python3
"""Packings of one sand, with few and with many grains, at two pressures, and their strength in triaxial compression."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib

import numpy
from study import Drawn, Series, Study, Table, curves, figures, main, panel

PRESSURES = ("1e3", "1e5")  # Pa, of the compaction
GRAINS = {"quick": (1000,), "thesis": (1000, 5000, 10000)}
TWINS = {"quick": (0, 1), "thesis": (0, 1, 2, 3)}  # 0: the packing itself; the others are moved by 1e-6 r
SHEAR = 1  # number of the stage in triaxial.toml


def deviation(values):
    """Returns the standard deviation; 0 for a single value."""
    return numpy.std(values, ddof=1) if len(values) > 1 else 0.0


def strength(table):
    """Returns the mean stress ratio between 5 and 8 % of axial strain."""
    strain = table["strain_axial"]
    return table.rows((table["stage"] == SHEAR) & (strain > 4.99) & (strain < 8.01))["stress_ratio"].mean()


def measure(study, seeds):
    """Measures void ratios, unbalanced forces and strengths: means over the twins of each seed, then over the seeds."""
    means = []
    for n in GRAINS[study.profile]:
        for p in PRESSURES:
            e = [Table.read(study.out / f"cell_packing_{n}_{p}_{s}.tsv")["void_ratio"][0] for s in seeds]
            study.measure(f"void_ratio_{n}_{p}", (numpy.mean(e), deviation(e)), "1")
        tests = {s: [Table.read(study.out / f"series_triaxial_{n}_{s}_{t}.tsv") for t in TWINS[study.profile]] for s in seeds}
        # The first row of twin 0 is the packing as it was made.
        study.measure(f"unbalanced_{n}", max(twins[0]["unbalanced_force"][0] for twins in tests.values()), "1")
        ratios = [numpy.mean([strength(table) for table in twins]) for twins in tests.values()]
        study.measure(f"ratio_{n}", (numpy.mean(ratios), deviation(ratios)), "1")
        means.append(numpy.mean(ratios))
    if len(means) > 1:
        study.measure("ratio_spread", max(means) / min(means) - 1, "1")


def draw(study, seeds):
    """Draws the test of each packing, a colour for each seed, and the strength that it is compared with."""
    n = GRAINS[study.profile][-1]
    tests = {(s, twin): Table.read(study.out / f"series_triaxial_{n}_{s}_{twin}.tsv") for s in seeds for twin in TWINS[study.profile]}
    runs = [Drawn("" if twin else f"seed {s}", Series(table.rows(table["stage"] == SHEAR)), colour)
            for s, colour in zip(seeds, figures.SERIES, strict=False) for (seed, twin), table in tests.items() if seed == s]
    figure = curves.figure([panel("strain_axial", "stress_ratio", runs), panel("strain_axial", "strain_volumetric", runs, legend=False)])
    stated = next(s for s in study.groups[0].statements if s.name == f"ratio_{n}")
    low, high = (float(stated.published) + sign * float(stated.tolerance) for sign in (-1, 1))
    figure.axes[0].fill_between([5, 8], low, high, color=figures.INK, alpha=0.15, linewidth=0, label="published, ± tolerance")
    figure.axes[0].legend()
    study.figure("strength", figure)


def build(arguments):
    """Reads the tables of the packings and tests in the folder OUT and writes what was measured and compared."""
    study = Study.of(pathlib.Path(__file__).parent, arguments, digits=None)
    for n in GRAINS["thesis"][len(GRAINS[study.profile]):]:
        for name in [f"unbalanced_{n}", f"ratio_{n}", *(f"void_ratio_{n}_{p}" for p in PRESSURES)]:
            study.unmade(name, "1", "made with PROFILE=thesis")
    if len(GRAINS[study.profile]) == 1:
        study.unmade("ratio_spread", "1", "made with PROFILE=thesis")
    measure(study, arguments.seeds)
    study.tell(grains=GRAINS[study.profile][-1], seeds=len(arguments.seeds))
    draw(study, arguments.seeds)
    return study


if __name__ == "__main__":
    main(build)
