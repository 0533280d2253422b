"""Tables of the bag varied in one thing at a time: effects of the variants, of the speed of the plates, and of causes of a misfit.

usage: python3 -m ch3.variants COMMAND NAME... > table; variants.mk calls it. Commands: options VARIANT bag|load; seed VARIANT;
table FOLDER VARIANT...; rates FAST SLOW; merge KEPT < NEW; beside [NAME=]FOLDER...; scatter FOLDER..., with mean and deviation;
apart FOLDER..., with mean and deviation of all but the first.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import itertools
import pathlib
import re
import statistics
import sys

from study import NotMade, Study, StudyError, compare, read_statements
from study.errors import suggestion
from study.tables import read_words

from . import compression
from .bag import HERE, Runs

STRAINS = (1, 4, 8)  # %
COLUMNS = ("name", "seed", "bag", "load", "description")


def cell(name, column):
    """Returns the entry of a variant in a column of variants.tsv. Raises StudyError for an unknown one."""
    rows = {row["name"]: row for _, row in read_words(HERE / "variants.tsv", COLUMNS)[1]}
    if name not in rows:
        raise StudyError(f"{HERE / 'variants.tsv'}: has no variant {name}{suggestion(name, rows)}")
    return rows[name][column]


def options(name, part):
    """Returns the settings of a variant for its bag or its load, as options of a tool."""
    return " ".join(f"--set {setting}" for setting in cell(name, part).split())


def bag_in(folder):
    """Returns the compressed bag of PE of a folder."""
    return Runs(folder, False).bag("uc_PE")


def as_text(rows):
    """Returns rows of words as tab-separated text."""
    return "".join("\t".join(row) + "\n" for row in rows)


def table(folder, names):
    """Returns the table of variants as text: their loads at STRAINS and at most, and the strain at the first broken yarn.

    The first name is the unvaried bag. The others are given as differences from it.
    """
    heads = ["variant", "what is varied", "void ratio under the preload"]
    for s in STRAINS:
        heads += [f"load at {s} % [kPa]", f"load at {s} %, change [%]", f"tension at {s} %, change [%]", f"q/p at {s} %", f"q/p at {s} %, change [%]"]
    heads += ["first break by [%]", "greatest load [kPa]", "greatest load, change [%]", "strain at the greatest load [%]"]
    first = bag_in(folder / names[0])
    return as_text([heads, *([name, cell(name, "description"), *carried(bag_in(folder / name), first)] for name in names)])


def carried(bag, first):
    """Returns the cells of a bag, with its differences from the first one."""
    cells = [f"{bag['void_ratio'][0]:.4f}"]
    for s in STRAINS:
        row, of_first = bag.row_at(s), first.row_at(s)
        load, tension, obliquity = (f"{100 * (bag[column][row] / first[column][of_first] - 1):+.1f}"
                                    for column in ("plate_pressure", "tension_yarn_face", "obliquity"))
        cells += [f"{bag['plate_pressure'][row]:.1f}", load, tension, f"{bag['obliquity'][row]:.3f}", obliquity]
    cells.append(f"{bag['strain_axial'][bag.broken]:.0f}" if bag["broken_yarns"].any() else "none")
    try:
        row = compression.peak(bag, "plate_pressure")
    except NotMade:
        return [*cells, "none", "none", "none"]
    load = bag["plate_pressure"][row]
    try:
        difference = f"{100 * (load / first['plate_pressure'][compression.peak(first, 'plate_pressure')] - 1):+.1f}"
    except NotMade:
        difference = "none"
    return [*cells, f"{load:.1f}", difference, f"{bag['strain_axial'][row]:.0f}"]


def rates(fast, slow):
    """Returns the table of axial stress under fast and slow plates as text.

    Stations are at every per cent up to the first at which a yarn of either has broken. Bags are named by their folders.
    """
    bags = [bag_in(folder) for folder in (fast, slow)]
    rows = [["axial strain [%]", *(f"{pathlib.Path(folder).name} [kPa]" for folder in (fast, slow)), "difference [%]"]]
    for s in itertools.count(1):
        try:
            stations = [(bag, bag.row_at(s)) for bag in bags]
        except NotMade:
            return as_text(rows)
        one, other = (bag["axial_stress"][row] for bag, row in stations)
        rows.append([f"{s}", f"{one:.2f}", f"{other:.2f}", f"{100 * (one / other - 1):+.2f}"])
        if any(bag["broken_yarns"][row] for bag, row in stations):
            return as_text(rows)


def verdicts(folder):
    """Returns the Verdicts of comparison.tsv for a folder's compressed bags, by description."""
    study = Study("ch3", "", folder, "quick")
    compression.measure(study, Runs(folder, False, absent="not compressed"))
    stated = [s for s in read_statements(HERE / "expected.tsv") if s.name in study.measures]
    return {v.statement.description: v for v in compare(stated, study.measures)}


