#!/usr/bin/env python3
"""Chapter 6: a geosynthetic that forms a square of soil, and one pulled out from under it (thesis Figs. 6.2 to 6.6)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import tomllib

import numpy
from ch6.runs import SIZES, Runs, label, speed, spread
from matplotlib.collections import LineCollection, PolyCollection
from study import Drawn, Study, figures, main, panel

HERE = pathlib.Path(__file__).parent
KEPT = HERE / "kept"
# Column, unit that it is drawn in, name on the page.
FIELDS = (("mean_stress", "kPa", "p (kPa)"), ("deviatoric_stress", "kPa", "q (kPa)"), ("strain_shear", "%", "ε_q (%)"),
          ("rotation", "rad", "rotation of the rods (rad)"), ("anisotropy", "1", "F_a"), ("strain_volumetric", "%", "ε_v (%)"))
EMPTY = "#d5d8dc"  # points without contacts, which have no fabric


def given(name):
    """Returns the numbers of a scenario."""
    return tomllib.loads((HERE / name).read_text(encoding="utf-8"))


def measure_shape(study, runs):
    """Measures shape-forming: stresses at the bottom, point A under the top, the last state."""
    curves, main_run = {c: runs.curve("shape", c) for c in runs.size.cases}, runs.curve("shape")
    coarsest, finest = (curves[runs.size.meshes[k]] for k in (0, -1))
    study.measure("shape_mesh_spread", spread([curves[c] for c in runs.size.meshes], 6), "1")
    study.measure("shape_speed_spread", spread([curves[c] for c in runs.size.speeds], 6), "1")
    study.measure("shape_onset", main_run.onset, "cm")
    study.measure("shape_onset_delay", lambda: finest.onset() - coarsest.onset(), "cm")
    a = runs.history("shape")
    study.measure("A_obliquity_first", lambda: a.obliquity(a.until(main_run.onset())), "1")
    study.measure("A_obliquity_falls", lambda: 100 * (1 - a.obliquity(a.part(0.9, 1)) / a.obliquity(a.until(main_run.onset()))), "%")
    study.measure("A_dilation", -a["volumetric"].min(), "%")
    study.measure("A_contracts_from", a["pull"][a.loosest], "cm")
    study.measure("A_obliquity_dilating", lambda: a.obliquity(a.dilating), "1")
    study.measure("A_contraction", a["volumetric"][-1] - a["volumetric"].min(), "%")
    study.measure("A_anisotropy_end", a["anisotropy"][a.part(0.9, 1)].mean(), "1")
    field = runs.field("shape")
    top = field.corners_at(field.side) > 0
    study.measure("shape_top_shear", field.mean("strain_shear", "1", top) / field.mean("strain_shear", "1", ~top), "1")
    study.measure("shape_asymmetry", field.asymmetry(), "%")
    study.measure("shape_energy", runs.balance("shape"), "%")


def measure_pullout(study, runs):
    """Measures the pull-out: mobilised friction, the last state, point B above the sheet."""
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
    study.measure("B_q_rises", b["q"][last].mean() / max(b["q"][0], 1e-3), "1")
    study.measure("B_q_change", 100 * abs(1 - b["q"][middle].mean() / b["q"][last].mean()), "%")
    study.measure("B_F_rises", b["anisotropy"][last].mean() - b["anisotropy"][0], "1")
    study.measure("B_F_change", 100 * abs(1 - b["anisotropy"][middle].mean() / b["anisotropy"][last].mean()), "%")
    study.measure("B_volumetric", b["volumetric"][b.part(0.95, 1)].mean(), "%")
    side, corner = field.along(2), field.along(1)
    study.measure("along_volumetric_side", field.mean("strain_volumetric", "%", side), "%")
    study.measure("along_volumetric_corner", field.mean("strain_volumetric", "%", corner), "%")
    study.measure("along_deviatoric_ratio", field.mean("deviatoric_stress", "kPa", side) / field.mean("deviatoric_stress", "kPa", corner), "1")
    study.measure("pullout_energy", runs.balance("pullout"), "%")


def draw_field(field):
    """Returns Fig. 6.3 or 6.4: six quantities of the points, how the nodes have moved, and the sheet."""
    figure, axes = figures.panels(3, rows=2, width=10.5, height=6.2)
    line = numpy.stack([field.bars("x_0", "m"), field.bars("y_0", "m")], axis=1)
    tension = field.bars("tension_ratio", "1")
    low = numpy.minimum(field.position.min(axis=0), 0) - 0.08
    high = field.position.max(axis=0) + 0.08
    for a, (name, unit, title) in zip(axes, FIELDS, strict=True):
        values = field.points(name, unit)
        if name == "anisotropy":
            values = numpy.ma.masked_less(values, 0)
        soil = PolyCollection(field.position[field.corners], array=values, cmap="viridis", edgecolor="face", linewidth=0.3)
        soil.cmap.set_bad(EMPTY)
        soil.set_clim(0 if name == "anisotropy" else None, None)
        a.add_collection(soil)
        if name == "deviatoric_stress":
            # The sheet is drawn thicker where it carries more of its strength.
            widths = 0.8 + 2.2 * tension[:-1].clip(0) / max(tension.max(), 1e-12)
            a.add_collection(LineCollection(numpy.stack([line[:-1], line[1:]], axis=1), colors=figures.ORANGE, linewidths=widths))
        else:
            a.plot(*line.T, color=figures.ORANGE, linewidth=0.8)
        figure.colorbar(soil, ax=a, shrink=0.85)
        a.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), aspect="equal", title=title)
        a.title.set_fontsize(10)
        a.grid(False)
        figures.label(a, "x (m)", "y (m)")
    moved = field.magnified * field.displacement
    axes[0].quiver(*field.start.T, *moved.T, angles="xy", scale_units="xy", scale=1, width=0.007, color="white", zorder=3)
    return figure


def responses(runs, kept, example):
    """Returns the curves of all runs. If there are kept full-size runs, returns theirs, and this run's main curve, dashed."""
    whole = kept or runs
    drawn = [Drawn(label(case), whole.curve(example, case), colour) for case, colour in zip(whole.size.cases, figures.SERIES, strict=False)]
    return drawn + ([Drawn(f"this run: {label(runs.size.main)}", runs.curve(example), figures.GREY, "--")] if kept else [])


