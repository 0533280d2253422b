"""words.toml of a study: all texts of its page, with numbers filled in from the run, and captions of figures."""
# SPDX-License-Identifier: GPL-3.0-or-later
import tomllib

import jinja2

from .errors import StudyError, suggestion

# Keys of words.toml itself, of each of its tables, and those that a table needs.
_KEYS = ("title", "lead", "headline", "remarks", "expected", "statements", "reason", "figure", "appendix")
_OF = {"figure": ("sentence", "number", "claim", "measures"), "statements": ("heading", "note", "table"), "expected": ("note",),
       "reason": ("of", "why"), "appendix": ("heading", "text", "tables")}
_NEEDED = {"figure": ("sentence",), "reason": ("of", "why"), "appendix": ("heading", "text")}
_LISTS = ("remarks", "measures", "of", "tables")  # the others are texts
_ENVIRONMENT = jinja2.Environment(undefined=jinja2.StrictUndefined)


class Texts:
    """The texts of a study. Each may hold placeholders such as {{ say("name") }}, which fill() replaces by numbers."""

    def __init__(self, path):
        """Raises StudyError, with file and key, for an unknown or missing key and for a value of the wrong type."""
        self.path = path
        try:
            with open(path, "rb") as file:
                given = tomllib.load(file)
        except OSError as error:
            raise StudyError(f"{path}: cannot be read: {error.strerror}") from error
        except tomllib.TOMLDecodeError as error:
            raise StudyError(f"{path}: {error}") from error
        self._known({key: text for key, text in given.items() if key not in _OF}, _KEYS, "")
        for kind, keys in _OF.items():
            entries = given.get(kind, {} if kind == "figure" else [])
            if kind == "figure" and not isinstance(entries, dict):
                raise StudyError(f"{path}: figure is {entries!r} where tables like [figure.load] belong")
            named = entries.items() if kind == "figure" else ((kind, entry) for entry in (entries if isinstance(entries, list) else [entries]))
            for where, entry in named:
                self._known(entry, keys, f"{where}: ", _NEEDED.get(kind, ()))
        self.title, self.lead, self.headline = (given.get(key, "") for key in ("title", "lead", "headline"))
        self.remarks, self.reasons = given.get("remarks", []), given.get("reason", [])
        self.expected, self.statements = given.get("expected", {}), given.get("statements", {})
        self.figures, self.appendices = given.get("figure", {}), given.get("appendix", [])

    def _known(self, given, keys, where, needed=()):
        if not isinstance(given, dict):
            raise StudyError(f"{self.path}: {where}is {given!r} where a table belongs")
        for key, text in given.items():
            if key not in keys:
                raise StudyError(f"{self.path}: {where}'{key}' is nothing that a page says{suggestion(key, keys)}")
            words = text if key in _LISTS and isinstance(text, list) else None if key in _LISTS else [text]
            if words is None or not all(isinstance(word, str) for word in words):
                raise StudyError(f"{self.path}: {where}{key} is {text!r} where {'a list of texts' if key in _LISTS else 'a text'} belongs")
        for key in needed:
            if key not in given:
                raise StudyError(f"{self.path}: {where}has no {key}")

    def figure(self, name):
        """Returns the table of a figure. Raises StudyError if there is none."""
        if name not in self.figures:
            raise StudyError(f"{self.path}: has no figure.{name}{suggestion(name, self.figures)}")
        return self.figures[name]

    def fill(self, text, values):
        """Returns a text with values in it. Raises StudyError for a name that has none."""
        try:
            return _ENVIRONMENT.from_string(text).render(values).strip()
        except jinja2.TemplateError as error:
            raise StudyError(f"{self.path}: {error}, in \"{text.strip()[:60]}\"") from error
