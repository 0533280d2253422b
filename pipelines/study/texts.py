"""words.toml of a study: all texts of its page, with numbers filled in from the run, and captions of figures."""
# SPDX-License-Identifier: GPL-3.0-or-later
import tomllib

import jinja2

from .errors import StudyError, suggestion

# Keys of words.toml itself, of each of its tables, and those that a table needs.
_KEYS = ("title", "lead", "headline", "remarks", "names")
_OF = {"figure": ("sentence", "number", "claim", "measures"), "statements": ("heading", "note", "table"), "expected": ("note",),
       "reason": ("of", "why"), "appendix": ("heading", "text", "tables"), "table": ("caption", "names")}
_NEEDED = {"figure": ("sentence",), "reason": ("of", "why"), "appendix": ("heading", "text")}
_BY_NAME = ("figure", "table")  # tables like [figure.load]; the others of _OF are [expected] or [[reason]]
_LISTS = ("remarks", "measures", "of", "tables")
_MAPS = ("names",)  # texts by name; what is neither a list nor a map is a text
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
        self._known({key: text for key, text in given.items() if key not in _OF}, (*_KEYS, *_OF), "")
        for kind, keys in _OF.items():
            entries = given.get(kind, {} if kind in _BY_NAME else [])
            if kind in _BY_NAME and not isinstance(entries, dict):
                raise StudyError(f"{path}: {kind} is {entries!r} where tables like [{kind}.load] belong")
            named = entries.items() if kind in _BY_NAME else ((kind, entry) for entry in (entries if isinstance(entries, list) else [entries]))
            for where, entry in named:
                self._known(entry, keys, f"{where}: ", _NEEDED.get(kind, ()))
        self.title, self.lead, self.headline = (given.get(key, "") for key in ("title", "lead", "headline"))
        self.remarks, self.reasons = given.get("remarks", []), given.get("reason", [])
        self.expected, self.statements = given.get("expected", {}), given.get("statements", {})
        self.figures, self.appendices = given.get("figure", {}), given.get("appendix", [])
        self._names, self._tables = given.get("names", {}), given.get("table", {})

    def _known(self, given, keys, where, needed=()):
        if not isinstance(given, dict):
            raise StudyError(f"{self.path}: {where}is {given!r} where a table belongs")
        for key, text in given.items():
            if key not in keys:
                raise StudyError(f"{self.path}: {where}'{key}' is nothing that a page says{suggestion(key, keys)}")
            kind, what = (list, "a list of texts") if key in _LISTS else (dict, "a table of texts") if key in _MAPS else (str, "a text")
            words = text.values() if isinstance(text, dict) else text if isinstance(text, list) else [text]
            if not isinstance(text, kind) or not all(isinstance(word, str) for word in words):
                raise StudyError(f"{self.path}: {where}{key} is {text!r} where {what} belongs")
        for key in needed:
            if key not in given:
                raise StudyError(f"{self.path}: {where}has no {key}")

    def figure(self, name):
        """Returns the table of a figure. Raises StudyError if there is none."""
        if name not in self.figures:
            raise StudyError(f"{self.path}: has no figure.{name}{suggestion(name, self.figures)}")
        return self.figures[name]

    def table(self, name):
        """Returns the caption of a kept table, and the words that the page shows for names in it, by name."""
        of_table = self._tables.get(name, {})
        return of_table.get("caption", name.replace("_", " ").capitalize()), self._names | of_table.get("names", {})

    def fill(self, text, values):
        """Returns a text with values in it. Raises StudyError for a name that has none."""
        try:
            return _ENVIRONMENT.from_string(text).render(values).strip()
        except jinja2.TemplateError as error:
            raise StudyError(f"{self.path}: {error}, in \"{text.strip()[:60]}\"") from error
