"""Judges NAME_ground_step, compiled as C, by the laws of mechanics with Pinocchio's dynamics.

  ground_step.py --treeline PROGRAM --work FOLDER SEED...

Each seed draws a tree of links with boxes, balls, cylinders and capsules and lets it fall. In every step: without a
contact velocities are those of free flight; what changes them otherwise is the impulse that the step reports, within
the cone of friction; no point that is in the ground after the flight ends the step below the surface; energy is not
made. Quaternions are handed over with random lengths. Exit status 1: a law does not hold.
"""

import argparse
import ctypes
import os
import random
import subprocess
import sys

import numpy as np
import pinocchio as pin

STEP, STEPS, FRICTION = 1e-3, 400, 0.6
# Measured: 7e-15, 1e-14, 1e-15, 6e-17, 8e-13, 1e-15, and 0.3 mm by which the end of a flight is off.
MOST = {"flight": 1e-13, "impulse": 1e-12, "touches": 1e-13, "friction": 1e-14, "speed": 1e-11, "energy": 1e-13, "depth": 1e-3}


def three(numbers):
    return " ".join(f"{x:.6f}" for x in numbers)


def draw_shape(rng):
    """XML, and lowest points of the shape as functions of its pose."""
    kind = rng.choice(["box", "sphere", "cylinder", "capsule"])
    radius, length = round(rng.uniform(0.03, 0.1), 6), round(rng.uniform(0.05, 0.3), 6)
    sizes = [round(rng.uniform(0.03, 0.2), 6) for _ in range(3)]
    place = [round(rng.uniform(-0.1, 0.1), 6) for _ in range(3)]
    turn = [round(rng.uniform(-3, 3), 6) for _ in range(3)]
    inside = f'size="{three(sizes)}"' if kind == "box" else f'radius="{radius:.6f}"'
    if kind in ("cylinder", "capsule"):
        inside += f' length="{length:.6f}"'
    xml = (f'<collision><origin xyz="{three(place)}" rpy="{three(turn)}"/>'
           f'<geometry><{kind} {inside}/></geometry></collision>')
    pose = pin.SE3(pin.rpy.rpyToMatrix(*turn), np.array(place))

    def points(link):
        at = link * pose
        axis, down = at.rotation[:, 2], np.array([0, 0, -1.0])
        if kind == "box":
            signs = [(a, b, c) for a in (1, -1) for b in (1, -1) for c in (1, -1)]
            return [at.act(np.multiply(sign, sizes) / 2) for sign in signs]
        if kind == "sphere":
            return [at.translation + radius * down]
        if kind == "cylinder":
            down = down - axis * (axis @ down)
            down = down / np.linalg.norm(down)
        return [at.translation + side * length / 2 * axis + radius * down for side in (1, -1)]

    return xml, points


def draw_link(rng, name):
    root = np.array([[rng.gauss(0, 1) for _ in range(3)] for _ in range(3)])
    second = root @ root.T * 0.004 + 0.01 * np.eye(3)
    inertia = np.trace(second) * np.eye(3) - second
    shapes = [draw_shape(rng) for _ in range(rng.randint(1, 2))]
    entries = " ".join(f'i{"xyz"[i]}{"xyz"[k]}="{inertia[i, k]:.9f}"' for i in range(3) for k in range(i, 3))
    inertial = (f'<inertial><origin xyz="{three([rng.uniform(-0.05, 0.05) for _ in range(3)])}"/>'
                f'<mass value="{rng.uniform(0.3, 3):.6f}"/><inertia {entries}/></inertial>')
    return f'<link name="{name}">{inertial}{"".join(xml for xml, _ in shapes)}</link>', [points for _, points in shapes]


