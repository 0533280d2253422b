#!/usr/bin/env python3
"""Reads own.toml and its tables, refuses what is wrong in one line, and writes what the rules of own/study.mk need.

That is inputs.mk, variables of make; inputs.said, what is doubtful; failure.tsv, q/p at failure of each test; a geotextile of each
stiffness that bags are made with; and copies of all that own.toml names. A file is written only if its content is another than before,
so that make repeats only what depends on it, wherever the tables lie and however they are named.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import dataclasses
import math
import pathlib
import sys
import tomllib

import numpy
from calibration import plausible, prior
from calibration.laboratory import Test, curve, distinct_names, observed, plain, pressure
from own import fabric, grading
from own.keys import table_of, value_of
from study import StudyError
from study.errors import suggestion
from study.files import put

KEYS = {"name": str, "grading": str, "void_ratio": float, "packing_void_ratio": float, "surcharge": "Pa", "settlement": "1", "geotextile": (str, dict), "bag": dict,
        "factors": dict, "strength_fraction": "1", "test": list}
OPTIONAL = ("factors", "packing_void_ratio", "strength_fraction")
BAG = {"width": "m", "height": "m"}
# Ranges of sizes (m) and surcharges (Pa) that bags have. The solution takes more (bag_extent, surcharge_range).
EXTENT, SURCHARGE = (0.01, 100), (1e3, 1e7)
# Heights over width like that of the simulated bags (lib/gws/solution/doubts.cpp).
SHAPE = (0.1, 0.4)
# Factors and the greatest ones that are taken; tan phi is divided by 1.25 in most codes.
FACTORS = {"creep": 10, "installation": 10, "durability": 10, "load": 10, "soil": 2}
REDUCING, PARTIAL = ("creep", "installation", "durability"), ("load", "soil")
# Share of the strength at which bags of discrete elements fail (thesis section 5.4), since their nodes are coarse: the default of gws-solve.
SHARE = 0.5
TEST = {"table": str, "confining_pressure": "Pa", "strains": str, "predict": bool}
# Stiffnesses of the bags over the asked geotextile's, and the width of a yarn, m: the yarns of bags are this far apart.
STIFFNESSES, YARN = (0.25, 0.5, 1, 2), 5e-3
# Number of the bag with the asked stiffness; numbers of further bags with it, each with its own packing and set of the posterior.
SAME, OTHERS = STIFFNESSES.index(1) + 1, (1, 2, 3, 4)
# Failure strain of the yarns of these bags. It is large, since identification ends at the first broken yarn.
WHOLE = 0.5
# Constant and exponent of Toyoura's failure line (thesis Table 5.2), and the greatest p_c (Pa) that the solution takes.
M, EXPONENT, GREATEST_P_C = 1.35, 0.0723, 1e12
# Steepest failure line of a soil: q/p of dense sand falls with an exponent of 0.12 where its angle falls by 12 deg over a decade (plausible.APART).
STEEPEST = 0.2


@dataclasses.dataclass
class Inputs:
    """Content of own.toml, in SI units; paths count from its folder."""

    path: pathlib.Path
    values: dict
    curves: list
    predicted: list
    grading: tuple
    fabric: fabric.Fabric
    prior: pathlib.Path

    @property
    def tests(self):
        """The tests that are calibrated to."""
        return [one.test for one in self.curves]

    @property
    def predictions(self):
        """The tests that are predicted."""
        return [one.test for one in self.predicted]

    @property
    def reduction(self):
        """The product of the reduction factors of the geotextile's strength."""
        return math.prod(self.values["factors"].get(name, 1) for name in REDUCING)

    @property
    def strength_fraction(self):
        """The share of the reduced strength at which the bag fails.

        The bag fails at SHARE of the product's strength (coarse nodes) or at the reduced strength, whichever is less. So neither
        effect counts twice, and greater reduction factors never raise the strength at which the bag fails.
        """
        return self.values.get("strength_fraction", min(1.0, SHARE * self.reduction))


