#!/usr/bin/env python3
"""Reads own.toml and its tables, refuses what is wrong in one line, and writes what the rules of own/study.mk need.

That is inputs.mk, variables of make; failure.tsv, q/p at failure of each test; and a geotextile of each stiffness that bags are
made with.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import dataclasses
import math
import pathlib
import sys
import tomllib

import numpy
from calibration.laboratory import Test, curve, observed, pressure
from own import fabric
from own.keys import table_of, value_of
from study import StudyError, Table
from study.errors import suggestion
from study.files import put

KEYS = {"name": str, "grading": str, "void_ratio": float, "packing_void_ratio": float, "surcharge": "Pa", "settlement": "1", "geotextile": (str, dict), "bag": dict,
        "factors": dict, "test": list}
OPTIONAL = ("factors", "packing_void_ratio")
BAG = {"width": "m", "height": "m"}
FACTORS = ("creep", "installation", "durability", "load", "soil")
TEST = {"table": str, "confining_pressure": "Pa", "strains": str, "predict": bool}
# Stiffnesses of the bags over the asked geotextile's, and the width of a yarn, m: the yarns of bags are this far apart.
STIFFNESSES, YARN = (0.25, 0.5, 1, 2), 5e-3
# Strain up to which the yarns of these bags are whole: identification ends at the first broken one.
WHOLE = 0.5
# Exponent, constant and reference pressure of Toyoura's failure line (thesis Table 5.2), whose exponent a single test cannot give.
M, EXPONENT = 1.35, 0.0723


@dataclasses.dataclass
class Inputs:
    """Content of own.toml, in SI units; paths count from its folder."""

    path: pathlib.Path
    values: dict
    tests: list
    predictions: list
    fabric: fabric.Fabric

    @property
    def reduction(self):
        """The product of the reduction factors of the geotextile's strength."""
        return math.prod(self.values["factors"].get(name, 1) for name in FACTORS[:3])


def read(path, catalogue="data/geotextiles"):
    """Returns the Inputs of an own.toml. Raises StudyError for the first thing that is wrong, before anything is computed."""
    path = pathlib.Path(path)
    try:
        given = tomllib.loads(path.read_text(encoding="utf-8"))
    except OSError as error:
        raise StudyError(f"{path}: cannot be read: {error.strerror}; begin with a copy of data/own/example/own.toml") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise StudyError(f"{path}: {error}") from error
    values = table_of(path, "", given, KEYS, OPTIONAL)
    values["bag"] = table_of(path, "bag.", values["bag"], BAG)
    values["factors"] = table_of(path, "factors.", values.get("factors", {}), dict.fromkeys(FACTORS, float), FACTORS)
    for key, value in values["factors"].items():
        if value < 1:
            raise StudyError(f"{path}: factors.{key} = {value:g}: a factor is 1 or more")
    if not 0 < values["settlement"] < 0.3:
        raise StudyError(f"{path}: settlement = {values['settlement']:g}: write a fraction of the height below 0.3, as 0.05 for 5 %")
    for key in ("void_ratio", "packing_void_ratio"):
        if 0.2 < values.setdefault(key, values["void_ratio"]) < 2:
            continue
        raise StudyError(f"{path}: {key} = {values[key]:g}: void ratios of granular soils lie between 0.2 and 2; 0.68, not 68 %")
    grading = Table.read(path.parent / values["grading"])
    sizes, finer = grading("diameter", "mm"), grading("finer_by_mass", "1")
    if not ((numpy.diff(sizes) > 0).all() and (numpy.diff(finer) >= 0).all() and abs(finer[-1] - 1) < 1e-6):
        raise StudyError(f"{grading.where}: diameters have to rise and finer_by_mass to end at 1 (100 %); sort or complete the rows")
    if not values["test"]:
        raise StudyError(f"{path}: [[test]] is missing: one drained triaxial test at least; pipelines/own/README.md tells its keys")
    tests, predictions = [], []
    for k, entry in enumerate(values["test"], start=1):
        one = table_of(path, f"test {k}: ", value_of(path, "", f"test {k}", entry, dict), TEST, ("predict",))
        if one["strains"] not in ("engineering", "natural"):
            raise StudyError(f'{path}: test {k}: strains = "{one["strains"]}"{suggestion(one["strains"], ("engineering", "natural"))}')
        test = Test(path.parent / one["table"], pressure(entry["confining_pressure"]), one["strains"], "")
        observed(curve(test), 1e3, 0)
        (predictions if one.get("predict") else tests).append(test)
    if not tests:
        raise StudyError(f"{path}: every test has predict = true: leave one to calibrate to without it")
    return Inputs(path, values, tests, predictions, fabric.read(path, values["geotextile"], catalogue))


