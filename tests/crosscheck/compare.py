#!/usr/bin/env python3
# Compares the two tables of the crosscheck, with a verdict for every line; exits with 1 if a bound is missed.
# SPDX-License-Identifier: GPL-3.0-or-later
import math
import sys

# The lattice follows the same path in the same steps. The remaining differences are the order of sums, and the peer's rotation of the
# shear force to first order.
STRESS_TOLERANCE = 1e-8
VOID_RATIO_TOLERANCE = 5e-4
STRESS_RATIO_TOLERANCE = 0.02
VOLUMETRIC_TOLERANCE = 3e-4
STRAINS = (0.005, 0.01, 0.02)
# Beyond this strain chaos has parted the twins, so that the scatter of the means is allowed for as well.
LAST_BEFORE_SCATTER = 0.01


def rows(name):
    with open(name) as file:
        return [[float(word) for word in line.split()] for line in file]


def verdict(good):
    print("  ok" if good else "  DISAGREES")
    return good


def lattice(name, ours, theirs):
    print(f"contact paths, {name}: strains in 1e-3, stresses in kPa, difference over the mean stress")
    print("  x      z        ours xx      peer xx      ours zz      peer zz   difference")
    good, ours, theirs = True, rows(ours), rows(theirs)
    if len(ours) != len(theirs):
        sys.exit(f"  {len(ours)} stations here, {len(theirs)} there")
    for mine, other in zip(ours, theirs):
        mean = sum(other[3:]) / 3
        apart = max(abs(a - b) for a, b in zip(mine[3:], other[3:])) / mean
        strain = max(abs(a - b) for a, b in zip(mine[:3], other[:3]))
        print(f"{1e3 * mine[0]:6.3f} {1e3 * mine[2]:6.3f} {mine[3] / 1e3:12.5f} {other[3] / 1e3:12.5f} "
              f"{mine[5] / 1e3:12.5f} {other[5] / 1e3:12.5f}   {apart:.1e}", end="")
        good &= verdict(apart <= STRESS_TOLERANCE and strain < 1e-8)
    return good


def ensemble(name, twins):
    return [rows(f"{name}.{twin}") for twin in range(twins)]


def mean(values):
    return sum(values) / len(values)


def spread(values):
    """Standard error of the mean; no number of one value."""
    middle, n = mean(values), len(values)
    return math.sqrt(sum((v - middle) ** 2 for v in values) / (n - 1) / n) if n > 1 else 0.0


def triaxial(name, twins):
    ours, theirs = ensemble("ours", twins), ensemble("theirs", twins)
    print(f"triaxial compression at 200 kPa, {name}, means of {twins} twins (standard errors in brackets)")
    good = True

    def line(quantity, column, row, scale, tolerance, relative, scatter):
        nonlocal good
        a, b = ([run[row][column] * scale for run in runs] for runs in (ours, theirs))
        allowed = tolerance * scale * (mean(b) if relative else 1)
        if scatter:
            allowed = max(allowed, 2 * math.hypot(spread(a), spread(b)))
        apart = mean(a) - mean(b)
        print(f"  {quantity:36s} {mean(a):9.4f} ({spread(a):.4f})  peer {mean(b):9.4f} ({spread(b):.4f})  "
              f"difference {apart:+.4f} of {allowed:.4f}", end="")
        good &= verdict(abs(apart) <= allowed)

    line("void ratio after compression", 3, 0, 1, VOID_RATIO_TOLERANCE, False, False)
    for strain in STRAINS:
        row = min(range(len(ours[0])), key=lambda k: abs(ours[0][k][0] - strain))
        scatter = strain > LAST_BEFORE_SCATTER
        line(f"stress ratio at {100 * strain:g} %", 2, row, 1, STRESS_RATIO_TOLERANCE, True, scatter)
        line(f"volumetric strain at {100 * strain:g} %, %", 1, row, 100, VOLUMETRIC_TOLERANCE, False, scatter)
    speeds = [mean([rows(f"{side}.{twin}.speed")[0][0] for twin in range(twins)]) for side in ("ours", "theirs")]
    print(f"  steps per second, one thread         {speeds[0]:9.0f}           peer {speeds[1]:9.0f}")
    return good


agreed = lattice(*sys.argv[2:]) if sys.argv[1] == "lattice" else triaxial(sys.argv[2], int(sys.argv[3]))
sys.exit(0 if agreed else 1)
