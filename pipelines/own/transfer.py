#!/usr/bin/env python3
"""From the model to the asked bag: by what the bags of grains with the asked stiffness carry more than the model, and how they scatter."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import pathlib
import sys

import numpy
from own.inputs import OTHERS, SAME
from study import StudyError, Table

# Normal deviate of the middle 80 %, and of the 95 % that gws-solve respond gives. Student's deviates of 80 % for 1, 2, ... degrees of freedom.
DEVIATE, OF_SOLVE = 1.2816, 1.9600
STUDENT = (3.0777, 1.8856, 1.6377, 1.5332, 1.4759)


def bags(out):
    """Returns the loading tables of the bags with the asked stiffness, from the end of the preload on."""
    tables = [Table.read(out / f"{name}.tsv") for name in (f"uc_{SAME}", *(f"other_{k}" for k in OTHERS))]
    return [table.rows(table("strain_axial", "1") > -1e-9) for table in tables]


def scatter(loads):
    """Returns the half width of the 80 % in which the logarithm of a further load lies, from loads of independent bags (Student's t)."""
    n = len(loads)
    return STUDENT[n - 2] * float(numpy.std(numpy.log(loads), ddof=1)) * numpy.sqrt(1 + 1 / n)


class Transfer:
    """The asked bag's load by settlement: the model's, times what bags of grains carry over what the model gives for such a bag.

    asked, grains: responses (gws-solve respond) of the asked bag, with its samples, and of a bag like those of grains. loads: tables of
    these. The factor takes out what the model misses alike in both. The middle 80 % hold the scatter of the bags, whose packings and
    contact parameters differ, and that of the constants; both are taken for independent and log-normal.
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
        """Returns the loads of the bags (kPa), and the model's for such a bag, at a settlement; beyond the last simulated one, there."""
        at = min(settlement, self.simulated)
        return [_at(table, at, "strain_axial") for table in self.loads], _at(self.grains, at, "settlement")

    def model(self, settlement):
        """Returns median, low and high (95 %, of the constants) of the asked bag's surcharge by the model (kPa)."""
        return tuple(_at(self.asked, settlement, "settlement", "surcharge" + end) for end in ("", "_low", "_high"))

    def factor(self, settlement):
        """Returns by what factor the bags of grains (their geometric mean) carry more than the model. Raises StudyError where one carries nothing."""
        loads, model = self.compared(settlement)
        if not min(*loads, model) > 0:
            raise StudyError(f"a bag of grains carries nothing at a settlement of {settlement:.3g}: no factor on the model can be told; see the "
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
    """Returns the surcharges for which the model designs the geotextile: for the asked one in the middle, and at the low end of the 80 %."""
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
