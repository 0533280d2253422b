"""Units that tables and figures use, and the factors between them."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math

from .errors import StudyError, suggestion

# Each unit with the quantity that it measures and its size in the SI unit of that quantity.
_UNITS = {
    "1": ("number", 1.0),
    "-": ("number", 1.0),
    "%": ("number", 1e-2),
    "‰": ("number", 1e-3),
    "m": ("length", 1.0),
    "cm": ("length", 1e-2),
    "mm": ("length", 1e-3),
    "um": ("length", 1e-6),
    "m2": ("area", 1.0),
    "m3": ("volume", 1.0),
    "s": ("time", 1.0),
    "ms": ("time", 1e-3),
    "ns": ("time", 1e-9),
    "min": ("time", 60.0),
    "h": ("time", 3600.0),
    "Pa": ("stress", 1.0),
    "kPa": ("stress", 1e3),
    "MPa": ("stress", 1e6),
    "GPa": ("stress", 1e9),
    "bar": ("stress", 1e5),
    "N/m2": ("stress", 1.0),
    "kN/m2": ("stress", 1e3),
    "MN/m2": ("stress", 1e6),
    "N/mm2": ("stress", 1e6),
    "N": ("force", 1.0),
    "kN": ("force", 1e3),
    "N/m": ("line force", 1.0),
    "kN/m": ("line force", 1e3),
    "MN/m": ("line force", 1e6),
    "N/mm": ("line force", 1e3),
    "N/cm": ("line force", 1e2),
    "J": ("energy", 1.0),
    "J m-1": ("energy per width", 1.0),
    "deg": ("angle", 1.0),
    "rad": ("angle", 180 / math.pi),
    "1/s": ("rate", 1.0),
    "1/m": ("stress over line force", 1.0),
    "kPa per kN/m and %": ("stress over line force and strain", 1.0),
    # A column that holds several parameters of a calibration, each in its own unit.
    "its own": ("value of a parameter", 1.0),
    "1 per its own": ("density of a parameter", 1.0),
}

# Characters of tables, and the characters that replace them in the names above.
_WRITTEN = str.maketrans({"²": "2", "³": "3", "\u00b5": "u", "\u03bc": "u"})


def factor(given, wanted):
    """Returns the factor from the unit `given` to the unit `wanted`. Raises StudyError if they do not fit."""
    given, wanted = (unit.translate(_WRITTEN) for unit in (given, wanted))
    for unit, other in ((given, wanted), (wanted, given)):
        if unit not in _UNITS:
            alike = [name for name in _UNITS if other not in _UNITS or measured(name) == measured(other)]
            raise StudyError(f"'{unit}' is not a known unit{suggestion(unit, alike)}")
    if _UNITS[given][0] != _UNITS[wanted][0]:
        raise StudyError(f"'{given}' is a unit of {_UNITS[given][0]}, '{wanted}' of {_UNITS[wanted][0]}")
    return _UNITS[given][1] / _UNITS[wanted][1]


def measured(unit):
    """Returns the quantity that a unit measures, as "stress"; "" for a unit that is not known."""
    return _UNITS.get(unit.translate(_WRITTEN), ("",))[0]
