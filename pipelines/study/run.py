"""What a study.py builds up, and how its files are written: measured.tsv, comparison.tsv, figures, page.html."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import dataclasses
import os
import pathlib
import sys

import markupsafe

from . import figures, pages
from .compare import Measure, Statement, compare, read_statements
from .errors import NotMade, StudyError
from .tables import write_table


@dataclasses.dataclass
class Group:
    """Statements that a page shows in one table, and what it says below it."""

    heading: str
    statements: list = dataclasses.field(default_factory=list)
    note: str = ""


class Study:
    """The measures, statements and figures of a study, in the order of its chapter.

    name: of its folder in pipelines/. title, lead: what the page opens with; the lead says what was done, in a few
    sentences of plain text or markup (markupsafe.Markup). seeds, out, profile: of this run of the study.
    """

    def __init__(self, name, title, out, profile):
        self.name, self.title, self.out, self.profile = name, title, pathlib.Path(out), profile
        self.lead, self.history, self.texts = "", "", []
        self.measures, self.groups, self._figures = {}, [Group("Measured beside published")], []

    def measure(self, name, value, unit, deviation=None):
        """Adds a measure: a number in a unit, and its standard deviation over packings where there are several.

        value: the number, or a function that returns it or raises NotMade with the reason why this profile has none. It is
        kept to the six digits of measured.tsv, so that a comparison is of the number that readers see.
        """
        if name in self.measures:
            raise StudyError(f"{name}: is measured twice")
        if callable(value):
            try:
                value = value()
            except NotMade as reason:
                self.unmade(name, unit, str(reason))
                return
        self.measures[name] = Measure(float(f"{value:.6g}"), unit, None if deviation is None else float(deviation))

    def unmade(self, name, unit, reason):
        """Says that this profile does not make the runs that would give the measure, and why."""
        self.measures[name] = Measure(None, unit, reason=reason)

    def state(self, name, relation, published, unit, source, description, tolerance=""):
        """Adds a published value or a statement of the thesis as a number; expect() reads a whole table of them."""
        self.groups[0].statements.append(Statement(name, relation, str(published), str(tolerance), unit, source, description))

    def expect(self, path, heading="", note=""):
        """Adds the statements of a table like expected.tsv, under a heading of their own where one is given.

        note: what the page says below the table, such as why something is not met.
        """
        group = Group(heading) if heading else self.groups[0]
        if heading:
            self.groups.append(group)
        group.statements += read_statements(path)
        group.note = note

    def text(self, heading, path):
        """Adds a report that a tool printed, folded, as it stands."""
        self.texts.append((heading, pathlib.Path(path).read_text(encoding="utf-8")))

    def figure(self, name, figure, sentence):
        """Adds a figure, drawn with study.figures, and the sentence beneath it."""
        self._figures.append((name, figures.svg(figure), sentence))

    def verdicts(self):
        """Each statement beside what was measured, group by group."""
        return [(group, compare(group.statements, self.measures)) for group in self.groups if group.statements]

    def write(self):
        """Writes all files of the study into its folder, each at once whole."""
        groups = self.verdicts()
        verdicts = [verdict for _, some in groups for verdict in some]
        made = {name: m for name, m in self.measures.items() if m.value is not None}
        _put(self.out / "measured.tsv", write_table({
            "name": list(made), "value": [m.value for m in made.values()], "unit": [m.unit for m in made.values()],
            "deviation": [m.deviation for m in made.values()]}))
        _put(self.out / "comparison.tsv", write_table({
            "description": [v.statement.description for v in verdicts], "unit": [v.statement.unit for v in verdicts],
            "published": [v.published for v in verdicts], "tolerance": [v.tolerance for v in verdicts],
            "measured": [v.measured for v in verdicts], "difference": [v.difference for v in verdicts],
            "verdict": ["met" if v.met else "not met" for v in verdicts],
            "source": [v.statement.source for v in verdicts]}))
        shown = []
        for name, svg, sentence in self._figures:
            _put(self.out / f"{name}.svg", svg)
            shown.append({"svg": markupsafe.Markup(pages.inline(svg, f"{self.name}_{name}")), "sentence": sentence})
        _put(self.out / "page.html", pages.render("chapter.html", study=self, groups=groups, figures=shown))
        met = sum(v.met for v in verdicts)
        print(f"{self.name}: {met} published values met, {len(verdicts) - met} not met (make report)")


def _put(path, text):
    """Writes a file under a temporary name and renames it, so that make never meets half of it."""
    temporary = path.with_name(f"{path.name}.{os.getpid()}")
    temporary.write_text(text, encoding="utf-8")
    temporary.replace(path)


def main(build):
    """Runs a study.py: build(study arguments) returns the Study that is then written. Errors are one line, status 65."""
    parser = argparse.ArgumentParser(description=build.__doc__)
    parser.add_argument("out", help="folder of the study's results, out/NAME")
    parser.add_argument("--profile", choices=["quick", "thesis"], default="quick")
    parser.add_argument("--seeds", nargs="+", type=int, default=[1], help="seeds of the packings")
    arguments = parser.parse_args()
    try:
        build(arguments).write()
    except (StudyError, OSError) as error:
        print(f"study: {error}", file=sys.stderr)
        sys.exit(65)
