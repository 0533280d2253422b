"""Uniaxial compression of the bags of PE and PP: measures of one bag beside its record, and of both beside each other."""
# SPDX-License-Identifier: GPL-3.0-or-later
import itertools

import numpy
from study import NotMade

from .bag import GEOTEXTILES

AT_FIRST, BEFORE, AT_PEAK, AFTER = 0.04, 0.08, 0.12, 0.19  # axial strains of recorded states: the last one is beyond AFTER


def first_break(bag, _):
    """Returns the axial strain (%) at which the first yarn broke."""
    strain = bag.last("first_break_strain")
    if numpy.isnan(strain):
        raise NotMade(f"no yarn breaks before {100 * bag.last('strain_axial'):.0f} %")
    return 100 * strain


def peak(bag, name):
    """Returns the row of the greatest value of a column, which has to come before the last row."""
    return bag.before_end(bag.most(name), f"the greatest {name.replace('_', ' ')}")


def left_over(bag, record, name):
    """Returns what is left of a stress after failure, of its greatest, over the same of the record, where the shorter one ends."""
    bag.before_end(bag.failed, "failure")
    end = min(bag.last("strain_axial"), record.last("strain_axial"))
    own, recorded = (series.where("strain_axial", end, name) / series[name].max() for series in (bag, record))
    return own / recorded


def obliquity_ratio(bag, record, strain):
    """Returns q/p over the recorded one at an axial strain."""
    recorded = [record.where("strain_axial", strain, name) for name in ("deviatoric_stress", "mean_stress")]
    return bag.where("strain_axial", strain, "obliquity") / (recorded[0] / recorded[1])


def whole(record):
    """Returns how many rows of a record come before a yarn has broken."""
    springs = record["intact_springs"]
    return int((springs == springs.max()).sum())


def slope(p, q):
    """Returns the slope of the line through the origin that is nearest to a path in p and q."""
    return (p * q).sum() / (p * p).sum()


def densest(bag):
    """Returns the row of the least void ratio."""
    return int(bag["delaunay_void_ratio"].argmin())


def dilation(bag, _):
    """Returns the growth of the void ratio from its least to that at 12 %."""
    return bag.where("strain_axial", AT_PEAK, "delaunay_void_ratio") - bag["delaunay_void_ratio"][densest(bag)]


def side_share(bag, strain):
    """Returns how much of what the faces' yarns stretch those do that run around the sides."""
    side, face = (bag.where("strain_axial", strain, name) for name in ("strain_yarn_side_around", "strain_yarn_face"))
    return side / face


def evens_out(bag, _):
    """Returns by how much p of the middle groups over that of the outer ones changes from 12 % to the end."""
    end = last_state(bag)
    return bag.middle_over_edge("mean_stress", end) - bag.middle_over_edge("mean_stress", bag.step_at(AT_PEAK))


def last_state(bag):
    """Returns the step of the last state, which has to be well after the greatest load."""
    if bag.last("strain_axial") <= AFTER:
        raise NotMade(f"the bag is compressed by {100 * bag.last('strain_axial'):.0f} % only")
    return bag.last("step")


def anisotropy(bag, name, strain):
    """Returns an anisotropy of the state recorded at an axial strain."""
    return bag.fabric(name, bag.step_at(strain))


def change(bag, name, start, end):
    """Returns by how much an anisotropy changes from one axial strain to another."""
    return anisotropy(bag, name, end) - anisotropy(bag, name, start)


def sides(bag):
    """Returns the greater of the friction angles mobilised on the two pairs of sides, row by row."""
    return numpy.maximum(bag["face_friction_x"], bag["face_friction_y"])


def rises(bag, angle):
    """Returns the mean of a friction angle after failure less its mean up to the first break."""
    bag.before_end(bag.failed, "failure")
    return angle[bag.failed + 1:].mean() - angle[1:bag.broken + 1].mean()


def greatest(differences, what):
    """Returns the difference whose size is the greatest. Raises NotMade where there is none."""
    if not differences:
        raise NotMade(f"nothing to compare {what} with")
    return max(differences, key=abs)


def rows_beside(bag, record, last):
    """Returns the rows of the record from the tension of the bag's first station to the row `last`.

    Stresses are no straight line between the preload and that station.
    """
    taut = numpy.flatnonzero(record["tension_yarn_face"] >= bag["tension_yarn_face"][min(1, len(bag.table) - 1)])
    first = int(taut[0]) if len(taut) else len(record.table) - 1
    return range(first, last + 1)


def beside(bag, record, name, along, rows):
    """Returns differences (%) of a column from the recorded one where `along` is as recorded, or the greatest that it comes to."""
    most = bag[along].max() if along != "strain_axial" else numpy.inf
    return [100 * (bag.where(along, min(record[along][i], most), name) / record[name][i] - 1) for i in rows]


