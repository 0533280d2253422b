"""Measured values beside published ones, and statements of a text as numbers."""
# SPDX-License-Identifier: GPL-3.0-or-later
import dataclasses
import math

from .errors import StudyError, suggestion
from .plain_text import number
from .tables import read_words
from .units import factor


@dataclasses.dataclass(frozen=True)
class Measure:
    """A number that a study's runs gave. None with a reason: this profile does not make the run that would give it."""

    value: float | None
    unit: str
    deviation: float | None = None
    reason: str = ""

    def within(self, name, unit):
        """Returns value and deviation in another unit. name: for the StudyError where there is no number or no such unit."""
        if self.value is None:
            raise StudyError(f"{name}: has no value in this profile: {self.reason}")
        if not math.isfinite(self.value):
            raise StudyError(f"{name}: the measured value is {self.value}, not a number")
        try:
            scale = factor(self.unit, unit)
        except StudyError as error:
            raise StudyError(f"{name}: {error}") from error
        return scale * self.value, None if self.deviation is None else scale * self.deviation


@dataclasses.dataclass(frozen=True)
class Statement:
    """A published value of a measure, and how near the measure has to be.

    published, tolerance: as written in expected.tsv, in `unit`. relation: one of RELATIONS.
    """

    name: str
    relation: str
    published: str
    tolerance: str
    unit: str
    source: str
    description: str

    @property
    def bound(self):
        """The published value with its relation, as in "at most 6"."""
        return self.published if self.relation == "within" else f"{self.relation} {self.published}"

    @property
    def margin(self):
        """The tolerance as in "± 0.1"; empty for bounds."""
        return f"± {self.tolerance}" if self.tolerance else ""

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


# Tests of the difference, measured less published, by relation.
RELATIONS = {
    "within": lambda difference, tolerance: abs(difference) <= tolerance,
    "at most": lambda difference, _: difference <= 0,
    "at least": lambda difference, _: difference >= 0,
}
_COLUMNS = ["name", "relation", "published", "tolerance", "unit", "source", "description"]


def _number(name, what, text):
    try:
        value = number(text)
    except StudyError as error:
        raise StudyError(f"{name}: the {what} {error}") from error
    if not math.isfinite(value):
        raise StudyError(f"{name}: the {what} '{text}' is no number")
    return value


def read_statements(path):
    """Reads expected.tsv, whose columns are those of Statement. Raises StudyError naming file and line."""
    statements = []
    for number, row in read_words(path, _COLUMNS)[1]:
        try:
            statement = Statement(**{name: row[name] for name in _COLUMNS})
        except StudyError as error:
            raise StudyError(f"{path}: line {number}: {error}") from error
        if any(s.name == statement.name and s.relation == statement.relation for s in statements):
            raise StudyError(f"{path}: line {number}: {statement.name} is stated twice")
        statements.append(statement)
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
        (value, spread), published = measure.within(s.name, s.unit), float(s.published)
        difference = value - published
        met = RELATIONS[s.relation](difference, float(s.tolerance or 0))
        if abs(difference) < 1e-9 * abs(published):  # rounding, which would be printed as a difference of -1.8e-15
            difference = 0.0
        deviation = "" if spread is None else f" ± {spread:.2g}"
        relative = f" ({100 * difference / published:+.1f} %)" if s.relation == "within" and published != 0 else ""
        verdicts.append(Verdict(s, f"{value:.4g}{deviation}", f"{difference:+.3g}{relative}", bool(met)))
    return verdicts
