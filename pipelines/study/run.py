"""The study that a study.py builds, and its files: measured.tsv, comparison.tsv, figures, page.html, card.json."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import dataclasses
import json
import pathlib
import re
import sys

from markupsafe import Markup

from . import curves, figures, pages
from .comparison import Measure, Statement, compare, read_statements
from .errors import NotMade, StudyError, suggestion
from .files import put
from .kept import read_kept
from .tables import write_table
from .texts import Texts
from .words import quantity, spell

FIRST_SCREEN = 100  # most words of lead and headline together; the score below them varies in length


@dataclasses.dataclass
class Group:
    """Statements that a page shows in one table, and the note below it. judged: whether this run has the size for them."""

    heading: str
    judged: bool
    statements: list = dataclasses.field(default_factory=list)
    note: str = ""
    table: str = "comparison"


@dataclasses.dataclass(frozen=True)
class Shown:
    """A figure on the page: its panels as markup, the sentence beneath, and the claim it supports. width: in points."""

    panes: list
    width: float
    sentence: str
    number: str
    claim: str
    measures: tuple


@dataclasses.dataclass(frozen=True)
class Score:
    """Agreement of a study: in words, and as a share of the judged statements. total: 0 if nothing is judged."""

    text: str
    met: int
    total: int

    def __str__(self):
        return self.text


@dataclasses.dataclass(frozen=True)
class Row:
    """A statement with what this run and the kept one measured; either may be missing. reason: why it is not met."""

    statement: Statement
    run: object
    kept: object
    reason: str
    judged: bool

    @property
    def verdict(self):
        """The Verdict that counts: of this run where it is judged, else of the kept one; None without."""
        return self.run if self.judged else self.kept


class Study:
    """The measures, statements and figures of a study, in the order of its chapter.

    name: its folder in pipelines/. judged: whether this run has the full size, for which published values hold. The page of a smaller
    run shows published values beside its own and those of a kept full-size run, and judges the kept run alone.
    lead: what was done. headline: what came out, in one sentence with numbers from say(). Both are text or markup
    (markupsafe.Markup), together not longer than FIRST_SCREEN. history: the provenance of a file of the study.
    digits: significant digits of measures, to which they are rounded before they are compared; measured.tsv has six, None keeps all.
    """

    def __init__(self, name, title, out, profile, judged=True, digits=6):
        self.name, self.title, self.out, self.profile, self.judged = name, title, pathlib.Path(out), profile, judged
        self.digits = digits
        self.lead, self.headline, self.history, self.remarks, self.reports, self.appendices = "", "", "", [], [], []
        self.measures, self.groups, self.checks = {}, [Group("Measured and published values", judged)], []
        self._figures, self._drawings, self._kept, self._reasons = {}, {}, [], {}
        self._texts, self._folder, self._values, self.pageless = None, None, {}, False
        self.first_screen = FIRST_SCREEN

    @classmethod
    def of(cls, folder, arguments, judged=True, digits=6):
        """Begins the study of a folder pipelines/NAME with its words.toml, its statements and the values kept at full size.

        judged: as in Study. Statements stand in expected.tsv and statements.tsv, bounds that any run has to keep in checks.tsv, kept
        values in kept/; each may be missing. With arguments.kept the study has tables and figures, but no page.
        """
        folder = pathlib.Path(folder)
        texts = Texts(folder / "words.toml")
        profile = "thesis" if arguments.kept else arguments.profile
        study = cls(folder.name, texts.title, arguments.out, profile, judged or arguments.kept, digits)
        study._texts, study._folder, study.pageless = texts, folder, arguments.kept
        for name, how in (("expected", texts.expected), ("statements", texts.statements)):
            if (folder / f"{name}.tsv").exists():
                study.expect(folder / f"{name}.tsv", **how)
        if (folder / "checks.tsv").exists():
            study.checks += read_statements(folder / "checks.tsv")
        for table in dict.fromkeys(group.table for group in study.groups):
            if not study.judged and (folder / "kept" / f"{table}.tsv").exists():
                study.kept(folder / "kept" / f"{table}.tsv")
        return study

    def tell(self, **values):
        """Takes the texts of the page from words.toml: lead, headline, remarks, reasons, appendix, and captions of figures that follow.

        values: names that the texts may use, beside say(), published(), `profile`, `judged`, and `kept`. `kept` is an argument for say(): it
        is true if this run is not judged, and say() then gives the kept run's numbers.
        """
        self._values = {"say": self.say, "published": self.published, "kept": not self.judged, "judged": self.judged, "profile": self.profile,
                        **values}
        texts = self._texts
        self.lead, self.headline = self._fill(texts.lead), self._fill(texts.headline)
        self.remarks += [text for text in map(self._fill, texts.remarks) if text]
        for entry in texts.reasons:
            for name in entry["of"]:
                self.reason(name, self._fill(entry["why"]))
        for entry in texts.appendices:
            tables = [item for name in entry.get("tables", ()) for item in self._tables(name)]
            self.appendix(entry["heading"], self._fill(entry["text"]), *tables)

    def _tables(self, name):
        """Returns the table that the study gave this name, or else the kept tables kept/NAME_thesis.tsv and kept/NAME_quick.tsv that exist."""
        if name in self._values:
            return [self._values[name]]
        there = [(size, self._folder / "kept" / f"{name}_{size}.tsv") for size in ("thesis", "quick")]
        caption, names = self._texts.table(name)
        there = [(f"{caption}, {'full size' if size == 'thesis' else 'quick profile'}:", pages.table(path, names))
                 for size, path in there if path.exists()]
        if not there:
            raise StudyError(f"{self._folder / 'words.toml'}: there is no kept table {name}")
        return [item for pair in there for item in pair]

    def _fill(self, text):
        return self._texts.fill(text, self._values)

    def _caption(self, name, sentence, number, claim, measures):
        """Returns the given caption of a figure or, without a sentence, the caption in words.toml."""
        if sentence or self._texts is None:
            return sentence, number, claim, measures
        if not self._values:
            raise StudyError(f"{name}: is drawn before the page was told its numbers; call study.tell() first")
        said = self._texts.figure(name)
        return *(self._fill(said.get(key, "")) for key in ("sentence", "number", "claim")), [self._fill(name) for name in said.get("measures", ())]

    def measure_each(self, rows, of, ending=""):
        """Adds a measure name + ending for each (name, unit, value) row: value(*of()). Both functions may raise NotMade."""
        for name, unit, value in rows:
            self.measure(name + ending, lambda value=value: value(*of()), unit)

    def measure(self, name, value, unit, deviation=None):
        """Adds a measure: a number in a unit, and its standard deviation over packings where there are several.

        value: the number, a pair of it and its deviation, or a function that returns either or raises NotMade with the reason
        why this profile has none.
        """
        if name in self.measures:
            raise StudyError(f"{name}: is measured twice")
        if callable(value):
            try:
                value = value()
            except NotMade as reason:
                self.unmade(name, unit, str(reason))
                return
        value, deviation = value if isinstance(value, tuple) else (value, deviation)
        kept = float(value) if self.digits is None else float(f"{value:.{self.digits}g}")
        self.measures[name] = Measure(kept, unit, None if deviation is None else float(deviation))

    def unmade(self, name, unit, reason):
        """Notes that this profile does not make the runs for the measure, and why."""
        if name in self.measures:
            raise StudyError(f"{name}: is measured twice")
        self.measures[name] = Measure(None, unit, reason=reason)

    def state(self, name, relation, published, unit, source, description, tolerance=""):
        """Adds a published value or a statement of the thesis as a number; expect() reads a whole table of them."""
        self.groups[0].statements.append(Statement(name, relation, str(published), str(tolerance), unit, source, description))

    def expect(self, path, heading="", note="", table="comparison", judged=None):
        """Adds the statements of a table like expected.tsv, under a heading of their own where one is given.

        note: what the page says below the table. table: name of the file, less .tsv, that they are written to with what was
        measured; without a heading it is comparison. judged: whether this run has the size for these statements,
        by default as the study. If it is False, values of a kept full-size run are read from kept/.
        """
        group = Group(heading, self.judged if judged is None else judged) if heading else self.groups[0]
        if heading:
            group.table = table
            self.groups.append(group)
        group.statements += read_statements(path)
        group.note = note
        if judged is False and (pathlib.Path(path).parent / "kept" / f"{table}.tsv").exists():
            self.kept(pathlib.Path(path).parent / "kept" / f"{table}.tsv")

    def accept(self, name, relation, bound, unit, description, tolerance=""):
        """Adds a bound that a run of any size has to keep: it says whether the chain of tools works, not whether it agrees."""
        self.checks.append(Statement(name, relation, str(bound), str(tolerance), unit, "this study", description))

    def reason(self, name, text):
        """Notes why a statement on this measure is not met; its row shows the reason if it is not."""
        self._reasons[name] = text

    def kept(self, path):
        """Reads what a run at full size measured: its comparison.tsv. Its statements have to be added before."""
        pairs = read_kept(path, [s for group in self.groups for s in group.statements])
        self._kept += pairs

    def say(self, name, digits=3, unit=None, deviation=False, kept=False):
        """Returns a measure as text for a sentence, such as "585 kPa", to so many significant digits.

        unit: converts to this unit. deviation: adds the standard deviation. kept: takes the kept run's value, with its digits.
        """
        if kept:
            verdict = next((v for s, v in self._kept if s.name == name), None)
            if verdict is None:
                raise StudyError(f"{name}: no kept run has it{suggestion(name, [s.name for s, _ in self._kept] or ['nothing'])}")
            return quantity(verdict.measured.replace("-", "−"), verdict.statement.unit)
        measure = self.measures.get(name)
        if measure is None:
            raise StudyError(f"{name}: is said but not measured{suggestion(name, self.measures)}")
        value, spread = measure.within(name, unit or measure.unit)
        text = spell(value, digits)
        if deviation and spread is not None:
            text += f" ± {spell(spread, 2)}"
        return quantity(text, unit or measure.unit)

    def published(self, name):
        """Returns the published value of a statement as text for a sentence: with its unit and the digits of its table."""
        stated = [s for group in self.groups for s in group.statements]
        found = next((s for s in stated if s.name == name), None)
        if found is None:
            raise StudyError(f"{name}: is not stated{suggestion(name, [s.name for s in stated])}")
        return quantity(found.published.replace("-", "−"), found.unit)

    def remark(self, text):
        """Adds a paragraph below the figures, as a caveat."""
        self.remarks.append(text)

    def text(self, heading, path):
        """Adds a report that a tool printed, folded, as it stands."""
        self.reports.append((heading, pages.content(pathlib.Path(path))))

    def appendix(self, heading, *items):
        """Adds a folded part at the end: text, markup, tables (paths of .tsv, or columns by name), reports (other paths).

        Experiments on causes belong here.
        """
        self.appendices.append((heading, [pages.content(item) for item in items]))

    def curves(self, name, *panels, sentence="", **layout):
        """Adds a figure of panels (study.curves.panel); sentence: as of figure(). layout: columns, width, height."""
        self.figure(name, curves.figure(panels, **layout), sentence)

    def figure(self, name, figure, sentence="", number="", claim="", measures=()):
        """Adds a figure drawn with study.figures; the first one opens the page and is on the study's card.

        sentence: beneath it. number: of the thesis's figure, as in "Fig. 3.8". claim: the thesis's sentence that it supports
        or not. measures: names of the statements whose verdicts are shown with it. Without a sentence, words.toml has all four.
        """
        if not self.pageless:
            sentence, number, claim, measures = self._caption(name, sentence, number, claim, measures)
            words, width = re.sub(r"<[^>]*>", "", str(sentence)), 72 * figure.get_figwidth()
            panes = [pages.pane(svg, f"{self.name}_{name}_{k}", words) for k, svg in enumerate(figures.panes(figure))]
            self._figures[name] = Shown(panes, width, sentence, number, claim, tuple(measures))
        self._drawings[name] = figures.svg(figure)

    def picture(self, path, sentence="", number="", claim="", measures=(), name=""):
        """Adds a picture, a .png or .jpg, as figure() adds a drawing. name: its name in words.toml."""
        if self.pageless:
            return
        sentence, number, claim, measures = self._caption(name, sentence, number, claim, measures)
        image = pages.picture(path, re.sub(r"<[^>]*>", "", str(sentence)))
        self._figures[name or str(path)] = Shown([image], 648, sentence, number, claim, tuple(measures))

    def rows(self):
        """Returns (group, Row list) pairs: each statement that this run or the kept one measured, beside its value."""
        stated = [s.name for group in self.groups for s in group.statements]
        for name in [*self._reasons, *(m for shown in self._figures.values() for m in shown.measures)]:
            if name not in stated:
                raise StudyError(f"{name}: is not stated{suggestion(name, stated)}")
        groups = []
        for group in self.groups:
            run = {id(v.statement): v for v in compare(group.statements, self.measures)}
            kept = {id(s): v for s, v in self._kept}
            rows = [Row(s, run.get(id(s)), kept.get(id(s)), self._reasons.get(s.name, ""), group.judged) for s in group.statements]
            rows = [r for r in rows if r.run or r.kept]
            if rows:
                groups.append((group, rows))
        return groups

    def score(self, groups):
        """Returns the Score of this run, or of the kept run if this one is not judged."""
        parts, met, total = self._tally([pair for pair in groups if pair[0].judged])
        coarse = [pair for pair in groups if not pair[0].judged]
        if self.judged and not coarse:
            return Score(", ".join(parts), met, total)
        at_full_size, of_these, of_all = self._tally(coarse)
        sentences = [", ".join(parts)] if parts else []
        sentences.append(", ".join(at_full_size) + " at full size" if at_full_size else "No full-size run is kept")
        unjudged = sum(len(rows) for _, rows in coarse)
        counted = f"One value of this {self.profile} run is" if unjudged == 1 else f"{unjudged} values of this {self.profile} run are"
        of_run = counted if parts else f"This {self.profile} run is"
        sentences.append(f"{of_run} not judged")
        checks = compare(self.checks, self.measures)
        failed = [v.statement.description for v in checks if not v.met]
        if failed:
            sentences.append(f"The run fails checks of the tools: {', '.join(failed)}")
        elif checks:
            sentences.append(f"The run passes {f'all {len(checks)} checks' if len(checks) > 1 else 'the check'} of the tools")
        return Score(". ".join(sentences) + ".", met + of_these, total + of_all)

    def _tally(self, groups):
        """Returns, for some groups, how many values and statements are met in words, then the number of met ones and of all."""
        parts, met, total = [], 0, 0
        for values, words in ((True, "published values within tolerance"), (False, "statements met")):
            verdicts = [r.verdict for group, rows in groups if (group is self.groups[0]) == values for r in rows if r.verdict]
            if verdicts:
                parts.append(f"{sum(v.met for v in verdicts)} of {len(verdicts)} {words}")
                met, total = met + sum(v.met for v in verdicts), total + len(verdicts)
        return parts, met, total

    def write(self):
        """Writes all files of the study into its folder. Each file appears whole."""
        groups = self.rows()
        score = self.score(groups)
        self._check_first_screen()
        self.write_tables()
        rows = [row for _, some in groups for row in some]
        shown = self._shown()
        markup = pages.render("chapter.html", study=self, groups=groups, figures=shown, score=score,
                              checks=compare(self.checks, self.measures),
                              rows={name: [r for r in rows if r.statement.name == name] for f in shown for name in f.measures})
        put(self.out / "page.html", pages.render("page.html", title=self.title, body=markup))
        opening = "".join(shown[0].panes).replace(f'"{self.name}_', f'"card_{self.name}_').replace(f"#{self.name}_", f"#card_{self.name}_")
        put(self.out / "card.json", json.dumps({
            "title": self.title, "headline": str(Markup.escape(self.headline)), "score": dataclasses.asdict(score), "figure": opening,
            "width": shown[0].width},
            ensure_ascii=False, indent=1) + "\n")
        print(f"{self.name}: {f'{score} (' if str(score) else '('}{self.out}/page.html)")

    def _shown(self):
        """Returns the figures in the order of words.toml, then all others in the order in which they were added."""
        order = list(self._texts.figures if self._texts else ())
        return [self._figures[name] for name in sorted(self._figures, key=lambda name: order.index(name) if name in order else len(order))]

    def _check_first_screen(self):
        if not (self.lead and self.headline and self._figures):
            raise StudyError(f"{self.name}: a page opens with a lead, a headline and a figure; set study.lead and study.headline")
        words = len(re.sub(r"<[^>]*>", " ", f"{self.lead} {self.headline}").split())
        if words > self.first_screen:
            raise StudyError(f"{self.name}: lead and headline have {words} words; {self.first_screen} are what a first screen holds")

    def write_tables(self):
        """Writes the measurements, the published values beside them, and the figures: all files except the page."""
        for name, svg in self._drawings.items():
            put(self.out / f"{name}.svg", svg)
        made = {name: m for name, m in self.measures.items() if m.value is not None}
        put(self.out / "measured.tsv", write_table({
            "name": list(made), "value": [m.value for m in made.values()], "unit": [m.unit for m in made.values()],
            "deviation": [m.deviation for m in made.values()]}))
        groups = self.rows()
        for table in dict.fromkeys(group.table for group, _ in groups) or ["comparison"]:
            self._write_comparison(table, [r for group, rows in groups for r in rows if r.run and group.table == table])

    def _write_comparison(self, table, rows):
        """Writes what this run measured into a table of that name."""
        verdicts, stated = [r.run for r in rows], [r.statement for r in rows]
        put(self.out / f"{table}.tsv", write_table({
            "description": [s.description for s in stated], "unit": [s.unit for s in stated],
            "published": [s.bound for s in stated], "tolerance": [s.margin for s in stated],
            "measured": [v.measured for v in verdicts], "difference": [v.difference for v in verdicts],
            "verdict": [("met" if r.run.met else "not met") if r.judged else "not judged" for r in rows],
            "source": [s.source for s in stated]}))


def main(build, **options):
    """Runs a study.py: build(study arguments) returns the Study that is then written. Errors are one line, status 65.

    options: arguments of this study alone, by name, each with the keywords for argparse, as in cases={"nargs": "+"}.
    """
    parser = argparse.ArgumentParser(description=build.__doc__)
    parser.add_argument("out", help="folder of the study's results, out/NAME")
    parser.add_argument("--profile", choices=["quick", "thesis"], default="quick")
    parser.add_argument("--seeds", nargs="+", type=int, default=[1], help="seeds of the packings")
    parser.add_argument("--kept", action="store_true", help="compare and draw what is kept in OUT of runs at full size, without a page")
    for name, how in options.items():
        parser.add_argument(f"--{name}", **how)
    arguments = parser.parse_args()
    try:
        if arguments.kept and not pathlib.Path(arguments.out).is_dir():
            name = pathlib.Path(arguments.out).parent.name
            raise StudyError(f"{arguments.out}: nothing is kept of {name} yet; make PROFILE=thesis {name}, then {name}-keep")
        study = build(arguments)
        if arguments.kept:
            study.write_tables()
        else:
            study.write()
    except (StudyError, OSError) as error:
        print(f"study: {error}", file=sys.stderr)
        sys.exit(65)
