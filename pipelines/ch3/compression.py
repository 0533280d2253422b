"""Uniaxial compression of the bags of PE and PP: measures of one bag compared with its recorded series, and ratios of both bags."""
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy
from study import NotMade

from .bag import GEOTEXTILES

AT_FIRST, BEFORE, AT_PEAK, AFTER = 4, 8, 12, 19  # axial strains (%) of recorded states: the last one is beyond AFTER


def first_break(bag, _):
    """Returns the axial strain (%) at which the first yarn broke."""
    strain = bag.last("first_break_strain")
    if numpy.isnan(strain):
        raise NotMade(f"no yarn breaks before {bag.last('strain_axial'):.0f} %")
    return strain


def peak(bag, name):
    """Returns the row of the greatest value of a column, which has to come before the last row."""
    return bag.before_end(bag.most(name), f"the greatest {name.replace('_', ' ')}")


def left_over(bag, record, name):
    """Returns the residual of a stress, over its greatest value, at the end of the shorter series; divided by the same ratio of the record."""
    bag.before_end(bag.failed, "failure")
    end = min(bag.last("strain_axial"), record.last("strain_axial"))
    own, recorded = (series.where("strain_axial", end, name) / series[name].max() for series in (bag, record))
    return own / recorded


def obliquity_ratio(bag, record, strain):
    """Returns q/p over the recorded one at an axial strain (%)."""
    q, p = (record.where("strain_axial", strain, name) for name in ("deviatoric_stress", "mean_stress"))
    return bag.where("strain_axial", strain, "obliquity") / (q / p)


def slope(record):
    """Returns the slope q/p of the least-squares line through the origin for a record's stress path up to the first break."""
    p, q = record["mean_stress"][record.whole], record["deviatoric_stress"][record.whole]
    return (p * q).sum() / (p * p).sum()


def side_share(bag, strain):
    """Returns the strain of the yarns around the sides over the strain of the faces' yarns, at an axial strain (%)."""
    side, face = (bag.where("strain_axial", strain, name) for name in ("strain_yarn_side_around", "strain_yarn_face"))
    return side / face


def middle(bag, name, strain):
    """Returns a stress of the middle groups over that of the outer ones at an axial strain (%)."""
    return bag.middle_over_edge(name, bag.step_at(strain))


def last_state(bag):
    """Returns the step of the last state, which has to be well after the greatest load."""
    if bag.last("strain_axial") <= AFTER:
        raise NotMade(f"the bag is compressed by {bag.last('strain_axial'):.0f} % only")
    return bag.last("step")


def anisotropy(bag, name, strain):
    """Returns an anisotropy of the state recorded at an axial strain (%)."""
    return bag.fabric(name, bag.step_at(strain))


def change(bag, name, start, end):
    """Returns by how much an anisotropy changes from one axial strain to another."""
    return anisotropy(bag, name, end) - anisotropy(bag, name, start)


def rises(bag, name):
    """Returns the mean of a friction angle after failure less its mean up to the first break."""
    bag.before_end(bag.failed, "failure")
    return bag[name][bag.failed + 1:].mean() - bag[name][1:bag.broken + 1].mean()


def taut(bag, record):
    """Returns the rows of the record from the first one with the yarn tension of the bag's first station on.

    Between the preload and that station, stresses are too curved to be interpolated.
    """
    first = numpy.flatnonzero(record["tension_yarn_face"] >= bag["tension_yarn_face"][min(1, len(bag) - 1)])
    return numpy.arange(first[0] if len(first) else len(record) - 1, len(record))


def to_peak(bag, record):
    """Returns the rows of taut() up to the greatest recorded axial stress."""
    rows = taut(bag, record)
    return rows[rows <= record.most("axial_stress")]


def unbroken(bag, record):
    """Returns the rows of taut() up to the tension of the bag's first break, where the strength of yarns has no effect yet."""
    rows = taut(bag, record)
    beyond = record["tension_yarn_face"][rows] > bag["tension_yarn_face"][bag.broken]
    return rows[:beyond.argmax() if beyond.any() else None]


def from_3(bag, record):
    """Returns the rows of to_peak() from 3 % of axial strain on."""
    rows = to_peak(bag, record)
    return rows[record["strain_axial"][rows] >= 3]


