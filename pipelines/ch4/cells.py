"""Results of the runs of chapter 4: a cell of reinforced soil in drained compression, the same of soil alone, sections of both forms."""
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib
import functools
import itertools
import pathlib
import tomllib

import numpy
from study import Folder, NotMade, Series, StudyError

HERE = pathlib.Path(__file__).parent
FORMS = ("wrapped", "layered")
GEOTEXTILES = ("PE", "PP", "5PP")  # from soft to stiff
MIDDLING = "PP"  # the geotextile that Fig. 4.6 shows
TWIN = "PE"  # the geotextile whose wrapped cell is also sheared at a tenth of the rate, in the fewest steps of all
GROUPS = ("1", "2", "3")  # groups of the reinforced soil, from its edge to its middle
SHEAR = 1  # number of the stage in triaxial.toml
EARLIEST = 2  # % of axial strain from which on the forms are compared


@functools.cache
def confining():
    """Returns the lateral stress that the cells are sheared under, kPa."""
    words = tomllib.loads((HERE / "triaxial.toml").read_text(encoding="utf-8"))["stage"][SHEAR]["confining_pressure"]
    number, unit = words.split()
    if unit != "kPa":
        raise StudyError(f"triaxial.toml: the confining pressure {words} is not in kPa")
    return float(number)


def column(name, unit, words, over=1.0):
    """Returns an entry of Series.derived: a column of the table over a number."""
    return unit, words, lambda cell: cell.table(name, unit) / over


def stress(name, words):
    """Returns an entry of Series.derived: a stress over the confining one."""
    return "1", words, lambda cell: cell.table(name, "kPa") / confining()


def grouped(k, stress_of, words):
    """Returns an entry of Series.derived: a stress of a group of the reinforced soil. Raises NotMade where it has no value in the run."""
    def read(cell):
        values = cell.table(f"group_{k}_{stress_of}_stress", "kPa", missing=True)
        if numpy.isnan(values).any():
            raise NotMade(f"{pathlib.Path(cell.table.where).stem}: the run did not record its groups")
        return values
    return "kPa", words, read


class Soil(Series):
    """A cell of soil alone, from the start of shear on. Cell has the same columns, and more."""

    derived = {"strain": ("%", "axial strain", lambda c: 100 * -numpy.expm1(-c.table("strain_axial", "1"))),
               "ratio": stress("stress_zz", "σₐ/σ_c"),
               "contraction": column("strain_volumetric", "%", "volumetric strain, contraction positive"),
               "e": column("void_ratio", "1", "void ratio of the cell"),
               "p": column("mean_stress", "kPa", "mean stress p"),
               "q": column("deviatoric_stress", "kPa", "deviatoric stress q")}

    def __init__(self, table):
        super().__init__(table.rows(table("stage", "1") == SHEAR))

    @functools.cached_property
    def peak(self):
        """Row of the greatest axial stress."""
        return self.most("ratio")


