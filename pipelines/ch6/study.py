#!/usr/bin/env python3
"""Chapter 6: a geosynthetic that forms a square of soil, and one pulled out from under it (thesis Figs. 6.2 to 6.6)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math
import pathlib
import tomllib

import numpy
from ch6.runs import SIZES, Runs, label, speed, spread, squares
from matplotlib.collections import LineCollection, PolyCollection
from study import Study, figures, main

HERE = pathlib.Path(__file__).parent
KEPT = HERE / "kept"
# Column, unit that it is drawn in, name on the page.
FIELDS = (("mean_stress", "kPa", "p (kPa)"), ("deviatoric_stress", "kPa", "q (kPa)"), ("strain_shear", "%", "ε_q (%)"),
          ("rotation", "rad", "rotation of the rods (rad)"), ("anisotropy", "1", "F_a"), ("strain_volumetric", "%", "ε_v (%)"))
EMPTY = "#d5d8dc"  # points without contacts, which have no fabric
CLAIMS = {
    "curves": "all shape-forming cases produce similar responses; finer meshes slightly postpone the onset of hardening, and the speed is "
              "marginal. In pull-out the initial rate is proportional to the speed, and further refinement has no effect on it (§6.4).",
    "shape": "p and the displacement distribute asymmetrically; displacement and shear strain under the top are much greater than in the "
             "rest (§6.4).",
    "pullout": "the soil settles on the left and heaves on the right, a vortex with its origin close to the left end of the inclusion "
               "(§6.4, §6.6).",
    "A": "the point is at failure and dilates at first; after the onset of hardening at about 7 cm it contracts, q/p falls, and F_a drops "
         "to almost zero (§6.5).",
    "B": "q and F_a rise to their maximums and then cease to change; the volume stagnates, then dilates marginally (§6.5).",
}


def given(name):
    """Returns the numbers of a scenario."""
    return tomllib.loads((HERE / name).read_text(encoding="utf-8"))


def measure_shape(study, runs):
    """Shape-forming: stresses at the bottom, point A under the top, the last state."""
    curves, main_run = {c: runs.curve("shape", c) for c in runs.size.cases}, runs.curve("shape")
    coarsest, finest = (curves[runs.size.meshes[k]] for k in (0, -1))
    study.measure("shape_mesh_spread", spread([curves[c] for c in runs.size.meshes], 6), "1")
    study.measure("shape_speed_spread", spread([curves[c] for c in runs.size.speeds], 6), "1")
    study.measure("shape_onset", main_run.onset, "cm")
    study.measure("shape_onset_delay", lambda: finest.onset() - coarsest.onset(), "cm")
    a = runs.history("shape")
    study.measure("A_obliquity_first", lambda: a.obliquity(a.until(main_run.onset())), "1")
    study.measure("A_obliquity_falls", lambda: 100 * (1 - a.obliquity(a.part(0.9, 1)) / a.obliquity(a.until(main_run.onset()))), "%")
    study.measure("A_dilation", -a.volumetric.min(), "%")
    study.measure("A_contracts_from", a.pull[a.loosest], "cm")
    study.measure("A_obliquity_dilating", lambda: a.obliquity(a.dilating), "1")
    study.measure("A_contraction", a.volumetric[-1] - a.volumetric.min(), "%")
    study.measure("A_anisotropy_end", a.anisotropy[a.part(0.9, 1)].mean(), "1")
    field = runs.field("shape")
    top = field.corners_at(field.side) > 0
    study.measure("shape_top_shear", field.mean("strain_shear", "1", top) / field.mean("strain_shear", "1", ~top), "1")
    study.measure("shape_asymmetry", field.asymmetry(), "%")
    study.measure("shape_energy", runs.balance("shape"), "%")


def measure_pullout(study, runs):
    """Pull-out: mobilised friction, the last state, point B above the sheet."""
    slow, fast = (runs.curve("pullout", runs.size.speeds[k]) for k in (0, -1))
    medium, fine = (runs.curve("pullout", runs.size.meshes[k]) for k in (-2, -1))
    speeds = [speed(case) for case in runs.size.speeds]
    full = numpy.tan(numpy.radians(given("pullout.toml")["geosynthetic"]["contact"]["friction_angle"]))
    study.measure("pullout_rate", fast.rate() / slow.rate() / (speeds[-1] / speeds[0]), "1")
    study.measure("pullout_mesh_rate", fine.rate() / medium.rate(), "1")
    study.measure("pullout_mobilised", 100 * runs.curve("pullout").mean(10, 20) / full, "%")
    study.measure("swinging_mobilised", lambda: 100 * runs.swinging().mean(10, 20) / full, "%")
    field = runs.field("pullout")
    x = field.start[:, 0] / field.side
    study.measure("pullout_settlement", -field.rise(x < 0.26), "mm")
    study.measure("pullout_heave", field.rise(x > 0.74), "mm")
    study.measure("pullout_centre", field.heaves_from, "m")
    b = runs.history("pullout")
    middle, last = b.part(1 / 3, 2 / 3), b.part(2 / 3, 1)
    study.measure("B_q_rises", b.q[last].mean() / max(b.q[0], 1e-3), "1")
    study.measure("B_q_change", 100 * abs(1 - b.q[middle].mean() / b.q[last].mean()), "%")
    study.measure("B_F_rises", b.anisotropy[last].mean() - b.anisotropy[0], "1")
    study.measure("B_F_change", 100 * abs(1 - b.anisotropy[middle].mean() / b.anisotropy[last].mean()), "%")
    study.measure("B_volumetric", b.volumetric[b.part(0.95, 1)].mean(), "%")
    side, corner = field.along(2), field.along(1)
    study.measure("along_volumetric_side", field.mean("strain_volumetric", "%", side), "%")
    study.measure("along_volumetric_corner", field.mean("strain_volumetric", "%", corner), "%")
    study.measure("along_deviatoric_ratio", field.mean("deviatoric_stress", "kPa", side) / field.mean("deviatoric_stress", "kPa", corner), "1")
    study.measure("pullout_energy", runs.balance("pullout"), "%")


def draw_curves(runs, kept):
    """Returns Fig. 6.2: the response of every run; beside a kept set of full size this run's main one alone, dashed."""
    figure, axes = figures.panels(2)
    friction = "friction ratio at the bottom"
    for a, example, words in zip(axes, ("shape", "pullout"), ("vertical stress at the bottom (kPa)", friction), strict=True):
        whole = kept or runs
        for case, colour in zip(whole.size.cases, figures.SERIES, strict=False):
            curve = whole.curve(example, case)
            a.plot(curve.pull, curve.value, color=colour, linewidth=1.2, label=label(case))
        if kept:
            curve = runs.curve(example)
            a.plot(curve.pull, curve.value, "--", color=figures.GREY, linewidth=1.2, label=f"this run: {label(runs.size.main)}")
        figures.label(a, "pulled (cm)", words, [friction])
        a.set_xlim(0, 25)
        a.set_ylim(bottom=0)
        a.legend()
    return figure


