#!/usr/bin/env python3
# Thousands of hostile inputs to every reader and option of the tools: mutated text, edited HDF5, extreme numbers.
# SPDX-License-Identifier: GPL-3.0-or-later
"""A seed gives the same cases each time (--seed). Each case demands: no signal, a documented status, no defect, no more
than 1 GiB of memory beyond the files' own size, and a few seconds of processor time. A failing command has to print one
line (mistakes in options and TOML: a line each) that begins with the tool's name, without control characters. Output is
whole or absent, and no temporary file stays. Failing cases are kept in a folder, each with its command."""
import argparse
import collections
import concurrent.futures
import os
import pathlib
import random
import re
import resource
import shlex
import shutil
import subprocess
import sys
import tempfile
import tomllib

import hostile_inputs

GIB = 1 << 30
CPU = 5  # s; run-dem and its like stop at the signal and end with 75
DOCUMENTED = {0, 1, 64, 65, 66, 70, 73, 74, 75}
STEPPING = {"pack-generate", "filter-expand", "run-dem", "fem-dem"}
# A valid command of each tool and verb, to which a hostile input is added. Names in braces are prepared files.
RIGHT = {
    ("pack-generate",): "--grains 10 --pressure 1e5 --tolerance 0.1 -o out.h5",
    ("filter-expand",): "{packing.h5} {cut.toml} -o out.h5",
    ("run-dem",): "--check {packing.h5} {triaxial.toml}",
    ("fem-dem",): "--check {elastic.toml}",
    ("homogenize",): "{run.h5} --tsv",
    ("fabric",): "{run.h5} --tsv",
    ("to-vtk",): "{run.h5} -o out",
    ("pf-weight", "draw"): "{prior.toml} --tsv -n 5",
    ("pf-weight", "assimilate"): "{ensemble.h5} {observed.tsv} --runs {runs.tsv} --variance 0.01 --tsv",
    ("pf-weight", "resample"): "{posterior.h5} -n 5 --tsv",
    ("gws-solve", "respond"): "--geotextile PP --tsv",
    ("gws-solve", "identify"): "{response.tsv} --tsv",
    ("gws-solve", "design"): "--surcharge 3e5 --tsv",
}
# Commands that read each prepared file, by its place in the command.
READERS = {
    "spheres.txt": [
        "pack-generate --import @ --as-is -o out.h5",
        "pack-generate --import @ --as-is --cell 1,1,1 -o out.h5",
    ],
    "grading.tsv": ["pack-generate --grading @ --grains 10 --pressure 1e5 --tolerance 0.1 -o out.h5"],
    "observed.tsv": ["pf-weight assimilate {ensemble.h5} @ --runs {runs.tsv} --variance 0.01 --tsv"],
    "runs.tsv": ["pf-weight assimilate {ensemble.h5} {observed.tsv} --runs @ --least-size 0.2 -o out.h5"],
    "sets.tsv": ["pf-weight assimilate @ {observed.tsv} --runs {runs.tsv} --variance 0.01 --tsv"],
    "response.tsv": ["gws-solve identify @ --tsv", "gws-solve identify @ -o out.h5"],
    "lateral.tsv": ["gws-solve respond --geotextile PP --lateral-history @ --tsv"],
    "compression.tsv": ["gws-solve identify {response.tsv} --compression @ --tsv"],
    "triaxial.toml": ["run-dem --check {packing.h5} @", "run-dem {packing.h5} @ -o out.h5"],
    "press.toml": ["run-dem --check {bag.h5} @"],
    "material.toml": ["pack-generate --material @ --grains 10 --pressure 1e5 --tolerance 0.1 -o out.h5"],
    "cut.toml": ["filter-expand {packing.h5} @ -o out.h5"],
    "bag.toml": ["filter-expand {packing.h5} @ -o out.h5"],
    "elastic.toml": ["fem-dem --check @", "fem-dem @ -o out.h5"],
    "on_mesh.toml": ["fem-dem --check @ --mesh {triangles.msh}"],
    "prior.toml": [
        "pf-weight draw @ --tsv -n 5",
        "pf-weight assimilate {sets.tsv} {observed.tsv} --runs {runs.tsv} --prior @ --variance 1 --tsv",
    ],
    "soil.toml": [
        "gws-solve respond --geotextile PP --soil @ --tsv",
        "gws-solve design --surcharge 3e5 --soil @ --tsv",
    ],
    "geotextile.toml": ["gws-solve respond --geotextile @ --tsv"],
    "triangles.msh": ["fem-dem --check {on_mesh.toml} --mesh @"],
    "quadrilaterals.msh": ["fem-dem --check {on_mesh.toml} --mesh @"],
    "text.stl": ["filter-expand {packing.h5} {cut.toml} --set container.file=@ -o out.h5"],
    "binary.stl": ["filter-expand {packing.h5} {cut.toml} --set container.file=@ -o out.h5"],
    "packing.h5": [
        "homogenize @ --tsv",
        "homogenize @ --tessellation --grains -o out.h5",
        "fabric @ --tsv",
        "to-vtk @ -o out",
        "to-vtk --text @",
        "run-dem --check @ {triaxial.toml}",
        "pack-generate --import @ --as-is -o out.h5",
        "filter-expand @ {cut.toml} -o out.h5",
    ],
    "bag.h5": [
        "homogenize @ --table bag --tsv",
        "homogenize @ --yarns --tsv --table yarns",
        "to-vtk @ -o out",
        "run-dem --check @ {press.toml}",
    ],
    "run.h5": [
        "homogenize @ --tsv",
        "homogenize @ --table series --tsv",
        "fabric @ --table chains --tsv",
        "to-vtk --state all @ -o out",
        "to-vtk --history @",
        "pf-weight assimilate {ensemble.h5} {observed.tsv} --runs @ --variance 1 --tsv",
        "run-dem --check @ {triaxial.toml}",
    ],
    "fields.h5": ["to-vtk {run.h5} --fields @ -o out", "to-vtk @ -o out", "gws-solve identify @ --tsv"],
    "ensemble.h5": [
        "pf-weight assimilate @ {observed.tsv} --runs {runs.tsv} --variance 0.01 --tsv",
        "pf-weight resample @ --tsv",
    ],
    "posterior.h5": ["pf-weight resample @ -n 5 --tsv", "pf-weight resample @ -n 5 --keep -o out.h5"],
    "multiscale.h5": [
        "fem-dem --table series @",
        "fem-dem --table nodes @",
        "fem-dem --take 0 @ -o out.h5",
        "to-vtk @ -o out",
    ],
}
SHARES = {"h5": 0.32, "toml": 0.20, "set": 0.14, "tsv": 0.12, "msh": 0.09, "stl": 0.07, "txt": 0.06}


