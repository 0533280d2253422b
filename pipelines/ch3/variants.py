"""The bag varied in one thing at a time: what each variant is worth, what the speed of plates is worth, what causes a misfit.

usage: python3 -m ch3.variants options|seed|table|rates|beside|merge ... > table; study.mk calls it.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import pathlib
import re
import statistics
import sys

from study import NotMade, Study, StudyError, compare, read_statements
from study.errors import suggestion
from study.tables import read_words

from . import compression
from .bag import HERE, Runs

STRAINS = (0.01, 0.04, 0.08)
COLUMNS = ("name", "seed", "bag", "load", "description")


def read_variants():
    """Returns the rows of variants.tsv by name."""
    return {row["name"]: row for _, row in read_words(HERE / "variants.tsv", COLUMNS)[1]}


def variant(name):
    """Returns the row of a variant. Raises StudyError for an unknown one."""
    rows = read_variants()
    if name not in rows:
        raise StudyError(f"{HERE / 'variants.tsv'}: has no variant {name}{suggestion(name, rows)}")
    return rows[name]


def options(name, part):
    """Returns the settings of a variant for its bag or its load, as options of a tool."""
    return " ".join(f"--set {setting}" for setting in variant(name)[part].split())


def bag_in(folder, name="uc_PE"):
    """Returns a compressed bag of a folder."""
    return Runs(folder, False, []).bag(name)


def row_at(bag, strain):
    """Returns the row of the station at an axial strain."""
    near = [i for i, x in enumerate(bag["strain_axial"]) if abs(x - strain) < 1e-4]
    if not near:
        raise StudyError(f"{bag.table.where}: has no station at an axial strain of {100 * strain:.0f} %")
    return near[0]


def table(folder, names):
    """Returns the table of variants as text: what each carries at STRAINS and at most, and where its first yarn breaks.

    The first name is the bag itself, which the others are told as differences from.
    """
    bags, descriptions = {name: bag_in(folder / name) for name in names}, read_variants()
    first = bags[names[0]]
    heads = ["variant", "what is varied", "void ratio under the preload"]
    for s in STRAINS:
        at = f"at {100 * s:.0f} %"
        heads += [f"load {at} [kPa]", "load [%]", "tension [%]", f"q/p {at}", "q/p [%]"]
    lines = ["\t".join([*heads, "first break by [%]", "greatest load [kPa]", "greatest load [%]", "at [%]"])]
    for name, bag in bags.items():
        cells = [name, descriptions[name]["description"], f"{bag['void_ratio'][0]:.4f}"]
        for s in STRAINS:
            row, of_first = row_at(bag, s), row_at(first, s)

            def difference(column, row=row, of_first=of_first, bag=bag):
                return f"{100 * (bag[column][row] / first[column][of_first] - 1):+.1f}"
            cells += [f"{bag['plate_pressure'][row]:.1f}", difference("plate_pressure"), difference("tension_yarn_face"),
                      f"{bag['obliquity'][row]:.3f}", difference("obliquity")]
        lines.append("\t".join(cells + failure_cells(bag, first)))
    return "\n".join(lines) + "\n"


def failure_cells(bag, first):
    """Returns where the first yarn has broken, the greatest load, its difference from that of the first bag, and its strain."""
    broken = bag["broken_yarns"] > 0
    cells = [f"{100 * bag['strain_axial'][bag.broken]:.0f}" if broken.any() else "none"]
    try:
        row = compression.peak(bag, "plate_pressure")
    except NotMade:
        return [*cells, "none", "none", "none"]
    try:
        most = first["plate_pressure"][compression.peak(first, "plate_pressure")]
        difference = f"{100 * (bag['plate_pressure'][row] / most - 1):+.1f}"
    except NotMade:
        difference = "none"
    return [*cells, f"{bag['plate_pressure'][row]:.1f}", difference, f"{100 * bag['strain_axial'][row]:.0f}"]


def rates(fast, slow):
    """Returns the table of axial stress under fast and slow plates as text.

    Stations are at every per cent up to the first at which a yarn of either has broken. Bags are named by their folders.
    """
    names = [pathlib.Path(folder).name for folder in (fast, slow)]
    lines = [f"axial strain [%]\t{names[0]} [kPa]\t{names[1]} [kPa]\tdifference [%]"]
    stations = [{}, {}]
    broken = set()
    for stress, folder in zip(stations, (fast, slow), strict=True):
        bag = bag_in(folder)
        for strain, axial, breaks in zip(100 * bag["strain_axial"], bag["axial_stress"], bag["broken_yarns"], strict=True):
            if abs(strain - round(strain)) < 0.01:
                stress[round(strain)] = axial
                if breaks:
                    broken.add(round(strain))
    s = 1
    while s in stations[0] and s in stations[1] and s - 1 not in broken:
        one, other = stations[0][s], stations[1][s]
        lines.append(f"{s}\t{one:.2f}\t{other:.2f}\t{100 * (one / other - 1):+.2f}")
        s += 1
    return "\n".join(lines) + "\n"


def verdicts(folder):
    """Returns what a folder's compressed bags have of the published values, by description, as comparison.tsv shows it."""
    study = Study("ch3", "", folder, "quick")
    compression.measure(study, Runs(folder, False, [], "not compressed"))
    stated = [s for s in read_statements(HERE / "expected.tsv") if s.name in study.measures]
    return {v.statement.description: v for v in compare(stated, study.measures)}