def _judge(path, values):
    """Raises StudyError for values of own.toml that are out of range."""
    for key, value in values["factors"].items():
        if not 1 <= value <= FACTORS[key]:
            raise StudyError(f"{path}: factors.{key} = {value:g}: this factor is from 1 to {FACTORS[key]}; write 1.35, not 135")
    if not 0 < values.get("strength_fraction", 1) <= 1:
        raise StudyError(f"{path}: strength_fraction = {values['strength_fraction']:g}: write a share of the strength, above 0 and at most 1")
    if not 0 < values["settlement"] < 0.3:
        raise StudyError(f"{path}: settlement = {values['settlement']:g}: write a fraction of the height below 0.3, as 0.05 for 5 %")
    for key in ("void_ratio", "packing_void_ratio"):
        if not 0.2 < values[key] < 2:
            raise StudyError(f"{path}: {key} = {values[key]:g}: void ratios of granular soils lie between 0.2 and 2; 0.68, not 68 %")
    for key, value in values["bag"].items():
        if not EXTENT[0] <= value <= EXTENT[1]:
            raise StudyError(f'{path}: bag.{key} = {value:g} m: bags measure {EXTENT[0]:g} to {EXTENT[1]:g} m; check the unit, as "400 mm"')
    if not SURCHARGE[0] <= values["surcharge"] <= SURCHARGE[1]:
        raise StudyError(f"{path}: surcharge = {values['surcharge'] / 1e3:g} kPa: bags carry {SURCHARGE[0] / 1e3:g} to {SURCHARGE[1] / 1e3:g} kPa; check "
                         'the unit, as "200 kPa"')


def _curves(path, entries, until):
    """Returns the curves of all [[test]] tables, and which of them are predicted."""
    found, predicted = [], []
    for k, entry in enumerate(entries, start=1):
        one = table_of(path, f"test {k}: ", value_of(path, "", f"test {k}", entry, dict), TEST, ("predict",))
        if one["strains"] not in ("engineering", "natural"):
            raise StudyError(f'{path}: test {k}: strains = "{one["strains"]}"{suggestion(one["strains"], ("engineering", "natural"))}')
        found.append(curve(Test(path.parent / one["table"], pressure(entry["confining_pressure"]), one["strains"], "")))
        observed(found[-1], until, 0)
        predicted.append(one.get("predict", False))
    distinct_names([one.test for one in found])
    plausible.distinct(found)
    return found, predicted


def read(path, catalogue="data/geotextiles", until=1e3):
    """Returns the Inputs of an own.toml. Raises StudyError for the first thing that is wrong, before anything is computed.

    until: axial strain (%) up to which tests are compared.
    """
    path = pathlib.Path(path)
    try:
        given = tomllib.loads(path.read_text(encoding="utf-8-sig"))
    except OSError as error:
        raise StudyError(f"{path}: cannot be read: {error.strerror}; begin with a copy of data/own/example/own.toml") from error
    except (tomllib.TOMLDecodeError, UnicodeDecodeError) as error:
        raise StudyError(f"{path}: {error}") from error
    values = table_of(path, "", given, KEYS, OPTIONAL)
    values["bag"] = table_of(path, "bag.", values["bag"], BAG)
    values["factors"] = table_of(path, "factors.", values.get("factors", {}), dict.fromkeys(FACTORS, float), FACTORS)
    values.setdefault("packing_void_ratio", values["void_ratio"])
    _judge(path, values)
    if not values["name"].strip() or not values["name"].isprintable():
        raise StudyError(f"{path}: name = {values['name']!r}: write one line of text, which the page begins with")
    sieved = grading.read(path.parent / values["grading"])
    if not values["test"]:
        raise StudyError(f"{path}: [[test]] is missing: one drained triaxial test at least; pipelines/own/README.md tells its keys")
    curves, predicted = _curves(path, values["test"], until)
    if all(predicted):
        raise StudyError(f"{path}: every test has predict = true: leave one to calibrate to without it")
    chosen = path.parent / "prior.toml" if (path.parent / "prior.toml").exists() else pathlib.Path(__file__).parent / "prior.toml"
    prior.read(chosen)
    return Inputs(path, values, [c for c, aside in zip(curves, predicted, strict=True) if not aside],
                  [c for c, aside in zip(curves, predicted, strict=True) if aside], sieved, fabric.read(path, values["geotextile"], catalogue), chosen)


