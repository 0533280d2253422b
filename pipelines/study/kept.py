"""Reads the kept measurements of a run at full size, its comparison.tsv, and matches them to the present statements."""
# SPDX-License-Identifier: GPL-3.0-or-later
from .comparison import Verdict
from .errors import StudyError, suggestion
from .tables import read_words

COLUMNS = ("description", "unit", "published", "tolerance", "measured", "difference", "verdict", "source")


def read_kept(path, statements):
    """Returns the Verdict of a kept comparison for each of the statements that it has, as (statement, verdict) pairs.

    Rows are matched to statements by their description, equal descriptions in their order. Raises StudyError for a row without a
    statement, or with another published value than the statement has now. The kept run has to be compared anew then.
    """
    left, verdicts = list(statements), []
    for number, row in read_words(path, COLUMNS)[1]:
        where = f"{path}: line {number}"
        found = next((s for s in left if s.description == row["description"]), None)
        if found is None:
            known = suggestion(row["description"], [s.description for s in left] or ["none is left"])
            raise StudyError(f"{where}: '{row['description']}' is no statement of the study{known}")
        for name, today in (("published", found.bound), ("tolerance", found.margin), ("unit", found.unit)):
            if row[name] != today:
                raise StudyError(f"{where}: {name} is '{row[name]}', in the statements '{today}'; compare the kept run anew")
        if row["verdict"] not in ("met", "not met"):
            raise StudyError(f"{where}: the verdict is '{row['verdict']}'; only runs that are judged can be kept")
        left.remove(found)
        verdicts.append((found, Verdict(found, row["measured"], row["difference"], row["verdict"] == "met")))
    return verdicts
