"""Measures of chapter 5's DEM runs: bags compared with recorded series, with each other and with cells, and the model compared with all."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import itertools

import numpy
from ch3 import compression
from ch4.cells import least_rise
from study import NotMade

from .grains import PRESSURES, RECORDED, SHEARED, SOILS, UNIAXIAL, Copies, strength, there, vertical_hoop

# Measures of a bag that chapter 3 has, too.
BESIDE_RECORD = ("first_break", "peak_axial", "peak_strain", "peak_pressure", "peak_pressure_strain", "obliquity_ratio", "contraction",
                 "equal_tension_lateral", "equal_tension_axial", "equal_tension_pressure", "energy_error")
COMPARED_AT = 8  # % of strain at which stresses are compared
EARLY = 5  # % of axial strain, well before failure
OWN = ("C_t", "kappa", "lambda", "xi", "p_1", "p_2", "alpha", "beta")


def at_8(bag, name):
    """Returns a column of a bag at 8 % of axial strain."""
    return bag.where("strain_axial", COMPARED_AT, name)


def rises_after_failure(bag, name):
    """Returns the mean of a friction angle after the first break less its mean before."""
    bag.before_end(bag.broken, "the first break")
    return bag[name][bag.broken + 1:].mean() - bag[name][1:bag.broken + 1].mean()


OF_EACH_BAG = (
    ("ratio_at_8", "1", lambda b: at_8(b, "surcharge") / at_8(b, "axial_stress")),
    ("axial_at_8", "kPa", lambda b: at_8(b, "axial_stress")),
    ("settlement", "%", lambda b: b["strain_axial"][b.before_end(b.most("plate_pressure"), "the greatest load")]),
    ("friction_most", "deg", lambda b: max(b["friction_sides"][1:].max(), b["face_friction_z"][1:].max())),
    ("friction_flat_over_sides", "1", lambda b: b["face_friction_z"][1:].mean() / b["friction_sides"][1:].mean()),
    ("friction_rises", "deg", lambda b: rises_after_failure(b, "friction_sides")),
)


def measure_bags(study, grains):
    """Measures each bag, and its differences from its recorded series where there is one."""
    beside = [row for row in compression.OF_ONE_BAG if row[0] in BESIDE_RECORD]
    for g in RECORDED:
        study.measure_each([(f"uc_{name}", *rest) for name, *rest in beside], lambda g=g: (grains.bag(g), grains.record[g]), f"_{g}")
    for g in UNIAXIAL:
        study.measure_each([(f"uc_{name}", *rest) for name, *rest in OF_EACH_BAG], lambda g=g: (grains.bag(g),), f"_{g}")
        study.measure(f"uc_tension_at_peak_{g}", lambda g=g: tension_at_peak(grains.bag(g), g), "1")


def tension_at_peak(bag, geotextile):
    """Returns the mean tension of the faces' yarns at the greatest load over their strength."""
    row = bag.before_end(bag.most("plate_pressure"), "the greatest load")
    return bag["tension_yarn_face"][row] / strength(geotextile)


def hoops(load, tension, whole, scales):
    """Returns the slope of scaled tension over scaled load, through the origin, and the deviation, % of the tension at the greatest load.

    whole: how many rows come before the first break. scales: load and tension with PP at its greatest load.
    """
    x, y = load[:whole] / scales[0], tension[:whole] / scales[1]
    slope = (x * y).sum() / (x * x).sum()
    return slope, 100 * abs(y - slope * x).max() / (tension[load.argmax()] / scales[1])


HOOPS = {"hr": "hoop_vertical", "ha": "tension_yarn_side_around"}


def scales_of(grains, kind):
    """Returns load and tension of a set of hoops of the bag of PP at its greatest load."""
    middling = grains.bag("PP")
    row = middling.before_end(middling.most("plate_pressure"), "the greatest load")
    return middling["plate_pressure"][row], middling[HOOPS[kind]][row]


def scaled_hoops(grains, geotextile, kind):
    """Returns slope and deviation of a set of hoops of a bag, scaled to the bag of PP."""
    bag = grains.bag(geotextile)
    bag.before_end(bag.most("plate_pressure"), "the greatest load")
    return hoops(bag["plate_pressure"], bag[HOOPS[kind]], bag.broken, scales_of(grains, kind))


def recorded_hoops(grains, geotextile, kind):
    """Returns slope and deviation of a set of hoops in the record of a bag, scaled to the record of PP."""
    def tension(record):
        return vertical_hoop(record["tension_yarn_face"], record.table("tension_yarn_vertical", "N")) if kind == "hr" \
            else record["tension_yarn_side_around"]
    record, middling = grains.record[geotextile], grains.record["PP"]
    load = middling["plate_pressure"]
    scales = load.max(), tension(middling)[load.argmax()]
    return hoops(record["plate_pressure"], tension(record), record.whole.stop, scales)


