#!/usr/bin/env python3
"""The page of a soil and a bag of one's own: what the bag carries and what its geotextile must be, with their uncertainty."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math
import pathlib
import re

import numpy
from calibration import predicted
from calibration.ensemble import PARAMETERS
from own.inputs import STIFFNESSES, failures, falls, read
from study import Drawn, Folder, Mean, NotMade, Series, Study, StudyError, figures, main, panel
from study.words import quantity, spell

HERE = pathlib.Path(__file__).parent
# Normal deviate of the middle 80 %, and of the 95 % that gws-solve respond gives.
DEVIATE, OF_SOLVE = 1.2816, 1.9600
# Lines of the wrapped soil as gws-solve identify names them, and in words.
LINES = {"compression_line": "compression line", "failure_line": "failure line", "near_failure_line": "near-failure line",
         "dilatancy_line": "dilatancy line", "stiffness": "stiffness"}
COMPRESSION = 1  # number of the stage in pipelines/ch3/uc.toml


def jackknife(values, bags=len(STIFFNESSES)):
    """Returns the standard deviation of an estimate from its values with one bag left out each (Efron & Tibshirani 1993, Eq. 11.5).

    bags: the number of bags. Where some of them cannot be left out, the variance of the other values stands for that of all.
    """
    return float(numpy.sqrt((bags - 1)**2 / bags * numpy.var(values, ddof=1)))


def combined(median, low, high, left_out):
    """Returns the middle 80 % of a positive quantity: the scatter of the constants (their 95 %) and that of the bags together.

    Both are taken for independent and log-normal. left_out: the quantity without one bag each; bags differ in their packing and
    have sets of the posterior, so that these count with them.
    """
    if not min(median, low, high, *left_out) > 0:
        raise NotMade("it is not above 0 in all draws")
    within = (numpy.log(high) - numpy.log(low)) / (2 * OF_SOLVE)
    spread = DEVIATE * numpy.hypot(within, jackknife(numpy.log(left_out)))
    return float(median * numpy.exp(-spread)), float(median * numpy.exp(spread))


class Bands:
    """Responses of the bag by the constants of all bags, and by those without one each, at the settlements that all have."""

    def __init__(self, folder, bags):
        self.whole, self.parts = folder("bands_soil"), [folder(f"bands_soil_{k}") for k in bags]
        self.end = min(t("settlement", "1")[-1] for t in (self.whole, *self.parts))

    def at(self, settlement, column="surcharge"):
        """Returns median, low and high of a column (kPa) at a settlement, which is at most `end`."""
        def value(table, name):
            return float(numpy.interp(settlement, table("settlement", "1"), table(name, "kPa")))
        median, low, high = (value(self.whole, column + end) for end in ("", "_low", "_high"))
        return median, *combined(median, low, high, [value(t, column) for t in self.parts])


def whole_parts(out):
    """Returns the numbers of the bags without which the others determine response and design. Raises StudyError for less than two."""
    bags = [k for k in range(1, len(STIFFNESSES) + 1)
            if all((out / f"{table}_soil_{k}.tsv").stat().st_size for table in ("bands", "design"))]
    if len(bags) < 2:
        raise StudyError(f"{out}: the constants hang on single bags (bands_soil_*.said): no interval can be told; compress the bags farther "
                         "(OWN_STRAIN), or make them larger (PROFILE=thesis)")
    return bags


def reach(table, settlement):
    """Returns by how much a table of a design goes beyond the asked settlement, for the sentence on what governs."""
    return table("settlement", "%")[0] - 100 * settlement


def doubts(out, names):
    """Returns what the tools doubted when they made some files, each once, without the tool's name."""
    said = []
    for name in names:
        text = (out / f"{name}.said").read_text(encoding="utf-8")
        said += [line.partition("doubt: ")[2] for line in text.splitlines() if "doubt: " in line]
    return list(dict.fromkeys(said))


def borrowed(identified, own):
    """Returns in words the lines of Toyoura sand that stand for those of this soil: those that the report of gws-solve identify lacks."""
    missing = [name for name in LINES if not re.search(rf"^{name}: \d+ points", identified, re.MULTILINE)]
    exponent = not falls(failures(own.curves)[0])
    return ["exponent of the failure line" if name == "failure_line" and exponent else LINES[name] for name in missing]


def measure(study, own, folder, bands, bags):
    """Measures the capacity of the bag, the demands on its geotextile, and their basis."""
    asked = own.values["settlement"]
    at = min(asked, bands.end)
    median, low, high = bands.at(at)
    for name, value in (("carried", median), ("carried_low", low), ("carried_high", high)):
        study.measure(name, value, "kPa")
    study.measure("at", 100 * at, "%")
    for name, unit in (("stiffness", "kN/m"), ("strength", "kN/m")):
        designs = [folder(f"design_{soil}")(name, unit)[0] for soil in ("soil", *(f"soil_{k}" for k in bags))]
        study.measure(f"needed_{name}", designs[0], unit)
        study.measure(f"needed_{name}_high", lambda d=designs: d[0] * numpy.exp(DEVIATE * jackknife(numpy.log(d[1:]))), unit)
    study.measure("settlement_of_design", folder("design_soil")("settlement", "%")[0], "%")
    peaks = {seed: twins(folder(f"check_{seed}")) for seed in (1, 2)}
    study.measure("peak", Mean.of([peak for some in peaks.values() for peak in some]), "1")
    study.measure("packings_apart", 100 * abs(numpy.mean(peaks[2]) / numpy.mean(peaks[1]) - 1), "%")


