#!/usr/bin/env python3
"""The page of a soil and a bag of one's own: what the bag carries and what its geotextile must be, with their uncertainty."""
# SPDX-License-Identifier: GPL-3.0-or-later
import math
import pathlib
import re

import numpy
from calibration import predicted
from calibration.ensemble import PARAMETERS
from own.inputs import OTHERS, SAME, STIFFNESSES, failures, falls, read
from own.transfer import Transfer
from study import Drawn, Folder, Mean, NotMade, Series, Study, figures, main, panel
from study.words import quantity, spell

HERE = pathlib.Path(__file__).parent
# Lines of the wrapped soil as gws-solve identify names them, and in words.
LINES = {"compression_line": "compression line", "failure_line": "failure line", "near_failure_line": "near-failure line",
         "dilatancy_line": "dilatancy line", "stiffness": "stiffness"}
# Options that messages of the tools name, and the variables of make that set them.
IN_MAKE = {"--grains": "OWN_GRAINS", "--rounds": "OWN_ROUNDS", "--samples": "OWN_SAMPLES"}
NUMBER = re.compile(r"\d+(?:\.\d+)?(?:e[-+]?\d+)?")
COMPRESSION = 1  # number of the stage in pipelines/ch3/uc.toml


def in_make(words):
    """Returns a message of a tool with the variables of make in place of the tool's options, so that its remedy can be followed."""
    for option, variable in IN_MAKE.items():
        words = re.sub(rf"{option}\b", variable, words)
    return words


def doubts(out, names):
    """Returns the doubts that tools printed when they made some files, without the tool's name. Doubts that differ only in numbers are given once."""
    said = {}
    for name in names:
        for line in (out / f"{name}.said").read_text(encoding="utf-8").splitlines():
            if "doubt: " in line:
                words = in_make(line.partition("doubt: ")[2])
                said.setdefault(NUMBER.sub("#", words), []).append(words)
    return [words + (f" (and {len(more)} more with other numbers)" if (more := set(alike) - {words}) else "") for words, *alike in said.values()]


def borrowed(identified, own):
    """Returns the names of lines that are Toyoura sand's, since the report of gws-solve identify has none of this soil."""
    missing = [name for name in LINES if not re.search(rf"^{name}: \d+ points", identified, re.MULTILINE)]
    exponent = not falls(failures(own.curves)[0])
    return ["exponent of the failure line" if name == "failure_line" and exponent else LINES[name] for name in missing]


def measure(study, own, folder, transfer):
    """Measures the capacity of the bag, the demands on its geotextile, and their basis."""
    asked = own.values["settlement"]
    at = min(asked, transfer.end)
    for name, value in zip(("carried", "carried_low", "carried_high"), transfer.at(at), strict=True):
        study.measure(name, value, "kPa")
    study.measure("at", 100 * at, "%")
    study.measure("by_model", transfer.model(at)[0], "kPa")
    study.measure("factor", transfer.factor(at), "1")
    study.measure("bags_apart", 100 * numpy.std(numpy.log(transfer.compared(at)[0]), ddof=1), "%")
    for name in ("stiffness", "strength"):
        study.measure(f"needed_{name}", lambda name=name: designed(folder, "design")(name, "kN/m")[0], "kN/m")
        study.measure(f"needed_{name}_high", lambda name=name: designed(folder, "design_high")(name, "kN/m")[0], "kN/m")
    study.measure("settlement_of_design", lambda: designed(folder, "design")("settlement", "%")[0], "%")
    peaks = {seed: twins(folder(f"check_{seed}")) for seed in (1, 2)}
    study.measure("peak", Mean.of([peak for some in peaks.values() for peak in some]), "1")
    study.measure("packings_apart", 100 * abs(numpy.mean(peaks[2]) / numpy.mean(peaks[1]) - 1), "%")


def designed(folder, name):
    """Returns the table of a design. Raises NotMade where no geotextile is enough."""
    if not (folder.path / f"{name}.tsv").stat().st_size:
        raise NotMade("no geotextile is enough")
    return folder(name)


def twins(table):
    """Returns the greatest stress ratio of each twin of a representative volume."""
    ids = table("id", "1")
    return [float(table.rows(ids == i)("stress_ratio", "1").max()) for i in numpy.unique(ids)]


def distinct(draws):
    """Returns how many different sets the bags have. A posterior of few sets gives several bags the same one."""
    return len(set(zip(*(draws(name, unit) for name, _, unit in PARAMETERS), strict=True)))


