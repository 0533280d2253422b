"""Simple shear of bags of PP under dead loads: measures of one bag, and their change with the load."""
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy
from study import NotMade

LARGE = 2410  # N: the thesis draws stress paths from this dead load on


class Shear:
    """A bag under one dead load. Rows: 0 before the shear, `peak` of the greatest shear, `thinnest` where it begins to dilate."""

    def __init__(self, bag):
        self.bag = bag
        self.peak, self.thinnest = int(abs(bag["plate_shear"]).argmax()), bag.most("settlement")

    def state(self):
        """Returns the step at the end of the first stage of the shear, when every bag dilates and its whole state is recorded."""
        first = numpy.flatnonzero(self.bag["stage"] == 1)
        if not len(first):
            raise NotMade("the bag is not sheared")
        return self.bag["step"][first[-1]]

    def lag(self, row):
        """Returns the stress ratio of the plates less the stress ratio of the soil."""
        return self.bag["shear_ratio"][row] - self.bag["soil_ratio"][row]

    def unsteadiness(self):
        """Returns the root mean square difference of the shear force from the mean of the rows before and after, over the mean shear force.

        Rows count from the least thickness on.
        """
        later = self.bag["plate_shear"][self.thinnest:]
        jumps = later[1:-1] - (later[:-2] + later[2:]) / 2
        if not len(jumps):
            raise NotMade("the bag is thinnest at the end")
        return numpy.sqrt((jumps**2).mean()) / abs(later[1:-1]).mean()

    def slope(self):
        """Returns the greatest q/p under shear: the slope of the critical state line of the bag."""
        return self.bag["obliquity"][1:].max()

    def dilated(self):
        """Returns by how much a bag grows thicker than it was at its thinnest (mm)."""
        return self.bag["settlement"].max() - self.bag.last("settlement")

    def group_change(self, name, which):
        """Returns the mean stress of some groups at the end over its value at state()."""
        end, state = (self.bag.groups(name, step)[which].mean() for step in (self.bag.last("step"), self.state()))
        return end / state

    def over_before(self, name):
        """Returns a stress at the greatest shear over that before the shear."""
        return self.bag[name][self.peak] / self.bag[name][0]

    def tension(self, family):
        """Returns the tension of a family of yarns at the greatest shear."""
        return self.bag[f"tension_yarn_{family}"][self.peak]


def ratio(s):
    """Returns shear over normal force of the plates at the greatest shear."""
    return s.bag["shear_ratio"][s.peak]


MIDDLE, EDGE = slice(1, -1), [0, -1]
# Each measure of one bag (s): name, unit, under which of the loads, value.
OF_ONE_BAG = (
    ("shear_ratio_first", "1", min, ratio),
    ("shear_ratio_last", "1", max, ratio),
    ("shear_lag", "1", min, lambda s: s.lag(-1)),
    ("shear_lag_grows", "1", min, lambda s: s.lag(-1) - s.lag((len(s.bag) - 1) // 2)),
    ("shear_contraction", "mm", min, lambda s: s.bag["settlement"].max() - s.bag["settlement"][0]),
    ("shear_dilation", "mm", min, Shear.dilated),
    ("shear_lateral", "1", LARGE, lambda s: s.over_before("lateral_stress")),
    ("shear_axial", "1", LARGE, lambda s: s.over_before("axial_stress")),
    ("shear_softening", "1", LARGE, lambda s: abs(s.bag.last("shear_stress")) / abs(s.bag["shear_stress"]).max()),
    ("shear_sides_over_faces", "1", max, lambda s: 0.5 * (s.tension("side_around") + s.tension("side_up")) / s.tension("face")),
    ("shear_hoop", "1", max, lambda s: s.tension("side_around") / s.tension("side_up")),
)
# Differences between the greatest load and a lesser load: name, unit, lesser load, value of one bag.
BETWEEN_LOADS = (
    ("shear_ratio_falls", "1", min, ratio),
    ("shear_soil_ratio_falls", "1", min, lambda s: s.bag["soil_ratio"].max()),
    ("shear_dilation_falls", "mm", min, Shear.dilated),
    ("shear_critical_c_falls", "1", min, lambda s: s.bag.fabric("a_c", s.bag.last("step"))),
    ("shear_slope_falls", "1", LARGE, Shear.slope),
)
# Measures of all loads from LARGE on: name, function that chooses the worst value, value of one bag.
OF_ALL = (
    ("shear_path_nears", min, lambda s: s.slope() - s.bag["obliquity"][0]),
    ("shear_path_leaves", max, lambda s: s.bag.last("obliquity") - s.slope()),
    ("shear_slope", max, Shear.slope),
    ("shear_middle_p", max, lambda s: s.group_change("mean_stress", MIDDLE)),
    ("shear_middle_q", max, lambda s: s.group_change("deviatoric_stress", MIDDLE)),
    ("shear_edge_p", min, lambda s: s.group_change("mean_stress", EDGE)),
    ("shear_normal_falls", max, lambda s: s.bag.fabric("a_n", s.bag.last("step")) - s.bag.fabric("a_n", s.state())),
)


def chosen(bags, which):
    """Returns the bag under the least (min) or the greatest (max) load, or under a load in N."""
    load = which if isinstance(which, int) else which(bags)
    if load not in bags:
        raise NotMade(f"no bag is sheared under {load} N")
    return bags[load]


def between(bags, lesser, value):
    """Returns a measure under the greatest load less its value under a lesser load."""
    if chosen(bags, max) is chosen(bags, lesser):
        raise NotMade("one load alone tells nothing of how loads differ")
    return value(chosen(bags, max)) - value(chosen(bags, lesser))


def worst_of_large(bags, worst, value):
    """Returns the worst value of a measure under all loads from LARGE on. Raises NotMade without such a load."""
    return worst(map(value, [bags[load] for load in bags if load >= LARGE] or [chosen(bags, LARGE)]))


def measure(study, runs):
    """Measures the sheared bags; shear_unrest is how much less steady the shear is under 1.33 kN than under 2.41 kN."""
    def bags():
        return [{load: Shear(bag) for load, bag in runs.sheared().items()}]
    study.measure_each([(name, unit, lambda b, which=which, value=value: value(chosen(b, which))) for name, unit, which, value in OF_ONE_BAG], bags)
    study.measure_each([(name, unit, lambda b, lesser=lesser, value=value: between(b, lesser, value))
                        for name, unit, lesser, value in BETWEEN_LOADS], bags)
    study.measure_each([(name, "1", lambda b, worst=worst, value=value: worst_of_large(b, worst, value)) for name, worst, value in OF_ALL], bags)
    study.measure("shear_unrest", lambda: chosen(*bags(), 1330).unsteadiness() / chosen(*bags(), LARGE).unsteadiness(), "1")