def limits(memory):
    def set_them():
        resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        resource.setrlimit(resource.RLIMIT_CPU, (CPU, 2 * CPU))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
        resource.setrlimit(resource.RLIMIT_FSIZE, (GIB, GIB))
    return set_them


class Cases:
    """Commands by number; the prepared files lie in `seeds`."""

    def __init__(self, tools, seeds, seed):
        self.tools, self.seeds, self.seed = tools, seeds, seed
        self.options = [(place, option) for place in RIGHT for option in self.options_of(place)]
        self.keys = [(name, key) for name in READERS if name.endswith(".toml")
                     for key in hostile_inputs.keys_of(tomllib.loads((seeds / name).read_text()))]
        chance = random.Random(seed)
        self.systematic = [(*option, value) for option in self.options
                           for value in chance.sample(hostile_inputs.WORDS, 11)]
        self.by_ending = collections.defaultdict(list)
        for name in READERS:
            self.by_ending[name.rsplit(".", 1)[1]].append(name)

    def options_of(self, place):
        command = [self.tools / place[0], *place[1:], "--help"]
        text = subprocess.run(command, capture_output=True, text=True, check=True).stdout
        found = re.findall(r"^  (?:-\w, )?(--[a-z-]+) ([^ ]+)(?:  |$)", text, re.MULTILINE)
        return [name for name, value in found if name not in ("--output", "--threads", "--help,")]

    def filled(self, template, word=""):
        parts = []
        for part in template.split():
            name = re.fullmatch(r"\{(.*)\}", part)
            parts.append(str(self.seeds / name[1]) if name else part.replace("@", word))
        return parts

    def make(self, number, folder):
        """The command of this case, run in `folder`, where its input is written."""
        chance = random.Random(self.seed * 1_000_003 + number)
        if number < len(self.systematic):
            place, option, value = self.systematic[number]
            return [place[0], *place[1:], *self.filled(RIGHT[place]), f"{option}={value}"]
        kind = chance.choices(list(SHARES), SHARES.values())[0]
        if kind == "set":
            name, key = chance.choice(self.keys)
            command = self.filled(chance.choice(READERS[name]), str(self.seeds / name))
            if command[0] in STEPPING - {"pack-generate"}:  # those with --set
                return [*command, f"--set={key}={chance.choice(hostile_inputs.WORDS)}"]
            return self.written(chance, name, folder)
        return self.written(chance, chance.choice(self.by_ending[kind]), folder)

    def written(self, chance, name, folder):
        source, target = self.seeds / name, folder / name
        if name.endswith(".h5"):
            shutil.copy(source, target)
            hostile_inputs.change_hdf5(chance, target, self.seeds)
        else:
            target.write_bytes(hostile_inputs.changed(chance, source.read_bytes()))
        return self.filled(chance.choice(READERS[name]), name)


