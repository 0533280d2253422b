"""Curves of chapter 3: of this run, of the kept one at full size where that is another (dashed), and points of the record."""
# SPDX-License-Identifier: GPL-3.0-or-later
from study import figures

from . import compression, making
from .bag import GEOTEXTILES
from .shear import LARGE

COLOURS = figures.GEOTEXTILE
LOADS = dict(zip((1330, 1870, 2410, 12050, 24100, 36150), figures.SERIES, strict=True))  # N
THIN = {"markersize": 2.5, "linewidth": 1.3}
RECORDED = {"delaunay_void_ratio": "void_ratio"}


def of_both(runs, kept):
    """Returns (runs, style, words) of what is drawn as curves: this run, and the kept one where that is another."""
    return [(runs, "o-", ""), *([(kept, "--", ", full size")] if kept else [])]


def column(series, name):
    """Returns a column as figures show it: strains in per cent."""
    return series[name] * (100 if name.startswith("strain") else 1)


def compressed(axes, runs, kept, x, y, recorded=True):
    """Draws a column over another one of the compressed bags and, where it was, as recorded."""
    for of, style, words in of_both(runs, kept):
        for g, bag in of.bags().items():
            axes.plot(column(bag, x), column(bag, y), style, color=COLOURS[g], label=g + words, **THIN)
    for g, record in runs.record.items() if recorded else ():
        figures.points(axes, column(record, x), column(record, RECORDED.get(y, y)), COLOURS[g], f"{g}, record")
    axes.legend()


def sheared(axes, runs, kept, x, y, least=0):
    """Draws what y(bag) returns over what x(bag) returns of the sheared bags under loads from the least on."""
    for of, style, words in of_both(runs, kept):
        for load, bag in of.sheared().items():
            if load >= least:
                axes.plot(x(bag), y(bag), style, color=LOADS[load], label=f"{load / 1000:g} kN{words}", **THIN)
    axes.legend()


def shear_strain(bag):
    """Returns the shear displacement in per cent of the height of the bag."""
    return 100 * bag["shear_displacement"] / bag["reference_height"]


def draw_compression(study, runs, kept):
    """Fig. 3.7."""
    figure, (load, stress) = figures.panels(2)
    compressed(load, runs, kept, "strain_axial", "plate_pressure")
    figures.label(load, "axial strain (%)", "load over the area of the bag (kPa)")
    compressed(stress, runs, kept, "strain_axial", "axial_stress")
    figures.label(stress, "axial strain (%)", "axial stress in the soil (kPa)")
    study.figure("compression", figure, "Uniaxial compression of bags of PE and PP. Points: recorded series of the same model.", "Fig. 3.7",
                 "the axial stress in the soil constantly exceeds that on the bag, and falls gently after failure.",
                 ["axial_over_surcharge_PE", "axial_over_surcharge_PP", "failure_strain_PE", "left_axial_PE"])


def draw_shape(study, runs, _):
    """Figs. 3.2 and 3.4."""
    figure, (histogram, rose) = figures.panels(2)
    for k, (name, words) in enumerate((("rv", "representative volume"), ("bag", "bag"), ("bag_soil", "bag, soil with soil"))):
        colour, table = figures.SERIES[k], runs.table(f"{name}_histogram")
        grains = table("grains", "1")
        histogram.bar(table("contacts", "1") + 0.27 * (k - 1), 100 * grains / grains.sum(), 0.25, color=colour, label=words)
        table = runs.table(f"{name}_rose")
        table = table.rows(table("plane", "1") == 0)
        rose.plot(table("angle", "deg"), table("density", "1"), "o-", color=colour, label=words, **THIN)
    pure = ["contacts of a grain", "contacts over those of an isotropic packing"]
    figures.label(histogram, pure[0], "grains (%)", pure)
    histogram.set_xlim(-0.6, 10.6)
    figures.label(rose, "angle from the vertical (deg)", pure[1], pure)
    rose.set_ylim(bottom=0)
    for axes in (histogram, rose):
        axes.legend()
    study.figure("shape", figure, "Grains by their number of contacts, and contacts by their angle from the vertical: the bag as it is "
                 "made and its representative volume.", "Figs. 3.2 and 3.4", "contact orientations and contact numbers of the bag have the "
                 "shapes of those of the representative volume.", ["contact_number", "orientation", "soil_contact_number", "soil_orientation"])