def draw(study, own, folder, transfer):
    """Draws the answer, the chart, the bags and the tests."""
    settlements = numpy.linspace(0, transfer.end, 30)[1:]
    rows = numpy.array([transfer.at(s) for s in settlements])
    figure, (left, right) = figures.panels(2)
    left.fill_between(100 * settlements, rows[:, 1], rows[:, 2], color=figures.BLUE, alpha=0.2, linewidth=0, label="middle 80 %")
    left.plot(100 * settlements, rows[:, 0], color=figures.BLUE, label="answer")
    left.plot(100 * settlements, [transfer.model(s)[0] for s in settlements], color=figures.BLUE, linewidth=1, linestyle="--", label="model alone")
    left.axvline(100 * own.values["settlement"], color=figures.GREY, linewidth=1)
    figures.label(left, "settlement (%)", "surcharge (kPa)")
    chart, factor = folder("chart"), study.measures["factor"].value
    right.loglog(chart("stiffness", "kN/m"), factor * chart("allowable_surcharge", "kPa", missing=True), color=figures.ORANGE,
                 label="within the settlement")
    right.plot(chart("stiffness", "kN/m"), factor * chart("capacity", "kPa"), color=figures.INK, label="ultimate")
    figures.label(right, "stiffness of the geotextile (kN/m)", "surcharge (kPa)")
    for a in (left, right):
        a.legend()
    study.figure("answer", figure)

    def drawn(name, label, colour):
        run = folder(name)
        return Drawn(label, Series(run.rows(run("stage", "1") == COMPRESSION)), colour)
    bags = [drawn(f"other_{k}_{SAME}", "J, other packings" if k == OTHERS[0] else "", figures.GREY) for k in OTHERS]
    bags += [drawn(f"uc_{k}", f"{share:g} J", colour) for k, (share, colour) in enumerate(zip(STIFFNESSES, figures.SERIES, strict=False), start=1)]
    study.curves("bags", panel("strain_axial", "surcharge", bags), panel("mean_stress", "deviatoric_stress", bags, legend=False))
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
    transfer = Transfer.of(study.out)
    measure(study, own, folder, transfer)
    said = [in_make(line) for line in (study.out / "calibration/said.txt").read_text(encoding="utf-8").splitlines() if not line.startswith("doubt: ")]
    identified = (study.out / "identified.txt").read_text(encoding="utf-8")
    rising = re.search(r"OWN_RISING := *(.*)", (study.out / "inputs.mk").read_text(encoding="utf-8"))[1].split()
    values, at = own.values, study.measures["at"].value
    study.tell(
        name=values["name"], void_ratio=values["void_ratio"], packing_void_ratio=values["packing_void_ratio"],
        pressures=[f"{t.pressure / 1e3:g}" for t in own.tests], calibration=said, rising=rising, borrowed=borrowed(identified, own),
        surcharge=f"{values['surcharge'] / 1e3:g}", asked=f"{100 * values['settlement']:g}", short=transfer.end < values["settlement"],
        fabric=quantity(spell(own.fabric.stiffness / 1e3), "kN/m"), designed=study.measures["needed_strength"].value is not None,
        enough=study.measures["needed_strength_high"].value is not None,
        reduction=f"{own.reduction:.3g}", share=f"{own.strength_fraction / own.reduction:.3g}", fraction=f"{own.strength_fraction:.3g}",
        share_from="own.toml" if "strength_fraction" in values else "grains" if own.strength_fraction < 1 else "factors",
        soil_factor=values["factors"].get("soil", 1), load_factor=values["factors"].get("load", 1),
        bags=1 + len(OTHERS), sets=distinct(folder("draws")),
        simulated=f"{100 * transfer.simulated:.3g}", beyond_simulated=at > 100 * transfer.simulated + 1e-6, folder=arguments.soil,
        doubts=doubts(study.out, ["inputs", "identified", "bands", "design"]), loose=doubts(study.out, [f"packing_{k}" for k in range(1, 2 + len(OTHERS))]))
    draw(study, own, folder, transfer)
    study.history = (study.out / "provenance.txt").read_text(encoding="utf-8")
    study.text("Identified contact parameters", study.out / "calibration/posterior.txt")
    study.text("Identified constants of the wrapped soil", study.out / "identified.txt")
    study.appendix("Constants of the wrapped soil over packings (packing_1: soil.toml; low and high: middle 80 and 95 % of one more packing's)",
                   study.out / "constants.tsv")
    study.appendix("RMS difference of the posterior's mean from each test", study.out / "calibration/misfits.tsv")
    return study


if __name__ == "__main__":
    main(build, soil={"required": True, "help": "folder of own.toml"})