def draw_robot(seed):
    rng = random.Random(seed)
    parts, shapes = [], {}
    for i in range(rng.randint(2, 6)):
        xml, shapes[f"link{i}"] = draw_link(rng, f"link{i}")
        parts.append(xml)
        if i > 0:  # a chain, whose joints are in one order everywhere
            axis = np.array([rng.gauss(0, 1) for _ in range(3)])
            kind = rng.choice(["revolute", "prismatic"])
            parts.append(f'<joint name="joint{i}" type="{kind}"><parent link="link{i - 1}"/>'
                         f'<child link="link{i}"/><origin xyz="{three([rng.uniform(-0.25, 0.25) for _ in range(3)])}" '
                         f'rpy="{three([rng.uniform(-3, 3) for _ in range(3)])}"/>'
                         f'<axis xyz="{three(axis / np.linalg.norm(axis))}"/>'
                         '<limit lower="-3" upper="3" effort="100" velocity="20"/></joint>')
    return '<robot name="drawn">' + "".join(parts) + "</robot>", shapes


class Report(ctypes.Structure):
    _fields_ = [("contacts", ctypes.c_int32), ("converged", ctypes.c_int32), ("left_out", ctypes.c_int32),
                ("miss", ctypes.c_double), ("impulse", ctypes.c_double * 3), ("energy", ctypes.c_double),
                ("touches", ctypes.c_double * 6 * 64)]


def compile_step(program, urdf, work):
    """A function of q, qd, tau that gives q, qd and the report after a step."""
    code = os.path.join(work, "code")
    with open(os.path.join(work, "drawn.urdf"), "w", encoding="utf-8") as file:
        file.write(urdf)
    with open(os.path.join(work, "scene.yaml"), "w", encoding="utf-8") as file:
        file.write("name: drawn\nbase: floating\nfunctions: []\nlanguage: c\n"
                   f"ground: {{friction: {FRICTION}, step: true}}\n")
    subprocess.run([os.path.abspath(program), "generate", "drawn.urdf", "scene.yaml", "--output", "code"], check=True,
                   capture_output=True, cwd=work)
    library = os.path.join(work, "step.so")
    sources = [os.path.join(code, name) for name in os.listdir(code) if name.endswith(".c")]
    subprocess.run(["gcc", "-std=c99", "-O1", "-ffp-contract=off", "-fPIC", "-shared", "-o", library, *sources],
                   check=True)
    step = ctypes.CDLL(library).drawn_ground_step
    step.restype, memory, friction = None, (ctypes.c_double * 256)(), ctypes.c_double(FRICTION)
    step.argtypes = [ctypes.c_void_p, ctypes.c_double, *[ctypes.c_void_p] * 5]

    def run(q, qd, tau):
        q, qd, report = q.copy(), qd.copy(), Report()
        step(ctypes.byref(friction), STEP, tau.ctypes.data, q.ctypes.data, qd.ctypes.data, memory, ctypes.byref(report))
        return q, qd, report

    return run


class Mechanics:
    """What Pinocchio and the shapes say of a state."""

    def __init__(self, urdf, shapes):
        self.model = pin.buildModelFromXML(urdf, pin.JointModelFreeFlyer())
        self.data, self.shapes = self.model.createData(), shapes

    def points(self, q):
        pin.framesForwardKinematics(self.model, self.data, q)
        frames = {name: self.data.oMf[self.model.getFrameId(name)] for name in self.shapes}
        return {name: [p for each in self.shapes[name] for p in each(pose)] for name, pose in frames.items()}

    def lowest(self, q):
        return min(p[2] for each in self.points(q).values() for p in each)

    def speed(self, q, qd, name, point):
        pin.forwardKinematics(self.model, self.data, q, qd)
        frame = self.model.getFrameId(name)
        v = pin.getFrameVelocity(self.model, self.data, frame, pin.LOCAL_WORLD_ALIGNED)
        origin = pin.updateFramePlacement(self.model, self.data, frame).translation
        return (v.linear + np.cross(v.angular, point - origin))[2]

    def energy(self, q, qd):
        return (pin.computeKineticEnergy(self.model, self.data, q, qd)
                + pin.computePotentialEnergy(self.model, self.data, q))

    def fly(self, q, qd, tau):
        qd = qd + STEP * pin.aba(self.model, self.data, q, qd, tau)
        flown = pin.integrate(self.model, q, STEP * qd)
        halfway = pin.Quaternion(q[3:7]).matrix() @ pin.exp3(STEP / 2 * qd[3:6])
        flown[:3] = q[:3] + STEP * halfway @ qd[:3]
        return flown, qd

    def impulse_on_base(self, q, change):
        """Linear, and angular about the base's origin; world axes."""
        mass = np.triu(pin.crba(self.model, self.data, q))
        mass = mass + np.triu(mass, 1).T
        linear, angular = (mass @ change)[:6].reshape(2, 3)
        rotation = pin.Quaternion(q[3:7]).matrix()
        return rotation @ linear, rotation @ angular

    def begin(self, rng):
        q = pin.neutral(self.model)
        q[3:7] = rng.normal(size=4)
        q[3:7] /= np.linalg.norm(q[3:7])
        q[7:] = rng.uniform(-1, 1, self.model.nq - 7)
        q[2] = 0.02 - self.lowest(q)
        return q, rng.normal(size=self.model.nv)