class Cell(Soil):
    """A cell with reinforced soil in it. p and q, and p1 to q3, are those of the soil and of its groups."""

    derived = Soil.derived | {
        "strain": column("strain_axial_engineering", "%", "axial strain"),
        "ratio": stress("axial_stress", "σₐ/σ_c"),
        "lateral": stress("lateral_stress", "σᵣ/σ_c"),
        **{f"strain_{axis}": column(f"strain_{axis}", "%", f"strain along {axis}") for axis in "xy"},
        "fill": ("1", "mean stress of the fill over σ_c",
                 lambda c: (c.table("fill_axial_stress", "kPa") + 2 * c.table("fill_lateral_stress", "kPa")) / 3 / confining()),
        "inside_axial": stress("soil_axial_stress", "σ_z'/σ_c"),
        "inside_lateral": stress("soil_lateral_stress", "σ_x'/σ_c"),
        "p": column("soil_mean_stress", "kPa", "mean stress p"),
        "q": column("soil_deviatoric_stress", "kPa", "deviatoric stress q"),
        "e_inside": column("soil_delaunay_void_ratio", "1", "void ratio of the reinforced soil"),
        "shear": column("soil_strain_deviatoric", "%", "deviatoric strain of the reinforced soil"),
        "broken": column("broken_yarns", "1", "broken yarns"),
        **{f"p{k}": grouped(k, "mean", "mean stress p") for k in GROUPS},
        **{f"q{k}": grouped(k, "deviatoric", "deviatoric stress q") for k in GROUPS}}

    @functools.cached_property
    def whole(self):
        """The rows before a yarn has broken."""
        broken = numpy.flatnonzero(self["broken"] > 0)
        return slice(int(broken[0]) if len(broken) else len(self))

    def path(self, of=""):
        """Returns the slope q/p of the stress path up to the peak, and the greatest distance from a line of that slope, % of the greatest q.

        The line is the least-squares line through the origin. of: a group; by default the whole reinforced soil.
        """
        rows = slice(self.peak + 1)
        p, q = self[f"p{of}"][rows], self[f"q{of}"][rows]
        slope = (p * q).sum() / (p * p).sum()
        return slope, 100 * abs(q - slope * p).max() / q.max()


class Runs:
    """The tables of a folder: the cells by form and geotextile, soil alone, contacts at the start, bands and sections.

    kept: whether the tables are those of kept runs. Some of these may be missing; whatever needs a missing one raises NotMade.
    """

    def __init__(self, out, kept=False):
        self.folder = Folder(out, "not among the kept runs" if kept else "")
        self.absent = Folder(out, "this profile does not make the run")

    @functools.cache
    def cell(self, form, geotextile):
        """Returns the Cell of a form with a geotextile."""
        return Cell(self.folder(f"{form}_{geotextile}"))

    def cells(self):
        """Returns the cells that there are. Raises NotMade for none."""
        found = []
        for form, geotextile in itertools.product(FORMS, GEOTEXTILES):
            with contextlib.suppress(NotMade):
                found.append(self.cell(form, geotextile))
        if not found:
            raise NotMade("no cell is among the kept runs")
        return found

    def shape(self, form):
        """Returns height, yarns' length and void ratio of the reinforced soil of a form, as it was placed and after it was compacted."""
        table = self.folder(f"{form}_shape")
        return {"height": table("height", "m"), "yarns": table("yarn_length", "1"), "e_inside": table("soil_void_ratio", "1")}

    @functools.cached_property
    def soil(self):
        """Soil alone."""
        return Soil(self.folder("soil"))

    def slow(self):
        """Returns the wrapped cell of TWIN sheared at a tenth of the rate. Raises NotMade if it was not run."""
        return Cell(self.absent(f"wrapped_{TWIN}_slow"))

    def pair(self, geotextile):
        """Returns the wrapped and the layered cell of a geotextile."""
        return tuple(self.cell(form, geotextile) for form in FORMS)

    @property
    def pairs(self):
        """The pairs of all geotextiles, from soft to stiff."""
        return [self.pair(g) for g in GEOTEXTILES]


def compared(pair):
    """Returns the stations of a pair of cells from EARLIEST on, as a slice."""
    return slice(int(numpy.searchsorted(pair[0]["strain"], EARLIEST - 1e-3)), None)


def both_whole(pair):
    """Returns the compared rows before the first break in either cell. Raises NotMade if there are none."""
    rows = slice(compared(pair).start, min(cell.whole.stop for cell in pair))
    if rows.stop <= rows.start:
        raise NotMade(f"yarns break before {EARLIEST} % of axial strain")
    return rows


def over(pair, name, rows=slice(None)):
    """Returns the column of the wrapped cell over that of the layered one."""
    wrapped, layered = (cell[name] for cell in pair)
    if len(wrapped) != len(layered):
        raise StudyError(f"{pair[1].table.where}: has another number of stations than {pair[0].table.where}")
    return (wrapped / layered)[rows]


def least_rise(values):
    """Returns the least rise from one value to the next: above 0 where they rise all along."""
    return numpy.diff(values).min()
