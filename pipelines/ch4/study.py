#!/usr/bin/env python3
"""Chapter 4: soil wrapped in a geotextile beside soil between two sheets, each in a periodic cell of soil (thesis Figs. 4.3 to 4.6)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib
import itertools

import numpy
from ch4 import drawing
from ch4.cells import FORMS, GEOTEXTILES, GROUPS, HERE, MIDDLING, TWIN, Runs, both_whole, compared, confining, least_rise, over
from study import NotMade, Study, main


def measure_start(study, runs):
    """Measures void ratios and contacts at rest under the confining pressure."""
    for form in FORMS:
        for name, column, unit, factor in (("e", "e", "1", 1), ("e_inside", "e_inside", "1", 1), ("fill", "fill", "%", 100)):
            study.measure(f"{name}_{form}", lambda f=form, c=column, k=factor: k * runs.cell(f, MIDDLING)[c][0], unit)
        study.measure(f"e_placed_{form}", lambda f=form: runs.shape(f)["e_inside"][0], "1")
        for name in ("height", "yarns"):
            study.measure(f"{name}_{form}", lambda f=form, n=name: 100 * (runs.shape(f)[n][1] / runs.shape(f)[n][0] - 1), "%")
    study.measure("orientation", lambda: abs(numpy.subtract(*(runs.folder(f"{form}_rose")["density"] for form in FORMS))).max(), "1")
    study.measure("denser", lambda: min(layered["e_inside"][0] - wrapped["e_inside"][0] for wrapped, layered in runs.pairs), "1")


def above(pair):
    """Returns the least axial stress of the wrapped cell over that of the layered one, before the first break and at the peaks."""
    wrapped, layered = (cell["ratio"].max() for cell in pair)
    return min(wrapped / layered, over(pair, "ratio", both_whole(pair)).min())


def contractions(runs, form):
    """Returns the greatest contraction of a form with each geotextile, %."""
    return [runs.cell(form, g)["contraction"].max() for g in GEOTEXTILES]


def dilations(pair):
    """Returns the dilation of the wrapped cell at its peak over that of the layered one.

    A layered cell that does not dilate counts as dilating by 0.01 %, so that any clear dilation of the wrapped cell is too much.
    """
    wrapped, layered = (max(0.0, -cell["contraction"][cell.peak]) for cell in pair)
    return wrapped / max(layered, 0.01)


def measure_cells(study, runs):
    """Measures stresses and volumes of the cells under load."""
    for g in GEOTEXTILES:
        for form in FORMS:
            study.measure(f"peak_{form}_{g}", lambda f=form, g=g: runs.cell(f, g)["ratio"].max(), "1")
        study.measure(f"above_{g}", lambda g=g: above(runs.pair(g)), "1")
    study.measure("gap_grows", lambda: least_rise([wrapped["ratio"].max() - layered["ratio"].max() for wrapped, layered in runs.pairs]), "1")
    study.measure("volumes_differ", lambda: max(
        abs(pair[0]["contraction"] - pair[1]["contraction"])[both_whole(pair)].max() for pair in runs.pairs), "%")
    study.measure("layered_contracts", lambda: numpy.subtract(*(contractions(runs, form) for form in ("layered", "wrapped"))).min(), "%")
    for form in FORMS:
        study.measure(f"contraction_grows_{form}", lambda f=form: least_rise(contractions(runs, f)), "%")
    study.measure("dilation_5PP", lambda: dilations(runs.pair("5PP")), "1")


def inside(pairs, name):
    """Returns, for each pair, the column of the wrapped cell over the one of the layered cell, from EARLIEST on."""
    return [over(pair, name, compared(pair)) for pair in pairs]


def residuals(runs, form):
    """Returns the lateral stress of the reinforced soil over the confining one, at the end and at the start, with each geotextile."""
    return [(ratio[-1], ratio[0]) for ratio in (runs.cell(form, g)["inside_lateral"] for g in GEOTEXTILES)]


def axial_below_lateral(pair):
    """Returns the axial stress in the layered soil over the lateral one in the wrapped soil, at the peak of the wrapped cell."""
    wrapped, layered = pair
    return layered["inside_axial"][wrapped.peak] / wrapped["inside_lateral"][wrapped.peak]


def measure_inside(study, runs):
    """Measures the stresses of the reinforced soil over the confining one."""
    study.measure("inside_above", lambda: min(r.min() for name in ("inside_axial", "inside_lateral") for r in inside(runs.pairs, name)), "1")
    for name in ("axial", "lateral"):
        study.measure(f"inside_gap_{name}", lambda n=name: min(
            (a / b).min() for a, b in zip(inside(runs.pairs, f"inside_{n}"), inside(runs.pairs, "ratio"), strict=True)), "1")
    study.measure("residual_wrapped", lambda: min(last / first for last, first in residuals(runs, "wrapped")), "1")
    study.measure("residual_layered", lambda: max((last for last, _ in residuals(runs, "layered")), key=lambda ratio: abs(ratio - 1.25)), "1")
    study.measure("axial_below_lateral", lambda: axial_below_lateral(runs.pair("5PP")), "1")


def inwards(cell):
    """Returns p of the second group over p of the first group, which lies at the edge, at the cell's peak."""
    return cell["p2"][cell.peak] / cell["p1"][cell.peak]


def edges(runs, form):
    """Returns inwards() of a form with each geotextile."""
    return numpy.array([inwards(runs.cell(form, g)) for g in GEOTEXTILES])


