"""Before loading: how the bag came to be, whether its contacts are spread as the representative volume's, its geotextile alone."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import tomllib

import numpy
from study import NotMade
from study.units import factor

from .bag import GEOTEXTILES, HERE

CURVE = "data/geotextiles/{}.toml"
FRICTION = (21, 25)  # degrees between nodes and soil in the shear boxes


def shares(table, of_rose):
    """Returns the numbers that fall into each class: grains by contacts, or contacts by their angle from the vertical."""
    if of_rose:
        return table.rows(table("plane", "1") == 0)("contacts", "1")
    return table("grains", "1")


def distance(one, other):
    """Returns the distance of Kolmogorov and Smirnov: the greatest difference of cumulative shares."""
    classes = max(len(one), len(other))
    cumulative = [numpy.cumsum(numpy.pad(counts, (0, classes - len(counts)))) / counts.sum() for counts in (one, other)]
    return abs(cumulative[0] - cumulative[1]).max()


def chance(one, other):
    """Returns the distance that two samples of these sizes exceed with a chance of 5 %."""
    return 1.358 * numpy.sqrt(1 / one.sum() + 1 / other.sum())


def spreads(runs):
    """Returns what is compared of the bag and the representative volume: name of the measure and both numbers by class."""
    pairs = []
    for prefix, bag in (("", "bag"), ("soil_", "bag_soil")):
        for name, kind in (("contact_number", "histogram"), ("orientation", "rose")):
            of_both = [shares(runs.table(f"{of}_{kind}"), kind == "rose") for of in (bag, "rv")]
            pairs.append((prefix + name, *of_both))
    return pairs


def spread_table(runs):
    """Returns the columns of shape.tsv: sizes of both samples, their distance and the one that is chance."""
    words = {"contact_number": "number of contacts", "orientation": "angle of contacts from the vertical",
             "soil_contact_number": "number of contacts, soil with soil alone",
             "soil_orientation": "angle of contacts from the vertical, soil with soil alone"}
    pairs = spreads(runs)
    return {"compared": [words[name] for name, _, _ in pairs],
            "bag [1]": [f"{bag.sum():.0f}" for _, bag, _ in pairs],
            "representative volume [1]": [f"{rv.sum():.0f}" for _, _, rv in pairs],
            "distance [1]": [f"{distance(bag, rv):.4g}" for _, bag, rv in pairs],
            "distance of samples [1]": [f"{chance(bag, rv):.4g}" for _, bag, rv in pairs]}


def spheres(runs):
    """Returns the number of grains of the bag, where they have the thesis's size."""
    if not runs.full:
        raise NotMade("grains are larger than the thesis's")
    return runs.table("bag_histogram")("grains", "1").sum()


@functools.cache
def strip_size():
    """Returns how many yarns of a strip lie side by side, and its length in mm."""
    with open(HERE / "strip_plan.toml", "rb") as file:
        sheet = tomllib.load(file)["sheet"][0]
    spacing, unit = sheet["spacing"].split()
    return sheet["cells"][0] + 1, sheet["cells"][1] * float(spacing) * factor(unit, "mm")


def stiffness(strip, geotextile):
    """Returns the force of a yarn of a strip at 1 % of strain over that of the curve it was given."""
    with open(CURVE.format(geotextile), "rb") as file:
        curve = tomllib.load(file)
    given = 0.01 * curve["yarn_tension"][0] / curve["yarn_strain"][0]
    return abs(strip("force_right_y", "N")[1]) / strip_size()[0] / given


def strength(strip):
    """Returns the force (N) of a yarn of a strip when its yarns are tautest."""
    return abs(strip("force_right_y", "N")[int(strip("yarn_tension_face", "N").argmax())]) / strip_size()[0]


def held_back(box):
    """Returns shear (N), which the walls push by as the sheet holds the soil back, and normal force (N) of a shear box."""
    return abs(box("force_left_x", "N") + box("force_right_x", "N")), abs(box("force_lid_z", "N"))


def sheared(box):
    """Returns the rows of a shear box after the dead load."""
    return box.rows(box("stage", "1") > 0)


def interface(box):
    """Returns the friction angle (deg) of the interface in a shear box: mean of the second half of the way."""
    shear, normal = (force[len(box) // 2:].sum() for force in held_back(box))
    return numpy.degrees(numpy.arctan2(shear, normal))


def measure(study, runs):
    """Measures the bag as it is made, the strips and the shear boxes."""
    study.measure("delaunay_void_ratio", lambda: runs.table("generation")("delaunay_void_ratio", "1")[-1], "1")
    study.measure("coordination_number", lambda: runs.table("generation")("coordination_number", "1")[-1], "1")
    study.measure("spheres", lambda: spheres(runs), "1")
    for name, bag, volume in spreads(runs):
        study.measure(name, distance(bag, volume) / chance(bag, volume), "1")
    for g in GEOTEXTILES:
        study.measure(f"strip_stiffness_{g}", lambda g=g: stiffness(runs.table(f"strip_{g}"), g), "1")
        study.measure(f"strip_strength_{g}", lambda g=g: strength(runs.table(f"strip_{g}")), "N")
    for angle in FRICTION:
        study.measure(f"box_friction_{angle}", lambda angle=angle: interface(runs.table(f"box_{angle}")), "deg")
    study.measure("box_friction_rises", lambda: interface(runs.table("box_25")) - interface(runs.table("box_21")), "deg")