def fault(command, done, files, before, after):
    """Returns the fault in the way a command ended, or nothing."""
    tool, status, words = command[0], done.returncode, done.stderr
    if status < 0:
        return "took more than its processor time" if -status in (9, 24) else f"signal {-status}"
    if status not in DOCUMENTED:
        return f"status {status}"
    try:
        text = words.decode()
    except UnicodeDecodeError:
        return "standard error is not UTF-8"
    if re.search(r"[\x00-\x09\x0b-\x1f\x7f-\x9f]", text):
        return "control characters on standard error"
    lines = text.splitlines()
    if "defect" in text or "not enough memory" in text or (status == 70 and tool not in STEPPING):
        return "a defect" if "memory" not in text else "memory"
    if any(not re.match(re.escape(tool) + r"( [a-z]+)?: ", line) for line in lines):
        return "a line without the tool's name"
    if any(len(line) > 8000 for line in lines):
        return "a line of more than 8000 characters"
    failing = [line for line in lines if ": doubt: " not in line]
    if status != 0 and not failing:
        return "no word on why it failed"
    if status != 0 and len(failing) > 1 and status not in (64, 65):
        return "several lines"
    new = {name for name in after - before if name not in files}
    if any(name.startswith(".") for name in new):
        return "a temporary file left behind"
    if new - {"out", "out.h5", "out.h5.part"} or (status in (64, 65, 66) and new):
        return f"files left behind: {' '.join(sorted(new))}"
    return ""


def run_case(cases, bases, number, keep):
    folder, begun = pathlib.Path(tempfile.mkdtemp(prefix="hostile-")), sum(os.times()[:4])
    try:
        command = cases.make(number, folder)
        inputs = set(os.listdir(folder))
        size = sum((folder / name).stat().st_size for name in inputs)
        try:
            done = subprocess.run([cases.tools / command[0], *command[1:], "--quiet"], cwd=folder, check=False,
                                  stdin=subprocess.DEVNULL, capture_output=True, timeout=120,
                                  preexec_fn=limits(bases[command[0]] + GIB + size),
                                  env={**os.environ, "OMP_NUM_THREADS": "1", "LC_ALL": "C.UTF-8"})
        except ValueError:  # a zero byte in an argument: no shell can give one
            return command[0], "", 64, 0
        wrong = fault(command, done, inputs, inputs, set(os.listdir(folder)))
        if wrong:
            kept = keep / f"{number:05d}"
            shutil.rmtree(kept, ignore_errors=True)
            shutil.copytree(folder, kept, symlinks=True)
            (kept / "command").write_text(f"# {wrong}; status {done.returncode}\n{shlex.join(map(str, command))}\n"
                                          + done.stderr.decode(errors="backslashreplace")[:4000])
        word = wrong and f"{number:05d}: {wrong}: {shlex.join(map(str, command))[:200]}"
        return command[0], word, done.returncode, sum(os.times()[:4]) - begun
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def base_of(tool):
    """Address space that a tool takes before it reads anything."""
    for memory in range(64 << 20, 2 * GIB, 32 << 20):
        done = subprocess.run([tool, "--version"], capture_output=True, preexec_fn=limits(memory), check=False)
        if done.returncode == 0:
            return memory
    raise SystemExit(f"hostile.py: {tool} does not run")


def main():
    options = argparse.ArgumentParser(description=__doc__)
    options.add_argument("--bin", type=pathlib.Path, default="build/bin", help="folder of the tools")
    options.add_argument("--cases", type=int, default=5000)
    options.add_argument("--only", type=int, nargs="*", help="numbers of single cases")
    options.add_argument("--sample", type=int, default=1, help="every so many-th case alone")
    options.add_argument("--seed", type=int, default=1)
    options.add_argument("--jobs", type=int, default=os.cpu_count())
    options.add_argument("--keep", type=pathlib.Path, default="build/hostile", help="folder of failing cases")
    given = options.parse_args()
    tools = given.bin.resolve()
    keep = given.keep.resolve()
    with tempfile.TemporaryDirectory(prefix="hostile-seeds-") as folder:
        seeds = pathlib.Path(folder)
        hostile_inputs.prepare(tools, seeds)
        cases = Cases(tools, seeds, given.seed)
        bases = {place[0]: base_of(tools / place[0]) for place in RIGHT}
        numbers = given.only or range(0, given.cases, given.sample)
        with concurrent.futures.ProcessPoolExecutor(given.jobs) as pool:
            results = list(pool.map(run_case, *zip(*((cases, bases, n, keep) for n in numbers)), chunksize=20))
    counts = collections.Counter((tool, status) for tool, _, status, _ in results)
    for tool in sorted({place[0] for place in RIGHT}):
        print(f"{tool}: " + ", ".join(f"{n} x {status}" for (t, status), n in sorted(counts.items()) if t == tool))
    wrong = [word for _, word, _, _ in results if word]
    used = sum(result[3] for result in results)
    print("\n".join(wrong + [f"hostile: {len(results)} cases in {used:.0f} s of processor time, {len(wrong)} wrong"
                             + (f", kept in {keep}" if wrong else "")]))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
