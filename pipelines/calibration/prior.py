"""The prior of a calibration: ranges of the contact parameters that the runs take."""
# SPDX-License-Identifier: GPL-3.0-or-later
import tomllib

from study import StudyError
from study.errors import suggestion

from .ensemble import PARAMETERS

UNITS = {name: unit for name, _, unit in PARAMETERS}


def read(path):
    """Returns the [[parameter]] tables of a prior. Raises StudyError for a parameter that is unknown, missing or in another unit."""
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
    return ranges