def measure_hoops(study, grains):
    """Measures tension over load, Fig. 5.8."""
    for kind in HOOPS:
        for g in UNIAXIAL:
            study.measure(f"hoop_{kind}_{g}", lambda g=g, kind=kind: scaled_hoops(grains, g, kind)[0], "1")
            study.measure(f"hoop_{kind}_bends_{g}", lambda g=g, kind=kind: scaled_hoops(grains, g, kind)[1], "%")
        for g in RECORDED:
            slope, deviation = recorded_hoops(grains, g, kind)
            study.measure(f"recorded_hoop_{kind}_{g}", slope, "1")
            study.measure(f"recorded_hoop_{kind}_bends_{g}", deviation, "%")

        def fan(kind=kind):
            slopes = numpy.array([scaled_hoops(grains, g, kind)[0] for g in UNIAXIAL])
            return 100 * abs(slopes / slopes.mean() - 1).max()
        study.measure(f"hoop_{kind}_fans", fan, "%")


def measure_all_bags(study, grains):
    """Measures ratios of all bags to each other, and the constants identified from them."""
    value_of = {name: value for name, _, value in OF_EACH_BAG}

    def values(name, some=UNIAXIAL):
        return numpy.array([value_of[name](grains.bag(g)) for g in some])

    def spread(name):
        return values(name).max() / values(name).min() - 1
    study.measure("uc_ratio_spreads", lambda: 100 * spread("ratio_at_8"), "%")
    study.measure("uc_stress_spreads", lambda: 1 + spread("axial_at_8"), "1")
    study.measure("uc_settlement_falls", lambda: numpy.sum(numpy.diff(values("settlement", UNIAXIAL[1:])) < 0), "1")
    study.measure("uc_settlement_grows", lambda: numpy.ptp(values("settlement")), "%")
    for line, column, unit in (("compression_line", "strain_volumetric", "%"), ("near_failure_line", "distance_to_failure", "1")):
        study.measure(f"own_{line}", lambda line=line, column=column, unit=unit: determined(grains.own(line), column, unit), "1")
    for name in OWN:
        unit = "Pa" if name == "alpha" else "1"
        study.measure(f"own_{name}", lambda name=name, unit=unit: grains.own("constants")(name, unit)[0], unit)
    study.measure("own_kappa_strained", lambda: kappa_of_strained(grains.own("near_failure_line")), "1")
    for g in RECORDED:
        study.measure(f"uc_preload_obliquity_{g}", lambda g=g: grains.bag(g)["obliquity"][0], "1")
        study.measure(f"recorded_preload_obliquity_{g}", preload_obliquity(grains.record[g]), "1")


def preload_obliquity(record):
    """Returns q/p in the first row of a record, under the preload."""
    return record["deviatoric_stress"][0] / record["mean_stress"][0]


def kappa_of_strained(points):
    """Returns kappa of the near-failure line, M_f - q/p = kappa/(eps_d + lambda) - xi (thesis Eq. 5.4), without the states under the preload.

    Each lambda from 0.2 to 6 % in steps of 0.002 gives kappa and xi by linear least squares. The lambda of the least sum of squares is taken.
    """
    strained = points["strain_deviatoric"] > 0
    strain, distance = points("strain_deviatoric", "%")[strained], points("distance_to_failure", "1")[strained]

    def fit(offset):
        constants, squares, *_ = numpy.linalg.lstsq(numpy.column_stack((1 / (strain + offset), -numpy.ones_like(strain))), distance, rcond=None)
        return squares[0], constants[0]
    return min(fit(offset) for offset in numpy.arange(0.2, 6, 0.002))[1]


def determined(table, column, unit):
    """Returns R2 of a fitted line."""
    values = table(column, unit)
    return 1 - sum((values - table("fitted", unit))**2) / sum((values - values.mean())**2)


def measure_directions(study, grains):
    """Measures principal stresses in space, Fig. 5.4."""
    def states():
        bag = grains.bag("PP")
        known = set(grains.volumes["step"])
        rows = [k for k in range(1, len(bag)) if bag["step"][k] in known and k <= bag.peak]
        return bag, [Copies(grains.volumes, bag["step"][k]) for k in rows]

    def state(row):
        return Copies(grains.volumes, grains.bag("PP")["step"][row])

    def densest():
        return int(grains.bag("PP")["delaunay_void_ratio"].argmin())

    def strongest():
        return grains.bag("PP").most("axial_stress")
    study.measure("sigma_1_inclined", lambda: max(copies.inclination() for copies in states()[1]), "deg")
    study.measure("sigma_1_inwards", lambda: state(strongest()).inwards(), "1")
    study.measure("sigma_2_turn_densest", lambda: state(densest()).turn(), "deg")
    study.measure("sigma_2_turns", lambda: state(strongest()).turn() - state(densest()).turn(), "deg")