def at_equal_tension(name, along="tension_yarn_face"):
    """Returns the measure: greatest difference of a stress at equal tension, up to the recorded peak."""
    def measured(bag, record):
        return greatest(beside(bag, record, name, along, rows_beside(bag, record, record.most("axial_stress"))), name)
    return measured


def at_equal_tension_unbroken(name):
    """Returns the measure: the same up to the bag's first break, before strength has its part."""
    def measured(bag, record):
        tension = bag["tension_yarn_face"][bag.broken]
        rows = itertools.takewhile(lambda i: record["tension_yarn_face"][i] <= tension,
                                   rows_beside(bag, record, len(record.table) - 1))
        return greatest(beside(bag, record, name, "tension_yarn_face", rows), name)
    return measured


def rows_at_strain(bag, record):
    """Returns the rows of the record from 3 % of axial strain to its greatest axial stress."""
    return [i for i in rows_beside(bag, record, record.most("axial_stress")) if record["strain_axial"][i] >= 0.03]


def at_equal_strain(name):
    """Returns the measure: greatest difference of a column at equal axial strain, from 3 % to the recorded peak."""
    def measured(bag, record):
        return greatest(beside(bag, record, name, "strain_axial", rows_at_strain(bag, record)), name)
    return measured


def block(bag, record):
    """Returns the greatest difference (%) of the volumetric strain, dilation positive, of the block between the faces.

    The faces' yarns stretch as it is pressed flat. It leaves out the sides, and the Delaunay tetrahedra that span what is
    hollow there.
    """
    def between_faces(stretch, axial):
        return 2 * stretch - axial
    differences = []
    for i in rows_at_strain(bag, record):
        axial = record["strain_axial"][i]
        own = bag.where("strain_axial", axial, "strain_yarn_face") - bag["strain_yarn_face"][0]
        recorded = record["strain_yarn_face"][i] - record["strain_yarn_face"][0]
        differences.append(100 * (between_faces(own, axial) - between_faces(recorded, axial)))
    return greatest(differences, "the block between the faces")


