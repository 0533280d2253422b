"""What the studies share beyond physics: tables with units, comparison with published values, figures, pages.

A study is a folder pipelines/NAME with study.mk (which file is made from which by which command), expected.tsv and
study.py, which reads like the chapter: it loads the tables of the tools, names each measure, states what was published
and draws. Everything that a study does not understand is an error with file, column and the nearest name.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
from .compare import Measure, Statement, compare, read_statements
from .errors import NotMade, StudyError
from .run import Study, main
from .tables import Table

__all__ = ["Measure", "NotMade", "Statement", "Study", "StudyError", "Table", "compare", "main", "read_statements"]
