#!/usr/bin/env python3
"""Packings: the same sand made from nothing with few and with many grains, at two pressures, and what it then carries."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib

import numpy
from study import Study, Table, figures, main

PRESSURES = ("1e3", "1e5")  # Pa, of the compaction
GRAINS = {"quick": (1000,), "thesis": (1000, 5000, 10000)}
TWINS = {"quick": (0, 1), "thesis": (0, 1, 2, 3)}  # 0: the packing itself; the others are moved by 1e-6 r
SHEAR = 1  # number of the stage in triaxial.toml


def deviation(values):
    """Returns the standard deviation; 0 for a single value."""
    return numpy.std(values, ddof=1) if len(values) > 1 else 0.0


def strength(table):
    """Returns the mean stress ratio between 5 and 8 % of axial strain."""
    strain = table("strain_axial", "%")
    between = (table("stage", "1") == SHEAR) & (strain > 4.99) & (strain < 8.01)
    return table.rows(between)("stress_ratio", "1").mean()


def measure(study, seeds):
    """Void ratios, unbalanced forces and strengths: means over the twins of each seed, then over the seeds."""
    means = []
    for n in GRAINS[study.profile]:
        for p in PRESSURES:
            e = [Table.read(study.out / f"cell_packing_{n}_{p}_{s}.tsv")("void_ratio", "1")[0] for s in seeds]
            study.measure(f"void_ratio_{n}_{p}", numpy.mean(e), "1", deviation(e))
        tests = {s: [Table.read(study.out / f"series_triaxial_{n}_{s}_{t}.tsv") for t in TWINS[study.profile]] for s in seeds}
        # The first row of twin 0 is the packing as it was made.
        study.measure(f"unbalanced_{n}", max(twins[0]("unbalanced_force", "1")[0] for twins in tests.values()), "1")
        ratios = [numpy.mean([strength(table) for table in twins]) for twins in tests.values()]
        study.measure(f"ratio_{n}", numpy.mean(ratios), "1", deviation(ratios))
        means.append(numpy.mean(ratios))
    if len(means) > 1:
        study.measure("ratio_spread", max(means) / min(means) - 1, "1")


def draw(study, seeds):
    """Each packing's test, one line a seed, and the strength that they are held against."""
    figure, axes = figures.panels(2)
    n = GRAINS[study.profile][-1]
    stated = next(s for s in study.groups[0].statements if s.name == f"ratio_{n}")
    low, high = (float(stated.published) + sign * float(stated.tolerance) for sign in (-1, 1))
    axes[0].fill_between([5, 8], low, high, color=figures.INK, alpha=0.15, linewidth=0, label="published, ± tolerance")
    for s, colour in zip(seeds, figures.SERIES, strict=False):
        for twin in TWINS[study.profile]:
            table = Table.read(study.out / f"series_triaxial_{n}_{s}_{twin}.tsv")
            table = table.rows(table("stage", "1") == SHEAR)
            for a, name, unit in zip(axes, ("stress_ratio", "strain_volumetric"), ("1", "%"), strict=True):
                a.plot(table("strain_axial", "%"), table(name, unit), color=colour, linewidth=1.1, label=None if twin else f"seed {s}")
    ratio = "stress ratio σₐ/σᵣ"
    figures.label(axes[0], "axial strain (%)", ratio, [ratio])
    figures.label(axes[1], "axial strain (%)", "volumetric strain, contraction positive (%)")
    axes[0].legend()
    study.figure("strength", figure, f"Triaxial compression of packings of {n} grains from {len(seeds)} seeds; lines of one colour are "
                 f"twins, moved by a millionth of a radius.", measures=[f"ratio_{n}", f"void_ratio_{n}_1e3"])


def build(arguments):
    """Reads the tables of the packings and tests in the folder OUT and writes what was measured and compared."""
    study = Study("packings", "Packings from nothing", arguments.out, arguments.profile, digits=None)
    study.expect(pathlib.Path(__file__).parent / "expected.tsv")
    for n in GRAINS["thesis"][len(GRAINS[study.profile]):]:
        for name in [f"unbalanced_{n}", f"ratio_{n}", *(f"void_ratio_{n}_{p}" for p in PRESSURES)]:
            study.unmade(name, "1", "made with PROFILE=thesis")
    if len(GRAINS[study.profile]) == 1:
        study.unmade("ratio_spread", "1", "made with PROFILE=thesis")
    measure(study, arguments.seeds)
    n = GRAINS[study.profile][-1]
    study.lead = ("Toyoura sand from its grading curve: a random cloud is compressed, friction is lowered until the void ratio is met "
                  f"and then restored, from {len(arguments.seeds)} seeds at each of two pressures. Packings made at 1 kPa are then loaded "
                  "in drained triaxial compression at 0.2 MPa.")
    study.headline = (f"All packings meet the void ratio of 0.68 ({study.say(f'void_ratio_{n}_1e3', 4)} with {n} grains), and carry "
                      f"{study.say(f'ratio_{n}', deviation=True)} times the lateral stress, where the thesis's own packing carries {study.published(f'ratio_{n}')}.")
    study.remark("Numbers are means over the seeds, ± their standard deviation. Grains have the same size however many they are. Two "
                 "packings of one sand at one void ratio do not carry the same: see their deviations.")
    draw(study, arguments.seeds)
    return study


if __name__ == "__main__":
    main(build)