def histories(runs, kept, example):
    """Returns a point's histories: at full size solid, of a smaller run dashed."""
    own = Drawn(str(runs.size), runs.history(example), figures.GREY if kept else figures.BLUE, "--" if kept else "-")
    return ([Drawn(str(kept.size), kept.history(example), figures.BLUE)] if kept else []) + [own]


def draw(study, runs, kept):
    """Draws each figure of the thesis at full size. A smaller run is dashed in it, or has its own figure below."""
    study.curves("curves", *(panel("pull_end", name, responses(runs, kept, example), xlim=(0, 25), ylim=(0, None))
                             for example, name in (("shape", "traction_y_bottom"), ("pullout", "interface_friction"))))
    for example, point in (("shape", "A"), ("pullout", "B")):
        study.figure(f"{example}_fields", draw_field((kept or runs).field(example)))
        if kept:
            study.figure(f"{example}_fields_here", draw_field(runs.field(example)))
        study.curves(point, *(panel(x, y, histories(runs, kept, example), legend=y == "q") for x, y in (
            ("shear", "obliquity"), ("shear", "volumetric"), ("p", "q"), ("shear", "touching"))), columns=2)


def build(arguments):
    """Reads the tables of fem-dem in the folder OUT and writes what was measured, drawn and compared."""
    study = Study.of(HERE, arguments, judged=arguments.profile == "thesis")
    runs = Runs(study.out, SIZES[study.profile])
    measure_shape(study, runs)
    measure_pullout(study, runs)
    if not arguments.kept:
        kept = None if study.judged else Runs(KEPT, SIZES["thesis"])
        whole = kept or runs
        field, pullout = whole.field("pullout"), given("pullout.toml")
        side, corner = (field.mean("deviatoric_stress", "kPa", field.along(corners)) for corners in (2, 1))
        study.tell(runs=runs, whole=whole, carried=f"{side / corner:.2g}", pressure=pullout["traction"][0]["y"].removeprefix("-"),
                   damping=pullout["soil"]["damping"], damping_of_thesis=given("shape.toml")["soil"]["damping"])
        draw(study, runs, kept)
    return study


if __name__ == "__main__":
    main(build)