def failures(curves):
    """Returns confining pressure (kPa) and greatest q/p of each test, and the names of tests whose last row is the greatest."""
    most = [(one.test.pressure / 1e3, one.strength) for one in curves]
    return [(sigma, 3 * (r - 1) / (r + 2)) for sigma, r in most], [one.test.name for one in curves if one.still_rises]


def doubts(own):
    """Returns sentences on values of own.toml and its tables that are unusual or lack a basis."""
    said = [line for one in own.curves + own.predicted for line in plausible.doubts(one)]
    said += plausible.compared(own.curves + own.predicted)
    rows, _ = failures(own.curves)
    if len({sigma for sigma, _ in rows}) > 1 and not falls(rows):
        points = " and ".join(f"{eta:.3g} at {sigma:g} kPa" for sigma, eta in sorted(rows))
        slope = numpy.polyfit(*_at_failure(rows), 1)[0]
        how = f"falls with an exponent of {-slope:.2g}, where soils have less than {STEEPEST:g}" if slope <= -STEEPEST else "does not fall with the pressure"
        said.append(f"{own.path}: q/p at failure, {points}, {how}, so that the tests give no failure line: one with Toyoura "
                    "sand's exponent through their mean stands for it; check their stresses, or give tests at other pressures")
    bag = own.values["bag"]
    said += [f"{own.path.parent / own.values['grading']}: {line}" for line in grading.doubts(*own.grading, bag["height"])]
    if not SHAPE[0] <= bag["height"] / bag["width"] <= SHAPE[1]:
        said.append(f"{own.path}: the bag is {1e3 * bag['width']:g} mm wide and {1e3 * bag['height']:g} mm high, where simulated bags had a height of "
                    f"{SHAPE[0]:g} to {SHAPE[1]:g} times their width: the solution is untested there; check that the two are not exchanged")
    return said + own.fabric.doubts


def _at_failure(rows):
    """Returns the logarithms of the mean stress (Pa), 3 sigma_r / (3 - q/p), and of q/p at failure."""
    sigma, eta = numpy.array(rows).T
    return numpy.log(1e3 * 3 * sigma / (3 - eta)), numpy.log(eta)


def falls(rows):
    """Returns whether a failure line M_f = M (p/p_c)^-n (thesis Eq. 5.3) fits: q/p at failure falls with the pressure, but not too steeply."""
    if len({round(sigma, 3) for sigma, _ in rows}) < 2:
        return False
    p, eta = _at_failure(rows)
    slope, intercept = numpy.polyfit(p, eta, 1)
    return bool(-STEEPEST < slope < 0 and (intercept - math.log(M)) / -slope < math.log(GREATEST_P_C))


def failure_options(rows, path):
    """Returns the failure line as an option of gws-solve: the points, or, if no line fits, p_c of one with Toyoura's exponent through their mean."""
    if falls(rows):
        return f"--failure {path}"
    p, eta = _at_failure(rows)
    return f"--set failure_line.p_c={math.exp(p.mean() + (eta.mean() - math.log(M)) / EXPONENT):.6g}"


def _put_new(path, content):
    """Writes a file unless it has this content already, so that make does not repeat what depends on it."""
    content = content.encode() if isinstance(content, str) else content
    path.parent.mkdir(parents=True, exist_ok=True)
    if not (path.exists() and path.read_bytes() == content):
        put(path, content)


def _copied(test, out):
    """Copies the table of a test into the folder of results; returns the Test of the copy, which has the same name."""
    copy = out / "tests" / f"{test.pressure / 1e3:g}kPa" / f"{plain(test.table.stem)}.tsv"
    _put_new(copy, test.table.read_bytes())
    return dataclasses.replace(test, table=copy)


