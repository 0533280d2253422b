#!/usr/bin/env python3
# Tables of recorded.sh: our ensembles beside the peer's, each with the laboratory, and a verdict for every bound.
# SPDX-License-Identifier: GPL-3.0-or-later
import csv
import math
import sys

PEER = {"hm": "hm31_eta0_0.2", "cl": "clid_0.2"}
LAWS = {"hm": "Hertz-Mindlin", "cl": "linear law"}
VOID_RATIO = 5e-4      # of the mean after isotropic compression
STRESS_RATIO = 0.02    # relative, up to 1 % strain
VOLUMETRIC = 0.03      # %, up to 1 % strain
LABORATORY = {"hm": 6.0, "cl": 2.2}  # %, root mean square of the stress ratio, as well as the peer meets it
# If differences are normal, 32 % of stations lie beyond one combined standard deviation; neighbours go together.
BEYOND = 0.45
SHOWN = (0.1, 0.5, 1, 1.5, 2, 3, 4, 6, 8, 10)


def table(name, delimiter):
    with open(name) as file:
        return list(csv.DictReader((line for line in file if not line.startswith("#")), delimiter=delimiter))


def peer(name):
    rows = table(name, ",")
    curve = {round(float(r["eps_a_pct"]), 2): (float(r["s33_over_s11"]), float(r["eps_v_pct"])) for r in rows}
    return float(rows[0]["void_ratio"]), curve


def ours(name):
    rows = [{key.split(" ")[0]: float(value) for key, value in r.items()} for r in table(name, "\t")]
    start = [r for r in rows if r["stage"] == 0][-1]["void_ratio"]
    shear = [r for r in rows if r["stage"] == 1]
    return start, {round(100 * r["strain_axial"], 2): (r["stress_ratio"], 100 * r["strain_volumetric"]) for r in shear}


def moments(values):
    mean = sum(values) / len(values)
    return mean, math.sqrt(sum((v - mean) ** 2 for v in values) / max(1, len(values) - 1))


def at(curve, strain):
    below = math.floor(10 * strain + 1e-9) / 10
    low, high = (curve.get(round(x, 2), (1.0, 0.0))[0] for x in (below, min(below + 0.1, 10)))
    return low + (high - low) * (strain - below) / 0.1


def against_laboratory(curves, laboratory):
    errors = []
    for row in laboratory:
        strain = float(row["strain_axial [%]"])
        if strain <= 10:
            errors.append(moments([at(c, strain) for c in curves])[0] / float(row["stress_ratio [1]"]) - 1)
    return 100 * math.sqrt(sum(e * e for e in errors) / len(errors))


def compare(mine, theirs):
    """Means and scatters at every common station: {strain: [(our mean, sd, peer mean, sd) of ratio and of volume]}."""
    common = sorted(set.intersection(*(set(c) for c in mine + theirs)))
    return {e: [moments([c[e][k] for c in mine]) + moments([c[e][k] for c in theirs]) for k in (0, 1)]
            for e in common if e > 0}


def main(folder, laboratory, twins):
    laboratory, good = table(laboratory, "\t"), True

    def bound(text, value, most):
        nonlocal good
        good &= value <= most
        print(f"  {text}: {value:.4g} of {most:.4g}  {'ok' if value <= most else 'MISSED'}")

    for law, title in LAWS.items():
        names = [PEER[law]] + [f"{PEER[law]}_pert{k}" for k in (1, 2, 3)]
        their_start, theirs = zip(*(peer(f"{folder}/{name}.csv") for name in names))
        best = math.inf
        for servo in ("stiffness", "inertia"):
            start, mine = zip(*(ours(f"{law}.{servo}.0.1.{k}.tsv") for k in range(twins)))
            print(f"{title}, servo \"{servo}\": mean (standard deviation) of {twins} twins, peer's of {len(names)}")
            print("  strain %   stress ratio      peer              difference   volumetric strain %  peer"
                  "               difference")
            stations = compare(list(mine), list(theirs))
            for e in SHOWN:
                (r, rs, pr, prs), (v, vs, pv, pvs) = stations[e]
                print(f"  {e:7.1f}   {r:7.4f} ({rs:.4f})  {pr:7.4f} ({prs:.4f})  {100 * (r / pr - 1):+7.2f} %   "
                      f"{v:8.4f} ({vs:.4f})   {pv:8.4f} ({pvs:.4f})  {v - pv:+8.4f}")
            early = [s for e, s in stations.items() if e <= 1]
            bound("void ratio after compression, difference",
                  abs(moments(start)[0] - moments(their_start)[0]), VOID_RATIO)
            bound("stress ratio up to 1 %, largest relative difference",
                  max(abs(r[0] / r[2] - 1) for r, _ in early), STRESS_RATIO)
            bound("volumetric strain up to 1 %, largest difference, %", max(abs(v[0] - v[2]) for _, v in early),
                  VOLUMETRIC)
            beyond = [sum(abs(s[k][0] - s[k][2]) > math.hypot(s[k][1], s[k][3]) for s in stations.values())
                      / len(stations) for k in (0, 1)]
            if servo == "inertia":
                bound("stations beyond the combined scatter, stress ratio", beyond[0], BEYOND)
            else:
                print(f"  stations beyond the combined scatter, stress ratio: {beyond[0]:.2f}")
            print(f"  stations beyond the combined scatter, volumetric strain: {beyond[1]:.2f}")
            rms = against_laboratory(mine, laboratory)
            print(f"  root mean square of the stress ratio against the laboratory: {rms:.2f} %, "
                  f"peer {against_laboratory(theirs, laboratory):.2f} %")
            best = min(best, rms)
        bound(f"{title}: stress ratio against the laboratory, %", best, LABORATORY[law])
        fast, slow = ours(f"{law}.stiffness.0.1.0.tsv")[1], ours(f"{law}.stiffness.0.01.0.tsv")[1]
        effect = [100 * (slow[e][0] / fast[e][0] - 1) for e in sorted(fast) if 1 <= e <= 8]
        print(f"  loading at 1 %/s instead of 10 %/s raises the stress ratio by {moments(effect)[0]:.1f} % "
              f"(mean over 1-8 % strain)")
    print("recorded: agreed" if good else "recorded: DISAGREED")
    return 0 if good else 1


sys.exit(main(sys.argv[1], sys.argv[2], int(sys.argv[3])))
