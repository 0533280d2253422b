# YADE's speed on a packing of bench-peers: steps per second of processor time after a warm-up, to the file in the order.
# SPDX-License-Identifier: GPL-3.0-or-later
# Run by YADE, which brings O, the engines and Matrix3: yade -n -x -j1 speed_yade.py; the order of work is in ORDER (JSON).
import json
import math
import os
import sys
import time

order = json.loads(os.environ["ORDER"])
friction = math.radians(29)
disks = order["disks"]

O.periodic = True
if disks:
    O.materials.append(FrictMat(young=3e10, poisson=0.5, density=2650, frictionAngle=friction))
    law = InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [Ip2_FrictMat_FrictMat_FrictPhys()],
                          [Law2_ScGeom_FrictPhys_CundallStrack()])
else:
    O.materials.append(FrictMat(young=3.1e9, poisson=0.3, density=2650e3, frictionAngle=friction))
    law = InteractionLoop([Ig2_Sphere_Sphere_ScGeom()],
                          [Ip2_FrictMat_FrictMat_MindlinPhys(krot=0.13, ktwist=0.13, eta=0)],
                          [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=True)])
for line in open(order["packing"]):
    words = line.split()
    if words[0] == "##PERIODIC::":
        lengths = [float(word) for word in words[1:]]
        O.cell.hSize = Matrix3(lengths[0], 0, 0, 0, lengths[1], 0, 0, 0, lengths[2])
        continue
    x, y, z, r = (float(word) for word in words)
    O.bodies.append(sphere([x, y, z], r))
    if disks:
        O.bodies[-1].state.blockedDOFs = "zXY"
O.cell.trsf = Matrix3.Identity

engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()]), law,
           GlobalStiffnessTimeStepper(timestepSafetyCoefficient=0.8, timeStepUpdateInterval=1)]
# A servo on the lateral stress, the axis led; in two dimensions the third length is kept.
p = order["pressure"]
goal, mask, rates = ((-p, -1, 0), 1, (1, 0.1, 0)) if disks else ((-p, -p, -1), 3, (1, 1, 0.1))
engines.append(PeriTriaxController(dynCell=True, goal=goal, stressMask=mask, maxStrainRate=rates, growDamping=0.25,
                                   globUpdate=1, doneHook="pass"))
O.engines = engines + [NewtonIntegrator(damping=0.2)]
O.dt = 1e-7
O.run(order["warm_up"], True)
started = time.process_time()
O.run(order["steps"], True)
with open(order["output"], "w") as speed:
    print(order["steps"] / (time.process_time() - started), sum(1 for i in O.interactions if i.isReal), file=speed)
sys.stdout.flush()
os._exit(0)
