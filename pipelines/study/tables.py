"""Tables of numbers as the tools print them: columns by name and unit, missing ones refused."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import re

import numpy

from .errors import NotMade, StudyError, suggestion
from .plain_text import cells, number, read_text, separator_of
from .quantities import quantity
from .units import factor

_HEAD = re.compile(r"^(?P<name>[^\[\]]+?)(?: (?:\[(?P<unit>[^\[\]]+)\]|\((?P<bracketed>[^()]+)\)))?$")


class Table:
    """Columns of equal length, each with a name and a unit ("1" for pure numbers).

    table("mean_stress", "kPa") is the column converted to that unit, as an array of floats. A column that is missing,
    has another kind of unit or holds a NaN raises StudyError with the file, the column and the nearest name.
    """

    def __init__(self, rows, units, where):
        self._rows, self._units, self.where = rows, units, str(where)
        self._place = {name: k for k, name in enumerate(units)}

    @classmethod
    def read(cls, path):
        """Reads a table with a header of "name [unit]", separated by tabs, semicolons or commas; # begins a line of comment."""
        return cls.parse(read_text(path), path)

    @classmethod
    def parse(cls, text, path):
        """Returns the table that a text holds. path: its name in messages."""
        lines = [line for line in text.splitlines() if line.strip() and not line.startswith("#")]
        if not lines:
            raise StudyError(f"{path}: holds no table; begin with a header of names such as \"time [s]\"")
        units, separator = {}, separator_of(lines[0])
        for head in cells(lines[0], separator):
            match = _HEAD.match(head)
            if not match:
                raise StudyError(f"{path}: '{head}' is no head of a column; write \"name [unit]\"")
            if match["name"] in units:
                raise StudyError(f"{path}: two columns are named {match['name']}")
            units[match["name"]] = match["unit"] or match["bracketed"] or ""
        rows = [cells(line, separator) for line in lines[1:]]
        for number, row in enumerate(rows, start=1):
            if len(row) != len(units):
                raise StudyError(f"{path}: row {number} has {len(row)} values, the header {len(units)} columns")
        return cls(rows, units, path)

    def has(self, name):
        """Returns whether there is a column of that name."""
        return name in self._units

    @property
    def names(self):
        """The names of the columns, in their order."""
        return list(self._units)

    def unit(self, name):
        """Returns the unit that a column has in its header, "" for none."""
        return self._units[name]

    def replace(self, name, values):
        """Returns the table with other numbers in one of its columns, in the column's own unit."""
        place = self._place[name]
        rows = [[*row[:place], repr(float(value)), *row[place + 1:]] for row, value in zip(self._rows, values, strict=True)]
        return Table(rows, self._units, self.where)

    def __len__(self):
        return len(self._rows)

    def __call__(self, name, unit, missing=False):
        """Returns the column in the unit asked for. missing: allows NaN, which represents "no value"."""
        if name not in self._units:
            raise StudyError(f"{self.where}: has no column {name}{suggestion(name, self._units)}")
        try:
            scale = factor(self._units[name] or "1", unit)
        except StudyError as error:
            why = error if self._units[name] else f"has no unit: head it as {name} [{unit}]"
            raise StudyError(f"{self.where}: column {name}: {why}") from error
        values = numpy.array([self._number(name, row) for row in range(len(self))], dtype=float)
        if not missing and numpy.isnan(values).any():
            row = int(numpy.flatnonzero(numpy.isnan(values))[0]) + 1
            raise StudyError(f"{self.where}: column {name} has no value in row {row}")
        return values if scale == 1 else scale * values

    def _number(self, name, row):
        try:
            return number(self._rows[row][self._place[name]])
        except StudyError as error:
            raise StudyError(f"{self.where}: row {row + 1}: column {name}: {error}") from error

    def __getitem__(self, name):
        """Returns the column in the unit that quantities.py gives it; those that may have no value in a row hold NaN there."""
        line = quantity(name)
        return self(name, line.unit, missing=line.missing)

    def rows(self, mask):
        """Returns the table of the rows where the mask holds. Raises StudyError where there is none."""
        if not numpy.any(mask):
            raise StudyError(f"{self.where}: has none of the rows asked for")
        return Table([row for row, kept in zip(self._rows, mask, strict=True) if kept], self._units, self.where)


class Folder:
    """The tables of a folder: folder("bag") is the Table of bag.tsv, read once.

    absent: why a table may be missing, as the reason of NotMade; without it a missing table is an error.
    """

    def __init__(self, path, absent=""):
        self.path, self.absent, self._read = pathlib.Path(path), absent, {}

    def __call__(self, name):
        path = self.path / f"{name}.tsv"
        if self.absent and not path.exists():
            raise NotMade(f"{name}: {self.absent}")
        if name not in self._read:
            self._read[name] = Table.read(path)
        return self._read[name]


def read_words(path, needed=()):
    """Reads a table whose cells are words: returns its header and (line number, row by name) pairs.

    needed: columns that it must have. Lines that begin with # are comments. Raises StudyError naming file and line, also where two
    columns have one name.
    """
    header, separator, rows = None, "\t", []
    for place, line in enumerate(read_text(path).splitlines(), start=1):
        if not line.strip() or line.startswith("#"):
            continue
        if header is None:
            separator = separator_of(line)
            header = cells(line, separator)
            for name in header:
                if header.count(name) > 1:
                    raise StudyError(f"{path}: line {place}: two columns are named {name}")
            for name in needed:
                if name not in header:
                    raise StudyError(f"{path}: line {place}: has no column {name}{suggestion(name, header)}")
            continue
        words = cells(line, separator)
        if len(words) != len(header):
            raise StudyError(f"{path}: line {place}: {len(words)} cells where the header has {len(header)}")
        rows.append((place, dict(zip(header, words, strict=True))))
    if header is None:
        raise StudyError(f"{path}: holds no table")
    return header, rows


class Cells:
    """A table of words beside numbers: cells("slope", "bag") is the number in the row that `key` calls "slope", in column "bag"."""

    def __init__(self, path, key):
        self.path = path
        self._header, rows = read_words(path, [key])
        self._rows = {row[key]: row for _, row in rows}

    def __call__(self, row, column):
        """Raises StudyError for an unknown row or column, or where there is no number."""
        for name, known in ((row, self._rows), (column, self._header)):
            if name not in known:
                raise StudyError(f"{self.path}: has no '{name}'{suggestion(name, known)}")
        try:
            return float(self._rows[row][column])
        except ValueError as error:
            raise StudyError(f"{self.path}: '{row}', {column}: {error}") from error


def write_table(columns):
    """Returns columns, a dictionary of heads and equally many values, as tab-separated text; None is an empty cell."""
    def cell(value):
        return "" if value is None else value if isinstance(value, str) else f"{value:.6g}"
    lines = ["\t".join(columns)]
    lines += ["\t".join(cell(value) for value in row) for row in zip(*columns.values(), strict=True)]
    return "\n".join(lines) + "\n"
