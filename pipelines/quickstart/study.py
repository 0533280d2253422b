#!/usr/bin/env python3
"""Quickstart: Toyoura sand from its grading curve to drained triaxial tests (thesis Fig. 3.2, base of Fig. 2.4)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib

import numpy
from study import Drawn, Folder, Mean, Series, Study, Table, figures, main, panel

PRESSURES = ("0.2", "0.5", "1.0")  # MPa
LABORATORY = "data/laboratory/toyoura_drained_triaxial_{}MPa.tsv"
COLOURS = dict(zip(PRESSURES, (figures.BLUE, figures.ORANGE, figures.GREEN), strict=True))
SHEAR = 1  # number of the stage in triaxial.toml


class Fabric(Series):
    """The fabric of the recorded states of a shear stage. Strains count from the first of them, whose recorded strain is left over from the compression."""

    derived = {"strain_axial": ("%", "axial strain", lambda f: numpy.where(numpy.arange(len(f)) > 0, f.table["strain_axial"], 0)),
               "from_stress": ("1", "q/p", lambda f: f.table("stress_obliquity", "1")),
               "from_fabric": ("1", "q/p", lambda f: f.table("stress_obliquity_from_fabric", "1"))}


class Runs:
    """The tables of all packings and tests, each by its seed or its pressure and seed."""

    def __init__(self, out, seeds):
        table = Folder(out)
        self.cells, self.fabrics = ([table(f"{kind}_packing_{s}") for s in seeds] for kind in ("cell", "fabric"))
        self.rose, self.histogram = table("rose_packing_1"), table("histogram_packing_1")
        self.shear = {p: [t.rows(t["stage"] == SHEAR) for t in (table(f"series_triaxial_{p}_{s}") for s in seeds)] for p in PRESSURES}
        self.sheared_fabrics = {p: [Fabric(f.rows(f["step"] >= shear["step"][0]))
                                    for f, shear in zip((table(f"fabric_triaxial_{p}_{s}") for s in seeds), self.shear[p], strict=True)]
                                for p in PRESSURES}
        self.means = {p: Mean(tables) for p, tables in self.shear.items()}
        self.laboratory = {p: Table.read(LABORATORY.format(p)) for p in ("0.2", "0.5")}


def measure_packings(study, runs):
    """Measures the packings before loading, as means over their seeds."""
    for name, unit, tables, value in (
            ("void_ratio", "1", runs.cells, lambda t: t["void_ratio"][0]),
            ("coordination_number", "1", runs.fabrics, lambda t: t["coordination_number"][0]),
            ("mean_radius", "mm", runs.cells, lambda t: t("mean_radius", "mm")[0]),
            ("cell_width", "mm", runs.cells, lambda t: (t("cell_length_x", "mm")[0] + t("cell_length_y", "mm")[0]) / 2),
            ("cell_height", "mm", runs.cells, lambda t: t("cell_length_z", "mm")[0])):
        study.measure(name, Mean.of([value(t) for t in tables]), unit)


def measure_tests(study, runs):
    """Measures the tests: peaks and volumes of the mean curves, energy balances of all runs."""
    for p, mean in runs.means.items():
        study.measure(f"peak_ratio_{p}", mean.greatest("stress_ratio"), "1")
        study.measure(f"contraction_{p}", mean.greatest("strain_volumetric"), "%")
        study.measure(f"volumetric_{p}", mean.at("strain_axial", 8.5, "strain_volumetric"), "%")
    laboratory, model = runs.laboratory["0.2"], runs.means["0.2"]
    at_its_strains = numpy.interp(laboratory["strain_axial"], model["strain_axial"], model["stress_ratio"])
    study.measure("misfit_0.2", 100 * numpy.sqrt(numpy.mean((at_its_strains / laboratory["stress_ratio"] - 1) ** 2)), "%")
    fabrics, tests = ([one for of in by_pressure.values() for one in of] for by_pressure in (runs.sheared_fabrics, runs.shear))
    study.measure("stress_force_fabric", 100 * max(abs(f["from_fabric"] / f["from_stress"] - 1)[f["strain_axial"] > 0.5].max() for f in fabrics), "%")
    study.measure("unbalanced_force", max(t["unbalanced_force"].max() for t in tests), "1")
    # Errors count from 1 % of axial strain on, since their share of hardly any work means nothing.
    study.measure("energy_error", max((abs(t["energy_error"]) / t["boundary_work"])[t["strain_axial"] > 1].max() for t in tests), "1")


def draw_packing(study, runs):
    """Draws the first packing: a rose of its contacts, and its grains by their number of contacts."""
    figure, (left, right) = figures.panels(2)
    vertical = runs.rose.rows(runs.rose["plane"] == 2)
    angle, density = numpy.radians(vertical["angle"]), vertical["density"]
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
    grains = runs.histogram["grains"]
    right.bar(runs.histogram["contacts"], 100 * grains / grains.sum(), color=figures.BLUE, alpha=0.65)
    figures.label(right, pure[2], "share of grains (%)", pure)
    study.figure("packing", figure)


def draw(study, runs):
    """Draws curves of the tests, a colour for each pressure."""
    whole = {"xlim": (0, 10)}
    means = [Drawn(f"{p} MPa", mean, COLOURS[p], spread=mean.spread) for p, mean in runs.means.items()]
    beside = means + [Drawn(f"{p} MPa", Series(t.rows(numpy.arange(len(t)) % 3 == 0)), COLOURS[p], "o", "laboratory") for p, t in runs.laboratory.items()]
    study.curves("response", panel("strain_axial", "stress_ratio", beside, **whole), panel("strain_axial", "strain_volumetric", beside, **whole))
    draw_packing(study, runs)
    fabrics = {p: some[0] for p, some in runs.sheared_fabrics.items()}
    obliquity = [Drawn(name, Series({"strain_axial": fabric["strain_axial"], "obliquity": fabric[of]}), COLOURS[p], line)
                 for p, fabric in fabrics.items() for name, of, line in ((f"{p} MPa", "from_stress", "-"), ("", "from_fabric", "o"))]
    study.curves("fabric", panel("strain_axial", ("a_c", "a_n", "a_t"), [Drawn("", fabrics["0.2"], "", "o-")], "anisotropy", ylim=(0, None), **whole),
                 panel("strain_axial", "obliquity", obliquity, ylim=(0, None), **whole))
    coordination = [Drawn(f"{p} MPa" if name == "coordination_number" else "",
                          Series({"strain_axial": mean["strain_axial"], "coordination_number": mean[name]}), COLOURS[p], line)
                    for p, mean in runs.means.items() for name, line in (("coordination_number", "-"), ("mechanical_coordination_number", "--"))]
    study.curves("state", panel("strain_axial", "void_ratio", means, **whole), panel("strain_axial", "coordination_number", coordination, **whole))
    energies = ("boundary_work", "frictional_dissipation", "damping_dissipation", "elastic_energy", "law_energy", "energy_error")
    study.curves("energy", panel("strain_axial", energies, [Drawn("", Series(runs.shear["0.2"][0]), "")], "energy (J)", **whole))


def build(arguments):
    """Reads the tables of the packings and tests in the folder OUT and writes what was measured, drawn and compared."""
    study = Study.of(pathlib.Path(__file__).parent, arguments, digits=None)
    runs = Runs(study.out, arguments.seeds)
    study.history = (study.out / "provenance.txt").read_text(encoding="utf-8")
    measure_packings(study, runs)
    measure_tests(study, runs)
    study.tell(pressures=PRESSURES, seeds=len(arguments.seeds))
    draw(study, runs)
    return study


if __name__ == "__main__":
    main(build)
