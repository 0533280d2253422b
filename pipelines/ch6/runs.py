"""Results of the runs of chapter 6: curves over the pull, the history of a point, the soil and its sheet at the end."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import functools
import math

import numpy
from study import Folder, NotMade, Series, StudyError

STRETCH = 3.0  # cm of pull that curves are averaged over: the few rods of a packing fluctuate


@dataclasses.dataclass(frozen=True)
class Size:
    """The runs of a profile, each named SQUARES_SPEED: squares along a side, cm/s. study.mk has the same names.

    main: the run whose fields and points are measured. meshes, speeds: runs that differ from each other in the mesh or the speed alone.
    """

    grains: int
    main: str
    meshes: tuple
    speeds: tuple

    def __str__(self):
        return f"{2 * squares(self.main)**2} elements, {self.grains} rods a point"

    @property
    def cases(self):
        """All runs, from the coarsest mesh and the lowest speed on."""
        return sorted({*self.meshes, *self.speeds}, key=lambda case: (squares(case), speed(case)))


SIZES = {"quick": Size(100, "4_3", ("2_3", "4_3"), ("4_3", "4_6")),
         "thesis": Size(400, "8_0.5", ("6_1", "8_1", "10_1"), ("8_0.25", "8_0.5", "8_1"))}


def squares(case):
    """Returns how many squares of two elements a run has along a side."""
    return int(case.split("_")[0])


def speed(case):
    """Returns the speed of a run's pull, cm/s."""
    return float(case.split("_")[1])


def label(case):
    """Returns a run's name for legends."""
    return f"{2 * squares(case)**2} elements, {speed(case):g} cm/s"


class Curve(Series):
    """A column of a run's table "loading" over the pull of the sheet's end (cm), in the rows where it has a value.

    Friction has no value while soil and sheet do not touch.
    """

    def __init__(self, table, name):
        touching = ~numpy.isnan(table[name])
        if not touching.any():
            raise StudyError(f"{table.where}: column {name} has no value in any row")
        super().__init__(table.rows(touching))
        self.pull, self.value = self["pull_end"], self[name]

    def at(self, pull):
        """Returns the values at pulls, linearly between rows. A pull beyond the last row by more than a tenth of a mm is refused."""
        if numpy.max(pull) > self.pull[-1] + 0.01:
            raise StudyError(f"{self.table.where}: the pull ends at {self.pull[-1]:.4g} cm, before {numpy.max(pull):.4g} cm")
        return numpy.interp(pull, self.pull, self.value)

    @property
    def end(self):
        """The pull at the end, cm, at most the quarter of a metre that the run is asked for."""
        return min(self.pull[-1], 25.0)

    def mean(self, start, end):
        """Returns the mean between two pulls."""
        return self.at(numpy.linspace(start, end, 21)).mean()

    def onset(self):
        """Returns the pull where hardening begins: the mean over 1 cm first exceeds a tenth of the mean over the last 3 cm."""
        last = self.mean(self.end - STRETCH, self.end)
        for start in numpy.arange(0, 24, 0.25):
            if self.mean(start, start + 1) > 0.1 * last:
                return start + 0.5
        raise NotMade("the stress nowhere passes a tenth of that at the end")

    def rate(self):
        """Returns the slope over the first 2 mm of pull, 1/s."""
        time = self["time"]
        return (self.at(0.2) - self.value[0]) / (0.2 * time[-1] / self.pull[-1])


def spread(curves, start):
    """Returns the greatest difference between curves, averaged over stretches of STRETCH from a pull on, over the greatest average."""
    end = min(c.end for c in curves)
    starts = numpy.arange(start, end - 0.01, STRETCH)
    means = numpy.array([[c.mean(a, min(a + STRETCH, end)) for a in starts] for c in curves])
    return numpy.ptp(means, axis=0).max() / means.max()


class History(Series):
    """The history of a point, output by output. Parts of it are given as shares of the pull, which has a constant speed."""

    derived = {"pull": ("cm", "pulled", lambda h: 25 * h.table["time"] / h.table["time"][-1]),
               "p": ("kPa", "p", lambda h: h.table["mean_stress"]), "q": ("kPa", "q", lambda h: h.table["deviatoric_stress"]),
               "shear": ("%", "ε_q", lambda h: h.table["strain_shear"]),
               "volumetric": ("%", "ε_v, contraction positive", lambda h: h.table["strain_volumetric"]),
               # Points below 1e-3 kPa have no q/p. Points without contacts, which have F_a = -1 in the table, have no F_a.
               "obliquity": ("1", "q/p", lambda h: h["q"] / numpy.where(h["p"] > 1e-3, h["p"], math.nan)),
               "touching": ("1", "F_a", lambda h: numpy.where(h["anisotropy"] >= 0, h["anisotropy"], math.nan))}

    def part(self, start, end):
        """Returns the rows from one share of the history to another, the outputs numbered from 1."""
        n = len(self)
        return slice(max(int(start * n), 1) - 1, math.floor(end * n))

    def obliquity(self, rows):
        """Returns q/p of the means over rows: q/p of single outputs fluctuates."""
        if not self["p"][rows].sum() > 0:
            raise NotMade("the point carries no mean stress there")
        return self["q"][rows].sum() / self["p"][rows].sum()

    def until(self, pull):
        """Returns the rows after the start up to a pull (cm), two at least."""
        return slice(1, max(int(len(self) * pull / 25), 3))

    @property
    def loosest(self):
        """The output at which the point is most dilated, or the first output if it never dilates."""
        return int(numpy.argmin(self["volumetric"]))

    @property
    def dilating(self):
        """The rows after the start up to the loosest."""
        return slice(1, self.loosest + 1)


