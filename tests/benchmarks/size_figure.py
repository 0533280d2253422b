"""Draws the cost of a contact against the size of a packing: size_figure.py TABLE FIGURE."""
# SPDX-License-Identifier: GPL-3.0-or-later
import pathlib
import sys

from study import Table, figures

table, figure = sys.argv[1:]
sizes = Table.read(table)
drawing, (axes,) = figures.panels(1, height=3.4)
axes.semilogx(sizes("grains", "1"), sizes("per_contact", "ns"), "o-", color=figures.BLUE, label="step of run-dem")
axes.semilogx(sizes("grains", "1"), sizes("memory_per_contact", "ns"), "o--", color=figures.INK, label="its records, read and written once")
axes.set_ylim(bottom=0)
axes.legend()
figures.label(axes, "grains", "time of a step per contact (ns)", pure=("grains",))
pathlib.Path(figure).write_text(figures.svg(drawing), encoding="utf-8")