def draw_fields(runs, example, words):
    """Returns Fig. 6.3 or 6.4 and its sentence: six quantities of the points, how the nodes have moved, and the sheet."""
    field = runs.field(example)
    figure, axes = figures.panels(3, rows=2, width=10.5, height=6.2)
    corners = field.position[field.corners]
    line = numpy.stack([field.bars("x_0", "m"), field.bars("y_0", "m")], axis=1)
    tension = field.bars("tension_ratio", "1")
    low = numpy.minimum(field.position.min(axis=0), 0) - 0.08
    high = field.position.max(axis=0) + 0.08
    for a, (name, unit, title) in zip(axes, FIELDS, strict=True):
        values = field.points(name, unit)
        if name == "anisotropy":
            values = numpy.ma.masked_less(values, 0)
        soil = PolyCollection(corners, array=values, cmap="viridis", edgecolor="face", linewidth=0.3)
        soil.cmap.set_bad(EMPTY)
        soil.set_clim(0 if name == "anisotropy" else None, None)
        a.add_collection(soil)
        if name == "deviatoric_stress":
            # The sheet is the thicker the more of its strength it carries.
            widths = 0.8 + 2.2 * tension[:-1].clip(0) / max(tension.max(), 1e-12)
            a.add_collection(LineCollection(numpy.stack([line[:-1], line[1:]], axis=1), colors=figures.ORANGE, linewidths=widths))
        else:
            a.plot(*line.T, color=figures.ORANGE, linewidth=0.8)
        figure.colorbar(soil, ax=a, shrink=0.85)
        a.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal", title=title)
        a.title.set_fontsize(10)
        a.grid(False)
        figures.label(a, "x (m)", "y (m)")
    most = numpy.linalg.norm(field.displacement, axis=1).max()
    magnified = 10**math.floor(math.log10(0.2 / most)) if 0 < most < 0.05 else 1
    moved = magnified * field.displacement
    axes[0].quiver(*field.start.T, *moved.T, angles="xy", scale_units="xy", scale=1, width=0.007, color="white", zorder=3)
    return figure, (f"{words} at the end: {2 * squares(runs.size.main)**2} elements, {runs.size.grains} rods a point. Arrows: displacements of "
                    f"the nodes, times {magnified}; line: the sheet, in the panel of q the thicker the more of its strength it carries; grey: no "
                    "contacts.")


