"""A table as figures and measures read it: columns in the units of QUANTITIES, and columns derived from them row by row."""
# SPDX-License-Identifier: GPL-3.0-or-later
import numpy

from .errors import StudyError
from .quantities import Line, quantity


class Series:
    """The rows of a table, in the order of loading: series["axial_stress"] is an array in kPa.

    table: a Table, or a dictionary of columns that are in these units already. derived: columns beyond those
    of the table, by name: the unit, the words along an axis, and a function that computes the column from the series.
    """

    derived = {}

    def __init__(self, table):
        self.table = table

    def __getitem__(self, name):
        return self.derived[name][2](self) if name in self.derived else self.table[name]

    def __len__(self):
        return len(self.table)

    def line(self, name):
        """Returns unit and words of a column, as figures need them."""
        return Line(name, *self.derived[name][:2]) if name in self.derived else quantity(name)

    def last(self, name):
        """Returns the last value of a column."""
        return self[name][-1]

    def most(self, name):
        """Returns the row of the greatest value of a column, the first where there are several."""
        return int(self[name].argmax())

    def where(self, along, at, name):
        """Returns the column `name` where the column `along` first reaches `at`, linearly between its rows.

        Raises StudyError where it never does or is beyond it from the start: nothing is extrapolated.
        """
        x, y = self[along], self[name]
        reached = numpy.flatnonzero(x >= at)
        if not len(reached) or (reached[0] == 0 and x[0] > at):
            raise StudyError(f"{self.table.where}: {along} does not come to {at:.6g} from below")
        k = reached[0]
        return float(y[k] if x[k] == at else y[k - 1] + (y[k] - y[k - 1]) * (at - x[k - 1]) / (x[k] - x[k - 1]))


class Mean(Series):
    """Means of a column over several tables of equally many rows, row by row. spread: standard deviations, row by row."""

    def __init__(self, tables, how=None):
        """how: function of the values of each row, by default their mean. Raises StudyError for tables of other lengths."""
        super().__init__(tables[0])
        if len({len(t) for t in tables}) > 1:
            raise StudyError(f"{tables[0].where}: has another number of rows than the tables beside it")
        self._tables, self._how = tables, how or (lambda values: values.mean(axis=0))
        self.spread = self if how else Mean(tables, deviation)

    def __getitem__(self, name):
        return self._how(numpy.array([t[name] for t in self._tables]))

    def greatest(self, name):
        """Returns the greatest mean and the deviation there."""
        row = self.most(name)
        return self[name][row], self.spread[name][row]

    def at(self, along, value, name):
        """Returns mean and deviation of a column in the row where another one has a value; it has to be there."""
        row = int(abs(self[along] - value).argmin())
        if abs(self[along][row] - value) > 1e-3:
            raise StudyError(f"{self.table.where}: has no row where {along} is {value}")
        return self[name][row], self.spread[name][row]

    @staticmethod
    def of(values):
        """Returns mean and deviation of single values."""
        return numpy.mean(values), deviation(values)


def deviation(values):
    """Returns the standard deviation along the first axis; 0 for a single value."""
    return numpy.std(values, axis=0, ddof=1) if len(values) > 1 else numpy.zeros_like(values[0])
