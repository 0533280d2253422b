"""Results of a calibration: its parameters, and the curves of the posterior beside each test, as tables and as drawings."""
# SPDX-License-Identifier: GPL-3.0-or-later
import os
import subprocess

import numpy
from study import Drawn, Series, Table, curves, figures, panel
from study.files import put
from study.tables import write_table

from .ensemble import PARAMETERS

OBSERVED = ("stress_ratio", "strain_volumetric")
LOW, HIGH = 0.05, 0.95
# Sets with less than this share of the greatest weight are not run to predict a test.
NEGLIGIBLE = 1e-3


def quantile(values, weights, share):
    """Returns the weighted quantile: the least value up to which the weights reach `share` of their sum."""
    order = numpy.argsort(values)
    reached = numpy.cumsum(weights[order]) >= share * weights.sum() - 1e-12
    return values[order][int(numpy.argmax(reached))]


def band(table, weight_of, names):
    """Returns columns of a table of curves over their stations: observation, weighted mean, 5 and 95 % of the weight, deviation.

    weight_of: weights by id.
    """
    ids, steps = table("id", "1"), table("step", "1")
    columns = {"strain_axial [%]": []}
    for step in numpy.unique(steps):
        rows = table.rows(steps == step)
        weights = numpy.array([weight_of[i] for i in ids[steps == step]])
        weights = weights / weights.sum()
        columns["strain_axial [%]"].append(rows["strain_axial"][0])
        for name in names:
            unit = "%" if name.startswith("strain") else "1"
            values = rows(name, unit)
            mean = float(values @ weights)
            for ending, value in (("observed", rows(f"{name}_observed", unit)[0]), ("", mean), ("low", quantile(values, weights, LOW)),
                                  ("high", quantile(values, weights, HIGH)), ("deviation", float(numpy.sqrt(weights @ (values - mean)**2)))):
                columns.setdefault(f"{name}{'_' if ending else ''}{ending} [{unit}]", []).append(value)
    return columns


def parameters(steps, runs, sets):
    """Returns the identified parameters: weighted mean, deviation, 5 and 95 % of the weight, and the set of the greatest weight."""
    heaviest = sets.rows(sets("id", "1") == runs("id", "1")[runs("weight", "1").argmax()])
    units = {name: unit for name, _, unit in PARAMETERS if steps.has(name)}
    return {"parameter": list(units), "unit": list(units.values()),
            **{end or "mean": [steps(f"{name}{'_' if end else ''}{end}", unit)[-1] for name, unit in units.items()]
               for end in ("", "deviation", "low", "high")},
            "heaviest": [heaviest(name, unit)[0] for name, unit in units.items()]}


def drawn(folder, rounds):
    """Returns the sets of the first `rounds` rounds as the text of one table, a row for each set."""
    texts = [(folder / f"round{r}_sets.tsv").read_text(encoding="utf-8").splitlines() for r in range(1, rounds + 1)]
    width = texts[0][0].count("\t") + 1
    return "\n".join([texts[0][0], *("\t".join(line.split("\t")[:width]) for text in texts for line in text[1:])]) + "\n"


def with_weight(sets, weight_of):
    """Returns the rows of a table of sets whose weight is not negligible."""
    head, *rows = sets.splitlines()
    least = NEGLIGIBLE * max(weight_of.values())
    return "\n".join([head, *(row for row in rows if weight_of.get(float(row.split("\t")[0]), 0) > least)]) + "\n"


def clear(folder):
    """Removes the posterior and curves of an earlier calibration in a folder, whose tests may have been others."""
    for path in [*folder.glob("predicted_*.tsv"), folder / "predicted.svg", folder / "posterior.h5"]:
        path.unlink(missing_ok=True)


def write(case, name):
    """Writes parameters.tsv, predicted_TEST.tsv, misfits.tsv, predicted.svg and posterior.svg of a calibration's last round."""
    steps, runs = (Table.read(case.folder / f"{name}_{table}.tsv") for table in ("steps", "runs"))
    sets = drawn(case.folder, int(name.removeprefix("round")))
    put(case.folder / "sets.tsv", sets)
    put(case.folder / "weights.tsv", write_table({"id [1]": runs("id", "1"), "weight [1]": runs("weight", "1")}))
    put(case.folder / "parameters.tsv", write_table(parameters(steps, runs, Table.parse(sets, "sets.tsv"))))
    weight_of = dict(zip(runs("id", "1"), runs("weight", "1"), strict=True))
    heavy = case.folder / "heavy_sets.tsv"
    put(heavy, with_weight(sets, weight_of))
    for test in case.given.predictions:
        case.predict(test, heavy)
    panels, beside, misfits = [], 1, {"test": [], **{f"{n} [{'%' if 'strain' in n else '1'}]": [] for n in OBSERVED}}
    for test in case.tests + case.given.predictions:
        table = Table.read(case.folder / f"{test.name}_curves.tsv")
        names = [n for n in OBSERVED if table.has(n)]
        if test.kind == "greatest" or not names:
            continue
        columns, beside = band(table, weight_of, names), max(beside, len(names))
        path = case.folder / f"predicted_{test.name}.tsv"
        put(path, write_table(columns))
        panels += draw(path, test, names, "" if test in case.tests else ", predicted")
        misfits["test"].append(test.name)
        for n in OBSERVED:
            unit = "%" if "strain" in n else "1"
            off = numpy.subtract(columns[f"{n} [{unit}]"], columns[f"{n}_observed [{unit}]"]) if n in names else None
            misfits[f"{n} [{unit}]"].append(None if off is None else float(numpy.sqrt(numpy.mean(off**2))))
    put(case.folder / "misfits.tsv", write_table(misfits))
    if panels:
        put(case.folder / "predicted.svg", figures.svg(curves.figure(panels, columns=beside)))
    subprocess.run([f"{os.environ['BIN']}/plot", "posterior", case.folder / f"{name}_posterior.h5", "--force", "--quiet", "-o",
                    case.folder / "posterior.svg"], check=True)


def draw(path, test, names, note):
    """Returns a panel for each observable of a test: the posterior's mean and spread, and the laboratory's points."""
    table = Table.read(path)
    strain = table["strain_axial"]

    def of(ending):
        return Series({"strain_axial": strain, **{n: table(f"{n}{ending}", "%" if n.startswith("strain") else "1") for n in names}})
    runs = [Drawn("posterior", of(""), figures.BLUE, spread=of("_deviation")), Drawn("laboratory", of("_observed"), figures.INK, "o")]
    return [panel("strain_axial", n, runs, legend=n == names[0], title=f"{test.pressure / 1e3:g} kPa{note}") for n in names]