def beside(folders, scatter=False, apart=False):
    """Returns what several bags have of the published values as text, a line a value, a column a bag.

    folders: each names its bag by its last part, or is written NAME=FOLDER. Left out are values after failure, which shorter
    runs cannot tell, and those that the first bag alone has. scatter: with mean and standard deviation of a sample. apart: the
    first bag is no part of these.
    """
    pairs = [(name or pathlib.Path(folder).name, folder) for name, _, folder in (text.rpartition("=") for text in folders)]
    names, of_each = [name for name, _ in pairs], [verdicts(folder) for _, folder in pairs]
    lines = ["\t".join(["description", "unit", "published", "tolerance", *names, *(["mean", "deviation"] if scatter else [])])]
    for description, first in of_each[0].items():
        if "failure" in description or not any(description in of for of in of_each[1:]):
            continue
        s = first.statement
        cells = [description, s.unit, s.published, f"± {s.tolerance}" if s.tolerance else ""]
        cells += [of[description].measured if description in of else "none" for of in of_each]
        if scatter:
            values = [float(of[description].measured) for of in of_each[apart:] if description in of]
            cells.append(f"{statistics.mean(values):.4g}" if values else "none")
            cells.append(f"{statistics.stdev(values):.2g}" if len(values) > 1 else "none")
        lines.append("\t".join(cells))
    return "\n".join(lines) + "\n"


def entries(text, where):
    """Returns the head of a table of variants, or none of histories, and what there is of each variant, by name.

    A table has a line for each variant, a history begins with "== NAME".
    """
    if text.startswith("variant\t"):
        lines = text.splitlines(keepends=True)
        return lines[0], {line.split("\t")[0]: line for line in lines[1:]}
    parts = re.split(r"^(?=== )", text, flags=re.MULTILINE)
    if parts[0]:
        raise StudyError(f"{where}: is neither a table of variants nor histories of them")
    return "", {part.split("\n")[0][3:]: part for part in parts[1:]}


def merge(new, kept, where):
    """Returns the new table or histories with those variants from the kept one that the new one lacks.

    Raises StudyError where differences of the kept table are from another bag, unless none of them stays.
    """
    head, rows = entries(new, "the new ones")
    _, old = entries(kept, where)
    stay = {name: text for name, text in old.items() if name not in rows}
    if head and stay and next(iter(old.items())) != next(iter(rows.items())):
        raise StudyError(f"{where}: is of another bag: remove it, or make all variants anew")
    return head + "".join([*rows.values(), *stay.values()])


def run(arguments):
    """Returns what a command prints."""
    names = arguments.names
    if arguments.command == "options":
        return options(names[0], names[1]) + "\n"
    if arguments.command == "seed":
        return variant(names[0])["seed"] + "\n"
    if arguments.command == "table":
        return table(pathlib.Path(names[0]), names[1:])
    if arguments.command == "rates":
        return rates(*names)
    if arguments.command == "beside":
        return beside(names, arguments.scatter, arguments.apart)
    kept = pathlib.Path(names[0])
    new = sys.stdin.read()
    return merge(new, kept.read_text(encoding="utf-8"), kept) if kept.exists() else new


def main():
    """Prints what study.mk asks for. Errors are one line, status 65."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", choices=["options", "seed", "table", "rates", "beside", "merge"])
    parser.add_argument("names", nargs="+", help="variant and bag or load; variant; folder and variants; two folders; "
                        "folders; what was kept")
    parser.add_argument("--scatter", action="store_true", help="beside: with mean and deviation")
    parser.add_argument("--apart", action="store_true", help="beside: mean and deviation without the first bag")
    try:
        sys.stdout.write(run(parser.parse_args()))
    except (StudyError, OSError) as error:
        print(f"study: {error}", file=sys.stderr)
        sys.exit(65)


if __name__ == "__main__":
    main()