def draw_histories(runs, kept, example):
    """Returns Fig. 6.5 or 6.6: the point's q/p and volume, stress path, anisotropy; solid at full size, else dashed."""
    figure, axes = figures.panels(4, width=11, height=3.0)
    pure = ["q/p", "F_a"]
    for whole, dashes, colour in ((kept, "-", figures.BLUE), (runs, "--" if kept else "-", figures.GREY if kept else figures.BLUE)):
        if whole is None:
            continue
        h = whole.history(example)
        loaded, touching = h.p > 1e-3, h.anisotropy >= 0  # kPa: q/p of nothing says nothing; F_a is -1 without contacts
        words = f"{2 * squares(whole.size.main)**2} elements, {whole.size.grains} rods a point"
        for a, x, y in ((axes[0], h.shear[loaded], h.q[loaded] / h.p[loaded]), (axes[1], h.shear, h.volumetric), (axes[2], h.p, h.q),
                        (axes[3], h.shear[touching], h.anisotropy[touching])):
            a.plot(x, y, dashes, color=colour, linewidth=1.1, label=words)
    figures.label(axes[0], "ε_q (%)", pure[0], pure)
    figures.label(axes[1], "ε_q (%)", "ε_v, contraction positive (%)")
    figures.label(axes[2], "p (kPa)", "q (kPa)")
    figures.label(axes[3], "ε_q (%)", pure[1], pure)
    axes[2].legend(fontsize=7)
    return figure


def draw(study, runs, kept):
    """Each figure of the thesis in its order: at full size, with this run dashed or below where it is another."""
    study.figure("curves", draw_curves(runs, kept), "Vertical stress at the bottom in shape-forming (left) and mobilised friction in "
                 "pull-out (right) over the pull.", "Fig. 6.2", CLAIMS["curves"],
                 ["shape_mesh_spread", "shape_speed_spread", "shape_onset_delay", "pullout_rate", "pullout_mesh_rate"])
    for example, words, number, verdicts in (
            ("shape", "Shape-forming", "Fig. 6.3", ["shape_asymmetry", "shape_top_shear"]),
            ("pullout", "Pull-out", "Fig. 6.4", ["pullout_settlement", "pullout_heave", "pullout_centre"])):
        figure, sentence = draw_fields(kept or runs, example, words)
        study.figure(f"{example}_fields", figure, sentence, number, CLAIMS[example], verdicts)
        if kept:
            study.figure(f"{example}_fields_here", *draw_fields(runs, example, f"This run: {words.lower()}"))
    study.figure("A", draw_histories(runs, kept, "shape"), "Point A, under the middle of the top, in shape-forming.", "Fig. 6.5", CLAIMS["A"],
                 ["A_obliquity_first", "A_dilation", "A_contracts_from", "A_obliquity_falls", "A_anisotropy_end"])
    study.figure("B", draw_histories(runs, kept, "pullout"), "Point B, above the middle of the inclusion, in pull-out.", "Fig. 6.6", CLAIMS["B"],
                 ["B_q_rises", "B_q_change", "B_F_rises", "B_F_change", "B_volumetric"])


