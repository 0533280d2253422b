#!/usr/bin/env python3
"""Chapter 4: soil wrapped in a geotextile beside soil between two sheets, each in a periodic cell of soil (thesis Figs. 4.3 to 4.6)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import itertools

import numpy
from ch4 import drawing
from ch4.cells import FORMS, GEOTEXTILES, GROUPS, HERE, MIDDLING, Runs, both_whole, compared, confining, least_rise, over
from study import NotMade, Study, main


def measure_start(study, runs):
    """At rest under the confining pressure: void ratios and contacts."""
    for form in FORMS:
        cell = runs.cell(form, MIDDLING)
        study.measure(f"e_{form}", cell["e"][0], "1")
        study.measure(f"e_inside_{form}", cell["e_inside"][0], "1")
        study.measure(f"fill_{form}", 100 * cell["fill"][0], "%")
        for name, (before, after) in runs.shape(form).items():
            study.measure(f"{name}_{form}", 100 * (after / before - 1), "%")
    roses = [runs.folder(f"{form}_rose")["density"] for form in FORMS]
    study.measure("orientation", abs(roses[0] - roses[1]).max(), "1")
    study.measure("denser", min(layered["e_inside"][0] - wrapped["e_inside"][0] for wrapped, layered in runs.pairs), "1")


def above(pair):
    """Returns the least axial stress of the wrapped cell over that of the layered one, before the first break and at the peaks."""
    wrapped, layered = (cell["ratio"].max() for cell in pair)
    return min(wrapped / layered, over(pair, "ratio", both_whole(pair)).min())


def measure_cells(study, runs):
    """Under load: stresses and volumes of the cells."""
    for g in GEOTEXTILES:
        for form in FORMS:
            study.measure(f"peak_{form}_{g}", runs.cell(form, g)["ratio"].max(), "1")
        study.measure(f"above_{g}", lambda g=g: above(runs.pair(g)), "1")
    study.measure("gap_grows", least_rise([wrapped["ratio"].max() - layered["ratio"].max() for wrapped, layered in runs.pairs]), "1")
    study.measure("volumes_differ", lambda: max(
        abs(pair[0]["contraction"] - pair[1]["contraction"])[both_whole(pair)].max() for pair in runs.pairs), "%")
    most = {form: [runs.cell(form, g)["contraction"].max() for g in GEOTEXTILES] for form in FORMS}
    study.measure("layered_contracts", numpy.subtract(most["layered"], most["wrapped"]).min(), "%")
    for form in FORMS:
        study.measure(f"contraction_grows_{form}", least_rise(most[form]), "%")
    wrapped, layered = (max(0.0, -cell["contraction"][cell.peak]) for cell in runs.pair("5PP"))
    # Where the layered form does not dilate the wrapped one has no half of that: any dilation is then too much.
    study.measure("dilation_5PP", wrapped / max(layered, 0.01), "1")


def measure_inside(study, runs):
    """Stresses of the reinforced soil over the confining one."""
    pairs = runs.pairs
    ratios = {name: [over(pair, name, compared(pair)) for pair in pairs] for name in ("inside_axial", "inside_lateral", "ratio")}
    study.measure("inside_above", min(r.min() for name in ("inside_axial", "inside_lateral") for r in ratios[name]), "1")
    for name in ("axial", "lateral"):
        inside = zip(ratios[f"inside_{name}"], ratios["ratio"], strict=True)
        study.measure(f"inside_gap_{name}", min((a / b).min() for a, b in inside), "1")
    wrapped, layered = ([cell["inside_lateral"] for cell in cells] for cells in zip(*pairs, strict=True))
    study.measure("residual_wrapped", min(ratio[-1] / ratio[0] for ratio in wrapped), "1")
    study.measure("residual_layered", max((ratio[-1] for ratio in layered), key=lambda ratio: abs(ratio - 1.25)), "1")
    wrapped, layered = runs.pair("5PP")
    study.measure("axial_below_lateral", layered["inside_axial"][wrapped.peak] / wrapped["inside_lateral"][wrapped.peak], "1")


def inwards(cell):
    """Returns p of the second group over that of the first, at the edge, at the cell's peak."""
    return cell["p2"][cell.peak] / cell["p1"][cell.peak]


