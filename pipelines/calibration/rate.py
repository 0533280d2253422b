"""The loading rate of a calibration: the scenario's, a given one, or the fastest that the response no longer depends on."""
# SPDX-License-Identifier: GPL-3.0-or-later
import re
import tomllib

import numpy
from study import Table
from study.command import Failure
from study.files import put

from .prior import read as read_prior

HALVINGS = 2
# Greatest root mean square of the difference between the curves at a rate and at half of it, over the tests' error.
NEGLIGIBLE = 1 / 3
_RATE = re.compile(r"^rate\s*=.*$", re.MULTILINE)


def middle(prior):
    """Returns the middle of a prior: each parameter's value by its column head. On a log scale it is the geometric mean."""
    ranges = read_prior(prior)
    return {f"{p['name']} [{p.get('unit', '1')}]": (p["low"] * p["high"])**0.5 if p.get("scale") == "log" else (p["low"] + p["high"]) / 2
            for p in ranges}


def _with_rate(case, rate):
    """Writes a copy of the scenario with another rate of its triaxial stage; returns the path."""
    text, count = _RATE.subn(f"rate = {rate:g}", case.given.scenario.read_text(encoding="utf-8"))
    if count != 1:
        raise Failure(65, f"calibrate: {case.given.scenario}: {count} lines begin with \"rate =\" where the one of the triaxial stage belongs")
    path = case.folder / f"scenario_{rate:g}.toml"
    put(path, text)
    return path


def _curves(case, test, rate):
    """Runs the middle of the prior at a rate; returns the tables of its curves and of the errors, or None if the run fails."""
    row, folder = middle(case.given.prior), case.folder / f"rate_{rate:g}"
    sets = case.folder / "rate_sets.tsv"
    put(sets, "\t".join(["id [1]", *row]) + "\n" + "\t".join(["0", *map(repr, row.values())]) + "\n")
    case.scenario = _with_rate(case, rate)
    case.run(sets, test, folder)
    if (folder / "runs/000000/failed").exists():
        return None
    words = ["assimilate", sets, "--prior", case.given.prior, *case.comparison(test, folder), "--quiet", "--tsv", "--table"]
    for table in ("curves", "steps"):
        case.filter(*words, table, output=case.folder / f"rate_{rate:g}_{table}.tsv", fails=(1,))
    return [Table.read(case.folder / f"rate_{rate:g}_{table}.tsv") for table in ("curves", "steps")]


def difference(one, other):
    """Returns the root mean square of the difference of two curves over the test's error, for the observable where it is greatest."""
    curves, steps = one
    units = {name: unit for name, unit in (("stress_ratio", "1"), ("strain_radial", "%"), ("strain_volumetric", "%")) if curves.has(name)}
    return max(float(numpy.sqrt(numpy.mean(((curves(name, unit) - other[0](name, unit)) / steps(f"{name}_error", unit))**2)))
               for name, unit in units.items())


def chosen(case):
    """Sets the scenario of a calibration to the rate that its options ask for; returns a sentence on the rate."""
    if case.given.rate == "scenario":
        return "loading rate: the scenario's, without a trial (--rate try makes one)"
    if case.given.rate != "try":
        case.scenario = _with_rate(case, float(case.given.rate))
        return f"loading rate: {float(case.given.rate):g} 1/s as given"
    test = next((t for t in case.tests if t.kind != "greatest"), None)
    with open(case.given.scenario, "rb") as file:
        rate = next((stage["rate"] for stage in tomllib.load(file).get("stage", []) if "rate" in stage), None)
    if test is None or rate is None:
        raise Failure(64, "calibrate: --rate try needs a test with a curve, and a scenario with a rate; give the rate as a number")
    if not isinstance(rate, int | float):
        raise Failure(65, f"calibrate: {case.given.scenario}: the rate is {rate!r}; for --rate try write it as a number in 1/s, without its unit")
    fast = _curves(case, test, rate)
    for _ in range(HALVINGS):
        if fast is None:
            break
        slow = _curves(case, test, rate / 2)
        share = difference(fast, slow) if slow else numpy.inf
        if share <= NEGLIGIBLE:
            case.scenario = _with_rate(case, rate)
            return f"loading rate: {rate:g} 1/s, half of it changes the curves by {share:.2g} of the tests' error"
        rate, fast = rate / 2, slow
    case.scenario = _with_rate(case, rate)
    reason = ("the middle of the prior cannot be run" if fast is None else
              f"halving it from {2 * rate:g} 1/s still changed the curves by {share:.2g} of the tests' error")
    return f"loading rate: {rate:g} 1/s, at which the response may still depend on the rate: {reason}"