class Field:
    """The soil and the sheet at the end of a run: nodes (m), elements as corners, and a point in each element."""

    def __init__(self, elements, points, nodes, bars):
        self.points, self.bars = points, bars
        self.corners = numpy.stack([elements(f"node_{k}", "1") for k in range(3)], axis=1).astype(int)
        for table, name, count in ((elements, "element", len(self.corners)), (points, "element", len(self.corners)),
                                   (nodes, "node", self.corners.max() + 1)):
            if list(table(name, "1")) != list(range(count)):
                raise StudyError(f"{table.where}: column {name} does not number {count} {name}s from 0 on; print the table of one state")
        self.position = numpy.stack([nodes("x", "m"), nodes("y", "m")], axis=1)
        self.displacement = numpy.stack([nodes("displacement_x", "m"), nodes("displacement_y", "m")], axis=1)
        self.start = self.position - self.displacement

    @property
    def side(self):
        """The side of the square of soil before the pull, m."""
        return self.start.max()

    @property
    def magnified(self):
        """Factor by which displacements are drawn larger than they are."""
        most = numpy.linalg.norm(self.displacement, axis=1).max()
        return 10**math.floor(math.log10(0.2 / most)) if 0 < most < 0.05 else 1

    def corners_at(self, height):
        """Returns how many corners of each element were at a height (m) before the pull."""
        return (abs(self.start[:, 1] - height) < 1e-4 * self.side)[self.corners].sum(axis=1)

    def mean(self, name, unit, mask):
        """Returns the mean of a column of the points where the mask holds."""
        return self.points.rows(mask)(name, unit).mean()

    def asymmetry(self):
        """Returns the difference of the mean stress of the left and the right half over their sum, %."""
        left = self.points("x", "m") < self.side / 2
        p = self.points("mean_stress", "kPa")
        return 100 * abs(p[left].sum() - p[~left].sum()) / abs(p.sum())

    def along(self, corners):
        """Returns the elements along the middle half of the bottom that have so many corners on it."""
        x = self.points("x", "m") / self.side
        return (self.corners_at(0) == corners) & (x >= 0.25) & (x <= 0.75)

    def rise(self, mask):
        """Returns the mean rise (mm) of the nodes whose mask holds."""
        return 1000 * self.displacement[mask, 1].mean()

    def heaves_from(self):
        """Returns the place (m) of the leftmost column of nodes that rises on the whole."""
        columns = numpy.round(self.start[:, 0] / self.side, 4)
        rising = [x for x in numpy.unique(columns) if self.displacement[columns == x, 1].sum() > 0]
        if not rising:
            raise NotMade("no column of nodes rises")
        return rising[0] * self.side


class Runs:
    """The tables in a folder of the runs of one size."""

    def __init__(self, folder, size):
        self.size, self.tables = size, Folder(folder)
        # Stress at the bottom in shape-forming, friction ratio in pull-outs; point A (shape) or B (pullout); the last state.
        self.curve, self.history, self.field = map(functools.cache, (self._curve, self._history, self._field))

    def table(self, kind, example, case=None):
        """Returns a table of fem-dem of a run, the main one where no case is given."""
        return self.tables(f"{kind}_{example}_{case or self.size.main}")

    def _curve(self, example, case=None):
        return Curve(self.table("loading", example, case), "traction_y_bottom" if example == "shape" else "interface_friction")

    def _history(self, example):
        return History(self.table("local", example))

    def _field(self, example):
        return Field(*(self.table(kind, example) for kind in ("elements", "points", "nodes", "bars")))

    def swinging(self):
        """Returns the curve of the pull-out with the thesis's damping of the soil."""
        if not (self.tables.path / f"loading_swinging_{self.size.main}.tsv").exists():
            raise NotMade("its run is not kept")
        return self.curve("swinging")

    def balance(self, example):
        """Returns the error of the energy balance at the end of the main run over the work done, %."""
        table = self.table("loading", example)
        return 100 * abs(table("energy_error", "J m-1")[-1] / table("external_work", "J m-1")[-1])
