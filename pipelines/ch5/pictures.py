"""Figures of chapter 5's DEM runs: principal stresses in space, friction of the interface, lines, hoops."""
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy
from study import Drawn, figures, panel

from .grains import PRESSURES, UNIAXIAL, Copies
from .measures import HOOPS, failure, misfits, scales_of

COLOURS = figures.GEOTEXTILE
PLANES = {"z": "xy", "x": "yz", "y": "zx"}  # plane by the axis normal to it
AXES = ((3, figures.GREEN), (2, figures.BLUE))  # minor and medium stress, as the thesis colours them


def draw_directions(study, grains):
    """Draws Fig. 5.4: the copies of the bag of PP from above, where the soil is densest and at the greatest axial stress."""
    bag = grains.bag("PP")
    rows = int(bag["delaunay_void_ratio"].argmin()), bag.most("axial_stress")
    figure, axes = figures.panels(2, height=4.6)
    for a, row, words in zip(axes, rows, ("least void ratio", "greatest axial stress"), strict=True):
        copies = Copies(grains.volumes, bag["step"][row])
        x, y = copies.place("x"), copies.place("y")
        apart = numpy.ptp(x) / (copies.side - 1)
        greatest = copies.stress(1)
        a.scatter(x, y, s=900 / copies.side * greatest / greatest.max(), color=figures.RED, alpha=0.25, linewidths=0, label="σ₁, along z")
        for number, colour in AXES:
            half = 0.5 * apart * copies.stress(number) / copies.stress(2).max()
            east, north = half * copies.direction(number, "x"), half * copies.direction(number, "y")
            a.plot([x - east, x + east], [y - north, y + north], color=colour, linewidth=1.4)
            a.plot([], [], color=colour, label=f"σ{'₂₃'[number - 2]}")
        a.set(title=f"{words}, {bag['strain_axial'][row]:.0f} %: σ₁ to {greatest.max():.0f} kPa", aspect="equal")
        a.grid(False)
        figures.label(a, "x (mm)", "y (mm)")
    axes[0].legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=3)
    study.figure("directions", figure)


def draw_friction(study, grains):
    """Draws Fig. 5.5: bags solid, cells at the least lateral stress dashed."""
    bags, cells = grains.bags(), grains.cells()
    drawn = [Drawn(g, bags[g], COLOURS[g]) for g in ("PE", "PP") if g in bags]
    drawn += [Drawn(f"{g}, 10 kPa", cells[g, "10"], COLOURS[g], "--") for g in ("PE", "PP") if (g, "10") in cells]
    study.curves("friction", *(panel("strain_axial", f"face_friction_{axis}", drawn, label=f"friction on the {plane} plane (deg)",
                                     legend=axis == "z", ylim=(0, 15)) for axis, plane in PLANES.items()), width=11)


def draw_states(study, grains):
    """Draws Fig. 5.6: void ratio and stresses of the soil in the bags, and the failure-state line."""
    bags = [Drawn(g, bag, COLOURS[g]) for g, bag in grains.bags().items()]
    figure, axes = figures.panels(3, width=11)
    p = numpy.geomspace(2, max(d.of["mean_stress"].max() for d in bags), 100)
    for drawn in bags:
        bag, rows = drawn.of, slice(drawn.of.most("axial_stress") + 1)
        for a, x, y in zip(axes, ("mean_stress",) * 3, ("delaunay_void_ratio", "deviatoric_stress", "obliquity"), strict=True):
            a.plot(bag[x][rows], bag[y][rows], "o-", color=drawn.colour, linewidth=1.1, markersize=2, label=drawn.name)
    axes[1].plot(p, failure(grains, p) * p, "--", color=figures.INK, label="sand at failure")
    axes[2].plot(p, failure(grains, p), "--", color=figures.INK, label="sand at failure")
    axes[0].set_xscale("log")
    axes[2].set_xscale("log")
    axes[1].legend()
    for a, words in zip(axes, ("void ratio", "deviatoric stress q (kPa)", "q/p"), strict=True):
        figures.label(a, "mean stress p (kPa)", words, ["void ratio", "q/p"])
    study.figure("states", figure)


