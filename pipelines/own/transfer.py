#!/usr/bin/env python3
"""Corrects the model's answers for the asked bag by the loads of simulated bags with the asked stiffness, and by the scatter of these."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import pathlib
import sys

import numpy
from own.inputs import OTHERS, SAME
from study import StudyError, Table

# Normal deviate of the middle 80 %, and of the 95 % that gws-solve respond gives. Student's deviates by share (%) for 1, 2, ... degrees of freedom.
DEVIATE, OF_SOLVE = 1.2816, 1.9600
STUDENT = {80: (3.0777, 1.8856, 1.6377, 1.5332, 1.4759), 95: (12.7062, 4.3027, 3.1824, 2.7764, 2.5706)}


def bags(out):
    """Returns the loading tables of the bags with the asked stiffness, from the end of the preload on."""
    tables = [Table.read(out / f"{name}.tsv") for name in (f"uc_{SAME}", *(f"other_{k}_{SAME}" for k in OTHERS))]
    return [table.rows(table("strain_axial", "1") > -1e-9) for table in tables]


def half_width(values, share=80):
    """Returns the half width of the middle 80 or 95 % of a further value, from two or more independent ones (Student's t)."""
    n = len(values)
    return STUDENT[share][n - 2] * float(numpy.std(values, ddof=1)) * numpy.sqrt(1 + 1 / n)


def scatter(loads):
    """Returns the half width of the 80 % interval for the logarithm of a further bag's load, from independent bags."""
    return half_width(numpy.log(loads))


class Transfer:
    """The asked bag's load by settlement: the model's load times a factor, the ratio of simulated to modelled loads of the simulated bags.

    asked, grains: the model's responses (gws-solve respond) for the asked bag, with samples, and for a bag like the simulated ones. loads:
    tables of the simulated bags. The factor removes errors that the model makes alike in both. The middle 80 % combine two scatters,
    as independent and log-normal: of the bags, whose packings and contact parameters differ, and of the constants.
    """

    def __init__(self, asked, grains, loads):
        self.asked, self.grains, self.loads = asked, grains, loads
        self.end = float(asked("settlement", "1")[-1])
        self.simulated = float(min(table("strain_axial", "1")[-1] for table in loads))

    @classmethod
    def of(cls, out):
        """Reads the tables in a folder of results."""
        return cls(Table.read(out / "bands.tsv"), Table.read(out / "of_grains.tsv"), bags(out))

    def compared(self, settlement):
        """Returns the simulated loads and the model's load for such a bag (kPa) at a settlement, or at the last simulated one before it."""
        at = min(settlement, self.simulated)
        return [_at(table, at, "strain_axial") for table in self.loads], _at(self.grains, at, "settlement")

    def model(self, settlement):
        """Returns median, low and high (95 %, of the constants) of the asked bag's surcharge by the model (kPa)."""
        return tuple(_at(self.asked, settlement, "settlement", "surcharge" + end) for end in ("", "_low", "_high"))

    def factor(self, settlement):
        """Returns the geometric mean of the simulated loads over the model's load. Raises StudyError if a bag carries nothing."""
        loads, model = self.compared(settlement)
        if not min(*loads, model) > 0:
            raise StudyError(f"a simulated bag carries nothing at a settlement of {settlement:.3g}: the factor on the model is unknown; see the "
                             "bags' tables uc_*.tsv and other_*.tsv")
        return float(numpy.exp(numpy.mean(numpy.log(loads))) / model)

    def spread(self, settlement):
        """Returns the half width of the middle 80 % of the logarithm of the load. Raises StudyError where a draw carries nothing."""
        _, low, high = self.model(settlement)
        if not low > 0:
            raise StudyError(f"the surcharge is not above 0 in all draws of the constants at a settlement of {settlement:.3g}: no range can be told; "
                             "compress the bags farther (OWN_STRAIN), or make them larger (PROFILE=thesis)")
        within = (numpy.log(high) - numpy.log(low)) / (2 * OF_SOLVE)
        return float(numpy.hypot(DEVIATE * within, scatter(self.compared(settlement)[0])))

    def at(self, settlement):
        """Returns median, low and high (middle 80 %) of the asked bag's surcharge (kPa) at a settlement, which is at most `end`."""
        median, spread = self.model(settlement)[0] * self.factor(settlement), self.spread(settlement)
        return median, float(median * numpy.exp(-spread)), float(median * numpy.exp(spread))


def _at(table, where, along, column="surcharge"):
    return float(numpy.interp(where, table(along, "1"), table(column, "kPa")))


def loads_of_design(transfer, surcharge, settlement):
    """Returns the two surcharges of the model's design: the bag then carries the asked one in the median, or at the low end of the 80 %."""
    at = min(settlement, transfer.end)
    middle = surcharge / transfer.factor(at)
    return middle, float(middle * numpy.exp(transfer.spread(at)))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=pathlib.Path, help="folder of results")
    parser.add_argument("surcharge", type=float, help="Pa")
    parser.add_argument("settlement", type=float)
    given = parser.parse_args()
    try:
        print(*(f"{load:.7g}" for load in loads_of_design(Transfer.of(given.out), given.surcharge, given.settlement)))
    except StudyError as error:
        sys.exit(f"own: {error}")
