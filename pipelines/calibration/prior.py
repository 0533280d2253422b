"""The prior of a calibration: ranges of the contact parameters that the runs take."""
# SPDX-License-Identifier: GPL-3.0-or-later
import re
import tomllib

from study import StudyError
from study.errors import suggestion
from study.units import factor

from .ensemble import PARAMETERS

UNITS = {name: unit for name, _, unit in PARAMETERS}
# Values that contacts may have, in these units. The ratio is Poisson's, or the one of the stiffnesses of linear contacts.
BOUNDS = {"young_modulus": (1e5, 1e13), "poisson_ratio": (0, 1), "rolling_stiffness": (0, 1e6), "rolling_limit": (0, 1e6), "friction_angle": (0, 89)}
_BOUND = re.compile(r"\s*([-+0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([^\s0-9.]\S*)\s*")


def _bound(where, given, unit):
    """Returns a bound as a number in its unit. Raises StudyError for what is neither a number nor a number and a unit."""
    try:
        if isinstance(given, str) and (match := _BOUND.fullmatch(given)):
            return float(match[1]) * factor(match[2], unit)
        if isinstance(given, int | float) and not isinstance(given, bool):
            return float(given)
    except (ValueError, StudyError) as error:
        raise StudyError(f"{where}: {error}") from error
    raise StudyError(f"{where} {'is missing' if given is None else f'= {given!r}'}: write a number in {unit}")


def _range(path, one):
    """Returns a [[parameter]] table with its bounds as numbers in its unit. Raises StudyError for bounds that the runs do not take."""
    name = one["name"]
    bounds = {key: _bound(f"{path}: {name}: {key}", one.get(key), UNITS[name]) for key in ("low", "high")}
    least, greatest = BOUNDS[name]
    for key, value in bounds.items():
        if not least <= value <= greatest:
            raise StudyError(f"{path}: {name}: {key} = {value:g}: write a number from {least:g} to {greatest:g} in {UNITS[name]}")
    if not bounds["low"] < bounds["high"]:
        raise StudyError(f"{path}: {name}: high = {bounds['high']:g} is not above low = {bounds['low']:g}: correct one of them")
    if one.get("scale") == "log" and not bounds["low"] > 0:
        raise StudyError(f"{path}: {name}: low = 0 has no place on a log scale: write a number above 0, or leave scale out")
    return {**one, **bounds}


def read(path):
    """Returns the [[parameter]] tables of a prior, with bounds in their units.

    Raises StudyError for a parameter that is unknown, missing or in another unit, and for bounds that are missing or not in order.
    """
    try:
        with open(path, encoding="utf-8-sig") as file:
            ranges = tomllib.loads(file.read()).get("parameter", [])
    except OSError as error:
        raise StudyError(f"{path}: cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise StudyError(f"{path}: {error}") from error
    if not (isinstance(ranges, list) and all(isinstance(one, dict) for one in ranges)):
        raise StudyError(f"{path}: write every parameter as a table [[parameter]]")
    names = [one.get("name") for one in ranges]
    for one, name in zip(ranges, names, strict=True):
        if name not in UNITS:
            raise StudyError(f"{path}: no run depends on a parameter named {name!r}{suggestion(name, UNITS)}")
        if names.count(name) > 1:
            raise StudyError(f"{path}: {name} is there twice; leave one of them out")
        if one.get("unit", "1") != UNITS[name]:
            raise StudyError(f"{path}: {name} is in {one.get('unit', '1')!r}; give it in {UNITS[name]!r}")
    for name in UNITS:
        if name not in names:
            raise StudyError(f"{path}: {name} is missing; every run takes {', '.join(UNITS)}")
    return [_range(path, one) for one in ranges]