def misses(robot, before, flown, after, report):
    """By how much a step misses each law, in the order of their names."""
    impulse = np.array(report.impulse)
    linear, angular = robot.impulse_on_base(flown[0], after[1] - flown[1])
    touches = np.array(report.touches)[:report.contacts]
    moment = sum((np.cross(each[:3] - flown[0][:3], each[3:]) for each in touches), np.zeros(3))
    yield "impulse" if report.contacts else "flight", np.abs(linear - impulse).max()
    yield "touches", max(np.abs(touches[:, 3:].sum(axis=0) - impulse).max(), np.abs(angular - moment).max())
    yield "friction", np.hypot(*impulse[:2]) - FRICTION * impulse[2]
    most = max(robot.energy(*before), robot.energy(*flown))
    yield "energy", (robot.energy(*after) - most) / (1 + abs(most))
    yield "depth", -robot.lowest(after[0])
    for name, each in robot.points(flown[0]).items():
        deep = [p for p in each if p[2] < 0]
        for p in deep if len(deep) <= 4 and report.left_out == 0 else []:  # of more points not all count
            least = min(0.0, robot.speed(*flown, name, p) - p[2] / STEP)
            yield "speed", least - robot.speed(flown[0], after[1], name, p)


def judge(program, seed, work):
    os.makedirs(work, exist_ok=True)
    urdf, shapes = draw_robot(seed)
    robot, step, rng = Mechanics(urdf, shapes), compile_step(program, urdf, work), np.random.default_rng(seed)
    state, worst, pressed = robot.begin(rng), dict.fromkeys(MOST, 0.0), 0
    for _ in range(STEPS):
        q, qd = state
        tau = np.concatenate([np.zeros(6), -3 * q[7:] - 0.1 * qd[6:]])
        longer = q.copy()
        longer[3:7] *= np.exp(rng.normal())
        *after, report = step(longer, qd, tau)
        if not report.converged or not np.isfinite(after[0]).all():
            sys.exit(f"seed {seed}: a step does not converge")
        pressed += report.contacts
        for law, miss in misses(robot, state, robot.fly(q, qd, tau), after, report):
            worst[law] = max(worst[law], float(miss))
        state = after
    print(f"seed {seed}: {robot.model.nv} velocities, {pressed} pressed, "
          + ", ".join(f"{law} {miss:.1e}" for law, miss in worst.items()), flush=True)
    return pressed > 50 and all(worst[law] <= MOST[law] for law in MOST)


def main():
    arguments = argparse.ArgumentParser()
    arguments.add_argument("--treeline", required=True)
    arguments.add_argument("--work", required=True)
    arguments.add_argument("seeds", nargs="+", type=int)
    given = arguments.parse_args()
    good = [judge(given.treeline, seed, os.path.join(given.work, str(seed))) for seed in given.seeds]
    return 0 if all(good) else 1


if __name__ == "__main__":
    sys.exit(main())
