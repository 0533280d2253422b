#!/usr/bin/env python3
"""Quickstart: Toyoura sand from its grading curve to drained triaxial tests (thesis Fig. 3.2, base of Fig. 2.4)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib

import numpy
from study import Study, StudyError, Table, figures, main

PRESSURES = ("0.2", "0.5", "1.0")  # MPa
LABORATORY = "data/laboratory/toyoura_drained_triaxial_{}MPa.tsv"
COLOURS = dict(zip(PRESSURES, (figures.BLUE, figures.ORANGE, figures.GREEN), strict=True))
SHEAR = 1  # number of the stage in triaxial.toml


class Mean:
    """Mean and standard deviation over the packings of a pressure, station by station of the shear stage."""

    def __init__(self, tables):
        self._tables = [t.rows(t("stage", "1") == SHEAR) for t in tables]
        if len({len(t) for t in self._tables}) > 1:
            raise StudyError(f"{self._tables[0].where}: has another number of stations than the other packings' runs")
        self.strain = self.mean("strain_axial", "%")

    def _all(self, name, unit):
        return numpy.array([t(name, unit) for t in self._tables])

    def mean(self, name, unit):
        """Returns the mean over the packings at each station."""
        return self._all(name, unit).mean(axis=0)

    def deviation(self, name, unit):
        """Returns the standard deviation over the packings at each station; zeros for a single packing."""
        return deviation(self._all(name, unit))

    def greatest(self, name, unit):
        """Returns the greatest of the mean curve and the deviation there."""
        k = int(self.mean(name, unit).argmax())
        return self.mean(name, unit)[k], self.deviation(name, unit)[k]

    def at(self, strain, name, unit):
        """Returns mean and deviation at the station of an axial strain in percent."""
        k = int(abs(self.strain - strain).argmin())
        if abs(self.strain[k] - strain) > 1e-3:
            raise StudyError(f"{self._tables[0].where}: has no station at an axial strain of {strain} %")
        return self.mean(name, unit)[k], self.deviation(name, unit)[k]


def deviation(values):
    """Returns the standard deviation along the first axis; 0 for a single value."""
    return numpy.std(values, axis=0, ddof=1) if len(values) > 1 else numpy.zeros_like(values[0])


class Runs:
    """The tables of all packings and tests, each by its seed or its pressure and seed."""

    def __init__(self, out, seeds):
        self.cells = [Table.read(out / f"cell_packing_{s}.tsv") for s in seeds]
        self.packing_fabrics = [Table.read(out / f"fabric_packing_{s}.tsv") for s in seeds]
        self.rose, self.histogram = Table.read(out / "rose_packing_1.tsv"), Table.read(out / "histogram_packing_1.tsv")
        self.series = {p: [Table.read(out / f"series_triaxial_{p}_{s}.tsv") for s in seeds] for p in PRESSURES}
        self.fabrics = {p: [Table.read(out / f"fabric_triaxial_{p}_{s}.tsv") for s in seeds] for p in PRESSURES}
        self.means = {p: Mean(tables) for p, tables in self.series.items()}
        self.laboratory = {p: Table.read(LABORATORY.format(p)) for p in ("0.2", "0.5")}

    def shear(self, pressure, k):
        """Returns the series of the shear stage of one test."""
        table = self.series[pressure][k]
        return table.rows(table("stage", "1") == SHEAR)

    def shear_fabric(self, pressure, k):
        """Returns the fabric of the recorded states of the shear stage, and their axial strains in percent.

        Strains count from the first of them: its own is that of the compression before.
        """
        start = self.shear(pressure, k)("step", "1")[0]
        table = self.fabrics[pressure][k]
        table = table.rows(table("step", "1") >= start)
        strain = table("strain_axial", "%").copy()
        strain[0] = 0
        return table, strain


def measure_packings(study, runs):
    """Before loading: what the packings are, as means over their seeds."""
    def mean(name, column, unit, tables):
        values = numpy.array([t(column, unit)[0] for t in tables])
        study.measure(name, values.mean(), unit, deviation(values))
    mean("void_ratio", "void_ratio", "1", runs.cells)
    mean("coordination_number", "coordination_number", "1", runs.packing_fabrics)
    mean("mean_radius", "mean_radius", "mm", runs.cells)
    widths = numpy.array([(t("cell_length_x", "mm")[0] + t("cell_length_y", "mm")[0]) / 2 for t in runs.cells])
    study.measure("cell_width", widths.mean(), "mm", deviation(widths))
    mean("cell_height", "cell_length_z", "mm", runs.cells)


def measure_tests(study, runs):
    """Under load: peaks and volumes of the mean curves, balances of all runs."""
    for p in PRESSURES:
        study.measure(f"peak_ratio_{p}", runs.means[p].greatest("stress_ratio", "1"), "1")
        study.measure(f"contraction_{p}", runs.means[p].greatest("strain_volumetric", "%"), "%")
        study.measure(f"volumetric_{p}", runs.means[p].at(8.5, "strain_volumetric", "%"), "%")
    laboratory, model = runs.laboratory["0.2"], runs.means["0.2"]
    at_its_strains = numpy.interp(laboratory("strain_axial", "%"), model.strain, model.mean("stress_ratio", "1"))
    misfit = numpy.sqrt(numpy.mean((at_its_strains / laboratory("stress_ratio", "1") - 1) ** 2))
    study.measure("misfit_0.2", 100 * misfit, "%")
    differences, forces, shares = [], [], []
    for p in PRESSURES:
        for k in range(len(runs.series[p])):
            fabric, strain = runs.shear_fabric(p, k)
            ratio = fabric("stress_obliquity_from_fabric", "1") / fabric("stress_obliquity", "1") - 1
            differences.append(abs(ratio[strain > 0.5]).max())
            shear = runs.shear(p, k)
            forces.append(shear("unbalanced_force", "1").max())
            share = abs(shear("energy_error", "J")) / shear("boundary_work", "J")
            # Shares of next to no work mean nothing: they count from 1 % of axial strain.
            shares.append(share[shear("strain_axial", "%") > 1].max())
    study.measure("stress_force_fabric", 100 * max(differences), "%")
    study.measure("unbalanced_force", max(forces), "1")
    study.measure("energy_error", max(shares), "1")


def draw_response(study, runs):
    figure, (left, right) = figures.panels(2)
    for axes, name, unit in ((left, "stress_ratio", "1"), (right, "strain_volumetric", "%")):
        for p, mean in runs.means.items():
            figures.band(axes, mean.strain, mean.mean(name, unit), mean.deviation(name, unit), COLOURS[p], f"{p} MPa")
        for p, table in runs.laboratory.items():
            figures.points(axes, table("strain_axial", "%")[::3], table(name, unit)[::3], COLOURS[p])
        axes.set_xlim(0, 10)
        axes.plot([], [], "o", markerfacecolor="none", color=figures.GREY, markersize=3.5, label="laboratory")
        axes.legend()
    ratio = "stress ratio σₐ/σᵣ"
    figures.label(left, "axial strain (%)", ratio, pure=[ratio])
    figures.label(right, "axial strain (%)", "volumetric strain, contraction positive (%)")
    study.figure("response", figure, "Drained triaxial compression. Lines: mean of the packings; bands: their standard deviation; "
                 "points: laboratory, Sun et al. 2007.", "Fig. 3.2b",
                 measures=[f"{name}_{p}" for name in ("peak_ratio", "volumetric") for p in runs.laboratory])


def draw_packing(study, runs):
    figure, (left, right) = figures.panels(2)
    vertical = runs.rose.rows(runs.rose("plane", "1") == 2)
    angle, density = numpy.radians(vertical("angle", "deg")), vertical("density", "1")
    width = angle[1] - angle[0]
    for a, d in zip(angle, density, strict=True):
        around = numpy.linspace(a - width / 2, a + width / 2, 9)
        left.fill(numpy.append(d * numpy.cos(around), 0), numpy.append(d * numpy.sin(around), 0), color=figures.BLUE,
                  alpha=0.6, linewidth=0.5, edgecolor="white")
    circle = numpy.linspace(0, 2 * numpy.pi, 200)
    left.plot(numpy.cos(circle), numpy.sin(circle), color=figures.ORANGE)
    left.set_aspect("equal")
    pure = ["density along x", "density along z", "contacts of a grain"]
    figures.label(left, *pure[:2], pure)
    grains = runs.histogram("grains", "1")
    right.bar(runs.histogram("contacts", "1"), 100 * grains / grains.sum(), color=figures.BLUE, alpha=0.65)
    figures.label(right, pure[2], "share of grains (%)", pure)
    study.figure("packing", figure, "The first packing before loading. Left: density of contact normals in the x–z plane over the "
                 "isotropic one, whose circle is at 1. Right: grains by number of contacts.", "Fig. 3.2a",
                 "the coordination number of the representative volume is slightly above that of the bag, 2.979 (§3.2.3).",
                 ["coordination_number", "void_ratio"])


def draw_fabric(study, runs):
    figure, (left, right) = figures.panels(2)
    fabric, strain = runs.shear_fabric("0.2", 0)
    for name, words, colour in (("a_c", "a_c, contact normals", figures.BLUE), ("a_n", "a_n, normal forces", figures.ORANGE),
                                ("a_t", "a_t, tangential forces", figures.GREEN)):
        left.plot(strain, fabric(name, "1"), "o-", markersize=3, color=colour, label=words)
    pure = ["anisotropy", "q/p"]
    figures.label(left, "axial strain (%)", pure[0], pure)
    for p in PRESSURES:
        fabric, strain = runs.shear_fabric(p, 0)
        right.plot(strain, fabric("stress_obliquity", "1"), color=COLOURS[p], label=f"{p} MPa")
        figures.points(right, strain, fabric("stress_obliquity_from_fabric", "1"), COLOURS[p])
    figures.label(right, "axial strain (%)", pure[1], pure)
    for axes in (left, right):
        axes.set_xlim(0, 10)
        axes.set_ylim(bottom=0)
        axes.legend()
    study.figure("fabric", figure, "Left: fabric anisotropies (Eq. 3.9) of the first packing at 0.2 MPa. Right: its q/p from "
                 "the stress (lines) and from the fabric, 2/5 (a_c + a_n + 3/2 a_t) (points).", measures=["stress_force_fabric"])


def draw_state(study, runs):
    figure, (left, right) = figures.panels(2)
    for p, mean in runs.means.items():
        figures.band(left, mean.strain, mean.mean("void_ratio", "1"), mean.deviation("void_ratio", "1"), COLOURS[p], f"{p} MPa")
        right.plot(mean.strain, mean.mean("coordination_number", "1"), color=COLOURS[p], label=f"{p} MPa")
        right.plot(mean.strain, mean.mean("mechanical_coordination_number", "1"), "--", color=COLOURS[p])
    pure = ["void ratio", "coordination number"]
    for axes, name in ((left, pure[0]), (right, pure[1])):
        axes.set_xlim(0, 10)
        figures.label(axes, "axial strain (%)", name, pure)
        axes.legend()
    study.figure("state", figure, "Void ratio and coordination number 2Nc/N; dashed: without grains of less than two contacts.")


def draw_energy(study, runs):
    figure, (axes,) = figures.panels(1)
    shear = runs.shear("0.2", 0)
    for name, words, colour, line in (
            ("boundary_work", "work of the boundary", figures.INK, "-"), ("frictional_dissipation", "sliding", figures.RED, "-"),
            ("damping_dissipation", "local damping", figures.ORANGE, "-"), ("elastic_energy", "elastic", figures.BLUE, "-"),
            ("law_energy", "taken by the incremental law", figures.PURPLE, "-"), ("energy_error", "left over", figures.GREY, "--")):
        axes.plot(shear("strain_axial", "%"), shear(name, "J"), line, color=colour, label=words)
    axes.set_xlim(0, 10)
    figures.label(axes, "axial strain (%)", "energy (J)")
    axes.legend()
    study.figure("energy", figure, "Energy of the first packing at 0.2 MPa. The incremental Hertz–Mindlin law itself takes out or "
                 "creates energy; what is left over after it is the error of the balance.", measures=["energy_error"])


def build(arguments):
    """Reads the tables of the packings and tests in the folder OUT and writes what was measured, drawn and compared."""
    study = Study("quickstart", "Toyoura sand, from a grading curve to triaxial tests", arguments.out, arguments.profile, digits=None)
    seeds = arguments.seeds
    runs = Runs(study.out, seeds)
    study.history = (study.out / "provenance.txt").read_text(encoding="utf-8")
    measure_packings(study, runs)
    measure_tests(study, runs)
    study.expect(pathlib.Path(__file__).parent / "expected.tsv")
    study.lead = (f"1000 spheres follow the grading of Toyoura sand, are brought to a void ratio of 0.68, compressed isotropically and "
                  f"sheared in drained triaxial compression with the Hertz–Mindlin parameters of thesis Table 3.1: "
                  f"{len(PRESSURES) * len(seeds)} runs of {len(seeds)} packings.")
    peaks = [study.say(f"peak_ratio_{p}", deviation=True) for p in PRESSURES]
    measured = [study.published(f"peak_ratio_{p}") for p in PRESSURES]
    study.headline = (f"At {', '.join(PRESSURES)} MPa the sand carries {', '.join(peaks)} times the lateral stress, where the laboratory "
                      f"measured {', '.join(measured)} (Sun et al. 2007).")
    study.remark("Numbers are means over the packings, curves means at equal strain, ± and bands the standard deviation. No laboratory "
                 "curve at 1.0 MPa is public, only the stress ratio at failure. The laboratory curves are smoothed and not kinematically "
                 "consistent (data/SOURCES.md).")
    for draw in (draw_response, draw_packing, draw_fabric, draw_state, draw_energy):
        draw(study, runs)
    return study


if __name__ == "__main__":
    main(build)
