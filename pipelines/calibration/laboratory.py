"""Triaxial tests of the laboratory as the particle filter takes them: natural strains in percent, stress ratio, some stations."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import pathlib
import re

import numpy
from study import StudyError, Table
from study.units import factor, measured

from . import plausible

# Names that the columns of strains may have.
AXIAL, VOLUMETRIC = ("strain_axial", "axial_strain"), ("strain_volumetric", "volumetric_strain")
# Observables with other names in a run: the greatest stress ratio of a test without a curve; the radial strain, a mean of two columns.
PEAK, RADIAL = "stress_ratio_peak", "strain_radial"
OF_A_RUN = {PEAK: "stress_ratio", RADIAL: "strain_xx,strain_yy"}
KINDS = ("engineering", "natural", "greatest")
LEAST_STATIONS = 3
# Range of confining pressures (Pa). Greatest relative difference of the lateral stress from it, in one row and in the median.
PRESSURES = (500, 1e8)
LATERAL, LATERAL_MEDIAN = 0.25, 0.1


def plain(name):
    """Returns the name of a file without characters that are special to a shell or to make."""
    return re.sub(r"[^A-Za-z0-9._+-]+", "_", name)


@dataclasses.dataclass(frozen=True)
class Test:
    """A drained triaxial test: its table, confining pressure (Pa), kind of strains (of KINDS) and the packing that it is run with."""

    table: pathlib.Path
    pressure: float
    kind: str
    packing: str

    @property
    def name(self):
        """The name of the test's files: the name of its table and its pressure."""
        return f"{plain(self.table.stem)}_{self.pressure / 1e3:g}kPa"

    @property
    def megapascals(self):
        """The confining pressure in MPa as text without an exponent."""
        return f"{self.pressure / 1e6:.9f}".rstrip("0").rstrip(".")


@dataclasses.dataclass(frozen=True)
class Curve:
    """All rows of a test: natural strains in percent and axial over radial stress; compression and contraction are positive."""

    test: Test
    table: Table
    axial: numpy.ndarray
    volumetric: numpy.ndarray
    ratio: numpy.ndarray

    @property
    def stress(self):
        """The name of the column that the stress ratio is computed from."""
        return _stress(self.table)

    @property
    def rising(self):
        """The mask of rows whose axial strain is above 0 and above the axial strains of all rows before."""
        return self.axial > numpy.maximum.accumulate(numpy.append(0, self.axial[:-1]))

    @property
    def strength(self):
        """The greatest stress ratio."""
        return self.ratio[self.rising].max()

    @property
    def still_rises(self):
        """Whether the last row of rising strain has the greatest stress ratio, so that the peak may lie beyond."""
        return bool(self.ratio[self.rising][-1] == self.strength)

    @property
    def without_unit(self):
        """The columns of strains that have no unit."""
        return [name for name in (*AXIAL, *VOLUMETRIC) if self.table.has(name) and not self.table.unit(name)]

    @property
    def pore_pressures(self):
        """The columns of pore pressures."""
        return [name for name in self.table.names if ("pore" in name.casefold() or name in ("u", "du")) and self._is_stress(name)]

    @property
    def unread(self):
        """The columns of stresses that the stress ratio is not computed from."""
        read = ("deviatoric_stress", "mean_stress") if self.stress == "deviatoric_stress" else ("stress_ratio",)
        return [name for name in self.table.names if self._is_stress(name) and name not in read]

    def _is_stress(self, name):
        return measured(self.table.unit(name)) == "stress"


def pressure(text):
    """Returns a pressure such as "100 kPa" in Pa. Raises StudyError for other text, and for values outside of PRESSURES."""
    match = re.fullmatch(r"\s*([0-9.]+(?:[eE][-+]?[0-9]+)?)\s*(\S+)\s*", str(text))
    try:
        value = float(match[1]) * factor(match[2], "Pa") if match else 0
    except ValueError:
        value = 0
    if not value > 0:
        raise StudyError(f'"{text}" is no pressure; write a number above 0 and its unit, as "100 kPa"')
    if not PRESSURES[0] <= value <= PRESSURES[1]:
        raise StudyError(f'"{text}" is no confining pressure of a test, which lies between {PRESSURES[0]:g} Pa and {PRESSURES[1] / 1e6:g} MPa; check '
                         "its unit")
    return value


def _strain(table, names, test):
    """Returns the natural strains (%) of the column that has one of the names. Raises StudyError where none is there."""
    name = next((name for name in names if table.has(name)), names[0])
    return _natural(table(name, "1"), test.kind, name, test.table)


def _stress(table):
    return "deviatoric_stress" if table.has("deviatoric_stress") else "stress_ratio"


