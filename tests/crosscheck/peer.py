# YADE on the crosscheck's input: a lattice strained along a path, or a packing in triaxial compression.
# SPDX-License-Identifier: GPL-3.0-or-later
# Run by YADE, which brings O, the engines and Matrix3: yade -n -x -j1 peer.py; the order of work is in ORDER (JSON).
import json
import math
import os
import random
import sys
import time

order = json.loads(os.environ["ORDER"])
law, rate = order["law"], order.get("rate", 0)
table = open(order["output"], "w")
started = time.time()


def material():
    friction = math.radians(law["friction_angle"])
    common = dict(young=law["young_modulus"], density=order["density"], frictionAngle=friction)
    if law["law"] == "hertz-mindlin":
        return FrictMat(poisson=law["poisson_ratio"], **common)
    stiffness, limit = law.get("rolling_stiffness", 0), law.get("rolling_limit", -1)
    return CohFrictMat(poisson=law["stiffness_ratio"], isCohesive=False, momentRotationLaw=True, alphaKr=stiffness,
                       alphaKtw=stiffness, etaRoll=limit, etaTwist=limit, **common)


def interactions():
    if law["law"] == "hertz-mindlin":
        moment = law.get("rolling_stiffness", 0)
        return InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
                               [Ip2_FrictMat_FrictMat_MindlinPhys(krot=moment, ktwist=moment, eta=0)],
                               [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)])
    linear = Law2_ScGeom6D_CohFrictPhys_CohesionMoment(always_use_moment_law=True, useIncrementalForm=True)
    return InteractionLoop([Ig2_Sphere_Sphere_ScGeom6D()], [Ip2_CohFrictMat_CohFrictMat_CohFrictPhys()], [linear])


def load_packing():
    chance = random.Random(order.get("seed", 0))
    O.periodic = True
    O.materials.append(material())
    for line in open(order["packing"]):
        if line.startswith("##PERIODIC::"):
            lengths = [float(word) for word in line.split()[1:]]
            O.cell.hSize = Matrix3(lengths[0], 0, 0, 0, lengths[1], 0, 0, 0, lengths[2])
            continue
        x, y, z, r = (float(word) for word in line.split())
        shift = order.get("perturb", 0) * r
        O.bodies.append(sphere([c + shift * chance.uniform(-1, 1) for c in (x, y, z)], r))
    O.cell.trsf = Matrix3.Identity


def void_ratio():
    solids = sum(4 / 3 * math.pi * body.shape.radius**3 for body in O.bodies)
    return O.cell.volume / solids - 1


def strains():
    return [-math.log(O.cell.trsf[a, a]) for a in range(3)]


def write(*values):
    print(*("%.15g" % value for value in values), sep="\t", file=table, flush=True)


def finish():
    table.close()
    with open(order["output"] + ".speed", "w") as speed:
        print(O.iter / (time.time() - started), file=speed)
    sys.stdout.flush()
    os._exit(0)


# The lattice: every axis goes to its strain at its rate; stations are lists of three strains and three rates.
def strain_along_path():
    goal, rates = order["stations"][strain_along_path.station]
    now = strains()
    if max(abs(goal[a] - now[a]) for a in range(3)) <= 1e-9:
        stress = getStress()
        write(*now, *(-stress[a, a] for a in range(3)))
        strain_along_path.station += 1
        if strain_along_path.station == len(order["stations"]):
            finish()
        goal, rates = order["stations"][strain_along_path.station]
    speed = [math.expm1(-(goal[a] - now[a])) / O.dt for a in range(3)]
    speed = [min(max(v, -rates[a]), rates[a]) for a, v in enumerate(speed)]
    O.cell.velGrad = Matrix3(speed[0], 0, 0, 0, speed[1], 0, 0, 0, speed[2])


strain_along_path.station = 0


# The triaxial test: YADE's own controller; the unbalanced force is looked at in every step.
def station_reached():
    global triax
    if station_reached.count == 0:
        O.cell.trsf = Matrix3.Identity
        triax.stressMask, triax.maxStrainRate = 3, (1, 1, rate)
        write(0, 0, 1, void_ratio())
    else:
        stress, strain = getStress(), strains()
        write(strain[2], sum(strain), 2 * stress[2, 2] / (stress[0, 0] + stress[1, 1]), void_ratio())
    if station_reached.count == order["stations"]:
        finish()
    station_reached.count += 1
    triax.goal = (-order["pressure"], -order["pressure"], -order["increment"] * station_reached.count)


station_reached.count = 0

load_packing()
engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]), interactions()]
if order["test"] == "lattice":
    O.dt = order["time_step"]
    engines.append(PyRunner(command="strain_along_path()", iterPeriod=1))
else:
    O.dt = 1e-7
    p = order["pressure"]
    triax = PeriTriaxController(dynCell=True, goal=(-p, -p, -p), stressMask=7, maxStrainRate=(1, 1, 1),
                                growDamping=0.25, maxUnbalanced=1e-3, relStressTol=1e-3, globUpdate=1,
                                doneHook="station_reached()")
    engines += [GlobalStiffnessTimeStepper(timestepSafetyCoefficient=0.8, timeStepUpdateInterval=1), triax]
O.engines = engines + [NewtonIntegrator(damping=0.2)]
O.run(-1, True)