def draw_hoops(study, grains):
    """Draws Fig. 5.8: load and tension of both sets of hoops, each over its value in the bag of PP at the greatest load."""
    bags = grains.bags()
    figure, (axes,) = figures.panels(1)
    for g, bag in bags.items():
        rows = slice(1, bag.most("plate_pressure") + 1)
        for (kind, column), line in zip(HOOPS.items(), ("--", "-"), strict=True):
            load, tension = scales_of(grains, kind)
            scaled = bag[column][rows] / tension, bag["plate_pressure"][rows] / load
            axes.loglog(*scaled, line, color=COLOURS[g], linewidth=1.2, label=g if kind == "ha" else None)
    figures.label(axes, "tension over that of PP at its greatest load", "load over the greatest of PP",
                  ["tension over that of PP at its greatest load", "load over the greatest of PP"])
    axes.legend()
    study.figure("hoops", figure)


def scatter(axes, table, x, y):
    """Draws the points of a line, a colour for each bag."""
    for k, g in enumerate(UNIAXIAL):
        own = table("series", "1") == k
        axes.plot(x[own], y[own], "o", color=COLOURS[g], markersize=2.5, label=g)


def draw_own_lines(study, grains):
    """Draws Figs. 5.7, 5.10, 5.12 and 5.14 for these bags."""
    given = grains.solutions("constants")
    constant = {name: given(f"{name}_given", "1")[0] for name in ("C_t", "kappa", "lambda", "xi", "p_1", "p_2", "beta")}
    figure, axes = figures.panels(2, rows=2, height=7.6)
    pure = ["(p/pₐ)^0.3", "M_f − q/p", "M_f − M + dε_v^p/dε_d^p"]
    line = grains.own("near_failure_line")
    scatter(axes[0], line, line("strain_deviatoric", "%"), line("distance_to_failure", "1"))
    x = numpy.linspace(0, line("strain_deviatoric", "%").max(), 200)
    axes[0].plot(x, constant["kappa"] / (x + constant["lambda"]) - constant["xi"], color=figures.INK)
    figures.label(axes[0], "deviatoric strain (%)", pure[1], pure)
    line = grains.own("compression_line")
    x = (line("mean_stress", "kPa") / 100)**0.3
    scatter(axes[1], line, x, line("strain_volumetric", "%"))
    ends = numpy.array([x.min(), x.max()])
    axes[1].plot(ends, constant["C_t"] * (ends - (given("p_0_given", "kPa")[0] / 100)**0.3), color=figures.INK, label="Table 5.2")
    figures.label(axes[1], pure[0], "volumetric strain (%)", pure)
    line = grains.own("dilatancy_line")
    x = line("distance_to_failure", "1")
    scatter(axes[2], line, x, line("distance_of_dilation_rate", "1"))
    ends = numpy.array([0, x.max()])
    axes[2].plot(ends, constant["p_1"] * ends - constant["p_2"], color=figures.INK)
    axes[2].set_ylim(-0.6, 1)
    figures.label(axes[2], pure[1], pure[2], pure)
    line = grains.own("stiffness")
    scatter(axes[3], line, line("tensile_stiffness", "kN/m"), line("young_modulus", "MPa"))
    stiffness = numpy.geomspace(30, 1300, 50)
    axes[3].loglog(stiffness, given("alpha_given", "MPa")[0] * (stiffness / 1e3)**constant["beta"], color=figures.INK)
    figures.label(axes[3], "stiffness of the geotextile (kN/m)", "Young's modulus (MPa)")
    axes[1].legend()
    study.figure("own_lines", figure)


def draw_validity(study, grains):
    """Where the solution with Table 5.2 is off: greatest stresses and settlement over the stiffness, of bags and of cells."""
    found = misfits(grains, "")
    figure, axes = figures.panels(3, width=11)
    for name, a in zip(("capacity", "axial", "settlement"), axes, strict=True):
        for pressure, colour in zip((None, *PRESSURES), figures.SERIES, strict=False):
            some = [g for g in UNIAXIAL if (g, pressure) in found]
            stiffness = [grains.model("", g, pressure)("tensile_stiffness", "kN/m")[0] for g in some]
            words = "bags" if pressure is None else f"cells, {pressure} kPa"
            if some:
                a.semilogx(stiffness, [found[g, pressure][name] for g in some], "o-", color=colour, linewidth=1.1, markersize=3, label=words)
        a.axhline(0 if name == "settlement" else 1, color=figures.INK, linewidth=0.8)
    pure = ["ultimate surcharge, model over DEM", "greatest axial stress inside, model over DEM"]
    for a, words in zip(axes, (*pure, "final settlement, model less DEM (%)"), strict=True):
        figures.label(a, "stiffness of the geotextile (kN/m)", words, pure)
    axes[0].legend()
    study.figure("validity", figure)


OF_ALL = (draw_directions, draw_friction, draw_states, draw_hoops, draw_own_lines, draw_validity)