def slope_before_break(series, name):
    """Returns the slope of a friction angle over axial strain before the first break, deg per %."""
    rows = slice(1, max(series.broken, 3))
    return numpy.polyfit(series["strain_axial"][rows], series[name][rows], 1)[0]


def measure_cells(study, grains):
    """Compares the cells with each other and with the bags."""
    def not_rising(value):
        found = {key: value(grains.cell(*key)) for key in itertools.product(SHEARED, PRESSURES)}
        return sum(found[g, high] <= found[g, low] for g in SHEARED for low, high in itertools.pairwise(PRESSURES))
    study.measure("cell_capacity_falls", lambda: not_rising(lambda c: c.capacity), "1")
    study.measure("cell_settlement_falls", lambda: not_rising(lambda c: c["strain_axial"][c.peak]), "1")
    study.measure("cell_spread_falls", lambda: least_rise(
        [-grains.cell(g, "100").capacity / grains.cell(g, "10").capacity for g in SHEARED]), "1")
    study.measure("cell_first_slope_least", lambda: min(c.path_slopes[0] for c in every_cell(grains)), "1")
    study.measure("cell_first_slope_most", lambda: max(c.path_slopes[0] for c in every_cell(grains)), "1")
    study.measure("cell_dilation_spreads", lambda: 100 * relative_range([c.dilation for c in every_cell(grains)]), "%")
    study.measure("cell_confinement", lambda: added_confinement(grains.cell("PE", "100")) / added_confinement(grains.cell("PP", "100")), "1")
    for g in ("PE", "PP"):
        study.measure(f"friction_grows_{g}", lambda g=g: slope_before_break(grains.cell(g, "10"), "face_friction_x")
                      - slope_before_break(grains.bag(g), "face_friction_x"), "deg")
    study.measure("cell_friction_most", lambda: max(
        max(grains.cell(g, "10")[f"face_friction_{axis}"].max() for axis in "xyz") for g in ("PE", "PP")), "deg")
    study.measure("cell_near_failure", lambda: max(near_failure(grains, g, p) for g in SHEARED for p in PRESSURES), "1")
    for g, p in itertools.product(SHEARED, PRESSURES):
        study.measure(f"cell_peak_{g}_{p}", lambda g=g, p=p: grains.cell(g, p).capacity, "kPa")


def every_cell(grains):
    """Returns all nine cells."""
    return [grains.cell(g, p) for g in SHEARED for p in PRESSURES]


def relative_range(values):
    """Returns the greatest less the least value over the size of their mean."""
    return numpy.ptp(values) / abs(numpy.mean(values))


def added_confinement(cell):
    """Returns the greatest lateral stress in the soil less that of the cell, kPa."""
    return (cell["radial_stress"] - cell.table("lateral_stress", "kPa")).max()


def near_failure(grains, geotextile, pressure):
    """Compares the distance to failure of a cell and of the bag with the same geotextile at 8 % of deviatoric strain.

    Returns the difference. The distance is the failure-state line, which falls with the mean stress, less q/p.
    """
    cell, bag = grains.cell(geotextile, pressure), grains.bag(geotextile)
    distances = []
    for series in (cell, bag):
        p, ratio = (series.where("strain_deviatoric", COMPARED_AT, name) for name in ("mean_stress", "obliquity"))
        distances.append(failure(grains, p) - ratio)
    return abs(distances[0] - distances[1])


def failure(grains, p):
    """Returns q/p at failure under a mean stress (kPa), of Table 5.2."""
    table = grains.solutions("constants")
    n, p_c = table("n_given", "1")[0], table("p_c_given", "kPa")[0]
    return 1.35 * (p / p_c)**-n


