"""Measures of the bag before loading: its generation, its contacts compared with the representative volume's, tests of the geotextile alone."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import tomllib

import numpy
from study import NotMade, Series
from study.units import factor

from .bag import GEOTEXTILES, HERE

CURVE = "data/geotextiles/{}.toml"
FRICTION = {21: "PP", 25: "PE"}  # friction angle (deg) of nodes and soil in the shear boxes: geotextile
# Quantities compared between the bag and the representative volume.
SPREADS = {"contact_number": "number of contacts", "orientation": "angle of contacts from the vertical",
           "soil_contact_number": "number of contacts, soil with soil alone",
           "soil_orientation": "angle of contacts from the vertical, soil with soil alone"}


def shares(table, kind):
    """Returns the count of each class: grains by number of contacts (histogram), or contacts by angle from the vertical (rose)."""
    return table["grains"] if kind == "histogram" else table.rows(table["plane"] == 0)["contacts"]


def distance(one, other):
    """Returns the distance of Kolmogorov and Smirnov: the greatest difference of cumulative shares."""
    classes = max(len(one), len(other))
    cumulative = [numpy.cumsum(numpy.pad(counts, (0, classes - len(counts)))) / counts.sum() for counts in (one, other)]
    return abs(cumulative[0] - cumulative[1]).max()


def chance(one, other):
    """Returns the distance that two samples of these sizes from one distribution exceed with a probability of 5 %."""
    return 1.358 * numpy.sqrt(1 / one.sum() + 1 / other.sum())


def spread(runs, name):
    """Returns the counts by class of the bag and of the representative volume for one of SPREADS."""
    kind = "rose" if name.endswith("orientation") else "histogram"
    return [shares(runs.table(f"{of}_{kind}"), kind) for of in ("bag_soil" if name.startswith("soil") else "bag", "rv")]


def spread_table(runs):
    """Returns the columns of a table: sizes of both samples, their distance, and the distance of chance()."""
    pairs = [spread(runs, name) for name in SPREADS]
    return {"compared": list(SPREADS.values()), "bag [1]": [f"{bag.sum():.0f}" for bag, _ in pairs],
            "representative volume [1]": [f"{rv.sum():.0f}" for _, rv in pairs],
            "distance [1]": [f"{distance(*pair):.4g}" for pair in pairs], "distance of samples [1]": [f"{chance(*pair):.4g}" for pair in pairs]}


def spheres(runs):
    """Returns the number of grains of the bag, where they have the thesis's size."""
    if not runs.full:
        raise NotMade("grains are larger than the thesis's")
    return runs.table("bag_histogram")["grains"].sum()


@functools.cache
def strip_size():
    """Returns how many yarns of a strip lie side by side, and its length in mm."""
    with open(HERE / "strip_plan.toml", "rb") as file:
        sheet = tomllib.load(file)["sheet"][0]
    spacing, unit = sheet["spacing"].split()
    return sheet["cells"][0] + 1, sheet["cells"][1] * float(spacing) * factor(unit, "mm")


class Strip(Series):
    """A strip of geotextile that is pulled."""

    derived = {"strain": ("%", "strain", lambda s: 100 * s.table("displacement_right_y", "mm") / strip_size()[1]),
               "tension": ("N", "tension of a yarn", lambda s: abs(s.table("force_right_y", "N")) / strip_size()[0])}

    def stiffness(self, geotextile):
        """Returns the force of a yarn at 1 % of strain over the force on the geotextile's curve."""
        with open(CURVE.format(geotextile), "rb") as file:
            curve = tomllib.load(file)
        return self["tension"][1] / (0.01 * curve["yarn_tension"][0] / curve["yarn_strain"][0])

    def strength(self):
        """Returns the mean force (N) of a yarn at the strip's greatest yarn tension."""
        return self["tension"][numpy.nanargmax(self.table("yarn_tension_face", "N"))]


class Box(Series):
    """A shear box on a fixed sheet. Its shear force is what the walls transfer to the soil, and the soil to the sheet."""

    derived = {"displacement": ("mm", "displacement", lambda b: b.table("displacement_left_x", "mm")),
               "shear": ("N", "shear force", lambda b: abs(b.table("force_left_x", "N") + b.table("force_right_x", "N"))),
               "normal": ("N", "normal force", lambda b: abs(b.table("force_lid_z", "N"))),
               "ratio": ("1", "shear over normal force", lambda b: b["shear"] / b["normal"])}

    def friction(self):
        """Returns the friction angle (deg) of the interface: mean over the second half of the displacement."""
        shear, normal = (self[name][len(self) // 2:].sum() for name in ("shear", "normal"))
        return numpy.degrees(numpy.arctan2(shear, normal))


def measure(study, runs):
    """Measures the bag as it is made, the strips and the shear boxes."""
    for name in ("delaunay_void_ratio", "coordination_number"):
        study.measure(name, lambda name=name: runs.table("generation")[name][-1], "1")
    study.measure("spheres", lambda: spheres(runs), "1")
    for name in SPREADS:
        study.measure(name, distance(*spread(runs, name)) / chance(*spread(runs, name)), "1")
    for g in GEOTEXTILES:
        study.measure(f"strip_stiffness_{g}", lambda g=g: Strip(runs.table(f"strip_{g}")).stiffness(g), "1")
        study.measure(f"strip_strength_{g}", lambda g=g: Strip(runs.table(f"strip_{g}")).strength(), "N")
    for angle in FRICTION:
        study.measure(f"box_friction_{angle}", lambda angle=angle: Box(runs.table(f"box_{angle}")).friction(), "deg")
    study.measure("box_friction_rises", lambda: Box(runs.table("box_25")).friction() - Box(runs.table("box_21")).friction(), "deg")