def draw_growth(study, runs, kept):
    """How the grains grew in the bag, §3.2.3."""
    figure, (void, coordination) = figures.panels(2)
    for k, (of, style, words) in enumerate(of_both(runs, kept)):
        table = of.table("generation")
        for axes, name in ((void, "delaunay_void_ratio"), (coordination, "coordination_number")):
            axes.plot(100 * (table("growth", "1") - 1), table(name, "1"), style, color=figures.SERIES[k], label=f"bag{words}", **THIN)
    pure = ["void ratio", "coordination number"]
    for axes, words in ((void, pure[0]), (coordination, pure[1])):
        figures.label(axes, "radii grown by (%)", words, pure)
        axes.legend()
    study.figure("growth", figure, "Growth of the grains in the bag: friction is lowered and the grains relieved until void ratio and "
                 "coordination number are met.", "§3.2.3", "the bag has a slightly smaller coordination number than the representative volume.",
                 ["delaunay_void_ratio", "coordination_number", "spheres"])


def draw_strip(study, runs, _):
    """Fig. 3.3."""
    figure, (axes,) = figures.panels(1, width=6.4)
    yarns, length = making.strip_size()
    for g in GEOTEXTILES:
        strip = runs.table(f"strip_{g}")
        strain = 100 * strip("displacement_right_y", "mm") / length
        axes.plot(strain, abs(strip("force_right_y", "N")) / yarns, "o-", color=COLOURS[g], label=g, **THIN)
    figures.label(axes, "strain (%)", "tension of a yarn (N)")
    axes.legend()
    study.figure("strip", figure, "Wide-width tension of a strip with unloading and reloading.", "Fig. 3.3", "yarns bear what tests of the "
                 "fabric gave.", ["strip_stiffness_PE", "strip_stiffness_PP"])


def draw_box(study, runs, _):
    """Fig. 3.5."""
    figure, (axes,) = figures.panels(1, width=6.4)
    for angle, g in zip(making.FRICTION, ("PP", "PE"), strict=True):
        box = making.sheared(runs.table(f"box_{angle}"))
        shear, normal = making.held_back(box)
        axes.plot(box("displacement_left_x", "mm"), shear / normal, "o-", color=COLOURS[g], label=f"{angle}° ({g})", **THIN)
    ratio = "shear over normal force"
    figures.label(axes, "displacement (mm)", ratio, pure=[ratio])
    axes.legend()
    study.figure("box", figure, "Shear box on a fixed sheet, for two friction angles between nodes and soil. Grains catch between nodes, so "
                 "that the interface carries more than either.", "Fig. 3.5", "friction of the nodes sets that of the interface.", ["box_friction_rises"])


def draw_shear(study, runs, kept):
    """Fig. 3.8."""
    figure, (plates, soil) = figures.panels(2)
    sheared(plates, runs, kept, shear_strain, lambda bag: abs(bag["plate_ratio"]))
    sheared(soil, runs, kept, shear_strain, lambda bag: abs(bag["shear_stress"]) / bag["axial_stress"])
    ratios = ["shear over normal force of the plates", "shear over axial stress in the soil"]
    for axes, words in zip((plates, soil), ratios, strict=True):
        figures.label(axes, "shear displacement over height (%)", words, ratios)
    study.figure("shear", figure, "Simple shear of bags of PP under dead loads.", "Fig. 3.8", "stress ratios fall with the load; that in the "
                 "soil falls progressively behind that of the plates; the bag first grows thinner, then thicker.",
                 ["shear_ratio_falls", "shear_lag", "shear_lag_grows", "shear_contraction", "shear_dilation", "shear_unrest"])


def draw_paths(study, runs, kept):
    """Fig. 3.10."""
    figure, (path, volume) = figures.panels(2)
    compressed(path, runs, kept, "mean_stress", "deviatoric_stress")
    figures.label(path, "p (kPa)", "q (kPa)")
    compressed(volume, runs, kept, "strain_axial", "delaunay_void_ratio")
    figures.label(volume, "axial strain (%)", "void ratio", pure=["void ratio"])
    study.figure("paths", figure, "Stress paths and void ratio under compression.", "Fig. 3.10", "stress paths are linear until yarns break, "
                 "less steep for the stronger geotextile; soil in PE contracts, then dilates; soil in PP contracts until yarns break.",
                 ["path_slope_PE", "path_slope_PP", "path_deviation_PE", "groups_deviation_PE", "obliquity_PP_over_PE", "contraction_PE",
                  "contraction_PP", "void_ratio_at_break_PE", "void_ratio_at_break_PP"])


def draw_shear_paths(study, runs, kept):
    """Fig. 3.11."""
    figure, (axes,) = figures.panels(1, width=6.4)
    sheared(axes, runs, kept, lambda bag: bag["mean_stress"], lambda bag: bag["deviatoric_stress"], LARGE)
    axes.set(xscale="log", yscale="log")
    figures.label(axes, "p (kPa)", "q (kPa)")
    study.figure("shear_paths", figure, "Stress paths under shear.", "Fig. 3.11", "the path nears the critical state line of the bag, then "
                 "leaves it; soil in the middle unloads, soil at the edges is compressed.", ["shear_path_nears", "shear_path_leaves",
                                                                                              "shear_slope_falls", "shear_middle_p", "shear_edge_p"])


