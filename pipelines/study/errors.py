"""The one error of the studies, the nearest known name for its messages, and what is no error: a number that is not made."""
# SPDX-License-Identifier: GPL-3.0-or-later
import difflib


class StudyError(Exception):
    """One line for the reader: which file, what is wrong, what would mend it."""


class NotMade(Exception):
    """Raised where this profile has no number for a measure, with the reason in a few words; Study.measure() keeps it."""


def suggestion(name, known):
    """Returns "; did you mean 'x'?" for the nearest of the known names, or all of them where none is near."""
    known = [str(k) for k in known]
    near = [k for k in known if k.casefold() == str(name).casefold()] or difflib.get_close_matches(str(name), known, n=1)
    return f"; did you mean '{near[0]}'?" if near else f"; known: {', '.join(known)}"
