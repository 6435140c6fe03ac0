"""A scene of `quicksand bench peers` in Yade: yade -j1 -n -x yade_peer.py SCENE.json ANSWER.json SETTING

Contacts are springs: forces follow from overlaps, and a step must be short against sqrt(m/k). Bonds are
those of Law2_ScGeom6D_CohFrictPhys_CohesionMoment, the law that has tensile strength and moments.

defaults: springs as soft as the rule of thumb allows (the largest force overlaps by 1 % of a radius);
    rolling friction by the law's own bound, which is mu_r times the spring's force, not mu_r (R_n + F_c);
    Cundall's damping of 0.2; gravity at once.
tuned: springs that reach F_c just where a bond of ours breaks, at d_c (without bonds, 100 times as stiff
    as by default); no bound on bending, as the law has none that fits; gravity rises without a jump over
    ten periods of a chain of all disks, as a load that comes at once swings to twice its value; where
    there are bonds a damping of 0.7 (of all forces: where gravity is left out of it, a chain of 1.01 F_c
    holds).
Both take half the time step of utils.PWaveTimeStep, as the tutorials do.
"""
import json
import math
import sys
import time

from yade import *
from yade import config, utils

scene_file, answer_file, setting = sys.argv[1:4]
scene = json.load(open(scene_file))
tuned = setting == "tuned"

radius = 0.5
bonded = scene["cohesion_force"] > 0
weight = sum(disk["mass"] for disk in scene["disks"])
largest = scene["cohesion_force"] if bonded else weight
stiffness = largest / (0.01 * radius)
if tuned:
    stiffness = scene["cohesion_force"] / scene["cohesion_range"] if bonded else 100 * stiffness

ramp = 10 * 4 * len(scene["disks"]) / math.sqrt(stiffness) if tuned else 0.0

# kn of two equal spheres is young radius (Ip2_*: harmonic mean of young radius).
young = stiffness / radius
angle = math.atan(scene["friction"])
if bonded:
    per_radius2 = 1 / radius**2  # adhesion is cohesion times radius^2
    material = CohFrictMat(young=young, poisson=0.5, frictionAngle=angle, density=1.0,
                           normalCohesion=scene["cohesion_force"] * per_radius2,
                           shearCohesion=scene["friction"] * scene["cohesion_force"] * per_radius2,
                           momentRotationLaw=True,
                           etaRoll=-1 if tuned else scene["rolling_friction"], etaTwist=-1)
    physics = Ip2_CohFrictMat_CohFrictMat_CohFrictPhys(setCohesionNow=True)
    law = Law2_ScGeom6D_CohFrictPhys_CohesionMoment(useIncrementalForm=True)
    shapes = [Ig2_Sphere_Sphere_ScGeom6D(interactionDetectionFactor=1.0001),
              Ig2_Box_Sphere_ScGeom6D(interactionDetectionFactor=1.0001)]
else:
    material = FrictMat(young=young, poisson=0.5, frictionAngle=angle, density=1.0)
    physics = Ip2_FrictMat_FrictMat_FrictPhys()
    law = Law2_ScGeom_FrictPhys_CundallStrack()
    shapes = [Ig2_Sphere_Sphere_ScGeom(), Ig2_Box_Sphere_ScGeom()]
O.materials.append(material)

disks = []
for disk in scene["disks"]:
    body = utils.sphere([*disk["position"], 0], disk["radius"], fixed=disk["fixed"])
    body.state.mass = disk["mass"]
    body.state.inertia = [disk["inertia"]] * 3
    if not disk["fixed"]:
        body.state.blockedDOFs = "zXY"
    disks.append(O.bodies.append(body))
far, thick = 1e3, 1.0
walls = []
for wall in scene["walls"]:
    (x, y), (nx, ny) = wall["point"], wall["normal"]
    extents = [far if abs(ny) > 0.5 else thick, far if abs(nx) > 0.5 else thick, 10.0]
    walls.append(O.bodies.append(
        utils.box([x - thick * nx, y - thick * ny, 0], extents, fixed=True)))

gravity = Vector3(*scene["gravity"], 0)
newton = NewtonIntegrator(gravity=Vector3.Zero if ramp else gravity, damping=0.7 if tuned and bonded else 0.2)
O.engines = [ForceResetter(),
             InsertionSortCollider([Bo1_Sphere_Aabb(aabbEnlargeFactor=1.01), Bo1_Box_Aabb()],
                                   verletDist=0.1 * radius),
             InteractionLoop(shapes, [physics], [law]),
             newton]
if ramp:
    def load():
        share = min(1.0, O.time / ramp)
        newton.gravity = share**2 * (3 - 2 * share) * gravity

    O.engines = [PyRunner(iterPeriod=10, command="load()"), *O.engines]
mass_density = 1 / (4 / 3 * math.pi * radius**3)
O.dt = 0.5 * radius * math.sqrt(mass_density / young)  # half of utils.PWaveTimeStep()

begin = time.process_time()
if bonded:
    O.step()  # makes the bonds, where disks touch
    for shape in shapes:
        shape.interactionDetectionFactor = 1
O.run(math.ceil((ramp + scene["time"]) / O.dt), True)
seconds = time.process_time() - begin


def whole(number):
    return disks[number] if number >= 0 else walls[-1 - number]


def broken(bond):
    a, b = (whole(number) for number in bond)
    try:
        contact = O.interactions[a, b]
    except IndexError:
        return True
    return not contact.isReal or contact.phys.cohesionBroken


state = [O.bodies[k].state for k in disks]
with open(answer_file, "w") as answer:
    json.dump({"version": config.version,
               "cpu_seconds": seconds, "ramp": ramp, "dt": O.dt, "steps": O.iter,
               "position": [list(s.pos)[:2] for s in state],
               "velocity": [[s.vel[0], s.vel[1], s.angVel[2]] for s in state],
               "broken": [k for k, bond in enumerate(scene["bonds"]) if broken(bond)]}, answer)
