"""What the runs of chapter 3 left: a bag under load with its groups and fabric, the recorded series, the tables of a folder."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import pathlib
import tomllib

import numpy
from study import NotMade, StudyError, Table

HERE = pathlib.Path(__file__).parent
GEOTEXTILES = ("PE", "PP")
RECORDED = "data/discrete_element/soilbag_uniaxial_{}.tsv"
# Columns of the tables of a bag and of the records, each in the unit that measures and figures take it in.
UNITS = {
    "step": "1", "stage": "1", "settlement": "mm", "shear_displacement": "mm", "strain_axial": "1", "plate_pressure": "kPa",
    "plate_shear": "kPa", "plate_ratio": "1", "surcharge": "kPa", "axial_stress": "kPa", "lateral_stress": "kPa",
    "radial_stress": "kPa", "mean_stress": "kPa", "deviatoric_stress": "kPa", "shear_stress": "kPa", "obliquity": "1",
    "void_ratio": "1", "delaunay_void_ratio": "1", "tension_yarn_face": "N", "tension_yarn_side_around": "N",
    "tension_yarn_side_up": "N", "tension_yarn_horizontal": "N", "strain_yarn_face": "1", "strain_yarn_side_around": "1",
    "strain_yarn_side_up": "1", "broken_yarns": "1", "first_break_strain": "1", "face_friction_x": "deg",
    "face_friction_y": "deg", "face_friction_z": "deg", "boundary_work": "J", "energy_error": "J", "volume_of_interest": "1",
    "a_c": "1", "a_n": "1", "a_t": "1", "intact_springs": "1",
    "reference_height": "mm", "slope": "1", "deviation": "1"}


class Series:
    """The columns of a table, row by row, in UNITS: series["axial_stress"] is an array in kPa."""

    def __init__(self, table):
        self.table = table

    def __getitem__(self, name):
        if name == "around":
            return around(self["tension_yarn_face"], self["tension_yarn_side_around"])
        return self.table(name, UNITS[name], missing=name == "first_break_strain")

    def last(self, name):
        """Returns the last value of a column."""
        return self[name][-1]

    def most(self, name):
        """Returns the row of the greatest value of a column, the first where there are several."""
        return int(self[name].argmax())

    def where(self, along, at, name):
        """Returns the column `name` where the column `along` first reaches `at`, linearly between its rows.

        Raises StudyError where it never does or is beyond it from the start: nothing is extrapolated.
        """
        x, y = self[along], self[name]
        reached = numpy.flatnonzero(x >= at)
        if not len(reached) or (reached[0] == 0 and x[0] > at):
            raise StudyError(f"{self.table.where}: {along} does not come to {at:.6g} from below")
        k = reached[0]
        return float(y[k] if x[k] == at else y[k - 1] + (y[k] - y[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]))


class Record(Series):
    """A recorded series of the same model. Its sides have horizontal yarns, which run around the bag."""

    def __getitem__(self, name):
        same = {"around": None, "lateral_stress": "radial_stress", "tension_yarn_side_around": "tension_yarn_horizontal"}
        return super().__getitem__(same.get(name) or name)


class Bag(Series):
    """A bag under load from the end of the preload on, which is its row 0 and the zero of its settlement.

    groups, fabric, path: functions that return the tables of its groups along x and of its fabric, both of its recorded states,
    and of its stress paths.
    """

    def __init__(self, table, groups, fabric, path):
        preload = numpy.flatnonzero(table("stage", "1") == 0)
        if not len(preload):
            raise StudyError(f"{table.where}: has no row of the preload, stage 0")
        super().__init__(table.rows(numpy.arange(len(table)) >= preload[-1]))
        self._groups, self._fabric, self._path = groups, fabric, path

    @functools.cached_property
    def broken(self):
        """Row of the first broken yarn, or the last row."""
        broken = numpy.flatnonzero(self["broken_yarns"] > 0)
        return int(broken[0]) if len(broken) else len(self.table) - 1

    @functools.cached_property
    def failed(self):
        """Row of failure: the last whose load is within 2 % of the greatest."""
        pressure = self["plate_pressure"]
        return int(numpy.flatnonzero(pressure >= 0.98 * pressure.max())[-1])

    def strain_at(self, table):
        """Returns the axial strain (%) of the recorded state that a table is of."""
        return 100 * self["strain_axial"][self["step"] == table("step", "1")[0]][0]

    def before_end(self, row, what):
        """Returns the row. Raises NotMade where it is the last one, so that nothing tells whether `what` has come by then."""
        if row == len(self.table) - 1:
            raise NotMade(f"{what} does not come before {100 * self.last('strain_axial'):.0f} %")
        return row

    def step_at(self, strain):
        """Returns the step of the station at an axial strain."""
        near = numpy.flatnonzero(abs(self["strain_axial"] - strain) < 1e-3)
        if not len(near):
            raise NotMade(f"no station at {100 * strain:.0f} %")
        return self["step"][near[0]]

    def fabric(self, name, step):
        """Returns an anisotropy of the state that was recorded at a step."""
        table = self._fabric()
        return Series(_of_step(table, step))[name][0]

    def recorded_fabric(self, name):
        """Returns the rows of the recorded states, and an anisotropy of each."""
        fabric = Series(self._fabric())
        rows = [i for i, step in enumerate(self["step"]) if step in fabric["step"]]
        return rows, numpy.array([self.fabric(name, self["step"][i]) for i in rows])

    def groups(self, name, step):
        """Returns a column of the groups at a step, in their order along x."""
        return Series(_of_step(self._groups(), step))[name]

    def middle_over_edge(self, name, step):
        """Returns the mean of the groups between the outermost two over that of these two."""
        values = self.groups(name, step)
        return values[1:-1].mean() / values[[0, -1]].mean()

    def path(self, name):
        """Returns a property of the stress paths up to the first break: of the whole soil, then of the groups."""
        return Series(self._path())[name]


def _of_step(table, step):
    return table.rows(table("step", "1") == step)


@functools.cache
def yarns_cut():
    """Returns how many yarns of a face and of a side of the thesis's bag a plane in its middle cuts."""
    with open(HERE / "bag.toml", "rb") as file:
        return tomllib.load(file)["geotextile_mesh"]["cells"][1:]


