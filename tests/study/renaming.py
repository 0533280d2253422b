"""Renames each column that a study reads, one after another: each time the error has to name the file and the column."""
# SPDX-License-Identifier: GPL-3.0-or-later
import contextlib

import pytest
from matplotlib import pyplot
from study import Study, StudyError, Table


def demand_columns(readers):
    """Fails unless each column that a reader takes from a table is missed by name when it is renamed. Returns how many there are.

    readers: functions without arguments that read their tables anew at each call, such as the measures of a study. A column is
    tried on the first reader that takes it, so cheap ones come first. Their figures are drawn and dropped, since saving them reads
    nothing and takes longer than the rest.
    """
    first = {}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Study, "figure", lambda *_, **__: None)
        for reader in readers:
            for column in columns_read(reader):
                first.setdefault(column, reader)
        for (where, name), reader in first.items():
            with renamed(where, name), pytest.raises(StudyError) as error:
                reader()
            pyplot.close("all")
            assert str(error.value).startswith(f"{where}: has no column {name};"), error.value
    return len(first)


def columns_read(reader):
    """Returns (file, column) of all that a reader takes from tables, in the order in which it does."""
    seen = {}
    with pytest.MonkeyPatch.context() as patch:
        ask = Table.__call__

        def noted(table, name, *unit, **how):
            seen[table.where, name] = True
            return ask(table, name, *unit, **how)
        patch.setattr(Table, "__call__", noted)
        reader()
    pyplot.close("all")
    return list(seen)


@contextlib.contextmanager
def renamed(where, name):
    """Lets a file have another name for one of its columns, wherever it is read."""
    with pytest.MonkeyPatch.context() as patch:
        read = Table.read

        def read_renamed(path):
            table = read(path)
            if str(path) != where:
                return table
            units = {f"{head}_renamed" if head == name else head: unit for head, unit in table._units.items()}
            return Table(table._rows, units, path)
        patch.setattr(Table, "read", read_renamed)
        yield