def measure_paths(study, runs):
    """Measures the stress paths of the reinforced soil and of its groups up to the peak."""
    def paths(geotextile, parts=("", *GROUPS)):
        return [runs.cell(form, geotextile).path(of) for form, of in itertools.product(FORMS, parts)]

    def apart(geotextile):
        slopes = numpy.array([slope for slope, _ in paths(geotextile)])
        return 100 * abs(slopes / slopes.mean() - 1).max()
    study.measure("slopes_differ", lambda: max(apart(g) for g in GEOTEXTILES), "%")
    study.measure("paths_bend", lambda: max(bend for g in GEOTEXTILES for _, bend in paths(g)), "%")
    for g in GEOTEXTILES:
        study.measure(f"slope_{g}", lambda g=g: numpy.mean([slope for slope, _ in paths(g, ("",))]), "1")
    study.measure("slope_soil", lambda: runs.soil["q"][-1] / runs.soil["p"][-1], "1")
    study.measure("slope_falls", lambda: min(least_rise([-runs.cell(form, g).path()[0] for g in GEOTEXTILES]) for form in FORMS), "1")
    study.measure("edge_wrapped", lambda: edges(runs, "wrapped").min(), "1")
    study.measure("edge_layered", lambda: (edges(runs, "layered") / edges(runs, "wrapped")).min(), "1")
    study.measure("edge_stiff", lambda: min(edges(runs, form)[-1] - edges(runs, form)[0] for form in FORMS), "1")


def fall(cell, name):
    """Returns the first value of a column less its least value."""
    return cell[name][0] - cell[name].min()


def banded(bands, zone):
    """Returns the share of the grains that shear most in a zone, over the share of all grains there."""
    there, all_of, much = zone(bands("distance", "1")), bands("grains", "1"), bands("sheared", "1")
    return (much[there].sum() / much.sum()) / (all_of[there].sum() / all_of.sum())


def measure_volumes(study, runs):
    """Measures void ratios of the cell and of the reinforced soil with PP, and where grains shear."""
    def both(of):
        wrapped, layered = (of(cell) for cell in runs.pair(MIDDLING))
        return wrapped - layered
    study.measure("shear_wrapped", lambda: both(lambda cell: cell["shear"][cell["e_inside"].argmin()]), "%")
    study.measure("layered_denser", lambda: -both(lambda cell: fall(cell, "e")), "1")
    study.measure("e_end_differs", lambda: abs(both(lambda cell: cell.last("e"))), "1")
    study.measure("inside_contracts", lambda: both(lambda cell: fall(cell, "e_inside")), "1")

    def kept(cell):
        return abs(cell["e_inside"][cell.whole] - cell["e_inside"][0]).max()
    study.measure("inside_keeps", lambda: kept(runs.cell("layered", MIDDLING)), "1")
    for form, zone in (("wrapped", lambda away: away > 0.61), ("layered", lambda away: away < 0.51)):
        study.measure(f"e_end_{form}", lambda f=form: runs.cell(f, MIDDLING).last("e_inside") / runs.cell(f, MIDDLING).last("e"), "1")
        study.measure(f"bands_{form}", lambda f=form, z=zone: banded(runs.folder(f"bands_{f}_{MIDDLING}_greatest"), z), "1")


def measure_chain(study, runs):
    """Measures whether the runs are sound. Runs that are not kept are left out."""
    def most(of):
        return lambda: max(of(cell) for cell in runs.cells())
    study.measure("lateral_held", most(lambda cell: 100 * abs(cell["lateral"] - 1).max()), "%")
    study.measure("energy_error", most(lambda cell: 100 * abs(cell["energy_error"]).max() / cell["boundary_work"].max()), "%")
    study.measure("unreinforced", lambda: runs.soil["ratio"].max() / runs.cell("wrapped", "PE")["ratio"].max(), "1")
    for axis in "xy":
        study.measure(f"widening_{axis}", lambda a=axis: -runs.cell("wrapped", MIDDLING).last(f"strain_{a}"), "%")
    study.measure("slow", lambda: slowed(runs), "%")


def slowed(runs):
    """Returns the greatest change of the cell's axial stress at a tenth of the rate, % of the greatest stress. Raises NotMade without that run."""
    slow, usual = runs.slow()["ratio"], runs.cell("wrapped", TWIN)["ratio"]
    if len(slow) != len(usual):
        raise NotMade("it has not come to the end")
    return 100 * abs(slow - usual).max() / usual.max()


MEASURES = (measure_start, measure_cells, measure_inside, measure_paths, measure_volumes, measure_chain)


def build(arguments):
    """Reads the tables of the cells in the folder OUT and writes what was measured, drawn and compared."""
    study = Study.of(HERE, arguments, judged=arguments.profile == "thesis")
    runs = Runs(study.out, arguments.kept)
    for measure in MEASURES:
        measure(study, runs)
    if not arguments.kept:
        bands = runs.folder(f"bands_wrapped_{MIDDLING}_greatest")
        study.tell(pressure=f"{confining():g} kPa", end=f"{runs.cell('wrapped', MIDDLING).last('strain'):.0f} %",
                   grains=f"{bands('grains', '1').sum():.0f}")
        study.history = (study.out / "provenance.txt").read_text(encoding="utf-8")
    for draw in drawing.OF_ALL if arguments.kept else drawing.OF_ALL + drawing.OF_RUNS:
        # A figure of kept runs is drawn as soon as its data are there.
        with contextlib.suppress(NotMade):
            draw(study, runs)
    return study


if __name__ == "__main__":
    main(build)