def greatest(differences, what):
    """Returns the difference whose size is the greatest. Raises NotMade where there is none."""
    if not len(differences):
        raise NotMade(f"nothing to compare {what} with")
    return max(differences, key=abs)


def equal(name, along, rows):
    """Returns a measure: the greatest difference (%) of a column from the record, positive if the bag has more, at equal values of `along`, in some rows.

    A recorded tension that the bag does not reach is replaced by the greatest one of the bag.
    """
    def measured(bag, record):
        chosen = rows(bag, record)
        most = bag[along].max() if along != "strain_axial" else numpy.inf
        pairs = zip(record[along][chosen], record[name][chosen], strict=True)
        return greatest([100 * (bag.where(along, min(at, most), name) / of - 1) for at, of in pairs], name)
    return measured


def block(bag, record):
    """Returns the greatest difference (%) from the record of the dilation of the block between the faces, positive if the bag dilates more.

    The dilation is twice the strain of the faces' yarns less the axial strain. It leaves out the sides, unlike the Delaunay
    volume, whose tetrahedra also span hollows there.
    """
    rows = from_3(bag, record)
    stretch = [bag.where("strain_axial", axial, "strain_yarn_face") - bag["strain_yarn_face"][0] for axial in record["strain_axial"][rows]]
    return greatest(2 * (stretch - (record["strain_yarn_face"] - record["strain_yarn_face"][0])[rows]), "the block between the faces")


COLUMNS = {"lateral": "lateral_stress", "axial": "axial_stress", "pressure": "plate_pressure", "tension": "tension_yarn_face"}
# Comparisons of a bag with its record: name, column of equal values, function that chooses the rows, compared COLUMNS.
EQUAL = (("tension", "tension_yarn_face", to_peak, ("lateral", "axial", "pressure")),
         ("around", "around", to_peak, ("lateral",)),
         ("unbroken", "tension_yarn_face", unbroken, ("lateral", "axial", "pressure")),
         ("strain", "strain_axial", from_3, ("tension", "axial", "pressure", "lateral")))

