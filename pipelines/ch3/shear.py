"""Simple shear of bags of PP under dead loads: measures of one bag, and of how they change with the load."""
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy
from study import NotMade

LARGE = 2410  # N: the thesis draws stress paths from this dead load on


class Shear:
    """A bag under one dead load. Rows: 0 before the shear, `peak` of the greatest shear, `thinnest` where it begins to dilate."""

    def __init__(self, bag):
        self.bag = bag
        self.shear = abs(bag["plate_shear"])
        self.soil_shear = abs(bag["shear_stress"])
        self.peak, self.thinnest = int(self.shear.argmax()), bag.most("settlement")

    @property
    def state(self):
        """Step at the end of the first stage of the shear, when every bag dilates and its whole state is recorded."""
        first = numpy.flatnonzero(self.bag["stage"] == 1)
        if not len(first):
            raise NotMade("the bag is not sheared")
        return self.bag["step"][first[-1]]

    def ratio(self, row):
        """Returns shear over normal force of the plates."""
        return abs(self.bag["plate_ratio"][row])

    def soil_ratio(self):
        """Returns shear over axial stress in the soil, row by row."""
        return self.soil_shear / self.bag["axial_stress"]

    def lag(self, row):
        """Returns by how much the stress ratio of the soil is behind that of the plates."""
        return self.ratio(row) - self.soil_ratio()[row]

    def unsteadiness(self):
        """Returns the root mean square of what the shear deviates from the mean of its neighbours, over its mean.

        Counted are rows from the least thickness on.
        """
        later = self.bag["plate_shear"][self.thinnest:]
        jumps = later[1:-1] - (later[:-2] + later[2:]) / 2
        if not len(jumps):
            raise NotMade("the bag is thinnest at the end")
        return numpy.sqrt((jumps**2).mean()) / abs(later[1:-1]).mean()

    def slope(self):
        """Returns the greatest q/p under shear: the slope of the critical state line of the bag."""
        return self.bag["obliquity"][1:].max()

    def group_change(self, name, middle):
        """Returns a stress of the middle groups, or of the outer two, at the end over that at the recorded state."""
        end, state = (self.bag.groups(name, step) for step in (self.bag.last("step"), self.state))
        which = slice(1, -1) if middle else [0, -1]
        return end[which].mean() / state[which].mean()

    def over_before(self, name):
        """Returns a stress at the greatest shear over that before the shear."""
        return self.bag[name][self.peak] / self.bag[name][0]

    def at_peak(self, *families):
        """Returns the tension of each of these families of yarns at the greatest shear."""
        return [self.bag[f"tension_yarn_{family}"][self.peak] for family in families]


def sides_over_faces(s):
    """Returns the mean tension of both families of the sides over that of the faces, at the greatest shear."""
    around, up, face = s.at_peak("side_around", "side_up", "face")
    return 0.5 * (around + up) / face


def hoop(s):
    """Returns the tension around the sides over that from face to face, at the greatest shear."""
    around, up = s.at_peak("side_around", "side_up")
    return around / up


def dilated(s):
    """Returns by how much a bag grows thicker than it was at its thinnest (mm)."""
    return s.bag["settlement"].max() - s.bag.last("settlement")


# Each measure of one bag: name, unit, which of the loads, value.
OF_ONE_BAG = (
    ("shear_ratio_first", "1", min, lambda s: s.ratio(s.peak)),
    ("shear_ratio_last", "1", max, lambda s: s.ratio(s.peak)),
    ("shear_lag", "1", min, lambda s: s.lag(-1)),
    ("shear_lag_grows", "1", min, lambda s: s.lag(-1) - s.lag((len(s.shear) - 1) // 2)),
    ("shear_contraction", "mm", min, lambda s: s.bag["settlement"].max() - s.bag["settlement"][0]),
    ("shear_dilation", "mm", min, dilated),
    ("shear_lateral", "1", LARGE, lambda s: s.over_before("lateral_stress")),
    ("shear_axial", "1", LARGE, lambda s: s.over_before("axial_stress")),
    ("shear_softening", "1", LARGE, lambda s: s.soil_shear[-1] / s.soil_shear.max()),
    ("shear_sides_over_faces", "1", max, sides_over_faces),
    ("shear_hoop", "1", max, hoop),
)

# Each measure of how the greatest load differs from a lesser one: name, unit, the lesser one, value of one bag.
BETWEEN_LOADS = (
    ("shear_ratio_falls", "1", min, lambda s: s.ratio(s.peak)),
    ("shear_soil_ratio_falls", "1", min, lambda s: s.soil_ratio().max()),
    ("shear_dilation_falls", "mm", min, dilated),
    ("shear_critical_c_falls", "1", min, lambda s: s.bag.fabric("a_c", s.bag.last("step"))),
    ("shear_slope_falls", "1", LARGE, Shear.slope),
)

# Each measure that has to hold for all loads from LARGE on: name, the worst of them, value of one bag.
OF_ALL = (
    ("shear_path_nears", min, lambda s: s.slope() - s.bag["obliquity"][0]),
    ("shear_path_leaves", max, lambda s: s.bag.last("obliquity") - s.slope()),
    ("shear_slope", max, Shear.slope),
    ("shear_middle_p", max, lambda s: s.group_change("mean_stress", True)),
    ("shear_middle_q", max, lambda s: s.group_change("deviatoric_stress", True)),
    ("shear_edge_p", min, lambda s: s.group_change("mean_stress", False)),
    ("shear_normal_falls", max, lambda s: s.bag.fabric("a_n", s.bag.last("step")) - s.bag.fabric("a_n", s.state)),
)


def chosen(bags, which):
    """Returns the bag under the least (min) or the greatest (max) load, or under a load in N."""
    load = which if isinstance(which, int) else which(bags)
    if load not in bags:
        raise NotMade(f"no bag is sheared under {load} N")
    return bags[load]


def large(bags):
    """Returns the bags under loads from LARGE on."""
    return [chosen(bags, load) for load in bags if load >= LARGE] or [chosen(bags, LARGE)]


def between(bags, lesser, value):
    """Returns a measure under the greatest load less that under a lesser one."""
    greater = chosen(bags, max)
    if greater is chosen(bags, lesser):
        raise NotMade("one load alone tells nothing of how loads differ")
    return value(greater) - value(chosen(bags, lesser))


def unrest(bags):
    """Returns how much less steady the shear is under 1.33 kN than under 2.41 kN."""
    return chosen(bags, 1330).unsteadiness() / chosen(bags, LARGE).unsteadiness()


def measure(study, runs):
    """Measures the sheared bags."""
    def bags():
        return {load: Shear(bag) for load, bag in runs.sheared().items()}
    for name, unit, which, value in OF_ONE_BAG:
        study.measure(name, lambda which=which, value=value: value(chosen(bags(), which)), unit)
    for name, unit, lesser, value in BETWEEN_LOADS:
        study.measure(name, lambda lesser=lesser, value=value: between(bags(), lesser, value), unit)
    for name, worst, value in OF_ALL:
        study.measure(name, lambda worst=worst, value=value: worst(map(value, large(bags()))), "1")
    study.measure("shear_unrest", lambda: unrest(bags()), "1")
