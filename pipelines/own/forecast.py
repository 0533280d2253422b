#!/usr/bin/env python3
"""Estimates the hours of make own: steps of all runs over the steps per second of a short trial on this machine."""
# SPDX-License-Identifier: GPL-3.0-or-later
import argparse
import os
import pathlib
import re
import subprocess
import sys

from own.inputs import OTHERS, STIFFNESSES, read
from study import StudyError

SCENARIO = pathlib.Path(__file__).parents[1] / "calibration/hertz-mindlin.toml"
# Bodies of a bag, steps of its compression, and the time of its filling over that of its compression, measured on quick bags of Toyoura sand and on
# chapter 3's full-size bag. A body of a bag takes longer than a body of the trial, which fits into the caches, by these factors (beside other tenants).
BODIES = {"quick": 13800, "thesis": 92600}
STEPS = {"quick": 29000, "thesis": 63000}
FILLING = {"quick": 1.4, "thesis": 1.0}
SLOWER = {"quick": 1.2, "thesis": 1.8}


def seconds_of(text):
    """Returns steps, bodies and steps per second from the last line of run-dem --check. Raises StudyError if it lacks them."""
    match = re.search(r"(\d+) steps .* of (\d+) grains .*: ([0-9.e+]+) steps/s", text)
    if not match:
        raise StudyError("run-dem --check does not tell its steps per second")
    return int(match[1]), int(match[2]), float(match[3])


def seconds_at_once(each, count, cores):
    """Returns the seconds of `count` runs on one core each."""
    return each * -(-count // cores)


def main(own, out, given):
    """Prints the hours of each part and their sum, on given.cores cores."""
    command = [f"{os.environ['BIN']}/run-dem", "--check", f"{out}/packing_1.h5", SCENARIO, "--set", f"stage.1.axial_strain={given.until}e-2"]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    steps, bodies, rate = seconds_of(done.stdout)
    tests = given.samples * given.rounds * len(own.tests) * steps / rate
    bag = STEPS[given.profile] * BODIES[given.profile] / (rate * bodies) * SLOWER[given.profile]
    # A run has one thread, and a bag is filled before it is compressed.
    runs = len(STIFFNESSES) + len(OTHERS) * given.varied
    bags = seconds_at_once(bag, runs, given.cores) + seconds_at_once(FILLING[given.profile] * bag, 1 + len(OTHERS), given.cores)
    tests /= given.cores
    for words, seconds in ((f"calibration, at most {given.rounds} rounds of {given.samples} sets", tests),
                           (f"{runs} compressions of bags, and filling {1 + len(OTHERS)}", bags), ("all", tests + bags)):
        print(f"{words}: {seconds / 3600:.2g} h on {given.cores} {'core' if given.cores == 1 else 'cores'}")


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("soil", type=pathlib.Path)
    parser.add_argument("out", type=pathlib.Path)
    for name, kind in (("samples", int), ("rounds", int), ("until", float), ("profile", str), ("varied", int), ("cores", int)):
        parser.add_argument(f"--{name}", type=kind, required=True)
    arguments = parser.parse_args()
    try:
        main(read(arguments.soil / "own.toml"), arguments.out, arguments)
    except (StudyError, OSError, subprocess.CalledProcessError) as error_:
        print(f"own: {error_}", file=sys.stderr)
        sys.exit(65)
