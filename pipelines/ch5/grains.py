"""DEM runs of chapter 5: seven bags between plates, nine cells of wrapped soil, the constants identified from them, the model."""
# SPDX-License-Identifier: GPL-3.0-or-later
import functools
import pathlib
import tomllib

import numpy
from ch3 import bag as ch3
from study import Folder, NotMade, Series, Table

UNIAXIAL = ("PE", "0.5PP", "PP", "2PP", "3PP", "4PP", "5PP")  # from soft to stiff, PE aside
RECORDED = ("PE", "PP", "3PP")  # geotextiles whose discrete-element series are public
SHEARED, PRESSURES = ("PE", "PP", "5PP"), ("10", "50", "100")  # kPa
SOILS = {"": "Table 5.2", "own_": "own constants"}  # whose constants a solution has, by the prefix of its table's name
SHEAR = 1  # number of the stage of a cell's run
FACE_YARNS, SIDE_YARNS = 91, 20  # yarns of a vertical hoop along a face, and up the sides
STRENGTH_OF = {"PE": "PE"}  # geotextiles with a curve of their own; the others are multiples of PP


def strength(geotextile):
    """Returns the tension (N) at which a yarn of a geotextile fails."""
    base = STRENGTH_OF.get(geotextile, "PP")
    with open(pathlib.Path("data/geotextiles") / f"{base}.toml", "rb") as file:
        return tomllib.load(file)["yarn_tension"][-1] * float(geotextile.removesuffix(base) or 1)


def hoop_strain(face, around, up):
    """Returns the mean strain of horizontal and vertical hoops.

    A vertical hoop runs over both faces, 2 x 400 mm, and both sides, 2 x 80 mm.
    """
    return (around + (5 * face + up) / 6) / 2


def vertical_hoop(face, up):
    """Returns the mean tension of the vertical hoops: faces and sides weighted by their numbers of yarns."""
    return (FACE_YARNS * face + SIDE_YARNS * up) / (FACE_YARNS + SIDE_YARNS)


class Pressed(Series):
    """Quantities that a bag and a cell have in common: stresses of the soil, strains, and the load from outside."""

    @functools.cached_property
    def peak(self):
        """Row of the greatest surcharge."""
        return self.most("surcharge")

    @property
    def path_slopes(self):
        """dq/dp of each increment."""
        return numpy.diff(self["deviatoric_stress"]) / numpy.diff(self["mean_stress"])

    @property
    def dilation(self):
        """-dε_v/dε_d of the last two increments up to the peak."""
        first = max(self.peak - 2, 0)
        volumetric, deviatoric = (self[f"strain_{kind}"][self.peak] - self[f"strain_{kind}"][first] for kind in ("volumetric", "deviatoric"))
        return -volumetric / deviatoric


class Bag(ch3.Bag, Pressed):
    """A bag under load from the end of the preload on. stiffness: the geotextile's in the model, kN/m."""

    derived = ch3.Bag.derived | {
        "radial_stress": ("kPa", "lateral stress", lambda b: b["lateral_stress"]),
        "hoop_strain": ("%", "hoop strain", lambda b: hoop_strain(b["strain_yarn_face"], b["strain_yarn_side_around"], b.up("strain", "%"))),
        "reinforcing_efficiency": ("1/m", "surcharge over stiffness", lambda b: b["surcharge"] / b.stiffness),
        "hoop_vertical": ("N", "tension of vertical hoops", lambda b: vertical_hoop(b["tension_yarn_face"], b.up("tension", "N")))}

    def __init__(self, table, stiffness):
        super().__init__(table, None)
        self.stiffness = stiffness

    def up(self, what, unit):
        """Returns tension or strain of the yarns that run up the sides."""
        return self.table(f"{what}_yarn_side_up", unit)


class Cell(Pressed):
    """A cell of wrapped soil in triaxial compression. Its surcharge is the cell's axial stress, stresses and volume are the soil's.

    Strains are engineering strains, like those of the bags and of the solution.
    """

    derived = {
        "strain_axial": ("%", "axial strain", lambda c: c.table("strain_axial_engineering", "%")),
        "strain_volumetric": ("%", "volumetric strain, contraction positive",
                              lambda c: -100 * numpy.expm1(-c.table("soil_strain_volumetric", "1"))),
        "strain_deviatoric": ("%", "deviatoric strain", lambda c: c["strain_axial"] - c["strain_volumetric"] / 3),
        "surcharge": ("kPa", "surcharge", lambda c: c.table("axial_stress", "kPa")),
        "axial_stress": ("kPa", "axial stress", lambda c: c.table("soil_axial_stress", "kPa")),
        "radial_stress": ("kPa", "lateral stress", lambda c: c.table("soil_lateral_stress", "kPa")),
        "mean_stress": ("kPa", "mean stress p", lambda c: c.table("soil_mean_stress", "kPa")),
        "deviatoric_stress": ("kPa", "deviatoric stress q", lambda c: c.table("soil_deviatoric_stress", "kPa")),
        "obliquity": ("1", "q/p", lambda c: c["deviatoric_stress"] / c["mean_stress"])}

    def __init__(self, table):
        super().__init__(table.rows(table["stage"] == SHEAR))

    @functools.cached_property
    def peak(self):
        """Row of the greatest surcharge. Raises NotMade if it is the last one, since a greater surcharge may come later."""
        row = self.most("surcharge")
        if row == len(self) - 1:
            raise NotMade(f"the greatest stress of the cell does not come before {self.last('strain_axial'):.0f} %")
        return row

    @property
    def capacity(self):
        """The greatest surcharge, kPa. Raises NotMade as peak does."""
        return self["surcharge"][self.peak]

    @functools.cached_property
    def broken(self):
        """Row of the first broken yarn, or the last row."""
        broken = numpy.flatnonzero(self["broken_yarns"] > 0)
        return int(broken[0]) if len(broken) else len(self) - 1