def _ratio(table, test):
    """Returns the stress ratio from its column, or from the deviatoric stress and the mean stress or the confining pressure."""
    if not table.has("deviatoric_stress"):
        return table("stress_ratio", "1")
    q = table("deviatoric_stress", "Pa")
    if not table.has("mean_stress"):
        return 1 + q / test.pressure
    lateral = table("mean_stress", "Pa") - q / 3
    if not abs(numpy.median(lateral) / test.pressure - 1) <= LATERAL_MEDIAN:
        raise StudyError(f"{test.table}: its lateral stress is {numpy.median(lateral) / 1e3:.4g} kPa, the confining pressure given "
                         f"{test.pressure / 1e3:.4g} kPa; correct the one that is wrong")
    wrong = ~(abs(lateral / test.pressure - 1) <= LATERAL)
    if wrong.any():
        row = int(numpy.argmax(wrong))
        raise StudyError(f"{test.table}: row {row + 1}: mean_stress - deviatoric_stress/3, the lateral stress, is {lateral[row] / 1e3:.4g} kPa, where "
                         f"the confining pressure is {test.pressure / 1e3:.4g} kPa; correct one of the columns")
    return 1 + q / lateral


def _natural(strain, kind, what, path):
    """Converts engineering or natural strains (fractions) to natural strains in percent; compression is positive in both."""
    if kind == "natural":
        return 100 * strain
    if (strain >= 1).any():
        row = int(numpy.argmax(strain >= 1))
        raise StudyError(f"{path}: row {row + 1}: {what} reaches {100 * strain[row]:.4g} %, of the initial size: write [%] or [1] as it is meant")
    return 0 - 100 * numpy.log(1 - strain)


def distinct_names(tests):
    """Raises StudyError where the files of two tests would have one name."""
    names = [test.name for test in tests]
    for k, test in enumerate(tests):
        if test.name in names[:k]:
            raise StudyError(f"{test.table}: two tests have a table of this name and {test.pressure / 1e3:g} kPa; name each test once, or rename one of the "
                             "tables")


def curve(test):
    """Returns the Curve of a test. Raises StudyError for columns that are missing, and for rows that no drained compression test has."""
    table = Table.read(test.table)
    axial, volumetric = (_strain(table, names, test) for names in (AXIAL, VOLUMETRIC))
    if not len(table):
        raise StudyError(f"{test.table}: holds no rows below its header")
    stress = _stress(table)
    if abs(axial).argmax() == 0 and (numpy.diff(axial) < 0).sum() > len(axial) / 2:
        raise StudyError(f"{test.table}: row 1 has the greatest axial strain, {axial[0]:.4g} %: sort the rows in the order of the test")
    if axial[-1] < 0 or table(stress, "kPa" if stress == "deviatoric_stress" else "1")[-1] < 0:
        raise StudyError(f"{test.table}: ends at an axial strain of {axial[-1]:.4g} %, or at a negative {stress}: compression is positive, and the "
                         "axial stress the greater one; change the signs")
    found = Curve(test, table, axial, volumetric, _ratio(table, test))
    if not found.rising.any():
        raise StudyError(f"{test.table}: no row has an axial strain above 0: give the rows of the test, with compression positive")
    plausible.judge(found)
    return found


def as_it_stands(found, names):
    """Returns whether the filter can read the table as it is: natural strains in percent that increase, and all columns."""
    table = found.table
    units = (("%",) if name.startswith("strain") else ("1", "-", "") for name in ("strain_axial", *names))
    return found.test.kind == "natural" and bool((numpy.diff(found.axial) > 0).all()) and all(
        table.has(name) and table.unit(name) in some for name, some in zip(("strain_axial", *names), units, strict=True))


def observed(found, until, stations, names=()):
    """Returns the columns of a curve at `stations` rows near evenly spaced natural axial strains, at most `until` percent.

    stations: 0 keeps all rows whose axial strain increases. names: observables; the radial strain is returned only if it is one of them.
    Raises StudyError where less than LEAST_STATIONS are left.
    """
    rising = found.rising & (found.axial <= until + 1e-9)
    if rising.sum() < LEAST_STATIONS:
        raise StudyError(f"{found.test.table}: {rising.sum()} rows have a rising axial strain above 0 and up to {until:g} %, of {len(rising)} between "
                         f"{found.axial.min():.4g} and {found.axial.max():.4g} %; {LEAST_STATIONS} are needed: give more rows, or a larger strain")
    rows = numpy.flatnonzero(rising)
    if stations:
        wanted = found.axial[rows[-1]] * numpy.arange(1, stations + 1) / stations
        rows = numpy.unique([rows[abs(found.axial[rows] - at).argmin()] for at in wanted])
    columns = {"strain_axial [%]": found.axial[rows], "stress_ratio [1]": found.ratio[rows], "strain_volumetric [%]": found.volumetric[rows]}
    if RADIAL in names and found.table.has(RADIAL):
        columns[f"{RADIAL} [%]"] = _strain(found.table, (RADIAL,), found.test)[rows]
    return columns


def greatest(test):
    """Returns the greatest stress ratio of a test without a curve. Raises StudyError for one that no soil has."""
    values = Table.read(test.table)(PEAK, "1")
    for row, value in enumerate(values, start=1):
        if not plausible.NO_STRENGTH <= value <= plausible.GREATEST_RATIO:
            raise StudyError(f"{test.table}: row {row}: {PEAK} is {value:.4g}; axial over radial stress at failure lies between "
                             f"{plausible.NO_STRENGTH} and {plausible.GREATEST_RATIO}: correct it")
    if len(values) != 1:
        raise StudyError(f"{test.table}: has {len(values)} rows of {PEAK}, of which a test has one: give each test a table of its own")
    return values[0]