# Measures of one bag (b), some relative to its recorded series (r): name, unit, value.
OF_ONE_BAG = (
    ("first_break", "%", first_break),
    ("peak_axial", "kPa", lambda b, r: b["axial_stress"][peak(b, "axial_stress")]),
    ("peak_strain", "%", lambda b, r: b["strain_axial"][peak(b, "axial_stress")]),
    ("peak_lateral", "kPa", lambda b, r: b["lateral_stress"][peak(b, "lateral_stress")]),
    ("peak_pressure", "kPa", lambda b, r: b["plate_pressure"][peak(b, "plate_pressure")]),
    ("peak_pressure_strain", "%", lambda b, r: b["strain_axial"][peak(b, "plate_pressure")]),
    ("failure_strain", "%", lambda b, r: b["strain_axial"][b.failed]),
    ("energy_error", "%", lambda b, r: 100 * abs(b.last("energy_error") / b.last("boundary_work"))),
    ("left_axial", "1", lambda b, r: left_over(b, r, "axial_stress")),
    ("left_pressure", "1", lambda b, r: left_over(b, r, "plate_pressure")),
    ("left_lateral", "1", lambda b, r: left_over(b, r, "lateral_stress")),
    ("contraction", "1", lambda b, r: b["delaunay_void_ratio"][0] - b["delaunay_void_ratio"].min()),
    ("densest_strain", "%", lambda b, r: b["strain_axial"][b["delaunay_void_ratio"].argmin()]),
    ("dilation", "1", lambda b, r: b.where("strain_axial", AT_PEAK, "delaunay_void_ratio") - b["delaunay_void_ratio"].min()),
    ("void_ratio_at_break", "1", lambda b, r: b["delaunay_void_ratio"][b.broken] - b["delaunay_void_ratio"][0]),
    ("obliquity", "1", lambda b, r: b["obliquity"][b.broken]),
    ("obliquity_ratio", "1", lambda b, r: obliquity_ratio(b, r, b["strain_axial"][b.broken])),
    ("toe_obliquity_ratio", "1", lambda b, r: obliquity_ratio(b, r, 2)),
    ("path_slope", "1", lambda b, r: b.path("slope")[0]),
    ("path_deviation", "1", lambda b, r: b.path("deviation")[0]),
    ("groups_deviation", "1", lambda b, r: b.path("deviation")[1:].max()),
    ("equal_strain_block", "%", block),
    *((f"equal_{kind}_{short}", "%", equal(COLUMNS[short], along, rows)) for kind, along, rows, some in EQUAL for short in some),
    ("greatest_obliquity", "1", lambda b, r: b["obliquity"].max()),
    ("axial_over_surcharge", "1", lambda b, r: (b["axial_stress"] / b["surcharge"]).min()),
    ("middle_p", "1", lambda b, r: middle(b, "mean_stress", BEFORE)),
    ("middle_q", "1", lambda b, r: middle(b, "deviatoric_stress", BEFORE)),
    ("middle_at_peak", "1", lambda b, r: middle(b, "mean_stress", AT_PEAK)),
    ("middle_evens_out", "1", lambda b, r: b.middle_over_edge("mean_stress", last_state(b)) - middle(b, "mean_stress", AT_PEAK)),
    ("side_share_toe", "1", lambda b, r: side_share(b, 3)),
    ("side_share", "1", lambda b, r: side_share(b, 10)),
    ("tension_families", "1", lambda b, r: (b["tension_yarn_face"] / b["tension_yarn_side_around"])[b.broken]),
    ("hoop_over_side", "1", lambda b, r: (b["tension_yarn_side_around"] / b["tension_yarn_side_up"])[b.broken]),
    ("face_friction", "deg", lambda b, r: max(b["friction_sides"][1:].max(), b["face_friction_z"][1:].max())),
    ("face_friction_z_over_sides", "1", lambda b, r: (b["face_friction_z"] / b["friction_sides"])[b.broken]),
    ("face_friction_z_rises", "deg", lambda b, r: rises(b, "face_friction_z")),
    ("face_friction_sides_rises", "deg", lambda b, r: rises(b, "friction_sides")),
    ("anisotropy_c_rises", "1", lambda b, r: change(b, "a_c", AT_FIRST, BEFORE)),
    ("anisotropy_c_stagnates", "1", lambda b, r: change(b, "a_c", BEFORE, AT_PEAK) - change(b, "a_c", AT_FIRST, BEFORE)),
    ("anisotropy_c_falls_later", "1", lambda b, r: b.fabric("a_c", last_state(b)) - anisotropy(b, "a_c", AT_PEAK)),
    ("anisotropy_n_falls", "1", lambda b, r: change(b, "a_n", AT_FIRST, AT_PEAK)),
    ("anisotropy_t_falls", "1", lambda b, r: change(b, "a_t", AT_FIRST, AT_PEAK)),
)
# Each measure of a record, up to the last row before a yarn has broken.
OF_A_RECORD = (
    ("recorded_path_slope", "1", slope),
    ("recorded_void_ratio_at_break", "1", lambda r: r["void_ratio"][r.whole][-1] - r["void_ratio"][0]),
)
# Measures of both bags, PP over PE: name, unit, value.
OF_BOTH = (
    ("obliquity_PP_over_PE", "1", lambda b: b["obliquity"][b.broken]),
    *((f"anisotropy_{short}_PP_over_PE", "1", lambda b, short=short: anisotropy(b, f"a_{short}", BEFORE)) for short in "cnt"),
)


def measure(study, runs):
    """Measures each compressed bag, its differences from its recorded series, and ratios of PP to PE."""
    for g in GEOTEXTILES:
        study.measure_each(OF_ONE_BAG, lambda g=g: (runs.bag(f"uc_{g}"), runs.record[g]), f"_{g}")
        study.measure_each(OF_A_RECORD, lambda g=g: (runs.record[g],), f"_{g}")
    study.measure_each([(name, unit, lambda pe, pp, value=value: value(pp) / value(pe)) for name, unit, value in OF_BOTH],
                       lambda: [runs.bag(f"uc_{g}") for g in GEOTEXTILES])


def measure_breaks(study, runs):
    """Measures the mean nearness to the seam (breaks.py) of yarns broken between smooth plates, and of yarns broken between rough plates."""
    def seam(table):
        if not len(table):
            raise NotMade("no yarn is broken")
        return table["seam"].mean()
    study.measure("breaks_smooth", lambda: seam(runs.table("uc_PE_breaks")), "1")
    study.measure("breaks_rough", lambda: seam(runs.table("uc_PE_rough_breaks")), "1")