def misfit(model, run):
    """Returns the differences of the model from a run, up to the run's greatest surcharge, as numbers by name.

    capacity, axial, lateral: the model's greatest values over the run's. early: its surcharge over the run's at EARLY. settlement, volumetric:
    difference in % at the end. rms_...: root mean square of the differences at equal axial strain, % of the run's greatest value.
    """
    rows = slice(run.peak + 1)
    strain = run["strain_axial"][rows]
    columns = {"surcharge": "surcharge", "axial": "axial_stress", "lateral": "radial_stress"}
    found = {"capacity": model("surcharge", "kPa").max() / run["surcharge"].max(),
             "axial": model("axial_stress", "kPa").max() / run["axial_stress"].max(),
             "lateral": model("radial_stress", "kPa").max() / run["radial_stress"].max(),
             "early": numpy.interp(EARLY, model("strain_axial", "%"), model("surcharge", "kPa")) / run.where("strain_axial", EARLY, "surcharge"),
             "settlement": model("strain_axial", "%")[-1] - strain[-1],
             "volumetric": model("strain_volumetric", "%")[-1] - run["strain_volumetric"][run.peak]}
    for name, column in columns.items():
        theirs = run[column][rows]
        inside = strain <= model("strain_axial", "%")[-1]
        difference = numpy.interp(strain[inside], model("strain_axial", "%"), model(column, "kPa")) - theirs[inside]
        found[f"rms_{name}"] = 100 * numpy.sqrt(numpy.mean(difference**2)) / theirs.max()
    return found


@functools.cache
def misfits(grains, soil):
    """Returns the misfits of the runs that there are, by (geotextile, lateral stress or None). soil: one of SOILS."""
    runs = {(g, None): bag for g, bag in grains.bags().items()} | grains.cells()
    return there({(g, p): lambda g=g, p=p, run=run: misfit(grains.model(soil, g, p), run) for (g, p), run in runs.items()})


MISFITS = ("capacity", "axial", "lateral", "early", "settlement", "volumetric", "rms_surcharge", "rms_axial", "rms_lateral")
HEADS = ("ultimate surcharge, model over DEM", "axial stress inside, model over DEM", "lateral stress inside, model over DEM",
         f"surcharge at {EARLY} % of axial strain, model over DEM", "final settlement, model less DEM (%)",
         "volumetric strain at the end, model less DEM (%)",
         "surcharge, RMS difference over the greatest (%)", "axial stress inside, RMS difference over the greatest (%)",
         "lateral stress inside, RMS difference over the greatest (%)")


def table_of_misfits(grains):
    """Returns the misfits of all runs and both soils as columns of words and numbers."""
    rows = [(soil, key) for soil in SOILS for key in misfits(grains, soil)]
    columns = {"constants of the model": [SOILS[soil] for soil, _ in rows], "geotextile": [g for _, (g, _) in rows],
               "lateral stress (kPa)": [p or "0, bag" for _, (_, p) in rows]}
    for name, head in zip(MISFITS, HEADS, strict=True):
        columns[head] = [f"{misfits(grains, soil)[key][name]:.3g}" for soil, key in rows]
    return columns


def measure_model(study, grains):
    """Compares the model, with the constants of Table 5.2, with the cells and the bags."""
    def of(name, some=SHEARED):
        found = misfits(grains, "")
        missing = [key for key in itertools.product(some, PRESSURES) if key not in found]
        if missing:
            raise NotMade(f"cell_{'_'.join(missing[0])}kPa: this profile makes no run past the greatest stress")
        return numpy.array([[found[g, p][name] for p in PRESSURES] for g in some])

    def bags(name):
        found = misfits(grains, "")
        if any((g, None) not in found for g in UNIAXIAL):
            raise NotMade("not all seven bags are there")
        return numpy.array([found[g, None][name] for g in UNIAXIAL])
    study.measure("model_settlement", lambda: max(of("settlement").flat, key=abs), "%")
    study.measure("model_over_cell", lambda: of("capacity").min(), "1")
    study.measure("model_over_cell_rises", lambda: least_rise(of("capacity").mean(axis=1)), "1")
    study.measure("model_inside", lambda: max((abs(of(name) - 1) - abs(of("capacity") - 1)).max() for name in ("axial", "lateral")), "1")
    study.measure("model_inside_rises", lambda: min(least_rise(of(name).mean(axis=1)) for name in ("axial", "lateral")), "1")

    def best(name):
        rms = of(name).mean(axis=1)
        return rms[-1] - rms[:-1].min()
    study.measure("model_best_5PP", lambda: max(best("rms_axial"), best("rms_lateral")), "%")
    study.measure("model_contracts", lambda: least_rise(of("volumetric").mean(axis=1)), "%")
    study.measure("model_bags_over", lambda: bags("capacity").min(), "1")
    study.measure("model_bags_most", lambda: bags("capacity").max(), "1")
    study.measure("model_bags_settlement", lambda: max(bags("settlement"), key=abs), "%")
    study.measure("model_bags_axial", lambda: bags("rms_axial").max(), "%")
    study.measure("model_bags_lateral", lambda: bags("rms_lateral").max(), "%")


MEASURES = (measure_bags, measure_hoops, measure_all_bags, measure_directions, measure_cells, measure_model)
