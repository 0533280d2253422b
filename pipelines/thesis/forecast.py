#!/usr/bin/env python3
"""Estimates hours, memory and disk of make thesis on this machine, by chapter, from a trial of about a minute.

The trial runs as many processes at once as there are cores, since runs side by side share caches and memory. The cost of a step is
a links + b bodies. The trial finds a and b from two packings: a thousand grains, and copies of them that fill a cell of chapter 4.
"""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import concurrent.futures
import dataclasses
import math
import os
import pathlib
import re
import subprocess
import sys

from study import StudyError
from study.files import put
from thesis import products

CALIBRATION = products.HERE.parent / "calibration"
COPIES = (10, 10)
# Sets of the prior of each law in the trial of chapter 2.
SETS = 8
LAWS = {"hm": "hertz-mindlin", "cl": "linear"}
# Memory of a process per body, measured on the bag of chapter 3 (722 MB of 92,815 bodies with all that is recorded).
MEGABYTES_PER_BODY = 722 / 92815


@dataclasses.dataclass(frozen=True)
class Rate:
    """Seconds of a step per link and per body, measured on an assembly of so many bodies."""

    bodies: int
    link: float
    body: float

    def step(self, bodies, links):
        """Returns the seconds of a step."""
        return self.link * links + self.body * bodies


def rate_of(text):
    """Returns the Rate that the last line of run-dem --check tells. Raises StudyError where it has none."""
    match = re.search(r"of (\d+) grains with (\d+) contacts in .*: ([0-9.e+-]+) steps/s.*; contacts (\d+) %", text)
    if not match:
        raise StudyError("run-dem --check does not tell its steps per second")
    bodies, links, second, share = int(match[1]), int(match[2]), 1 / float(match[3]), int(match[4]) / 100
    return Rate(bodies, share * second / links, (1 - share) * second / bodies)


def between(rates, bodies):
    """Returns the Rate for a number of bodies, linear in its logarithm between both trials (caches are outgrown), constant beyond."""
    small, large = rates
    share = (math.log(bodies) - math.log(small.bodies)) / (math.log(large.bodies) - math.log(small.bodies))
    share = min(1.0, max(0.0, share))
    return Rate(bodies, small.link + share * (large.link - small.link), small.body + share * (large.body - small.body))


def tiled(text, copies=COPIES):
    """Returns the text of copies, along x and y, of a periodic packing's text (to-vtk --text). Raises StudyError if it is not periodic."""
    size, grains = None, []
    for line in text.splitlines():
        if line.startswith("##PERIODIC::"):
            size = [float(word) for word in line.split()[1:]]
        elif line.strip() and not line.startswith("#"):
            grains.append([float(word) for word in line.split()])
    if size is None:
        raise StudyError("to-vtk --text tells no periodic cell")
    lines = ["##PERIODIC:: " + " ".join(repr(n * length) for n, length in zip((*copies, 1), size, strict=True))]
    for i in range(copies[0]):
        for j in range(copies[1]):
            lines += [f"{x + i * size[0]!r} {y + j * size[1]!r} {z!r} {r!r}" for x, y, z, r in grains]
    return "\n".join(lines) + "\n"


def mean_runtime(joblog):
    """Returns the mean seconds of a job in a log of GNU parallel. The time of the whole trial would count idle cores at its end."""
    head, *rows = [line.split("\t") for line in joblog.splitlines()]
    if not rows:
        raise StudyError("the trial of chapter 2 ran no test")
    return sum(float(row[head.index("JobRuntime")]) for row in rows) / len(rows)


class Machine:
    """The tools on this machine, and trials of them in a folder."""

    def __init__(self, tools, folder, cores):
        self.tools, self.folder, self.cores = pathlib.Path(tools), pathlib.Path(folder), cores
        self.folder.mkdir(parents=True, exist_ok=True)

    def run(self, tool, *words):
        """Runs a tool and returns what it prints. Raises StudyError with its last line where it fails."""
        done = subprocess.run([self.tools / tool, *map(str, words)], capture_output=True, text=True, check=False)
        if done.returncode:
            raise StudyError(f"{tool}: {done.stderr.strip().splitlines()[-1] if done.stderr.strip() else done.returncode}")
        return done.stdout

    def at_once(self, tool, *words):
        """Runs a command once on every core at the same time, and returns what each run prints."""
        with concurrent.futures.ThreadPoolExecutor(self.cores) as pool:
            return list(pool.map(lambda _: self.run(tool, *words), range(self.cores)))

    def rates(self):
        """Returns the Rates of a thousand grains and of copies of them."""
        small, text, large = (self.folder / name for name in ("grains.h5", "copies.txt", "copies.h5"))
        self.run("pack-generate", "--grains", 1000, "--void-ratio", 0.68, "--pressure", 1e3, "--seed", 1, "--threads", 1, "--quiet", "--force", "-o", small)
        put(text, tiled(self.run("to-vtk", "--text", small)))
        self.run("pack-generate", "--import", text, "--density", 2650e3, "--threads", self.cores, "--quiet", "--force", "-o", large)
        found = []
        for packing in (small, large):
            said = self.at_once("run-dem", "--check", packing, CALIBRATION / "hertz-mindlin.toml", "--threads", 1)
            some = [rate_of(text) for text in said]
            found.append(Rate(some[0].bodies, sum(r.link for r in some) / len(some), sum(r.body for r in some) / len(some)))
        return found

    def test_seconds(self, law, prior, strain):
        """Returns the seconds of a core that a test of 1000 grains takes on average, over some sets of a prior."""
        sets, folder = self.folder / f"sets_{law}.tsv", self.folder / law
        put(sets, self.run("pf-weight", "draw", prior, "--samples", SETS, "--first", 1, "--tsv"))
        subprocess.run(["rm", "-rf", folder / "runs"], check=True)
        done = subprocess.run([CALIBRATION / "ensemble.sh", sets, folder, law, self.folder / "grains.h5", CALIBRATION / f"{LAWS[law]}.toml",
                               "0.2", str(strain)], env=os.environ | {"BIN": str(self.tools), "JOBS": str(self.cores)},
                              capture_output=True, text=True, check=False)
        if done.returncode:
            raise StudyError(f"{CALIBRATION / 'ensemble.sh'}: {done.stderr.strip()}")
        return mean_runtime((folder / f"{sets.stem}.joblog").read_text(encoding="utf-8"))