def failures(tests):
    """Returns confining pressure (kPa) and greatest q/p of each test, and the names of those whose last row is their greatest."""
    rows, rising = [], []
    for test in tests:
        ratio = observed(curve(test), 1e3, 0)["stress_ratio [1]"]
        most = ratio.max()
        rows.append((test.pressure / 1e3, 3 * (most - 1) / (most + 2)))
        if ratio.argmax() == len(ratio) - 1:
            rising.append(test.name)
    return rows, rising


def failure_options(rows, path):
    """Returns what tells gws-solve the failure line: points at two pressures or more, else p_c by Toyoura's exponent.

    M_f = M (p/p_c)^-n (thesis Eq. 5.3), at p = 3 sigma_r / (3 - q/p).
    """
    if len({round(sigma, 3) for sigma, _ in rows}) > 1:
        return f"--failure {path}"
    sigma, eta = rows[0][0], sum(eta for _, eta in rows) / len(rows)
    return f"--set failure_line.p_c={1e3 * 3 * sigma / (3 - eta) * (eta / M)**(1 / EXPONENT):.6g}"


def _put_new(path, text):
    """Writes a file unless it holds this text already: what hangs on it is then not made anew."""
    if not (path.exists() and path.read_text(encoding="utf-8") == text):
        put(path, text)


def write(own, out):
    """Writes the files of the module's docstring into a folder."""
    out.mkdir(parents=True, exist_ok=True)
    rows, rising = failures(own.tests)
    _put_new(out / "failure.tsv", "confining_pressure [kPa]\tobliquity_at_failure [1]\n" + "".join(f"{s:.6g}\t{e:.6g}\n" for s, e in rows))
    for k, share in enumerate(STIFFNESSES, start=1):
        j = share * own.fabric.stiffness
        _put_new(out / f"geotextile_{k}.toml", fabric.sheet(
            f"A linear geotextile of {share:g} times the stiffness of own.toml's; whole up to {WHOLE:.0%}.", f"own_{k}", stiffness=j,
            strength=j * WHOLE, failure_strain=WHOLE) + f"yarn_strain = [{WHOLE}]\nyarn_tension = [{j * WHOLE * YARN!r}]\n")
    v, factors = own.values, own.values["factors"]
    _put_new(out / "geotextile.toml", own.fabric.file())
    lines = {
        "GRADING": own.path.parent / v["grading"], "VOID_RATIO": v["packing_void_ratio"],
        "TESTS": " ".join(f"--{verb} '{t.table}' '{t.pressure / 1e3:g} kPa' {t.kind}" for verb, some in (
            ("test", own.tests), ("predict", own.predictions)) for t in some),
        "PRESSURE": own.tests[0].megapascals, "FIRST": own.tests[0].name,
        "FAILURE": failure_options(rows, out / "failure.tsv"), "SURCHARGE": v["surcharge"], "SETTLEMENT": v["settlement"],
        "SHAPE": f"--width {v['bag']['width']:g} --height {v['bag']['height']:g}", 
        "REDUCED": " ".join([*(["--strength-fraction 1"] if own.reduction > 1 else []), *(
            f"--rf-{name} {factors[name]:g}" for name in FACTORS[:3] if name in factors)]),
        "PARTIAL": " ".join(f"--factor-{name} {factors[name]:g}" for name in FACTORS[3:] if name in factors),
        "STIFFNESS": own.fabric.stiffness, "BAGS": " ".join(str(k) for k in range(1, len(STIFFNESSES) + 1)), "RISING": " ".join(rising)}
    _put_new(out / "inputs.mk", "# What own.toml says, for make.\n" + "".join(f"OWN_{key} := {value}\n" for key, value in lines.items()))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("soil", type=pathlib.Path, help="folder of own.toml")
    parser.add_argument("out", type=pathlib.Path, help="folder of the study's results")
    arguments = parser.parse_args()
    try:
        write(read(arguments.soil / "own.toml"), arguments.out)
    except (StudyError, OSError) as error_:
        print(f"own: {error_}", file=sys.stderr)
        sys.exit(65)
