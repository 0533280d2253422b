"""Triaxial tests of the laboratory as the particle filter takes them: natural strains in percent, stress ratio, some stations."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import pathlib
import re

import numpy
from study import StudyError, Table
from study.units import factor

# Columns by what they may be called, each with its unit here.
AXIAL, VOLUMETRIC = ("strain_axial", "axial_strain"), ("strain_volumetric", "volumetric_strain")
# The greatest stress ratio of a test, where there is no curve, and the columns of a run that an observable is the mean of.
PEAK = "stress_ratio_peak"
OF_A_RUN = {PEAK: "stress_ratio", "strain_radial": "strain_xx,strain_yy"}
KINDS = ("engineering", "natural", "greatest")
LEAST_STATIONS = 3


@dataclasses.dataclass(frozen=True)
class Test:
    """A drained triaxial test: its table, confining pressure (Pa), kind of strains (of KINDS) and the packing that it is run with."""

    table: pathlib.Path
    pressure: float
    kind: str
    packing: str

    @property
    def name(self):
        """The name of its files: that of its table and its pressure."""
        return f"{self.table.stem}_{self.pressure / 1e3:g}kPa"

    @property
    def megapascals(self):
        """The confining pressure in MPa, with digits and a decimal point alone."""
        return f"{self.pressure / 1e6:.9f}".rstrip("0").rstrip(".")


def pressure(text):
    """Returns a pressure such as "100 kPa" in Pa. Raises StudyError for what is none, or is not above 0."""
    match = re.fullmatch(r"\s*([0-9.]+(?:e[-+]?[0-9]+)?)\s*(\S+)\s*", str(text))
    try:
        value = float(match[1]) * factor(match[2], "Pa") if match else 0
    except ValueError:
        value = 0
    if not value > 0:
        raise StudyError(f'"{text}" is no pressure; write a number above 0 and its unit, as "100 kPa"')
    return value


def _column(table, names, unit):
    """Returns the column that has one of the names. Raises StudyError where none is there."""
    return table(next((name for name in names if table.has(name)), names[0]), unit)


def _ratio(table, test):
    """Returns the stress ratio from its column, or from the deviatoric stress and the mean stress or the confining pressure."""
    if not table.has("deviatoric_stress"):
        return table("stress_ratio", "1")
    q = table("deviatoric_stress", "Pa")
    lateral = table("mean_stress", "Pa") - q / 3 if table.has("mean_stress") else numpy.full(len(q), test.pressure)
    if not (lateral > 0).all():
        raise StudyError(f"{test.table}: row {int(numpy.argmax(~(lateral > 0))) + 1}: mean_stress - deviatoric_stress/3, the lateral stress, "
                         "is not above 0; check both columns and their units")
    if abs(numpy.median(lateral) / test.pressure - 1) > 0.1:
        raise StudyError(f"{test.table}: its lateral stress is {numpy.median(lateral) / 1e3:.4g} kPa, the confining pressure given "
                         f"{test.pressure / 1e3:.4g} kPa; correct the one that is wrong")
    return 1 + q / lateral


def _natural(strain, kind, what, path):
    """Returns natural strains in percent of engineering or natural ones, as numbers; compression is positive in both."""
    if kind == "natural":
        return 100 * strain
    if (strain >= 1).any():
        raise StudyError(f"{path}: {what} reaches {100 * strain.max():.4g} %, of the initial size: write [%] or [1] as it is meant")
    return -100 * numpy.log(1 - strain)


def _rising(axial):
    """Returns for each row whether its axial strain is above 0 and above those of all rows before."""
    return axial > numpy.maximum.accumulate(numpy.append(0, axial[:-1]))


def left_out(test):
    """Returns a sentence on the rows that observed() leaves out since the axial strain does not rise there, or "" if none are.

    Rows up to the first strain above 0 are the start of the test, and are not counted.
    """
    axial = _column(Table.read(test.table), AXIAL, "1")
    started = numpy.maximum.accumulate(axial) > 0
    count = int((started & ~_rising(axial)).sum())
    return f"{test.name}: {count} of {len(axial)} rows are left out, since the axial strain does not rise there (unloading)" if count else ""


def observed(test, until, stations):
    """Returns the columns of a test at `stations` rows near evenly spaced natural axial strains, at most `until` percent.

    stations: 0 keeps all rows whose axial strain increases. Raises StudyError for columns that are missing and for strains or
    stresses that no compression test has.
    """
    table = Table.read(test.table)
    axial, volumetric = (_natural(_column(table, names, "1"), test.kind, names[0], test.table) for names in (AXIAL, VOLUMETRIC))
    stress = "deviatoric_stress" if table.has("deviatoric_stress") else "stress_ratio"
    if axial[-1] < 0 or table(stress, "kPa" if stress == "deviatoric_stress" else "1")[-1] < 0:
        raise StudyError(f"{test.table}: ends at an axial strain of {axial[-1]:.4g} %, or at a negative {stress}: compression is positive, and the "
                         "axial stress the greater one; change the signs")
    ratio = _ratio(table, test)
    rising = _rising(axial) & (axial <= until + 1e-9)
    if rising.sum() < LEAST_STATIONS:
        raise StudyError(f"{test.table}: {rising.sum()} rows have a rising axial strain above 0 and up to {until:g} %; "
                         f"{LEAST_STATIONS} are needed: give more rows, or a larger strain")
    rows = numpy.flatnonzero(rising)
    if stations:
        wanted = axial[rows[-1]] * numpy.arange(1, stations + 1) / stations
        rows = numpy.unique([rows[abs(axial[rows] - at).argmin()] for at in wanted])
    return {"strain_axial [%]": axial[rows], "stress_ratio [1]": ratio[rows], "strain_volumetric [%]": volumetric[rows]}