def two_scale_seconds(text):
    """Returns the seconds of one core that fem-dem --check tells. Raises StudyError where it has none."""
    match = re.search(r"about ([0-9.e+]+) (s|min|h|days) on 1 thread", text)
    if not match:
        raise StudyError("fem-dem --check does not tell its time on one thread")
    return float(match[1]) * {"s": 1, "min": 60, "h": 3600, "days": 86400}[match[2]]


@dataclasses.dataclass
class Chapter:
    """Cost of a chapter: seconds of one core, megabytes of memory of its largest process, and of disk."""

    name: str
    seconds: float = 0
    memory: float = 0
    disk: float = 0
    alike: int = 0  # products whose steps were not measured


def of_products(some, rates, out):
    """Returns the cost of these products of one chapter. Finished products in the folder of results cost nothing."""
    chapter = Chapter(some[0].chapter)
    for product in some:
        left = product.left(out)
        chapter.seconds += left * between(rates, product.bodies).step(product.bodies, product.links)
        chapter.memory = max(chapter.memory, product.bodies * MEGABYTES_PER_BODY)
        chapter.disk += product.megabytes if left else 0
        chapter.alike += left > 0 and product.basis != "measured"
    return chapter


def of_calibration(cases, sets, seconds, rates, out):
    """Returns the Chapter of all cases LAW_GRAINS_PRESSURE. seconds: by law, of a test of 1000 grains."""
    chapter = Chapter("ch2", memory=100)
    small = between(rates, 1000).step(1000, 2600)
    for case in cases:
        law, grains, _ = case.split("_")
        if (pathlib.Path(out) / "ch2" / case / "posterior.h5").exists():
            continue
        n = int(grains)
        chapter.seconds += sets * seconds[law] * between(rates, n).step(n, 2.6 * n) / small
        # Series of 30 kB each stay; runs do not.
        chapter.disk += 0.03 * sets
    return chapter


def report(chapters, cores):
    """Returns the lines that make thesis-forecast prints."""
    lines = [f"{'chapter':10}{'core hours':>12}{f'hours, {cores} cores':>18}{'memory':>10}{'disk':>10}"]
    for c in chapters:
        lines.append(f"{c.name:10}{c.seconds / 3600:12.1f}{c.seconds / 3600 / cores:18.1f}{c.memory * cores / 1e3:7.1f} GB{c.disk / 1e3:7.1f} GB"
                     + (f"   steps of {c.alike} runs estimated from like ones" if c.alike else ""))
    total = sum(c.seconds for c in chapters) / 3600
    lines.append(f"{'all':10}{total:12.1f}{total / cores:18.1f}{max(c.memory for c in chapters) * cores / 1e3:7.1f} GB{sum(c.disk for c in chapters) / 1e3:7.1f} GB")
    return lines


def main(given):
    """Runs the trial and prints the forecast."""
    machine = Machine(given.tools, pathlib.Path(given.out) / "forecast", given.cores)
    rates = machine.rates()
    seconds = {law: machine.test_seconds(law, given.prior, given.strain) for law in LAWS}
    by_chapter = {}
    for product in products.read():
        by_chapter.setdefault(product.chapter, []).append(product)
    chapters = [of_calibration(given.cases, given.sets, seconds, rates, given.out), *(of_products(some, rates, given.out) for some in by_chapter.values())]
    two_scales = Chapter("ch6", memory=200)
    for path in given.checks:
        text = pathlib.Path(path).read_text(encoding="utf-8")
        if not (pathlib.Path(given.out) / "ch6" / f"{pathlib.Path(path).stem}.h5").exists():
            two_scales.seconds += two_scale_seconds(text)
            two_scales.disk += 60
    print("\n".join(report([*chapters, two_scales], given.cores)))
    put(pathlib.Path(given.out) / "rates.tsv", "bodies [1]\tlink [s]\tbody [s]\n" + "".join(f"{r.bodies}\t{r.link!r}\t{r.body!r}\n" for r in rates))


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", help="folder of the results")
    for name, kind in (("tools", str), ("cores", int), ("prior", str), ("strain", float), ("sets", int)):
        parser.add_argument(f"--{name}", type=kind, required=True)
    parser.add_argument("--cases", nargs="+", required=True, help="of chapter 2, LAW_GRAINS_PRESSURE")
    parser.add_argument("--checks", nargs="*", default=[], help="what fem-dem --check said of each run of chapter 6")
    try:
        main(parser.parse_args())
    except (StudyError, OSError) as error_:
        print(f"thesis-forecast: {error_}", file=sys.stderr)
        sys.exit(65)
