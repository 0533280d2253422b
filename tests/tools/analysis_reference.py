# Stress, void ratio, fabric and coordination of a file, summed anew with numpy, beside the table a tool printed.
# SPDX-License-Identifier: GPL-3.0-or-later
"""usage: analysis_reference.py STATES.h5 TABLE.tsv (of homogenize or fabric)"""
import sys

import h5py
import numpy


def deviator(tensor, d):
    return tensor - numpy.trace(tensor) / d * numpy.eye(d)


def state(file, frame):
    """Expected columns of one state."""
    grains = file["particles/grains"]
    d = int(grains["box"].attrs["dimension"])
    cell = grains["box/edges/value"][frame][:d, :d]
    volume = abs(numpy.linalg.det(cell))
    contacts = {name: data[()] for name, data in file[f"contacts/{frame:06d}"].items()}
    n, f_n, f_t = contacts["normal"][:, :d], contacts["normal_force"], contacts["shear_force"][:, :d]
    branch, count = contacts["branch_vector"][:, :d], len(f_n)
    stress = numpy.einsum("ci,cj->ij", f_n[:, None] * n + f_t, branch) / volume
    stress = (stress + stress.T) / 2
    s, p = deviator(stress, d), numpy.trace(stress) / d
    q = numpy.sqrt((1.5 if d == 3 else 0.5) * (s * s).sum())
    principal = numpy.sort(numpy.linalg.eigvalsh(stress))[::-1]
    radius = grains["radius"][()]
    solids = (4 / 3 * numpy.pi * radius**3 if d == 3 else numpy.pi * radius**2).sum()
    expected = {"mean_stress": p, "deviatoric_stress": q, "stress_obliquity": q / p, "void_ratio": volume / solids - 1,
                "coordination_number": (contacts["bodies"] >= 0).sum() / len(radius)}
    expected.update((f"principal_{k + 1}", value) for k, value in enumerate(principal))

    phi = numpy.einsum("ci,cj->ij", n, n) / count
    a_c = (7.5 if d == 3 else 4) * deviator(phi, d)
    weight = count * (1 + numpy.einsum("ci,ij,cj->c", n, a_c, n))
    chi_n = numpy.einsum("c,ci,cj->ij", f_n / weight, n, n)
    chi_t = numpy.einsum("ci,cj->ij", f_t / weight[:, None], n)
    chi_t = (chi_t + chi_t.T) / 2
    a_n = (7.5 if d == 3 else 4) * deviator(chi_n, d) / numpy.trace(chi_n)
    a_t = (5 if d == 3 else 4) * deviator(chi_t, d) / numpy.trace(chi_n)
    for name, a in (("a_c", a_c), ("a_n", a_n), ("a_t", a_t)):
        size = numpy.sqrt((1.5 if d == 3 else 0.5) * (a * a).sum())
        expected[name] = -size if (a * s).sum() < 0 else size
    for prefix, tensor in (("stress", stress), ("contact_normal", phi), ("normal_force", chi_n),
                           ("tangential_force", chi_t)):
        for i in range(d):
            for j in range(i, d):
                expected[f"{prefix}_{'xyz'[i]}{'xyz'[j]}"] = tensor[i, j]
    ends = numpy.bincount(contacts["bodies"][contacts["bodies"] >= 0], minlength=len(radius))
    none, one = (ends == 0).sum(), (ends == 1).sum()
    expected["mechanical_coordination_number"] = (ends.sum() - one) / (len(radius) - none - one)
    return expected


with open(sys.argv[2], encoding="utf-8") as text:
    names = [column.split(" [")[0] for column in text.readline().rstrip("\n").split("\t")]
    rows = [dict(zip(names, map(float, line.split("\t")))) for line in text]
with h5py.File(sys.argv[1]) as states:
    steps = states["particles/grains/position/step"][()].tolist()
    compared = 0
    for row in rows:
        expected = state(states, steps.index(row["step"]))
        stresses = max(abs(expected["principal_1"]), 1e-300)
        for name in expected.keys() & row.keys():
            scale = stresses if "stress" in name or "principal" in name else 1
            assert abs(row[name] - expected[name]) < 1e-9 * max(scale, abs(expected[name])), (name, row, expected[name])
            compared += 1
print(len(rows), "states,", compared, "numbers")