class Grains:
    """The tables of the runs in a folder, and the solutions beside them.

    absent: why a bag's table may be missing; cells may be missing at any rate. solutions: folder of the tables of gws-solve.
    """

    def __init__(self, folder, solutions, absent=""):
        self.bags_of, self.cells_of = Folder(folder, absent), Folder(folder, absent or "this profile does not make the run")
        self.solutions = Folder(solutions)
        self.record = {g: ch3.Record(Table.read(ch3.RECORDED.format(g))) for g in RECORDED}

    @functools.cache
    def bag(self, geotextile):
        """Returns the Bag of a geotextile."""
        return Bag(self.bags_of(f"uc_{geotextile}"), self.model("", geotextile)("tensile_stiffness", "kN/m")[0])

    @functools.cache
    def cell(self, geotextile, pressure):
        """Returns the Cell of a geotextile under a lateral stress (kPa, as text). Raises NotMade without."""
        return Cell(self.cells_of(f"cell_{geotextile}_{pressure}kPa"))

    def bags(self):
        """Returns the bags that there are, by geotextile."""
        return there({g: functools.partial(self.bag, g) for g in UNIAXIAL})

    def cells(self):
        """Returns the cells that there are, by geotextile and lateral stress."""
        return there({(g, p): functools.partial(self.cell, g, p) for g in SHEARED for p in PRESSURES})

    def own(self, name):
        """Returns a table of constants identified from these bags."""
        return self.bags_of(f"own_{name}")

    def model(self, soil, geotextile, pressure=None):
        """Returns the solution for a bag, or for a cell under a lateral stress. soil: one of SOILS."""
        name = f"{soil}uniaxial_{geotextile}" if pressure is None else f"{soil}triaxial_{geotextile}_{pressure}kPa"
        return (self.bags_of if soil else self.solutions)(name)

    @functools.cached_property
    def volumes(self):
        """Principal stresses of the copies in the bag of PP, state by state."""
        return self.bags_of("volumes_PP")


def there(makers):
    """Returns the results of the makers by name, without those that raise NotMade."""
    made = {}
    for name, make in makers.items():
        try:
            made[name] = make()
        except NotMade:
            continue
    return made


class Copies:
    """Principal stresses (kPa) and their directions in the copies of a bag, n by n, at one step."""

    def __init__(self, table, step):
        self.table = table.rows(table["step"] == step)
        self.side = round(len(self.table)**0.5)

    def stress(self, number):
        """Returns principal stress 1, 2 or 3 of each copy."""
        return self.table(f"principal_{number}", "kPa")

    def direction(self, number, axis):
        """Returns a component of the unit direction of principal stress 1, 2 or 3 in each copy."""
        return self.table(f"direction_{number}{axis}", "1")

    def place(self, axis):
        """Returns where the copies are along x or y, mm."""
        return self.table(f"centre_{axis}", "mm")

    def inclination(self):
        """Returns the angle of the greatest stress to the vertical, deg, mean over the copies."""
        return numpy.degrees(numpy.arccos(numpy.minimum(1, abs(self.direction(1, "z"))))).mean()

    def turn(self):
        """Returns the angle of the medium stress to the nearer of x and y, in plan, deg, mean over the copies."""
        angle = numpy.degrees(numpy.arctan2(abs(self.direction(2, "y")), abs(self.direction(2, "x"))))
        return numpy.minimum(angle, 90 - angle).mean()

    def inwards(self):
        """Returns the greatest stress of the copies in the middle over that of the outermost ones."""
        x, y = numpy.divmod(numpy.arange(self.side**2), self.side)
        off = numpy.maximum(abs(x - (self.side - 1) / 2), abs(y - (self.side - 1) / 2))
        stress = self.stress(1)
        return stress[off <= self.side / 5].mean() / stress[off > (self.side - 1) / 2 - 0.5].mean()
