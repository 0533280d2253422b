"""The geotextile of own.toml: a name, a data sheet or a product of a catalogue, as the numbers that bags and the solution need.

Keys, and the curve through a sheet's points, are those of gws-solve (lib/gws/solution/data_sheet.h), which judges the file that is written here.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import pathlib
import re
import tomllib

import numpy
from own.keys import table_of
from study import StudyError
from study.errors import suggestion

POINTS = {"tension_at_2": "N/m", "tension_at_5": "N/m", "strength": "N/m", "failure_strain": "1"}
STRAINS = {"tension_at_2": 0.02, "tension_at_5": 0.05}
KEYS = {"stiffness": "N/m", **POINTS, "machine": dict, "cross": dict}
# Keys of files of geotextiles that the solution does not need.
ASIDE = ("name", "yarn_strain", "yarn_tension", "unloading_slope")
DIRECTIONS = ("machine", "cross")
# Ranges of geotextiles (N/m). Nets and light nonwovens still exceed the lower ends (lib/gws/solution/geotextile.cpp).
RANGES = {"stiffness": (2e3, 1e9), "strength": (500, 1e7), "tension_at_2": (10, 1e7), "tension_at_5": (25, 1e7)}

# Failure strains: the least one that is taken, as by gws-solve, and the one below which hardly a polymer breaks. Stiffness (N/m) that
# hardly a geotextile has. Least secant of a point over the secant to failure (lib/gws/solution/data_sheet.cpp).
LEAST_STRAIN, STIFF_STRAIN, STIFF, LEAST_SHARE = 0.01, 0.02, 2e7, 0.02


@dataclasses.dataclass
class Fabric:
    """A geotextile: stiffness (N/m; the secant to failure by default), the points of its data sheet by key, and doubts about it."""

    stiffness: float
    points: dict
    doubts: list = dataclasses.field(default_factory=list)

    def file(self):
        """Returns the text of its file for gws-solve, which refuses a stiffness beside tensions at strains."""
        return sheet("The geotextile of own.toml.", "own", **({"stiffness": self.stiffness} if not STRAINS.keys() & self.points else {}), **self.points)


def sheet(comment, name, **values):
    """Returns the text of a geotextile's file from values in SI units."""
    lines = [f"{key} = {value!r}" if key == "failure_strain" else f'{key} = "{value!r} N/m"' for key, value in values.items()]
    return "\n".join([f"# {comment}", f'name = "{name}"', *lines]) + "\n"


def _strain_at(side, tension):
    """Returns the strain of a direction at a tension, linearly between the points of its sheet."""
    points = sorted([(0.0, 0.0), *((side[key], strain) for key, strain in STRAINS.items() if key in side), (side["strength"], side["failure_strain"])])
    return float(numpy.interp(tension, *zip(*points, strict=True)))


def _lesser(path, machine, cross):
    """Returns the lesser tension of each point, and the greater strain at the lesser strength: both directions are at least as stiff and strong.

    Raises StudyError where one direction lacks a point.
    """
    for key in POINTS:
        if (key in machine) != (key in cross):
            without, other = ("cross", "machine") if key in machine else ("machine", "cross")
            raise StudyError(f"{path}: geotextile.{without} has no {key}, which geotextile.{other} has: give it, or leave out one direction")
    lesser = {key: min(machine[key], cross[key]) for key in POINTS if key in machine}
    if {"strength", "failure_strain"} <= lesser.keys():
        lesser["failure_strain"] = max(_strain_at(side, lesser["strength"]) for side in (machine, cross))
    return lesser


def _points(path, given, direction):
    """Returns the values of a table of a geotextile, of one direction or of both together, and doubts. Raises StudyError for wrong ones."""
    values = table_of(path, "geotextile.", {key: value for key, value in given.items() if key not in ASIDE}, KEYS, KEYS)
    sides = {side: table_of(path, f"geotextile.{side}.", values.pop(side), POINTS, POINTS) for side in DIRECTIONS if side in values}
    if direction and direction not in sides:
        raise StudyError(f"{path}: geotextile: it has no table {direction}: leave out @{direction}")
    if sides and values:
        raise StudyError(f"{path}: geotextile.{next(iter(values))} stands beside the tables of its directions: move it into them")
    if direction:
        sides = {direction: sides[direction]}
    both = _lesser(path, *(sides[s] for s in DIRECTIONS)) if len(sides) == 2 else next(iter(sides.values()), values)
    judged = {f"geotextile.{side}.": points for side, points in sides.items()} or {"geotextile.": values}
    return both, [line for where, points in judged.items() for line in _judge(path, where, points)]


