"""Measured values beside published ones, and statements of a text as numbers."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import math
import pathlib

from .errors import StudyError, suggestion
from .units import factor


@dataclasses.dataclass(frozen=True)
class Measure:
    """A number that a study's runs gave. None with a reason: this profile does not make the run that would give it."""

    value: float | None
    unit: str
    deviation: float | None = None
    reason: str = ""


@dataclasses.dataclass(frozen=True)
class Statement:
    """What was published of a measure, and how near it has to be.

    published, tolerance: as written in expected.tsv, in `unit`. relation: one of RELATIONS.
    """

    name: str
    relation: str
    published: str
    tolerance: str
    unit: str
    source: str
    description: str

    def __post_init__(self):
        if self.relation not in RELATIONS:
            raise StudyError(f"{self.name}: '{self.relation}' is not a known relation{suggestion(self.relation, RELATIONS)}")
        _number(self.name, "published value", self.published)
        if (self.relation == "within") != bool(self.tolerance):
            raise StudyError(f"{self.name}: a tolerance belongs to the relation within, and to no other")
        if self.tolerance and not _number(self.name, "tolerance", self.tolerance) > 0:
            raise StudyError(f"{self.name}: the tolerance {self.tolerance} must be above 0")


@dataclasses.dataclass(frozen=True)
class Verdict:
    """One row of a comparison, as a page shows it. met: whether the relation holds."""

    statement: Statement
    measured: str
    difference: str
    met: bool

    @property
    def published(self):
        """The published value with its relation, as in "at most 6"."""
        s = self.statement
        return s.published if s.relation == "within" else f"{s.relation} {s.published}"

    @property
    def tolerance(self):
        """The tolerance as in "± 0.1"; empty for bounds."""
        return f"± {self.statement.tolerance}" if self.statement.tolerance else ""


# Whether a measured value, less the published one, is near enough.
RELATIONS = {
    "within": lambda difference, tolerance: abs(difference) <= tolerance,
    "at most": lambda difference, _: difference <= 0,
    "at least": lambda difference, _: difference >= 0,
}
_COLUMNS = ["name", "relation", "published", "tolerance", "unit", "source", "description"]


def _number(name, what, text):
    try:
        value = float(text)
    except ValueError:
        value = math.nan
    if not math.isfinite(value):
        raise StudyError(f"{name}: the {what} '{text}' is no number")
    return value


def read_statements(path):
    """Reads expected.tsv, whose columns are those of Statement. Raises StudyError naming file and line."""
    statements, header = [], None
    for number, line in enumerate(pathlib.Path(path).read_text(encoding="utf-8").splitlines(), start=1):
        if not line.strip() or line.startswith("#"):
            continue
        cells = line.split("\t")
        if header is None:
            header = cells
            for name in _COLUMNS:
                if name not in header:
                    raise StudyError(f"{path}: line {number}: has no column {name}{suggestion(name, header)}")
            continue
        if len(cells) != len(header):
            raise StudyError(f"{path}: line {number}: {len(cells)} cells where the header has {len(header)}")
        row = dict(zip(header, cells, strict=True))
        try:
            statement = Statement(**{name: row[name] for name in _COLUMNS})
        except StudyError as error:
            raise StudyError(f"{path}: line {number}: {error}") from error
        if any(s.name == statement.name and s.relation == statement.relation for s in statements):
            raise StudyError(f"{path}: line {number}: {statement.name} is stated twice")
        statements.append(statement)
    if header is None:
        raise StudyError(f"{path}: holds no statements")
    return statements


def compare(statements, measures):
    """Returns a Verdict for each statement whose measure this profile makes, in their order.

    measures: Measure by name. Raises StudyError for a statement without a measure, a NaN, a unit that does not fit.
    """
    verdicts = []
    for s in statements:
        if s.name not in measures:
            raise StudyError(f"{s.name}: is stated but not measured{suggestion(s.name, measures)}")
        measure = measures[s.name]
        if measure.value is None:
            continue
        if not math.isfinite(measure.value):
            raise StudyError(f"{s.name}: the measured value is {measure.value}, not a number")
        try:
            scale = factor(measure.unit, s.unit)
        except StudyError as error:
            raise StudyError(f"{s.name}: {error}") from error
        value, published = scale * measure.value, float(s.published)
        difference = value - published
        met = RELATIONS[s.relation](difference, float(s.tolerance or 0))
        deviation = "" if measure.deviation is None else f" ± {scale * measure.deviation:.2g}"
        relative = f" ({100 * difference / published:+.1f} %)" if s.relation == "within" and published != 0 else ""
        verdicts.append(Verdict(s, f"{value:.4g}{deviation}", f"{difference:+.3g}{relative}", bool(met)))
    return verdicts