def draw_yarns(study, runs, kept):
    """Tension of yarns, of which Figs. 3.12 and 3.13 show pictures, and their breaks."""
    figure, (tension, broken) = figures.panels(2)
    compressed(tension, runs, kept, "strain_axial", "tension_yarn_face")
    figures.label(tension, "axial strain (%)", "tension of yarns on the faces (N)")
    compressed(broken, runs, kept, "strain_axial", "broken_yarns", recorded=False)
    figures.label(broken, "axial strain (%)", "broken yarns", pure=["broken yarns"])
    study.figure("yarns", figure, "Mean tension of the yarns on the faces, and how many are broken.", "Fig. 3.12", "stress is concentrated in "
                 "the middle until failure, and uniform at the end; yarns on the faces carry more than those on the sides.",
                 ["first_break_PE", "first_break_PP", "middle_at_peak_PE", "middle_evens_out_PE", "tension_families_PE", "hoop_over_side_PE"])


def draw_friction(study, runs, kept):
    """Fig. 3.15."""
    figure, (axes,) = figures.panels(1, width=6.4)
    for of, style, words in of_both(runs, kept):
        bag = of.bag("uc_PE")
        for k, (angle, where) in enumerate(((bag["face_friction_z"], "upper and lower face"), (compression.sides(bag), "sides"))):
            axes.plot(column(bag, "strain_axial"), angle, style, color=figures.SERIES[k], label=where + words, **THIN)
    figures.label(axes, "axial strain (%)", "mobilised friction angle (deg)")
    axes.legend()
    study.figure("friction", figure, "Friction mobilised between soil and geotextile in the bag of PE.", "Fig. 3.15", "before failure friction "
                 "develops on the upper and lower face only; it then rises abruptly, and stays considerably below its strength.",
                 ["face_friction_PE", "face_friction_z_over_sides_PE", "face_friction_z_rises_PE", "face_friction_sides_rises_PE"])


def draw_shear_stresses(study, runs, kept):
    """Fig. 3.16."""
    figure, axes = figures.panels(2)
    for a, name, words in zip(axes, ("lateral_stress", "axial_stress"), ("lateral stress (kPa)", "axial stress (kPa)"), strict=True):
        sheared(a, runs, kept, shear_strain, lambda bag, name=name: bag[name])
        a.set_yscale("log")
        figures.label(a, "shear displacement over height (%)", words)
    study.figure("shear_stresses", figure, "Stresses in the soil under shear.", "Fig. 3.16", "lateral stresses nearly double, the axial stress "
                 "rises, shear stress has no peak.", ["shear_lateral", "shear_axial", "shear_softening"])


def draw_fabric(study, runs, kept):
    """Fig. 3.17."""
    figure, axes = figures.panels(3, width=11)
    for a, name in zip(axes, ("a_c", "a_n", "a_t"), strict=True):
        for of, style, words in of_both(runs, kept):
            for g, bag in of.bags().items():
                rows, values = bag.recorded_fabric(name)
                a.plot(column(bag, "strain_axial")[rows], values, style, color=COLOURS[g], label=g + words, **THIN)
        figures.label(a, "axial strain (%)", name, pure=[name])
        a.set_ylim(bottom=0)
        a.legend()
    study.figure("fabric", figure, "Anisotropies of contact orientation, normal and tangential forces under compression.", "Fig. 3.17",
                 "those of forces fall, that of orientation rises until yarns break and falls later; all are lower for the stronger geotextile.",
                 ["anisotropy_c_rises_PE", "anisotropy_c_stagnates_PE", "anisotropy_c_falls_later_PE", "anisotropy_n_falls_PE",
                  "anisotropy_t_falls_PE", "anisotropy_c_PP_over_PE"])


def draw_shear_fabric(study, runs, kept):
    """Fig. 3.18."""
    figure, axes = figures.panels(2)
    for a, name in zip(axes, ("a_c", "a_n"), strict=True):
        sheared(a, runs, kept, lambda bag, name=name: shear_strain(bag)[bag.recorded_fabric(name)[0]],
                lambda bag, name=name: bag.recorded_fabric(name)[1])
        figures.label(a, "shear displacement over height (%)", name, pure=[name])
        a.set_ylim(bottom=0)
    study.figure("shear_fabric", figure, "Anisotropies of contact orientation and normal forces under shear, at the states recorded.",
                 "Fig. 3.18", "that of normal forces falls from phase transformation on; that of orientation ends lower under a greater load.",
                 ["shear_normal_falls", "shear_critical_c_falls"])