def twins(table):
    """Returns the greatest stress ratio of each twin of a representative volume."""
    ids = table("id", "1")
    return [float(table.rows(ids == i)("stress_ratio", "1").max()) for i in numpy.unique(ids)]


def distinct(draws):
    """Returns how many of the sets that the bags were given are different ones: a posterior of few sets gives one to several bags."""
    return len(set(zip(*(draws(name, unit) for name, _, unit in PARAMETERS), strict=True)))


def draw(study, own, folder, bands):
    """The answer, the chart, the bags and the tests."""
    settlements = numpy.linspace(0, bands.end, 30)[1:]
    rows = numpy.array([bands.at(s) for s in settlements])
    figure, (left, right) = figures.panels(2)
    left.fill_between(100 * settlements, rows[:, 1], rows[:, 2], color=figures.BLUE, alpha=0.2, linewidth=0, label="middle 80 %")
    left.plot(100 * settlements, rows[:, 0], color=figures.BLUE, label="model")
    left.axvline(100 * own.values["settlement"], color=figures.GREY, linewidth=1)
    figures.label(left, "settlement (%)", "surcharge (kPa)")
    chart = folder("chart")
    right.loglog(chart("stiffness", "kN/m"), chart("allowable_surcharge", "kPa", missing=True), color=figures.ORANGE, label="within the settlement")
    right.plot(chart("stiffness", "kN/m"), chart("capacity", "kPa"), color=figures.INK, label="ultimate")
    figures.label(right, "stiffness of the geotextile (kN/m)", "surcharge (kPa)")
    for a in (left, right):
        a.legend()
    study.figure("answer", figure)
    runs = [folder(f"uc_{k}") for k in range(1, len(STIFFNESSES) + 1)]
    bags = [Drawn(f"{share:g} J", Series(run.rows(run("stage", "1") == COMPRESSION)), colour)
            for run, share, colour in zip(runs, STIFFNESSES, figures.SERIES, strict=False)]
    study.curves("bags", panel("strain_axial", "plate_pressure", bags), panel("mean_stress", "deviatoric_stress", bags, legend=False))
    panels = []
    for test in own.tests + own.predictions:
        path = folder.path / "calibration" / f"predicted_{test.name}.tsv"
        panels += predicted.draw(path, test, predicted.OBSERVED, ", predicted" if test in own.predictions else "")
    study.curves("tests", *panels, columns=2)


def build(arguments):
    """Reads the tables in the folder OUT and writes what the bag carries, how that was reached and what it rests on."""
    study = Study.of(HERE, arguments)
    study.first_screen = math.inf  # the soil's name and the number of its tests are the user's
    own = read(pathlib.Path(arguments.soil) / "own.toml")
    folder = Folder(study.out)
    bags = whole_parts(study.out)
    bands = Bands(folder, bags)
    measure(study, own, folder, bands, bags)
    said = [line for line in (study.out / "calibration/said.txt").read_text(encoding="utf-8").splitlines() if not line.startswith("doubt: ")]
    identified = (study.out / "identified.txt").read_text(encoding="utf-8")
    rising = re.search(r"OWN_RISING := *(.*)", (study.out / "inputs.mk").read_text(encoding="utf-8"))[1].split()
    study.tell(void_ratio=own.values["void_ratio"], packing_void_ratio=own.values["packing_void_ratio"], lost=len(STIFFNESSES) - len(bags), left=len(bags), sets=distinct(folder("draws")), name=own.values["name"], surcharge=f"{own.values['surcharge'] / 1e3:g}", asked=f"{100 * own.values['settlement']:g}",
               short=bands.end < own.values["settlement"], borrowed=borrowed(identified, own), reduction=f"{own.reduction:.3g}", share=f"{own.strength_fraction / own.reduction:.3g}", fraction=f"{own.strength_fraction:.3g}",
               share_from="own.toml" if "strength_fraction" in own.values else "grains" if own.strength_fraction < 1 else "factors", calibration=said, rising=rising,
               pressures=[f"{t.pressure / 1e3:g}" for t in own.tests], beyond=reach(folder("design_soil"), own.values["settlement"]) > 1e-6,
               fabric=quantity(spell(own.fabric.stiffness / 1e3), "kN/m"), folder=arguments.soil, doubts=doubts(study.out, ["inputs", "identified", "bands_soil", "design_soil"]), loose=doubts(study.out, ["packing_1", "packing_2"]), soil_factor=own.values["factors"].get("soil", 1),
               load_factor=own.values["factors"].get("load", 1))
    draw(study, own, folder, bands)
    study.history = (study.out / "provenance.txt").read_text(encoding="utf-8")
    study.text("Identified contact parameters", study.out / "calibration/posterior.txt")
    study.text("Identified constants of the wrapped soil", study.out / "identified.txt")
    study.appendix("RMS difference of the posterior's mean from each test", study.out / "calibration/misfits.tsv")
    return study


if __name__ == "__main__":
    main(build, soil={"required": True, "help": "folder of own.toml"})