# Each measure of one bag (b) beside its record (r): name, unit, value.
OF_ONE_BAG = (
    ("first_break", "%", first_break),
    ("peak_axial", "kPa", lambda b, r: b["axial_stress"][peak(b, "axial_stress")]),
    ("peak_strain", "%", lambda b, r: 100 * b["strain_axial"][peak(b, "axial_stress")]),
    ("peak_lateral", "kPa", lambda b, r: b["lateral_stress"][peak(b, "lateral_stress")]),
    ("peak_pressure", "kPa", lambda b, r: b["plate_pressure"][peak(b, "plate_pressure")]),
    ("peak_pressure_strain", "%", lambda b, r: 100 * b["strain_axial"][peak(b, "plate_pressure")]),
    ("failure_strain", "%", lambda b, r: 100 * b["strain_axial"][b.failed]),
    ("energy_error", "%", lambda b, r: 100 * abs(b.last("energy_error") / b.last("boundary_work"))),
    ("left_axial", "1", lambda b, r: left_over(b, r, "axial_stress")),
    ("left_pressure", "1", lambda b, r: left_over(b, r, "plate_pressure")),
    ("left_lateral", "1", lambda b, r: left_over(b, r, "lateral_stress")),
    ("contraction", "1", lambda b, r: b["delaunay_void_ratio"][0] - b["delaunay_void_ratio"].min()),
    ("densest_strain", "%", lambda b, r: 100 * b["strain_axial"][densest(b)]),
    ("dilation", "1", dilation),
    ("void_ratio_at_break", "1", lambda b, r: b["delaunay_void_ratio"][b.broken] - b["delaunay_void_ratio"][0]),
    ("obliquity", "1", lambda b, r: b["obliquity"][b.broken]),
    ("obliquity_ratio", "1", lambda b, r: obliquity_ratio(b, r, b["strain_axial"][b.broken])),
    ("toe_obliquity_ratio", "1", lambda b, r: obliquity_ratio(b, r, 0.02)),
    ("path_slope", "1", lambda b, r: b.path("slope")[0]),
    ("path_deviation", "1", lambda b, r: b.path("deviation")[0]),
    ("groups_deviation", "1", lambda b, r: b.path("deviation")[1:].max()),
    ("equal_strain_block", "%", block),
    ("equal_tension_lateral", "%", at_equal_tension("lateral_stress")),
    ("equal_tension_axial", "%", at_equal_tension("axial_stress")),
    ("equal_tension_pressure", "%", at_equal_tension("plate_pressure")),
    ("equal_around_lateral", "%", at_equal_tension("lateral_stress", "around")),
    ("equal_unbroken_lateral", "%", at_equal_tension_unbroken("lateral_stress")),
    ("equal_unbroken_axial", "%", at_equal_tension_unbroken("axial_stress")),
    ("equal_unbroken_pressure", "%", at_equal_tension_unbroken("plate_pressure")),
    ("equal_strain_tension", "%", at_equal_strain("tension_yarn_face")),
    ("equal_strain_axial", "%", at_equal_strain("axial_stress")),
    ("equal_strain_pressure", "%", at_equal_strain("plate_pressure")),
    ("equal_strain_lateral", "%", at_equal_strain("lateral_stress")),
    ("greatest_obliquity", "1", lambda b, r: b["obliquity"].max()),
    ("axial_over_surcharge", "1", lambda b, r: (b["axial_stress"] / b["surcharge"]).min()),
    ("middle_p", "1", lambda b, r: b.middle_over_edge("mean_stress", b.step_at(BEFORE))),
    ("middle_q", "1", lambda b, r: b.middle_over_edge("deviatoric_stress", b.step_at(BEFORE))),
    ("middle_at_peak", "1", lambda b, r: b.middle_over_edge("mean_stress", b.step_at(AT_PEAK))),
    ("middle_evens_out", "1", evens_out),
    ("side_share_toe", "1", lambda b, r: side_share(b, 0.03)),
    ("side_share", "1", lambda b, r: side_share(b, 0.10)),
    ("tension_families", "1", lambda b, r: (b["tension_yarn_face"] / b["tension_yarn_side_around"])[b.broken]),
    ("hoop_over_side", "1", lambda b, r: (b["tension_yarn_side_around"] / b["tension_yarn_side_up"])[b.broken]),
    ("face_friction", "deg", lambda b, r: max(sides(b)[1:].max(), b["face_friction_z"][1:].max())),
    ("face_friction_z_over_sides", "1", lambda b, r: (b["face_friction_z"] / sides(b))[b.broken]),
    ("face_friction_z_rises", "deg", lambda b, r: rises(b, b["face_friction_z"])),
    ("face_friction_sides_rises", "deg", lambda b, r: rises(b, sides(b))),
    ("anisotropy_c_rises", "1", lambda b, r: change(b, "a_c", AT_FIRST, BEFORE)),
    ("anisotropy_c_stagnates", "1", lambda b, r: change(b, "a_c", BEFORE, AT_PEAK) - change(b, "a_c", AT_FIRST, BEFORE)),
    ("anisotropy_c_falls_later", "1", lambda b, r: b.fabric("a_c", last_state(b)) - anisotropy(b, "a_c", AT_PEAK)),
    ("anisotropy_n_falls", "1", lambda b, r: change(b, "a_n", AT_FIRST, AT_PEAK)),
    ("anisotropy_t_falls", "1", lambda b, r: change(b, "a_t", AT_FIRST, AT_PEAK)),
)

# Each measure of PP over the same of PE: name, value of one bag.
OF_BOTH = (
    ("obliquity_PP_over_PE", lambda b: b["obliquity"][b.broken]),
    ("anisotropy_c_PP_over_PE", lambda b: anisotropy(b, "a_c", BEFORE)),
    ("anisotropy_n_PP_over_PE", lambda b: anisotropy(b, "a_n", BEFORE)),
    ("anisotropy_t_PP_over_PE", lambda b: anisotropy(b, "a_t", BEFORE)),
)


# Each measure of a record, up to the last row before a yarn has broken: name, value.
OF_A_RECORD = (
    ("recorded_path_slope", lambda r: slope(r["mean_stress"][:whole(r)], r["deviatoric_stress"][:whole(r)])),
    ("recorded_void_ratio_at_break", lambda r: r["void_ratio"][whole(r) - 1] - r["void_ratio"][0]),
)


def measure(study, runs):
    """Measures each compressed bag beside its record, and PP beside PE."""
    for g in GEOTEXTILES:
        for name, unit, value in OF_ONE_BAG:
            study.measure(f"{name}_{g}", lambda g=g, value=value: value(runs.bag(f"uc_{g}"), runs.record[g]), unit)
        for name, value in OF_A_RECORD:
            study.measure(f"{name}_{g}", value(runs.record[g]), "1")
    for name, value in OF_BOTH:
        study.measure(name, lambda value=value: value(runs.bag("uc_PP")) / value(runs.bag("uc_PE")), "1")


def seam(table):
    """Returns how near the seam yarns broke in the mean: 0 in the middle of their face or side, 1 on its edge."""
    if not len(table):
        raise NotMade("no yarn is broken")
    return table("seam", "1").mean()


def measure_breaks(study, runs):
    """Measures where yarns broke between smooth and rough plates."""
    study.measure("breaks_smooth", lambda: seam(runs.table("uc_PE_breaks")), "1")
    study.measure("breaks_rough", lambda: seam(runs.table("uc_PE_rough_breaks")), "1")
