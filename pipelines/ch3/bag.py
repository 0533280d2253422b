"""Results of the runs of chapter 3: a bag under load with its groups and fabric, the recorded series, the tables of a folder."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import pathlib
import tomllib

import numpy
from study import Folder, NotMade, Series, StudyError, Table

HERE = pathlib.Path(__file__).parent
GEOTEXTILES = ("PE", "PP")
RECORDED = "data/discrete_element/soilbag_uniaxial_{}.tsv"


@functools.cache
def yarns_cut():
    """Returns how many yarns of a face and of a side a plane through the middle of the thesis's bag cuts."""
    with open(HERE / "bag.toml", "rb") as file:
        return tomllib.load(file)["geotextile_mesh"]["cells"][1:]


def around(series):
    """Returns the mean tension of the yarns that a plane in the middle cuts, which balance the lateral stress."""
    faces, sides = yarns_cut()
    return (faces * series["tension_yarn_face"] + sides * series["tension_yarn_side_around"]) / (faces + sides)


class Record(Series):
    """A recorded series of the same model. Its sides have horizontal yarns, which run around the bag."""

    derived = {"around": ("N", "tension around the bag", around),
               "lateral_stress": ("kPa", "lateral stress", lambda r: r["radial_stress"]),
               "delaunay_void_ratio": ("1", "void ratio", lambda r: r["void_ratio"]),
               "tension_yarn_side_around": ("N", "tension of yarns around the sides", lambda r: r["tension_yarn_horizontal"])}

    @property
    def whole(self):
        """The rows before a yarn has broken."""
        springs = self["intact_springs"]
        return slice(int((springs == springs.max()).sum()))


class Bag(Series):
    """A bag under load. Row 0 is the end of the preload, where the settlement is 0.

    parts: a function that returns a table of the bag by its name. "groups" along x and "fabric" are tables of the recorded states.
    "path" has the stress paths up to the first break, first of the whole soil, then of each group.
    """

    derived = {"around": Record.derived["around"],
               "friction_sides": ("deg", "sides", lambda b: numpy.maximum(b["face_friction_x"], b["face_friction_y"])),
               "shear_strain": ("%", "shear displacement over height", lambda b: 100 * b["shear_displacement"] / b["reference_height"]),
               "shear_ratio": ("1", "shear over normal force of the plates", lambda b: abs(b["plate_ratio"])),
               "soil_ratio": ("1", "shear over axial stress in the soil", lambda b: abs(b["shear_stress"]) / b["axial_stress"])}

    def __init__(self, table, parts):
        preload = numpy.flatnonzero(table["stage"] == 0)
        if not len(preload):
            raise StudyError(f"{table.where}: has no row of the preload, stage 0")
        super().__init__(table.rows(numpy.arange(len(table)) >= preload[-1]))
        self._parts = parts

    @functools.cached_property
    def broken(self):
        """Row of the first broken yarn, or the last row."""
        broken = numpy.flatnonzero(self["broken_yarns"] > 0)
        return int(broken[0]) if len(broken) else len(self) - 1

    @functools.cached_property
    def failed(self):
        """Row of failure: the last whose load is within 2 % of the greatest."""
        pressure = self["plate_pressure"]
        return int(numpy.flatnonzero(pressure >= 0.98 * pressure.max())[-1])

    def before_end(self, row, what):
        """Returns the row. Raises NotMade if it is the last one, since `what` may then come later."""
        if row == len(self) - 1:
            raise NotMade(f"{what} does not come before {self.last('strain_axial'):.0f} %")
        return row

    def row_at(self, strain):
        """Returns the row of the station at an axial strain (%)."""
        near = numpy.flatnonzero(abs(self["strain_axial"] - strain) < 0.1)
        if not len(near):
            raise NotMade(f"no station at {strain:.0f} %")
        return int(near[0])

    def step_at(self, strain):
        """Returns the step of the station at an axial strain (%)."""
        return self["step"][self.row_at(strain)]

    def fabric(self, name, step):
        """Returns an anisotropy of the state that was recorded at a step."""
        return _of_step(self._parts("fabric"), step)[name][0]

    def groups(self, name, step):
        """Returns a column of the groups at a step, in their order along x."""
        return _of_step(self._parts("groups"), step)[name]

    def path(self, name):
        """Returns a property of the stress paths: of the whole soil, then of the groups."""
        return self._parts("path")[name]

    def middle_over_edge(self, name, step):
        """Returns the mean over the inner groups over the mean over the two outermost groups."""
        values = self.groups(name, step)
        return values[1:-1].mean() / values[[0, -1]].mean()

    def recorded(self):
        """Returns the bag at its recorded states alone, with the anisotropies of each."""
        return Recorded(self, self._parts("fabric"))


def _of_step(table, step):
    return table.rows(table["step"] == step)


class Recorded(Series):
    """Anisotropies of a bag's recorded states, over its strains there."""

    def __init__(self, bag, fabric):
        super().__init__(fabric.rows(numpy.isin(fabric["step"], bag["step"])))
        self._bag, self._rows = bag, numpy.isin(bag["step"], fabric["step"])

    def __getitem__(self, name):
        return self._bag[name][self._rows] if "strain" in name else super().__getitem__(name)

    def line(self, name):
        """Returns unit and words of a column: the bag's own."""
        return self._bag.line(name)


class Runs:
    """The tables of a folder: those that the study has just made, or those kept of its runs at full size.

    full: whether grains and yarns have the thesis's size. loads: dead loads (N) of the bags in simple shear; by default
    all whose tables exist. absent: why a table may be missing; without it each missing table is an error.
    """

    def __init__(self, folder, full, loads=(), absent=""):
        self.table, self.full = Folder(folder, absent), full
        self.loads = sorted(loads or [int(path.stem[3:]) for path in self.table.path.glob("ss_*.tsv") if path.stem[3:].isdigit()])
        self.record = {g: Record(Table.read(RECORDED.format(g))) for g in GEOTEXTILES}
        self.bag = functools.cache(lambda name: Bag(self.table(name), lambda part: self.table(f"{name}_{part}")))

    @classmethod
    def kept(cls, folder=HERE / "kept"):
        """Returns what is kept of the runs at full size, in the repository or in another folder."""
        return cls(folder, True, absent="not among the kept runs")

    def bags(self):
        """Returns the compressed bags that are there, by geotextile."""
        there = [g for g in GEOTEXTILES if not self.table.absent or (self.table.path / f"uc_{g}.tsv").exists()]
        return {g: self.bag(f"uc_{g}") for g in there}

    def sheared(self):
        """Returns the sheared bags by their dead load, the least first."""
        if not self.loads:
            raise NotMade("no bag is sheared")
        return {load: self.bag(f"ss_{load}") for load in self.loads}
