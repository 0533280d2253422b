"""The error of the studies, the nearest known name for its messages, and the exception for a number that a profile does not make."""
# SPDX-License-Identifier: GPL-3.0-or-later
import difflib


class StudyError(Exception):
    """An error in one line for the reader: the file, the mistake, the remedy."""


class NotMade(Exception):
    """Raised where this profile has no number for a measure, with the reason in a few words; Study.measure() keeps it."""


def suggestion(name, known):
    """Returns "; did you mean 'x'?" for the nearest of the known names, or all of them where none is near."""
    known = [str(k) for k in known]
    near = [k for k in known if k.casefold() == str(name).casefold()] or difflib.get_close_matches(str(name), known, n=1)
    return f"; did you mean '{near[0]}'?" if near else f"; known: {', '.join(known)}"
