#!/usr/bin/env python3
"""Writes status.html beside the results of make thesis: which files are done, running, stopped, failed or still to come."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import dataclasses
import pathlib
import re
import sys
import time

from study import StudyError, Table, pages
from study.files import put
from study.plain_text import read_text
from thesis import products
from thesis.forecast import Rate, between

# A run writes a checkpoint every five minutes. Without one for three times as long, it counts as stopped.
SILENT = 900
# Interval at which the page is written and reloads itself, s.
EVERY = 30
_FAILED = re.compile(r"^make(?:\[\d+\])?: \*\*\* \[[^\]]*?: (?P<target>[^\]\s]+)\] Error (?P<status>\d+)")
# make thesis writes this line into its log when it begins.
BEGUN = "thesis: begins"
_SAID = re.compile(r"^[a-z0-9-]+(?: [a-z]+)?: (?!doubt)")


def hours(seconds):
    """Returns a time as text, in minutes below two hours."""
    return f"{seconds / 60:.0f} min" if seconds < 7200 else f"{seconds / 3600:.1f} h"


def failures(log):
    """Returns the reasons of failures by file: the last message of a tool before make gave up a target, and the exit status.

    A target that was made again later did not fail. Every beginning of make thesis tries all targets again.
    """
    found, said = {}, ""
    for line in log.splitlines():
        if line == BEGUN:
            found, said = {}, ""
            continue
        match = _FAILED.match(line)
        if match:
            found[match["target"]] = f"{said or 'it said nothing'} (exit status {match['status']})"
            said = ""
        elif _SAID.match(line):
            said = line
        elif (again := re.match(r"^  (?:run|fill|pack) +(\S+)$", line)):
            found.pop(again[1], None)
    return found


@dataclasses.dataclass
class Row:
    """A line of the page: state is done, running, stopped, failed or waiting."""

    chapter: str
    name: str
    state: str
    share: float
    words: str


def time_left(product, states, rates):
    """Returns the seconds that a run has left: by its pace between the last two states, else by the machine's; None without either."""
    left = product.steps - states[-1][0]
    if len(states) > 1 and states[-1][0] > states[-2][0]:
        return left * (states[-1][1] - states[-2][1]) / (states[-1][0] - states[-2][0])
    return left * between(rates, product.bodies).step(product.bodies, product.links) if rates else None


def row_of(product, out, failed, rates, now):
    """Returns the Row of a product."""
    reason = failed.get(str(product.file(out)))
    if product.file(out).exists():
        return Row(product.chapter, product.name, "done", 1, time.strftime("%Y-%m-%d %H:%M", time.localtime(product.file(out).stat().st_mtime)))
    states = product.states(out)
    share = min(0.99, states[-1][0] / product.steps) if states else 0
    if reason:
        return Row(product.chapter, product.name, "failed", share, reason)
    if not states:
        return Row(product.chapter, product.name, "waiting", 0, "")
    if now - states[-1][1] > SILENT:
        return Row(product.chapter, product.name, "stopped", share, "make thesis goes on from here")
    if states[-1][0] >= product.steps:
        return Row(product.chapter, product.name, "running", share, "beyond the steps that were expected")
    left = time_left(product, states, rates)
    return Row(product.chapter, product.name, "running", share, f"about {hours(left)} left" if left is not None else "")


def known_rates(out):
    """Returns the Rates that the last forecast measured, or none."""
    path = pathlib.Path(out) / "rates.tsv"
    if not path.exists():
        return []
    table = Table.read(path)
    return [Rate(int(n), link, body) for n, link, body in zip(table("bodies", "1"), table("link", "s"), table("body", "s"), strict=True)]


def others(out, chapter, names, failed):
    """Returns the Rows of files whose steps are in no table: done, failed, running or waiting."""
    rows = []
    for name in names:
        path = pathlib.Path(out) / chapter / name
        reason = failed.get(str(path))
        state = "done" if path.exists() else "failed" if reason else "running" if path.with_name(f"{path.name}.part").exists() else "waiting"
        rows.append(Row(chapter, name.removesuffix(".h5").removesuffix("/posterior"), state, float(state == "done"), reason or ""))
    return rows


def figures(out):
    """Returns the pages and drawings of the chapters that have some: (chapter, page or "", drawings)."""
    found = []
    for folder in sorted(pathlib.Path(out).glob("ch?")):
        page = folder / "page.html"
        drawings = sorted(path.relative_to(out).as_posix() for path in folder.glob("*.svg"))
        if page.exists() or drawings:
            found.append((folder.name, page.relative_to(out).as_posix() if page.exists() else "", drawings))
    return found


def write(given, now):
    """Writes the page."""
    out = pathlib.Path(given.out)
    log = read_text(out / "log") if (out / "log").exists() else ""
    failed, rates = failures(log), known_rates(out)
    rows = [row_of(product, out, failed, rates, now) for product in products.read()]
    rows += others(out, "ch6", given.two_scales, failed) + others(out, "ch2", [f"{case}/posterior.h5" for case in given.cases], failed)
    put(out / "status.html", pages.render(
        "status.html", title="make thesis", refresh=EVERY, rows=rows, figures=figures(out),
        written=time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(now)),
        counts={state: sum(row.state == state for row in rows) for state in ("done", "running", "stopped", "failed", "waiting")}))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", help="folder of the results")
    parser.add_argument("--cases", nargs="*", default=[], help="of chapter 2, LAW_GRAINS_PRESSURE")
    parser.add_argument("--two-scales", nargs="*", default=[], help="files of chapter 6")
    parser.add_argument("--while", type=int, dest="process", help="write the page again and again, as long as this process lives")
    arguments = parser.parse_args()
    try:
        write(arguments, time.time())
        while arguments.process and pathlib.Path(f"/proc/{arguments.process}").exists():
            time.sleep(EVERY)
            write(arguments, time.time())
    except (StudyError, OSError) as error_:
        print(f"thesis-status: {error_}", file=sys.stderr)
        sys.exit(65)
