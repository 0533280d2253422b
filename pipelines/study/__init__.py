"""Tools that the studies share beyond physics: tables with units, comparison with published values, figures, pages.

A study is a folder pipelines/NAME with study.mk (which file is made from which by which command), expected.tsv and
study.py, which reads like the chapter: it loads the tables of the tools, names each measure, states what was published
and draws. Everything that a study does not understand is an error with file, column and the nearest name.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import importlib

# The module of each name. They are imported when they are asked for: plot --help draws nothing and need not wait.
_HOME = {"Measure": "comparison", "Statement": "comparison", "compare": "comparison", "read_statements": "comparison", "NotMade": "errors",
         "StudyError": "errors", "Study": "run", "main": "run", "Cells": "tables", "Folder": "tables", "Table": "tables",
         "Mean": "series", "Series": "series", "Drawn": "curves", "panel": "curves"}
__all__ = list(_HOME)  # pylint: disable=undefined-all-variable


def __getattr__(name):
    if name not in _HOME:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(importlib.import_module(f".{_HOME[name]}", __name__), name)
