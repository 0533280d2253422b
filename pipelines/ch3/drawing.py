"""Figures of chapter 3: curves of this run; dashed, curves of the kept full-size run if this run is smaller; points of the record."""
# SPDX-License-Identifier: GPL-3.0-or-later
from study import Drawn, Series, figures, panel

from . import making
from .bag import GEOTEXTILES
from .shear import LARGE

COLOURS = figures.GEOTEXTILE
LOADS = dict(zip((1330, 1870, 2410, 12050, 24100, 36150), figures.SERIES, strict=True))  # N


def of_both(runs, kept):
    """Returns (runs, line, note) of the drawn curves: this run, and the kept full-size run if there is one."""
    return [(runs, "o-", ""), *([(kept, "--", "full size")] if kept else [])]


def draw_compressed(study, runs, kept):
    """Draws Figs. 3.7, 3.10, 3.12, 3.15 and 3.17, of the compressed bags."""
    bags = [Drawn(g, bag, COLOURS[g], line, note) for of, line, note in of_both(runs, kept) for g, bag in of.bags().items()]
    beside = bags + [Drawn(g, record, COLOURS[g], "o", "record") for g, record in runs.record.items()]
    states = [Drawn(d.name, d.of.recorded(), d.colour, d.line, d.note) for d in bags]
    study.curves("compression", panel("strain_axial", "plate_pressure", beside), panel("strain_axial", "axial_stress", beside))
    study.curves("paths", panel("mean_stress", "deviatoric_stress", beside), panel("strain_axial", "delaunay_void_ratio", beside))
    study.curves("yarns", panel("strain_axial", "tension_yarn_face", beside), panel("strain_axial", "broken_yarns", bags))
    study.curves("friction", panel("strain_axial", ("face_friction_z", "friction_sides"), [d for d in bags if d.name == "PE"],
                                   "mobilised friction angle (deg)"))
    study.curves("fabric", *(panel("strain_axial", name, states, ylim=(0, None)) for name in ("a_c", "a_n", "a_t")), width=11)


def draw_sheared(study, runs, kept):
    """Draws Figs. 3.8, 3.11, 3.16 and 3.18, of the sheared bags."""
    bags = {(load, note): Drawn(f"{load / 1000:g} kN", bag, LOADS[load], line, note)
            for of, line, note in of_both(runs, kept) for load, bag in of.sheared().items()}
    states = [Drawn(d.name, d.of.recorded(), d.colour, d.line, d.note) for d in bags.values()]
    study.curves("shear", *(panel("shear_strain", name, bags.values()) for name in ("shear_ratio", "soil_ratio")))
    study.curves("shear_paths", panel("mean_stress", "deviatoric_stress", [d for (load, _), d in bags.items() if load >= LARGE],
                                      xscale="log", yscale="log"))
    study.curves("shear_stresses", *(panel("shear_strain", f"{name}_stress", bags.values(), yscale="log") for name in ("lateral", "axial")))
    study.curves("shear_fabric", *(panel("shear_strain", name, states, ylim=(0, None)) for name in ("a_c", "a_n")))


def draw_shape(study, runs, _):
    """Draws Figs. 3.2 and 3.4."""
    figure, (histogram, rose) = figures.panels(2)
    for k, (name, words) in enumerate((("rv", "representative volume"), ("bag", "bag"), ("bag_soil", "bag, soil with soil"))):
        colour, table = figures.SERIES[k], runs.table(f"{name}_histogram")
        histogram.bar(table["contacts"] + 0.27 * (k - 1), 100 * table["grains"] / table["grains"].sum(), 0.25, color=colour, label=words)
        table = runs.table(f"{name}_rose")
        table = table.rows(table["plane"] == 0)
        rose.plot(table["angle"], table["density"], "o-", color=colour, label=words, linewidth=1.3, markersize=2.5)
    pure = ["contacts of a grain", "contacts over those of an isotropic packing"]
    figures.label(histogram, pure[0], "grains (%)", pure)
    histogram.set_xlim(-0.6, 10.6)
    figures.label(rose, "angle from the vertical (deg)", pure[1], pure)
    rose.set_ylim(bottom=0)
    for axes in (histogram, rose):
        axes.legend()
    study.figure("shape", figure)


class Growth(Series):
    """Growth of the grains in the bag, round by round."""

    derived = {"grown": ("%", "radii grown by", lambda s: 100 * (s.table("growth", "1") - 1))}


def draw_growth(study, runs, kept):
    """Draws the growth of the grains in the bag, §3.2.3."""
    grown = [Drawn("bag", Growth(of.table("generation")), figures.SERIES[k], line, note) for k, (of, line, note) in enumerate(of_both(runs, kept))]
    study.curves("growth", *(panel("grown", name, grown) for name in ("delaunay_void_ratio", "coordination_number")))


def draw_strip_and_box(study, runs, _):
    """Draws Figs. 3.3 and 3.5."""
    strips = [Drawn(g, making.Strip(runs.table(f"strip_{g}")), COLOURS[g], "o-") for g in GEOTEXTILES]
    boxes = {angle: runs.table(f"box_{angle}") for angle in making.FRICTION}
    boxes = [Drawn(f"{angle}° ({making.FRICTION[angle]})", making.Box(box.rows(box["stage"] > 0)), COLOURS[making.FRICTION[angle]], "o-")
             for angle, box in boxes.items()]  # after the dead load
    study.curves("strip", panel("strain", "tension", strips))
    study.curves("box", panel("displacement", "ratio", boxes))