def around(face, side):
    """Returns the mean tension of the yarns that a plane in the middle cuts, which balance the lateral stress."""
    faces, sides = yarns_cut()
    return (faces * face + sides * side) / (faces + sides)


class Runs:
    """The tables of a folder: those that the study has just made, or those kept of its runs at full size.

    absent: why a table may be missing; without it each missing table is an error. full: whether grains and yarns have the
    thesis's size. loads: dead loads of the bags in simple shear, N, from the least to the greatest.
    """

    def __init__(self, folder, full, loads, absent=""):
        self.folder, self.full, self.absent = pathlib.Path(folder), full, absent
        self.loads = sorted(loads)
        self.record = {g: Record(Table.read(RECORDED.format(g))) for g in GEOTEXTILES}
        self.table, self.bag = functools.cache(self._table), functools.cache(self._bag)

    def _table(self, name):
        path = self.folder / f"{name}.tsv"
        if self.absent and not path.exists():
            raise NotMade(f"{name}: {self.absent}")
        return Table.read(path)

    def _bag(self, name):
        return Bag(self.table(name), *(lambda part=part: self.table(f"{name}_{part}") for part in ("groups", "fabric", "path")))

    def bags(self):
        """Returns the compressed bags that are there, by geotextile."""
        there = {}
        for g in GEOTEXTILES:
            try:
                there[g] = self.bag(f"uc_{g}")
            except NotMade:
                continue
        return there

    def sheared(self):
        """Returns the sheared bags by their dead load, the least first."""
        if not self.loads:
            raise NotMade("no bag is sheared")
        return {load: self.bag(f"ss_{load}") for load in self.loads}

    @classmethod
    def kept(cls, folder=HERE / "kept"):
        """Returns what is kept of the runs at full size, in the repository or in another folder."""
        folder = pathlib.Path(folder)
        loads = [int(path.stem[3:]) for path in folder.glob("ss_*.tsv") if path.stem[3:].isdigit()]
        return cls(folder, True, loads, "not among the kept runs")
