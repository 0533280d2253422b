"""Values of own.toml by key, in SI units: an unknown key, a missing one or one without its unit is one line with file and key."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math
import re

from study import StudyError
from study.errors import suggestion
from study.units import factor

_WORDS = {dict: "table", list: "list of tables", bool: "true or false"}
_EXAMPLES = {"Pa": "300 kPa", "N/m": "50 kN/m", "m": "400 mm", "1": "15 %"}


def value_of(path, where, key, given, kind):
    """Returns a value in its kind or unit; of "1" as a fraction or in %. Raises StudyError with file, key and remedy."""
    if kind == "1" and not isinstance(given, str):
        kind = float
    if isinstance(kind, str):
        match = re.fullmatch(r"\s*([0-9.]+(?:[eE][-+]?[0-9]+)?)\s*([^\s0-9.]\S*)\s*", given) if isinstance(given, str) else None
        try:
            number = float(match[1]) * factor(match[2], kind) if match else 0
        except (StudyError, ValueError) as error:
            raise StudyError(f"{path}: {where}{key}: {error}") from error
        if not 0 < number < math.inf:
            raise StudyError(f'{path}: {where}{key} = {given!r}: write a number above 0 with its unit, as "{_EXAMPLES[kind]}"')
        return number
    if kind is float:
        if isinstance(given, bool) or not isinstance(given, int | float) or not 0 < given < math.inf:
            raise StudyError(f"{path}: {where}{key} = {given!r}: write a number above 0")
        return float(given)
    if not isinstance(given, kind):
        raise StudyError(f"{path}: {where}{key} = {given!r} is no {_WORDS.get(kind, 'text')}")
    return given


def table_of(path, where, given, keys, optional=()):
    """Returns the values of a table by key. Raises StudyError for an unknown or a missing one."""
    for key in given:
        if key not in keys:
            raise StudyError(f"{path}: {where}{key} is unknown{suggestion(key, keys)}")
    for key in keys:
        if key not in given and key not in optional:
            raise StudyError(f"{path}: {where}{key} is missing; pipelines/own/README.md tells all keys")
    return {key: value_of(path, where, key, value, keys[key]) for key, value in given.items()}