def measure_paths(study, runs):
    """Stress paths of the reinforced soil and of its groups up to the peak."""
    slopes = {(g, form, of): runs.cell(form, g).path(of) for g, form, of in itertools.product(GEOTEXTILES, FORMS, ("", *GROUPS))}
    each = [numpy.array([slope for (of, *_), (slope, _) in slopes.items() if of == g]) for g in GEOTEXTILES]
    study.measure("slopes_differ", max(100 * abs(some / some.mean() - 1).max() for some in each), "%")
    study.measure("paths_bend", max(bend for _, bend in slopes.values()), "%")
    whole = {g: numpy.mean([slopes[g, form, ""][0] for form in FORMS]) for g in GEOTEXTILES}
    for g, slope in whole.items():
        study.measure(f"slope_{g}", slope, "1")
    study.measure("slope_soil", runs.soil["q"][-1] / runs.soil["p"][-1], "1")
    study.measure("slope_falls", min(least_rise([-slopes[g, form, ""][0] for g in GEOTEXTILES]) for form in FORMS), "1")
    edge = {form: numpy.array([inwards(runs.cell(form, g)) for g in GEOTEXTILES]) for form in FORMS}
    study.measure("edge_wrapped", edge["wrapped"].min(), "1")
    study.measure("edge_layered", (edge["layered"] / edge["wrapped"]).min(), "1")
    study.measure("edge_stiff", min(ratio[-1] - ratio[0] for ratio in edge.values()), "1")


def measure_volumes(study, runs):
    """Void ratios of the cell and of the reinforced soil with PP, and where grains shear."""
    wrapped, layered = runs.pair(MIDDLING)
    at_least = [cell["shear"][cell["e_inside"].argmin()] for cell in (wrapped, layered)]
    study.measure("shear_wrapped", at_least[0] - at_least[1], "%")

    def fall(cell, name):
        return cell[name][0] - cell[name].min()
    study.measure("layered_denser", fall(layered, "e") - fall(wrapped, "e"), "1")
    study.measure("e_end_differs", abs(wrapped.last("e") - layered.last("e")), "1")
    study.measure("inside_contracts", fall(wrapped, "e_inside") - fall(layered, "e_inside"), "1")
    study.measure("inside_keeps", abs(layered["e_inside"][layered.whole] - layered["e_inside"][0]).max(), "1")
    for form, cell in zip(FORMS, (wrapped, layered), strict=True):
        study.measure(f"e_end_{form}", cell.last("e_inside") / cell.last("e"), "1")
    for form, zone in (("wrapped", lambda away: away > 2 / 3), ("layered", lambda away: away < 0.51)):
        bands = runs.folder(f"bands_{form}_{MIDDLING}_greatest")
        there, all_of, much = zone(bands("distance", "1")), bands("grains", "1"), bands("sheared", "1")
        study.measure(f"bands_{form}", (much[there].sum() / much.sum()) / (all_of[there].sum() / all_of.sum()), "1")


def measure_chain(study, runs):
    """Whether the runs are what they should be."""
    cells = [cell for pair in runs.pairs for cell in pair]
    study.measure("lateral_held", max(100 * abs(cell["lateral"] - 1).max() for cell in cells), "%")
    study.measure("energy_error", max(100 * abs(cell["energy_error"]).max() / cell["boundary_work"].max() for cell in cells), "%")
    study.measure("unreinforced", runs.soil["ratio"].max() / runs.cell("wrapped", "PE")["ratio"].max(), "1")
    for axis in "xy":
        study.measure(f"widening_{axis}", -runs.cell("wrapped", MIDDLING).last(f"strain_{axis}"), "%")
    study.measure("slow", lambda: slowed(runs), "%")


def slowed(runs):
    """Returns by how much the cell's axial stress differs at most at a tenth of the rate, % of the greatest. Raises NotMade."""
    slow, usual = runs.slow()["ratio"], runs.cell("wrapped", MIDDLING)["ratio"]
    if len(slow) != len(usual):
        raise NotMade("it has not come to the end")
    return 100 * abs(slow - usual).max() / usual.max()


MEASURES = (measure_start, measure_cells, measure_inside, measure_paths, measure_volumes, measure_chain)


def build(arguments):
    """Reads the tables of the cells in the folder OUT and writes what was measured, drawn and compared."""
    study = Study.of(HERE, arguments, judged=arguments.profile == "thesis")
    runs = Runs(study.out)
    for measure in MEASURES:
        measure(study, runs)
    if not arguments.kept:
        bands = runs.folder(f"bands_wrapped_{MIDDLING}_greatest")
        study.tell(pressure=f"{confining():g} kPa", end=f"{runs.cell('wrapped', MIDDLING).last('strain'):.0f} %",
                   grains=f"{bands('grains', '1').sum():.0f}")
        study.history = (study.out / "provenance.txt").read_text(encoding="utf-8")
    for draw in drawing.OF_ALL if arguments.kept else drawing.OF_ALL + drawing.OF_RUNS:
        draw(study, runs)
    return study


if __name__ == "__main__":
    main(build)