def explain(study, whole, say):
    """Says why statements are not met, and what to bear in mind."""
    field = whole.field("pullout")
    carried = [field.mean("deviatoric_stress", "kPa", field.along(corners)) for corners in (2, 1)]
    for name in ("B_volumetric", "along_volumetric_side"):
        study.reason(name, "a triangle with a side on the inclusion contracts and one with a corner on it dilates; which of the two B is the "
                     "thesis does not say")
    study.reason("A_obliquity_first", f"the onset is that of the whole square, after A contracts; while A itself dilates, q/p is "
                 f"{say('A_obliquity_dilating')}")
    study.reason("swinging_mobilised", "the soil swings as fast as the sheet is pulled, so that a part of the interface sticks while another slips")
    damping = given("pullout.toml")["soil"]["damping"], given("shape.toml")["soil"]["damping"]
    study.remark(f"In pull-out the soil is damped by {damping[0]:g} 1/s, not by the thesis's {damping[1]:g} 1/s: with that it swings on the interface "
                 "from the first slip to the end of the pull.")
    study.remark("Other known differences from the thesis's program: interface forces are read where the soil is, not one step of the bars "
                 "further; friction stays with a place of the sheet while it slides from one bar of the boundary to the next; the time step of the "
                 "soil follows from its masses and the contacts; the packings are our own, of the published sizes and numbers of rods.")
    study.remark("Along the inclusion every square of the mesh has a triangle with a side on it and one with a corner on it. In pull-out the former "
                 f"carry {carried[0] / carried[1]:.2g} times the deviatoric stress of the latter: where point B lies decides its sign. "
                 "Point B is here the point nearest to the middle of the inclusion, one of the former.")
    study.remark("Rotations of the kept runs at full size count from the making of the packing, so that all of one picture are shifted by one "
                 "angle; those of later runs count from the start of the pull.")


def build(arguments):
    """Reads the tables of fem-dem in the folder OUT and writes what was measured, drawn and compared."""
    profile = "thesis" if arguments.kept else arguments.profile
    judged = profile == "thesis"
    study = Study("ch6", "Two scales: a geosynthetic in soil of aluminium rods", arguments.out, profile, judged)
    runs = Runs(study.out, SIZES[profile])
    measure_shape(study, runs)
    measure_pullout(study, runs)
    study.expect(HERE / "statements.tsv", "Statements of §6.4 and §6.5")
    if arguments.kept:
        return study
    kept = None if judged else Runs(KEPT, SIZES["thesis"])
    if kept:
        study.kept(KEPT / "comparison.tsv")

    def say(name):
        return study.say(name, kept=not judged)

    whole, pressure = kept or runs, given("pullout.toml")["traction"][0]["y"].removeprefix("-")
    study.accept("shape_energy", "at most", 1, "%", "shape-forming: error of the energy balance over the work done")
    study.accept("pullout_energy", "at most", 1, "%", "pull-out: likewise")
    study.accept("pullout_mobilised", "within", 100, "%", "pull-out: friction of the interface that is mobilised, of all", tolerance=3)
    study.lead = (f"Explicit finite elements whose points are periodic packings of {whole.size.grains} disks, beside a chain of bars for the "
                  f"geosynthetic: a sheet that forms a square of soil without confinement, and one pulled out from under soil at {pressure}. "
                  "The thesis has curves and pictures, no numbers; its sentences are held against the runs.")
    study.headline = (f"The sheet begins to harden the square at {say('shape_onset')} of pull (the thesis: {study.published('shape_onset')}); in "
                      f"pull-out the rate at which friction is first mobilised grows with the speed, {say('pullout_rate')} times as in proportion.")
    draw(study, runs, kept)
    explain(study, whole, say)
    return study


if __name__ == "__main__":
    main(build)
