#!/usr/bin/env python3
"""Lays what make own finds for Toyoura sand beside Table 5.2 of the thesis: constants, surcharges and chart. Part of toyoura.sh.

The constants are compared with the middle 80 and 95 % of one more packing's, beside the intervals of 95 % that gws-solve identify gives for one
packing; the surcharges with the range of 80 % of the page's answer. The chart has one range, in proportion, that of the asked settlement.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import pathlib
import re
import sys

import numpy
from own.transfer import Transfer
from study import Table

# A constant in the report of gws-solve identify: name, value, ends of its 95 %, value in Table 5.2.
CONSTANT = re.compile(r"^  (\w+) +(\S+)(?: Pa)? +95 %: +(\S+) to (\S+)(?: Pa)? +given (\S+):")
SETTLEMENTS = (0.01, 0.02, 0.03, 0.05, 0.07)


def judged(what, value, low, high, given):
    """Prints one comparison and returns whether the value of the table lies inside: False for a NaN, None without an interval."""
    inside = bool(low <= given <= high) if numpy.isfinite([low, high]).all() else None
    word = {True: "inside", False: "outside", None: "not determined"}[inside]
    print(f"{what:60s} {value:10.4g}  {low:10.4g} to {high:10.4g}  table {given:10.4g}  {word}")
    return inside


def constants(text, packings):
    """Yields what is compared, middle and ends of both ranges, and the table's value for each constant in a report of gws-solve identify.

    packings: rows of constants.tsv by constant. One that no bag determines has no range.
    """
    for line in text.splitlines():
        if found := CONSTANT.match(line):
            name, value, low, high, given = found[1], *(float(word) for word in found.groups()[1:])
            count, *numbers = packings.get(name, ["0", *["nan"] * 5])
            yield f"{name} ({value:.3g}, one packing {low:.3g} to {high:.3g}; {count} packings)", [float(word) for word in numbers], given


def compare(own, response, chart, asked):
    """Prints every comparison; returns by kind how many values lie inside, and how many have an interval."""
    transfer = Transfer.of(own)
    rows = [line.split("\t") for line in (own / "constants.tsv").read_text(encoding="utf-8").splitlines()[1:]]
    packings = {row[0].rpartition(".")[2]: row[3:] for row in rows}
    inside = {}
    for words, (middle, *ends), given in constants((own / "identified.txt").read_text(encoding="utf-8"), packings):
        for share, low, high in ((80, *ends[:2]), (95, *ends[2:])):
            inside.setdefault(f"constants ({share} %)", []).append(judged(f"{share} % {words}", middle, low, high, given))
    inside["surcharges"] = []
    for settlement in SETTLEMENTS:
        if settlement > transfer.end:
            break
        value, low, high = transfer.at(settlement)
        given = float(numpy.interp(settlement, response("settlement", "1"), response("surcharge", "kPa")))
        inside["surcharges"].append(judged(f"surcharge (kPa) at {100 * settlement:g} %", value, low, high, given))
    ours, spread = Table.read(own / "chart.tsv"), transfer.spread(asked)
    stiffness, allowable = ours("stiffness", "kN/m"), transfer.factor(asked) * ours("allowable_surcharge", "kPa", missing=True)
    inside["points of the chart"] = []
    for at, given in zip(chart("stiffness", "kN/m"), chart("allowable_surcharge", "kPa", missing=True), strict=True):
        if stiffness[0] <= at <= stiffness[-1] and given == given:
            value = float(numpy.exp(numpy.interp(numpy.log(at), numpy.log(stiffness), numpy.log(allowable))))
            inside["points of the chart"].append(judged(f"allowed (kPa), J {at:.0f} kN/m", value, value * numpy.exp(-spread), value * numpy.exp(spread), given))
    return {kind: ([one for one in some if one is not None].count(True), sum(one is not None for one in some)) for kind, some in inside.items()}


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("own", type=pathlib.Path, help="folder of make own's results")
    parser.add_argument("response", help="gws-solve respond --tsv with the table's constants")
    parser.add_argument("chart", help="gws-solve design --chart --tsv with them")
    parser.add_argument("settlement", type=float, help="of the chart")
    given = parser.parse_args()
    counts = compare(given.own, Table.read(given.response), Table.read(given.chart), given.settlement)
    print("crosscheck: Table 5.2 lies inside for " + ", ".join(f"{held} of {all_} {kind}" for kind, (held, all_) in counts.items()))
    # Four constants in five lie inside their 80 % if the ranges are right, so these do not decide.
    return 0 if all(held == all_ > 0 for kind, (held, all_) in counts.items() if kind != "constants (80 %)") else 1


if __name__ == "__main__":
    sys.exit(main())