def beside(folders, scatter=False, apart=False):
    """Returns a table of several bags beside the published values as text: a line for each value, a column for each bag.

    folders: paths whose last part names the bag, or NAME=FOLDER. The table leaves out values after failure, which shorter runs
    do not reach, and values that only the first bag has. scatter: adds mean and standard deviation of a sample. apart: leaves
    the first bag out of both.
    """
    pairs = [(name or pathlib.Path(folder).name, verdicts(folder)) for name, _, folder in (words.rpartition("=") for words in folders)]
    of_each = [of for _, of in pairs]
    rows = [["description", "unit", "published", "tolerance", *(name for name, _ in pairs), *(["mean", "deviation"] if scatter else [])]]
    for description, first in of_each[0].items():
        if "failure" in description or not any(description in of for of in of_each[1:]):
            continue
        s = first.statement
        measured = [of[description].measured if description in of else "none" for of in of_each]
        values = [float(value) for value in measured[apart:] if value != "none"]
        scattered = [f"{statistics.mean(values):.4g}" if values else "none", f"{statistics.stdev(values):.2g}" if len(values) > 1 else "none"]
        rows.append([description, s.unit, s.published, s.margin, *measured, *(scattered if scatter else [])])
    return as_text(rows)


def entries(text, where):
    """Splits a table or histories of variants: returns the head (empty for histories), and the text of each variant by name.

    A table has a line for each variant. A history begins with "== NAME".
    """
    if text.startswith("variant\t"):
        lines = text.splitlines(keepends=True)
        return lines[0], {line.split("\t")[0]: line for line in lines[1:]}
    parts = re.split(r"^(?=== )", text, flags=re.MULTILINE)
    if parts[0]:
        raise StudyError(f"{where}: is neither a table of variants nor histories of them")
    return "", {part.split("\n")[0][3:]: part for part in parts[1:]}


def merge(new, kept, where):
    """Returns the new table or histories, with the variants of the kept text that the new text lacks.

    Raises StudyError if kept rows that stay are differences from another bag.
    """
    head, rows = entries(new, "the new ones")
    _, old = entries(kept, where)
    stay = {name: text for name, text in old.items() if name not in rows}
    if head and stay and next(iter(old.items())) != next(iter(rows.items())):
        raise StudyError(f"{where}: is of another bag: remove it, or make all variants anew")
    return head + "".join([*rows.values(), *stay.values()])


def merged(path):
    """Returns standard input, merged with the kept file at a path if it exists."""
    new, kept = sys.stdin.read(), pathlib.Path(path)
    return merge(new, kept.read_text(encoding="utf-8"), kept) if kept.exists() else new


COMMANDS = {"options": lambda name, part: options(name, part) + "\n", "seed": lambda name: cell(name, "seed") + "\n",
            "table": lambda folder, *names: table(pathlib.Path(folder), names), "rates": rates, "merge": merged,
            "beside": lambda *folders: beside(folders), "scatter": lambda *folders: beside(folders, True),
            "apart": lambda *folders: beside(folders, True, True)}


def main(commands=None, description=__doc__):
    """Prints what the pipeline asks for. commands: functions of names by the command's name, COMMANDS unless given. Errors are one line, status 65."""
    commands = commands or COMMANDS
    parser = argparse.ArgumentParser(description=description, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=commands)
    parser.add_argument("names", nargs="+")
    arguments = parser.parse_args()
    try:
        sys.stdout.write(commands[arguments.command](*arguments.names))
    except (StudyError, NotMade, OSError) as error:
        print(f"study: {error}", file=sys.stderr)
        sys.exit(65)


if __name__ == "__main__":
    main()