def _judge(path, where, values):
    """Returns doubts about points of a sheet. Raises StudyError where they are missing, contradict each other, or are no geotextile's."""
    for key in ("strength", "failure_strain"):
        if key not in values:
            raise StudyError(f"{path}: {where}{key} is missing; pipelines/own/README.md tells all keys")
    for key, (least, greatest) in RANGES.items():
        if not least <= values.get(key, least) <= greatest:
            raise StudyError(f"{path}: {where}{key} = {values[key] / 1e3:g} kN/m: geotextiles have {least / 1e3:g} to {greatest / 1e3:g} kN/m; check its "
                             "unit")
    if values["failure_strain"] >= 1:
        raise StudyError(f"{path}: {where}failure_strain = {values['failure_strain']:g}: write a fraction, as 0.15 for 15 %")
    if values["failure_strain"] <= LEAST_STRAIN:
        raise StudyError(f"{path}: {where}failure_strain = {100 * values['failure_strain']:.4g} %: geotextiles break above {100 * LEAST_STRAIN:g} %; "
                         'write 12 % as 0.12 or as "12 %"')
    at = [(STRAINS[key], values[key], key) for key in STRAINS if key in values] + [(values["failure_strain"], values["strength"], "strength")]
    for (strain, tension, key), (next_strain, next_tension, next_key) in zip(at, at[1:], strict=False):
        if next_strain <= strain:
            raise StudyError(f"{path}: {where}failure_strain = {values['failure_strain']:g}, but {key} is given: correct it, or leave {key} out")
        if next_tension <= tension:
            raise StudyError(f"{path}: {where}{next_key} = {next_tension / 1e3:.4g} kN/m is not above {key} = {tension / 1e3:.4g} kN/m: "
                             "correct one of them, or its unit")
    secant = values["strength"] / values["failure_strain"]
    if not secant >= RANGES["stiffness"][0]:
        raise StudyError(f"{path}: {where}strength over failure_strain is {secant / 1e3:.4g} kN/m, where geotextiles have a stiffness of "
                         f"{RANGES['stiffness'][0] / 1e3:g} kN/m at least: check both units")
    for strain, tension, key in at[:-1]:
        if tension / strain < LEAST_SHARE * secant:
            raise StudyError(f"{path}: {where}{key} = {tension / 1e3:.4g} kN/m beside strength = {values['strength'] / 1e3:.4g} kN/m at "
                             f"{100 * values['failure_strain']:.4g} %: check both units")
    if "stiffness" in values and len(at) > 1:
        raise StudyError(f"{path}: {where}stiffness stands beside {at[0][2]}, which tells a stiffness too: leave one of them out")
    if not 0.2 < values.get("stiffness", secant) / secant < 5:
        raise StudyError(f"{path}: {where}stiffness is {values['stiffness'] / 1e3:.4g} kN/m, strength over failure_strain {secant / 1e3:.4g} kN/m: "
                         "they contradict each other; correct one of the three")
    return _unusual(path, where, values)


def _unusual(path, where, values):
    """Returns doubts about the points of a sheet that hardly a geotextile has."""
    strain = values["failure_strain"]
    secants = [values.get("stiffness", 0), values["strength"] / strain, *(values[key] / STRAINS[key] for key in STRAINS if key in values)]
    said = [f"{where}failure_strain = {100 * strain:.4g} %, where polymers break at more than {100 * STIFF_STRAIN:g} %: write 12 % as 0.12 or as "
            '"12 %"'] if strain < STIFF_STRAIN else []
    if max(secants) > STIFF:
        said.append(f"the greatest stiffness of {where.rstrip('.')}, {max(secants) / 1e3:.4g} kN/m, is more than {STIFF / 1e3:g} kN/m, which hardly a "
                    "geotextile has: check failure_strain, and the units of its tensions")
    return [f"{path}: {line}" for line in said]


def _open(path, name):
    """Returns the content of a TOML file beside own.toml, or of the catalogue of geotextiles."""
    try:
        return tomllib.loads(name.read_text(encoding="utf-8-sig"))
    except OSError as error:
        raise StudyError(f"{path}: geotextile: {name}: cannot be read: {error.strerror}") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise StudyError(f"{path}: geotextile: {name}: {error}") from error


def _named(path, word, catalogue):
    """Returns the table that a word names, and by how much it is multiplied: NAME, 3NAME, FILE.toml or FILE.toml:PRODUCT."""
    if match := re.fullmatch(r"(.*\.toml)(?::(.*))?", word):
        name, product = match.groups()
        content = _open(path, path.parent / name)
        if product is None:
            return content, 1
        listed = content.get("product", [])
        if not (isinstance(listed, list) and all(isinstance(entry, dict) and isinstance(entry.get("name"), str) for entry in listed)):
            raise StudyError(f"{path}: geotextile: {name}: every product of a catalogue is a table [[product]] with a name")
        products = {entry["name"]: entry for entry in listed}
        if len(products) < len(listed):
            raise StudyError(f"{path}: geotextile: {name}: two products have one name; rename one of them")
        if product not in products:
            raise StudyError(f"{path}: geotextile: {name} has no [[product]] named '{product}'{suggestion(product, products)}")
        return products[product], 1
    known = {entry.stem: entry for entry in sorted(pathlib.Path(catalogue).glob("*.toml"))}
    layers, base = re.fullmatch(r"([0-9.]*)(.*)", word).groups()
    if base not in known:
        raise StudyError(f'{path}: geotextile = "{word}" is not in {catalogue}{suggestion(base, known)}; or write [geotextile] with strength and '
                         "failure_strain of its data sheet")
    try:
        times = float(layers or 1)
    except ValueError:
        times = 0
    if not 0 < times <= 1000:
        raise StudyError(f'{path}: geotextile = "{word}": {layers} layers; write a number above 0 and at most 1000')
    return _open(path, known[base]), times


def read(path, given, catalogue):
    """Returns the Fabric that own.toml gives: a table, or a word with @machine or @cross. Raises StudyError for what is wrong."""
    layers, direction = 1, ""
    if isinstance(given, str):
        word, _, direction = given.partition("@")
        if direction not in ("", *DIRECTIONS):
            raise StudyError(f"{path}: geotextile: '{direction}' is no direction{suggestion(direction, DIRECTIONS)}; write @machine or @cross")
        given, layers = _named(path, word, catalogue)
    values, doubts = _points(path, given, direction)
    values = {key: value if key == "failure_strain" else layers * value for key, value in values.items()}
    sides = [side for side in DIRECTIONS if side in given]
    if not direction and len(sides) == 1:
        doubts.append(f"{path}: the geotextile has values of its {sides[0]} direction alone, which are taken for the other one too; give both, or write "
                      f'"FILE.toml@{sides[0]}" where one direction counts')
    return Fabric(values.pop("stiffness", values["strength"] / values["failure_strain"]), values, doubts)
