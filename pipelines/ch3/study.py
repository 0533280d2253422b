#!/usr/bin/env python3
"""Chapter 3: the soilbag, made from copies of a representative volume, compressed and sheared (thesis Figs. 3.2 to 3.18)."""
# SPDX-License-Identifier: GPL-3.0-or-later
import tomllib

from ch3 import compression, drawing, making, pictures, shear
from ch3.bag import HERE, Runs
from study import Cells, Study, main

MEASURES = (making.measure, compression.measure, compression.measure_breaks, shear.measure)
# OF_ALL: figures of this run and of the kept full-size runs. OF_RUNS: figures of this run alone.
OF_ALL = (drawing.draw_compressed, drawing.draw_sheared, drawing.draw_shape, drawing.draw_growth)
# Kinetic energy at rest, J (thesis §3.3.1)
THESIS_ENERGY = 1e-5
OF_RUNS = (drawing.draw_strip_and_box, pictures.draw_breaks, pictures.draw_bag)


def given(name):
    """Returns the scenario or plan of this name."""
    return tomllib.loads((HERE / name).read_text(encoding="utf-8"))


def span(*descriptions, digits=0, bags=("bulging_seed_1", "bulging_seed_2", "bulging_seed_3")):
    """Returns the range of values in rows of the kept table of bulging bags as text: "2 to 5", or "2" if both ends are equal."""
    bulging = Cells(HERE / "kept" / "bulging_thesis.tsv", "description")
    values = [bulging(description, bag) for description in descriptions for bag in bags]
    low, high = (f"{value:.{digits}f}" for value in (min(values), max(values)))
    return low if low == high else f"{low} to {high}"


def build(arguments):
    """Reads the tables of the bags, strips and boxes in the folder OUT and writes what was measured, drawn and compared."""
    full = arguments.kept or arguments.profile == "thesis"
    study = Study.of(HERE, arguments, judged=full)
    runs = Runs.kept(study.out) if arguments.kept else Runs(study.out, full, arguments.loads)
    for measure in MEASURES:
        measure(study, runs)
    if not arguments.kept:
        study.tell(grains=f"{runs.table('bag_histogram')['grains'].sum():.0f}", span=span, spread=making.spread_table(runs),
                   loading=given("uc.toml"), thesis_energy=THESIS_ENERGY)
        study.history = (study.out / "provenance.txt").read_text(encoding="utf-8")
    for draw in OF_ALL if arguments.kept else OF_ALL + OF_RUNS:
        draw(study, runs, None if full else Runs.kept())
    return study


if __name__ == "__main__":
    main(build, loads={"nargs": "+", "type": int, "default": [], "help": "dead loads (N) of the bags in simple shear"})