def claim(own, out):
    """Remembers the folder of own.toml in the folder of results. Raises StudyError where that holds the results of another soil."""
    holder, folder = out / "folder", own.path.parent.resolve()
    held = pathlib.Path(holder.read_text(encoding="utf-8").strip()) if holder.exists() else folder
    if held != folder and (held / "own.toml").exists():
        raise StudyError(f"{out} holds the results of {held}, a folder of the same name as {folder}: rename one of the two folders, or remove {out}")
    _put_new(holder, f"{folder}\n")


def write(own, out):
    """Writes the files of the module's docstring into a folder."""
    out.mkdir(parents=True, exist_ok=True)
    claim(own, out)
    rows, rising = failures(own.curves)
    said = doubts(own)
    _put_new(out / "inputs.said", "".join(f"own: doubt: {line}\n" for line in said))
    for source, copy in ((own.path, "own.toml"), (own.path.parent / own.values["grading"], "grading.tsv"), (own.prior, "prior.toml")):
        _put_new(out / copy, source.read_bytes())
    tests, predictions = ([_copied(test, out) for test in some] for some in (own.tests, own.predictions))
    _put_new(out / "failure.tsv", "confining_pressure [kPa]\tobliquity_at_failure [1]\n" + "".join(f"{s:.6g}\t{e:.6g}\n" for s, e in rows))
    for k, share in enumerate(STIFFNESSES, start=1):
        j = share * own.fabric.stiffness
        _put_new(out / f"geotextile_{k}.toml", fabric.sheet(
            f"A linear geotextile of {share:g} times the stiffness of own.toml's; whole up to {WHOLE:.0%}.", f"own_{k}", stiffness=j,
            strength=j * WHOLE, failure_strain=WHOLE) + f"yarn_strain = [{WHOLE}]\nyarn_tension = [{j * WHOLE * YARN!r}]\n")
    v, factors = own.values, own.values["factors"]
    _put_new(out / "geotextile.toml", own.fabric.file())
    lines = {
        "VOID_RATIO": v["packing_void_ratio"],
        "TESTS": " ".join(f"--{verb} '{t.table}' '{t.pressure / 1e3:g} kPa' {t.kind}" for verb, some in (
            ("test", tests), ("predict", predictions)) for t in some),
        "TABLES": " ".join(str(t.table) for t in tests + predictions), "PRESSURE": own.tests[0].megapascals, "FIRST": own.tests[0].name,
        "FAILURE": failure_options(rows, out / "failure.tsv"), "SURCHARGE": v["surcharge"], "SETTLEMENT": v["settlement"],
        "SHAPE": f"--width {v['bag']['width']:g} --height {v['bag']['height']:g}",
        "REDUCED": " ".join([f"--strength-fraction {own.strength_fraction!r}", *(
            f"--rf-{name} {factors[name]!r}" for name in REDUCING if name in factors)]),
        "PARTIAL": " ".join(f"--factor-{name} {factors[name]:g}" for name in PARTIAL if name in factors),
        "STIFFNESS": own.fabric.stiffness, "BAGS": " ".join(str(k) for k in range(1, len(STIFFNESSES) + 1)), "SAME": SAME,
        "OTHERS": " ".join(map(str, OTHERS)), "RISING": " ".join(rising)}
    _put_new(out / "inputs.mk", "# What own.toml says, for make.\n" + "".join(f"OWN_{key} := {value}\n" for key, value in lines.items()))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("soil", type=pathlib.Path, help="folder of own.toml")
    parser.add_argument("out", type=pathlib.Path, help="folder of the study's results")
    parser.add_argument("--until", type=float, default=1e3, metavar="%%", help="axial strain up to which tests are compared")
    arguments = parser.parse_args()
    try:
        write(read(arguments.soil / "own.toml", until=arguments.until), arguments.out)
    except (StudyError, OSError) as error_:
        print(f"own: {error_}", file=sys.stderr)
        sys.exit(65)
