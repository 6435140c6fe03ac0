#!/usr/bin/python3
"""A scene of `quicksand bench peers` in Siconos: siconos_peer.py SCENE.json ANSWER.json SETTING

Disks in two dimensions by its own runner (siconos.io.mechanics_run, contacts found by Bullet), Moreau-Jean
steps with Coulomb friction, as in its examples. It has no law of bonds that break, so it is given scenes
without. The shebang is that of Debian's Python, for which the package is.

defaults: 1000 sweeps of Gauss-Seidel at most, to 1e-4, dt = 1e-2; theta = 1, implicit Euler, as ours.
tuned: 100 000 sweeps, to 1e-8, and contacts count as closed from a gap of 1e-3 d on: by default, those that
    rounding has opened a little are free for a step, and what stands sinks.
Overlaps are those that a contact begins with, what a disk moves in a step: nothing takes them back.
"""
import json
import os
import sys
import tempfile
import time

try:
    import siconos.kernel as sk
    import siconos.numerics as sn
    from siconos.mechanics.collision.bullet import SiconosBulletOptions, SICONOS_BULLET_2D
    from siconos.mechanics.collision.tools import Contactor
    from siconos.io.mechanics_run import MechanicsHdf5Runner
except ImportError:
    sys.exit(127)

scene_file, answer_file, setting = sys.argv[1:4]
with open(scene_file) as file:
    scene = json.load(file)
sweeps, tolerance, closed = {"defaults": (1000, 1e-4, 0.0), "tuned": (100000, 1e-8, 1e-3)}[setting]
dt = 1e-2
steps = round(scene["time"] / dt)
gravity = scene["gravity"]


class Weights:
    """Gravity along -y, on each body once."""

    def __init__(self):
        self.bodies = []

    def __call__(self, body):
        mass = body.scalarMass()
        body.setFExtPtr([mass * gravity[0], mass * gravity[1], 0])
        self.bodies.append(body)


weights = Weights()  # called in the order of names, so these are as long as each other
record = os.path.join(tempfile.mkdtemp(), "run.hdf5")
with MechanicsHdf5Runner(io_filename=record, mode="w", verbose=False) as io:
    for number, disk in enumerate(scene["disks"]):
        shape = f"disk {disk['radius']:.17g}"
        io.add_primitive_shape(shape, "Disk", [disk["radius"]])
        moving = {} if disk["fixed"] else {"mass": disk["mass"], "inertia": disk["inertia"]}
        io.add_object(f"body {number:06d}", [Contactor(shape)], translation=disk["position"],
                      orientation=[0], velocity=[0, 0, 0], **moving)
    far, thick = 200.0, 2.0
    for number, wall in enumerate(scene["walls"]):
        (x, y), (nx, ny) = wall["point"], wall["normal"]
        io.add_primitive_shape(f"wall {number}", "Box2d",
                               (far, thick) if abs(ny) > 0.5 else (thick, far))
        io.add_object(f"wall {number}", [Contactor(f"wall {number}")], orientation=[0],
                      translation=[x - nx * thick / 2, y - ny * thick / 2])
    io.add_Newton_impact_friction_nsl("contact", mu=scene["friction"], e=0)

bullet = SiconosBulletOptions()
bullet.dimension = SICONOS_BULLET_2D
bullet.perturbationIterations = 0  # a disk has one point of contact
bullet.minimumPointsPerturbationThreshold = 0
solver = sk.solver_options_create(sn.SICONOS_FRICTION_2D_NSGS)
solver.iparam[sn.SICONOS_IPARAM_MAX_ITER] = sweeps
solver.dparam[sn.SICONOS_DPARAM_TOL] = tolerance

with MechanicsHdf5Runner(io_filename=record, mode="r+", set_external_forces=weights,
                         verbose=False) as io:
    begin = time.process_time()
    io.run(T=steps * dt, h=dt, theta=1.0, Newton_max_iter=1, bullet_options=bullet,
           solver_options=solver, constraint_activation_threshold=closed, output_frequency=steps, verbose=False, verbose_progress=False)
    seconds = time.process_time() - begin

position = [disk["position"] for disk in scene["disks"]]
velocity = [[0, 0, 0] for _ in scene["disks"]]
movers = [k for k, disk in enumerate(scene["disks"]) if not disk["fixed"]]
for number, body in zip(movers, weights.bodies):
    position[number] = list(body.q())[:2]
    velocity[number] = list(body.velocity())
with open(answer_file, "w") as file:
    json.dump({"version": "4.4", "cpu_seconds": seconds, "ramp": 0, "dt": dt, "steps": steps,
               "position": position, "velocity": velocity, "broken": []}, file)
