"""The grading of own.toml: rows that no grading has are refused before anything is computed, unusual soils are doubted."""
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy
from study import StudyError, Table

# Diameters (mm) of silt, sand, gravel and cobbles (ISO 14688-1), as in lib/packing/generate/doubtful.cpp, and the one below which
# grains are silt.
SIZES, SILT = (0.002, 200), 0.063
# Fewer grains than this over the height of a bag do not act as a continuum.
OVER_HEIGHT = 4
# How far the last share may lie from 1, as in lib/packing/generate/grading.cpp.
LAST = 1e-12


def read(path):
    """Returns the diameters (mm), which rise, and the shares of mass that are finer (0 to 1). Raises StudyError, by row, for what is no grading."""
    table = Table.read(path)
    sizes, finer = table("diameter", "mm"), table("finer_by_mass", "1")
    if not len(table):
        raise StudyError(f"{table.where}: holds no rows below its header")
    _refuse(table, ~((sizes >= SIZES[0]) & (sizes <= SIZES[1])), lambda k: (
        f"diameter is {sizes[k]:.4g} mm, where granular soils have {SIZES[0]:g} to {SIZES[1]:g} mm: check its unit, or leave the row out"))
    _refuse(table, ~((finer >= 0) & (finer <= 1)), lambda k: f"finer_by_mass is {100 * finer[k]:.4g} %: it lies between 0 and 100 %; check its unit")
    if not ((numpy.diff(sizes) > 0).all() and (numpy.diff(finer) >= 0).all() and abs(finer[-1] - 1) <= LAST):
        raise StudyError(f"{table.where}: diameters have to rise and finer_by_mass to end at 1 (100 %); sort or complete the rows")
    return sizes, finer


def _refuse(table, wrong, said):
    if wrong.any():
        row = int(numpy.argmax(wrong))
        raise StudyError(f"{table.where}: row {row + 1}: {said(row)}")


def doubts(sizes, finer, height):
    """Returns sentences on what is unusual in a grading for a bag of some height (m)."""
    said = []
    fines = float(numpy.interp(SILT, sizes, finer, left=0))
    if fines > 0.5:
        said.append(f"{100 * fines:.3g} % of the mass is finer than {SILT:g} mm: silt drains slowly and may be cohesive, "
                    "and the simulated grains are neither")
    if OVER_HEIGHT * sizes[-1] > 1e3 * height:
        said.append(f"its largest grains measure {sizes[-1]:.4g} mm in a bag of {1e3 * height:g} mm: fewer than {OVER_HEIGHT} over its height. "
                    "The simulated bags have more, and the solution assumes a continuum; use a higher bag, or sieve the soil")
    return said
