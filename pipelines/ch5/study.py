#!/usr/bin/env python3
"""Chapter 5: soil wrapped in a geotextile, by the analytical solution and by grains (thesis Figs. 5.2 to 5.20)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import pathlib

import numpy
from ch3.bag import RECORDED
from ch5 import measures, pictures
from ch5.grains import PRESSURES, SHEARED, UNIAXIAL, Grains, hoop_strain
from ch5.grains import RECORDED as ANALYSED
from study import Drawn, Folder, NotMade, Series, Study, Table, figures, main, panel
from study.files import put
from study.tables import write_table

HERE = pathlib.Path(__file__).parent
DRAWN = UNIAXIAL[:-1]
LINES = ("compression_line", "failure_line", "near_failure_line", "dilatancy_line", "stiffness", "increments", "constants")
COLOURS = figures.GEOTEXTILE
CROSSES = "x"  # points of these DEM runs; circles are recorded ones
GRAINS = "Statements of §5.2 to §5.5 about the DEM runs, and recorded series"
CONSTANTS = ("C_t", "p_0", "n", "p_c", "kappa", "lambda", "xi", "p_1", "p_2", "alpha", "beta")


class Solution(Series):
    """A solution of gws-solve; its hoop is the fabric."""

    derived = {"tensile_strain": ("%", "tensile strain", lambda s: s["hoop_strain"]),
               "tension": ("kN/m", "tension", lambda s: s.table("hoop_tension", "kN/m"))}


class Recorded(Series):
    """A recorded series of discrete elements. Yarns are 5 mm apart, so that a tension in N over 5 is in kN/m."""

    derived = {"tensile_strain": ("%", "tensile strain", lambda r: r["strain_yarn_face"]),
               "tension": ("kN/m", "tension", lambda r: r["tension_yarn_face"] / 5),
               "hoop_strain": ("%", "hoop strain", lambda r: hoop(r.table)),
               "reinforcing_efficiency": ("1/m", "surcharge over stiffness", lambda r: r["surcharge"] / r.table("tensile_stiffness", "kN/m")),
               "strain_deviatoric": ("%", "deviatoric strain", lambda r: r["strain_axial"] - r["strain_volumetric"] / 3)}


class Runs:
    """The tables of gws-solve in the folder of results, and the recorded series."""

    def __init__(self, out):
        table = Folder(out)
        self.uniaxial = {g: table(f"uniaxial_{g}") for g in UNIAXIAL}
        self.triaxial = {(g, p): table(f"triaxial_{g}_{p}kPa") for g in SHEARED for p in PRESSURES}
        self.recorded = {g: Table.read(RECORDED.format(g)) for g in ANALYSED}
        self._table = table

    @functools.cached_property
    def lines(self):
        """Lines and constants identified from the recorded series."""
        return {name: self._table(name) for name in LINES}

    @functools.cached_property
    def chart(self):
        """The design chart."""
        return self._table("chart")

    @functools.cached_property
    def bands(self):
        """The response with the scatter of its constants."""
        return self._table("bands")

    def given(self, constant, unit="1"):
        """Returns a constant of thesis Table 5.2."""
        return self.lines["constants"](f"{constant}_given", unit)[0]


def between(table, x, x_unit, y, y_unit, at):
    """Returns the column y where the column x is `at`, linear between rows, and extrapolated beyond the ends.

    A recorded bag may settle by a little more than the solution, which ends at half the strength of the geotextile.
    """
    a, b = table(x, x_unit), table(y, y_unit)
    k = numpy.clip(numpy.searchsorted(a, at, side="right") - 1, 0, len(a) - 2)
    return b[k] + (b[k + 1] - b[k]) * (at - a[k]) / (a[k + 1] - a[k])


def last(table, name, unit):
    """Returns the last value of a column, which belongs to the ultimate load."""
    return table(name, unit)[-1]


def hoop(recorded):
    """Returns the mean strain (%) of the recorded hoops."""
    return hoop_strain(*(recorded(f"strain_yarn_{family}", "%") for family in ("face", "horizontal", "vertical")))


def measure_beside_record(study, g, model, recorded):
    """Measures the solution of one geotextile beside its recorded series, up to the greatest recorded surcharge."""
    peak = int(recorded("surcharge", "kPa").argmax())
    strain = recorded("strain_axial", "%")[:peak + 1]
    study.measure(f"ultimate_{g}", last(model, "surcharge", "kPa"), "kPa")
    study.measure(f"settlement_{g}", last(model, "strain_axial", "%"), "%")
    study.measure(f"excess_{g}", 100 * (last(model, "surcharge", "kPa") / recorded("surcharge", "kPa")[peak] - 1), "%")
    study.measure(f"settlement_difference_{g}", last(model, "strain_axial", "%") - strain[-1], "%")
    for name, column in (("lateral", "radial_stress"), ("axial", "axial_stress"), ("surcharge", "surcharge")):
        theirs = recorded(column, "kPa")[:peak + 1]
        difference = between(model, "strain_axial", "%", column, "kPa", strain) - theirs
        study.measure(f"misfit_{name}_{g}", 100 * numpy.sqrt(numpy.mean(difference**2)) / theirs.max(), "%")
    study.measure(f"volumetric_{g}", last(model, "strain_volumetric", "%"), "%")
    study.measure(f"volumetric_difference_{g}", last(model, "strain_volumetric", "%") - recorded("strain_volumetric", "%")[peak], "%")
    hoops = hoop(recorded)[1:peak + 1]
    inside = (hoops > 0) & (hoops <= last(model, "hoop_strain", "%"))
    ratio = recorded("surcharge", "kPa")[1:peak + 1][inside] / between(model, "hoop_strain", "%", "surcharge", "kPa", hoops[inside])
    study.measure(f"hoops_excess_{g}", 100 * numpy.mean(ratio - 1), "%")
    study.measure(f"hoops_above_{g}", 100 * numpy.mean(ratio > 1), "%")


def slope(model, share):
    """Returns the slope of surcharge over settlement (kPa per %) at a share of the final settlement."""
    e = share * last(model, "strain_axial", "%")
    low, high = (between(model, "strain_axial", "%", "surcharge", "kPa", e * s) for s in (0.98, 1.02))
    return (high - low) / (0.04 * e)


def measure_trends(study, uniaxial):
    """Measures how the solution depends on the stiffness of the geotextile."""
    slopes = {}
    for g, model in uniaxial.items():
        slopes[g] = last(model, "reinforcing_efficiency", "1/m") / last(model, "hoop_strain", "%")
        study.measure(f"hoop_slope_{g}", slopes[g], "kPa per kN/m and %")
        surcharge, strain = model("surcharge", "kPa"), model("hoop_strain", "%")
        study.measure(f"curvature_{g}", 100 * max(abs(surcharge - surcharge[-1] * strain / strain[-1])) / surcharge[-1], "%")
    models = list(uniaxial.values())
    kind = models[1:]  # multiples of PP, from soft to stiff
    settlements = [last(m, "strain_axial", "%") for m in kind]
    steps = numpy.diff([slopes[g] for g in UNIAXIAL[1:]])
    study.measure("settlement_falls", numpy.sum(numpy.diff(settlements) <= 0), "1")
    study.measure("efficiency_rises", numpy.sum(numpy.diff([last(m, "reinforcing_efficiency", "1/m") for m in models]) >= 0), "1")
    study.measure("hoop_slope_rises", numpy.sum(steps > 0), "1")
    study.measure("hoop_slope_diverges", numpy.sum(abs(steps[1:]) > abs(steps[:-1])), "1")
    study.measure("hardening", min(slope(m, 0.3) / slope(m, 0.05) for m in models), "1")
    study.measure("late_bending", 100 * max(abs(slope(m, 0.97) / slope(m, 0.6) - 1) for m in models), "%")
    study.measure("least_confinement", min(min(m("axial_stress", "kPa") - m("surcharge", "kPa")) for m in models), "kPa")
    stresses = [between(m, "strain_axial", "%", "axial_stress", "kPa", 8) for m in models]
    ratios = [between(m, "strain_axial", "%", "surcharge", "kPa", 8) / s for m, s in zip(models, stresses, strict=True)]
    study.measure("spread_of_ratio", 100 * (max(ratios) / min(ratios) - 1), "%")
    study.measure("spread_of_stress", max(stresses) / min(stresses), "1")


def measure_triaxial(study, runs):
    """Measures how the solution depends on the lateral stress."""
    capacity = settlement = 0
    shifts = []
    for g in SHEARED:
        alone = runs.uniaxial[g]
        at_8 = between(alone, "strain_deviatoric", "%", "strain_volumetric", "%", 8)
        before = alone
        for p in PRESSURES:
            run = runs.triaxial[g, p]
            capacity += last(run, "surcharge", "kPa") <= last(before, "surcharge", "kPa")
            settlement += last(run, "strain_axial", "%") <= last(before, "strain_axial", "%")
            shifts.append(between(run, "strain_deviatoric", "%", "strain_volumetric", "%", 8) - at_8)
            study.measure(f"start_{g}_{p}", run("surcharge", "kPa")[0], "kPa")
            before = run
        low, high = runs.triaxial[g, "10"], runs.triaxial[g, "100"]
        study.measure(f"spread_{g}", 100 * (last(high, "surcharge", "kPa") / last(low, "surcharge", "kPa") - 1), "%")
        dilation = -numpy.diff(low("strain_volumetric", "1"))[-1] / numpy.diff(low("strain_deviatoric", "1"))[-1]
        study.measure(f"dilation_{g}", dilation, "1")
        study.measure(f"volumetric_at_8_{g}", at_8, "%")
        study.measure(f"start_lateral_{g}", high("radial_stress", "kPa")[0], "kPa")
    study.measure("start_hoop_PE", runs.triaxial["PE", "100"]("hoop_strain", "%")[0], "%")
    study.measure("unordered_capacity", capacity, "1")
    study.measure("unordered_settlement", settlement, "1")
    study.measure("contraction_by_pressure", max(shifts, key=abs), "%")


def measure_constants(study, runs):
    """Measures the constants identified from the recorded series, beside Table 5.2."""
    line = runs.lines["near_failure_line"]
    distance = line("distance_to_failure", "1")
    study.measure("nfsl", 1 - sum(line("residual", "1")**2) / sum((distance - distance.mean())**2), "1")
    table = runs.lines["constants"]
    for c in CONSTANTS:
        unit = "Pa" if c in ("p_0", "p_c", "alpha") else "1"
        value, low, high, given = (table(c + ending, unit)[0] for ending in ("", "_low", "_high", "_given"))
        study.measure(c, value, unit)
        study.measure(f"{c}_outside", not low <= given <= high, "1")
        study.measure(f"{c}_difference", 100 * (value / given - 1), "%")


def compared(runs, grains, some):
    """Returns what is drawn of some geotextiles: solutions, points of the recorded series that are public, and of these bags (crosses).

    Solutions with the constants of Table 5.2 are solid, those with the bags' own dashed. grains: the DEM runs, or None.
    """
    bags = grains.bags() if grains else {}
    return [*(Drawn(g, Solution(runs.uniaxial[g]), COLOURS[g]) for g in some),
            *(Drawn("", Solution(grains.model("own_", g)), COLOURS[g], "--") for g in some if g in bags),
            *(Drawn("", Recorded(runs.recorded[g]), COLOURS[g], "o") for g in some if g in runs.recorded),
            *(Drawn("", bags[g], COLOURS[g], CROSSES) for g in some if g in bags)]


def draw_tension(study, runs):
    """Draws Fig. 5.2."""
    tension = [drawn for g in ("PE", "PP") for drawn in (
        Drawn(f"{g}, yarns of the discrete elements", Recorded(runs.recorded[g]), COLOURS[g], "o"),
        Drawn(f"{g}, model, to half the strength", Solution(runs.uniaxial[g]), COLOURS[g]))]
    study.curves("tension", panel("tensile_strain", "tension", tension, xlim=(0, 9), ylim=(0, 26)))


def draw_uniaxial(study, runs, grains=None):
    """Draws Figs. 5.15 and 5.16. grains: the DEM runs, if there are any."""
    study.curves("surcharge", *(panel("strain_axial", "surcharge", compared(runs, grains, some), xlim=(0, 20), ylim=(0, None))
                                for some in (UNIAXIAL[:3], UNIAXIAL[3:])))
    drawn = compared(runs, grains, DRAWN)
    study.curves("internal", *(panel(x, y, drawn, legend=y == "axial_stress", xlim=(0, end), ylim=limits) for x, y, end, limits in (
        ("strain_axial", "axial_stress", 18, None), ("strain_axial", "radial_stress", 18, None), ("hoop_strain", "reinforcing_efficiency", 9, None),
        ("strain_deviatoric", "strain_volumetric", 18, (-4, 3)))), columns=2)


def scatter_of_series(axes, table, x, y):
    """Draws the points of a line, a colour for each series."""
    for k, g in enumerate(ANALYSED):
        own = table("series", "1") == k
        figures.points(axes, x[own], y[own], COLOURS[g], g)


def draw_lines(study, runs):
    """Draws Figs. 5.6c, 5.7, 5.10 and 5.12."""
    figure, axes = figures.panels(2, rows=2, height=7.6)
    pure = ["(p/pₐ)^0.3", "q/p at failure", "M_f − q/p", "M_f − M + dε_v^p/dε_d^p"]
    line = runs.lines["failure_line"]
    x = line("mean_stress", "kPa")
    axes[0].semilogx(x, line("failure_obliquity", "1"), "o", color=figures.INK, label="laboratory")
    axes[0].plot(numpy.sort(x), line("fitted", "1")[x.argsort()], color=figures.GREY, label="identified")
    figures.label(axes[0], "mean stress (kPa)", pure[1], pure)
    line = runs.lines["near_failure_line"]
    x = line("strain_deviatoric", "%")
    scatter_of_series(axes[1], line, x, line("distance_to_failure", "1"))
    given = numpy.linspace(0, 15, 200)
    axes[1].plot(given, runs.given("kappa") / (given + runs.given("lambda")) - runs.given("xi"), color=figures.INK, label="Table 5.2")
    axes[1].plot(numpy.sort(x), line("fitted", "1")[x.argsort()], "--", color=figures.GREY, label="identified")
    axes[1].set_ylim(0, 1.2)
    figures.label(axes[1], "deviatoric strain (%)", pure[2], pure)
    line = runs.lines["compression_line"]
    x = (line("mean_stress", "kPa") / 100)**0.3
    scatter_of_series(axes[2], line, x, line("strain_volumetric", "%"))
    axes[2].plot(numpy.sort(x), line("fitted", "%")[x.argsort()], color=figures.GREY)
    figures.label(axes[2], pure[0], "volumetric strain (%)", pure)
    line = runs.lines["dilatancy_line"]
    x = line("distance_to_failure", "1")
    scatter_of_series(axes[3], line, x, line("distance_of_dilation_rate", "1"))
    given = numpy.linspace(0, 0.8, 2)
    axes[3].plot(given, runs.given("p_1") * given - runs.given("p_2"), color=figures.INK, label="Table 5.2")
    axes[3].plot(numpy.sort(x), line("fitted", "1")[x.argsort()], "--", color=figures.GREY, label="identified")
    axes[3].set_ylim(-0.6, 1)
    figures.label(axes[3], pure[2], pure[3], pure)
    for a in axes:
        a.legend()
    study.figure("lines", figure)


def draw_stiffness(study, runs):
    """Draws Figs. 5.13 and 5.14."""
    figure, (left, right) = figures.panels(2)
    increments, moduli = runs.lines["increments"], runs.lines["stiffness"]
    for k, g in enumerate(ANALYSED):
        own = increments.rows(increments("series", "1") == k)
        stress = numpy.append(0, numpy.cumsum(own("generalized_stress", "kPa")))
        strain = numpy.append(0, numpy.cumsum(own("plastic_axial", "%")))
        modulus = moduli.rows(moduli("series", "1") == k)("young_modulus", "kPa")[0]
        figures.points(left, stress, strain, COLOURS[g], g)
        left.plot(stress, 100 * stress / modulus, color=COLOURS[g])
    figures.label(left, "accumulated p* (kPa)", "plastic axial strain (%)")
    stiffness = moduli("tensile_stiffness", "kN/m")
    right.loglog(stiffness, moduli("young_modulus", "MPa"), "o", color=figures.INK, label="from the discrete elements")
    given = numpy.geomspace(30, 1300, 50)
    right.plot(given, 1e-6 * runs.given("alpha", "Pa") * (given / 1e3)**runs.given("beta"), color=figures.ORANGE, label="Table 5.2")
    figures.label(right, "stiffness of the geotextile (kN/m)", "Young's modulus (MPa)")
    for a in (left, right):
        a.legend()
    study.figure("stiffness", figure)


def draw_triaxial(study, runs, grains=None):
    """Draws Figs. 5.17 to 5.20: solutions, and points of the DEM cells where they are made. grains: as in draw_uniaxial()."""
    cells, marks = grains.cells() if grains else {}, dict(zip(PRESSURES, ("x", "+", "."), strict=True))
    for x, y in (("strain_axial", "surcharge"), ("strain_axial", "axial_stress"), ("strain_axial", "radial_stress"),
                 ("strain_deviatoric", "strain_volumetric")):
        study.curves(f"triaxial_{y}", *(
            panel(x, y, [*(Drawn(f"{g}, {p} kPa", Series(runs.triaxial[g, p]), COLOURS[g], dashes)
                           for p, dashes in zip(PRESSURES, ("-", "--", ":"), strict=True)),
                         *(Drawn("", cells[g, p], COLOURS[g], marks[p]) for p in PRESSURES if (g, p) in cells)],
                  xlim=(0, None)) for g in SHEARED), height=3.6)


def draw_design(study, runs):
    """The design chart, and the bands of the identified constants."""
    figure, (left, right) = figures.panels(2)
    chart = runs.chart
    x = chart("stiffness", "kN/m")
    left.loglog(x, chart("capacity", "kPa"), color=figures.INK, label="ultimate")
    left.plot(x, chart("allowable_surcharge", "kPa", missing=True), color=figures.ORANGE, label="within 6 %, safety 1.5")
    figures.label(left, "stiffness of the geotextile (kN/m)", "surcharge (kPa)")
    right.semilogx(x, chart("settlement", "%"), color=figures.INK, label="at the ultimate load")
    right.plot(x, chart("service_settlement", "%", missing=True), color=figures.ORANGE, label="at 300 kPa")
    figures.label(right, "stiffness of the geotextile (kN/m)", "settlement (%)")
    for a in (left, right):
        a.legend()
    study.figure("chart", figure)
    figure, axes = figures.panels(2)
    bands, model, recorded = runs.bands, runs.uniaxial["PP"], runs.recorded["PP"]
    for a, y, words in zip(axes, ("surcharge", "radial_stress"), ("surcharge", "lateral stress"), strict=True):
        x = bands("settlement", "%")
        a.fill_between(x, bands(f"{y}_low", "kPa"), bands(f"{y}_high", "kPa"), color=figures.ORANGE, alpha=0.2, linewidth=0,
                       label="95 % of the draws")
        a.plot(x, bands(y, "kPa"), color=figures.ORANGE, label="their median")
        a.plot(model("strain_axial", "%"), model(y, "kPa"), "--", color=figures.INK, label="Table 5.2")
        figures.points(a, recorded("strain_axial", "%"), recorded(y, "kPa"), figures.INK, "discrete elements")
        figures.label(a, "axial strain (%)", f"{words} (kPa)")
        a.set_xlim(0, 14)
        a.legend()
    study.figure("bands", figure)


def put_misfits(study, grains):
    """Writes the differences of the model from each DEM run, as a table that the page shows, too."""
    path = study.out / "misfits.tsv"
    put(path, write_table(measures.table_of_misfits(grains)))
    if not study.pageless:
        study.appendix("Difference of the model from each DEM run", path)


def build_of_grains(study, grains):
    """Measures and draws the DEM runs."""
    for measure in measures.MEASURES:
        measure(study, grains)
    put_misfits(study, grains)


def draw_of_grains(study, grains, beside=()):
    """Draws the figures of DEM bags and cells, and those in `beside`, functions of the same arguments.

    A figure whose runs are missing is left out.
    """
    for draw in (*pictures.OF_ALL, *beside):
        try:
            draw(study, grains)
        except NotMade as reason:
            study.remark(f"Not drawn: {reason}.")


def build_kept(arguments):
    """Compares and draws the kept DEM runs at full size, beside the solutions made last."""
    study = Study.of(HERE, arguments, digits=None)
    study.groups, study.checks = [], []  # statements on the solution need no DEM run
    study.expect(HERE / "grains.tsv", GRAINS, table="grains")
    grains = Grains(study.out, arguments.solutions, "not among the kept runs")
    build_of_grains(study, grains)
    runs = Runs(arguments.solutions)
    draw_of_grains(study, grains, [lambda study, grains: draw_uniaxial(study, runs, grains), lambda study, grains: draw_triaxial(study, runs, grains)])
    return study


def build(arguments):
    """Reads the tables of gws-solve and of the runs in the folder OUT and writes what was measured, drawn and compared."""
    if arguments.kept:
        return build_kept(arguments)
    study = Study.of(HERE, arguments, digits=None)
    study.expect(HERE / "grains.tsv", GRAINS, table="grains", judged=arguments.profile == "thesis")
    runs, grains = Runs(study.out), Grains(study.out, study.out)
    for g, recorded in runs.recorded.items():
        measure_beside_record(study, g, runs.uniaxial[g], recorded)
    measure_trends(study, runs.uniaxial)
    measure_triaxial(study, runs)
    measure_constants(study, runs)
    build_of_grains(study, grains)
    study.tell(draws=f"{runs.bands('samples', '1').max():.0f}", bags=f"{len(grains.bags())}", cells=f"{len(grains.cells())}",
               full=arguments.profile == "thesis")
    study.history = (study.out / "provenance.txt").read_text(encoding="utf-8")
    draw_of_grains(study, grains)
    draw_uniaxial(study, runs, grains)
    draw_triaxial(study, runs, grains)
    for draw in (draw_tension, draw_lines, draw_stiffness, draw_design):
        draw(study, runs)
    study.text("Identified constants; \"given\" is Table 5.2, made from six series", study.out / "identified.txt")
    study.text("Constants identified from these bags", study.out / "own_identified.txt")
    study.text("What capacity and settlement hang on", study.out / "sensitivity.txt")
    study.text("Bands of the identified constants", study.out / "bands.txt")
    return study


if __name__ == "__main__":
    main(build, solutions={"default": "out/ch5", "help": "with --kept: folder of the solutions that kept runs are laid beside"})
