"""Objects that two hands hold: Newton's and Euler's equations of the object, welded to a judge's hands."""

import numpy as np

from conventions import rotation_from_quaternion
from expected import sized, terms
from robot_file import rotation_from_rpy
from rows import Point, place_yaml, rows_bias, rows_jacobian, skew
from scenes import rpy_of

FUNCTIONS = ["object_state", "object_control_torque", "object_forward_dynamics"]
GRAVITY = np.array([0, 0, -9.81])


class HeldObject:
    """A body of which each hand has the frame where the figures have the hands: its grasps are closed."""

    def __init__(self, case, figures, random):
        self.points = [Point(p.name, p.link, p.xyz, p.rpy, "world") for p in case.points]
        poses = [figures.pose(p.name) for p in self.points]
        self.mass, self.center = 3.0, random.uniform(-0.1, 0.1, 3)
        self.inertia = np.diag([0.05, 0.06, 0.07])
        origin = 0.5 * (poses[0][1] + poses[1][1])
        R = rotation_from_quaternion(*_unit(random.normal(size=4)))
        self.grasps = [(Rp.T @ (origin - p), rpy_of(Rp.T @ R)) for Rp, p in poses]

    def frame(self):
        """The object's frame as one on the first hand's link."""
        first, (xyz, rpy) = self.points[0], self.grasps[0]
        R = rotation_from_rpy(first.rpy)
        return first.link, first.xyz + R @ xyz, rpy_of(R @ rotation_from_rpy(rpy))

    def yaml(self, case):
        numbers = lambda values: "[" + ", ".join(repr(float(x)) for x in values) + "]"
        moments = ", ".join(f"{key}: {x}" for key, x in zip(("ixx", "iyy", "izz"), np.diag(self.inertia)))
        points = "".join(f"  - {point.yaml()}\n" for point in self.points)
        grasps = "".join(f"      - {{point: {point.name}, origin: {place_yaml(*grasp)}}}\n"
                         for point, grasp in zip(self.points, self.grasps))
        return (case.base_yaml() + "operational_points:\n" + points
                + f"objects:\n  - name: box\n    mass: {self.mass}\n    center: {numbers(self.center)}\n"
                + f"    inertia: {{{moments}}}\n    grasps:\n" + grasps)


def _unit(vector):
    return vector / np.linalg.norm(vector)


class ClosedChain:
    """Robot and object at one state: [M J^T 0; J 0 -C; 0 C^T -Lambda] (qdd, f, xdd) = what follows from velocities."""

    def __init__(self, f, case):
        held, n = case.object, f.T.shape[1]
        self.n = n
        self.M, self.h = f.mass_matrix(), f.nonlinear_effects()
        self.J, bias = rows_jacobian(f, held.points), rows_bias(f, held.points)
        R, self.origin = f.pose("object")
        twist = f.velocity("object")
        w, c = twist[3:], R @ held.center
        inertia = R @ held.inertia @ R.T
        self.arms = [f.pose(point.name)[1] - self.origin for point in held.points]
        self.axes = self._linkage_axes(R)
        self.C = np.vstack([np.block([[np.eye(3), -skew(r)], [np.zeros((3, 3)), np.eye(3)]]) for r in self.arms])
        turning = np.concatenate([np.concatenate([np.cross(w, np.cross(w, r)), np.zeros(3)]) for r in self.arms])
        m = held.mass
        self.Lambda = np.block([[m * np.eye(3), -m * skew(c)], [m * skew(c), inertia - m * skew(c) @ skew(c)]])
        about_origin = self.Lambda[3:, 3:]
        self.own = np.concatenate([m * np.cross(w, np.cross(w, c)) - m * GRAVITY,
                                   np.cross(w, about_origin @ w) - m * np.cross(c, GRAVITY)])
        self.matrix = np.block([[self.M, self.J.T, np.zeros((n, 6))],
                                [self.J, np.zeros((12, 12)), -self.C],
                                [np.zeros((6, n)), self.C.T, -self.Lambda]])
        self.known = np.concatenate([-self.h, turning - bias, self.own])

    def _linkage_axes(self, R):
        x = _unit(self.arms[1] - self.arms[0])
        up = R[:, 2] if abs(x @ R[:, 2]) <= 0.9 else R[:, 0]
        y = _unit(np.cross(up, x))
        return np.array([x, y, np.cross(x, y)])

    def solve(self, tau):
        """qdd, forces of the hands on the object, accelerations of the object, internal forces."""
        known = self.known.copy()
        known[:self.n] += tau
        found = np.linalg.solve(self.matrix, known)
        forces = found[self.n:self.n + 12]
        return found[:self.n], forces, found[self.n + 12:], self.internal(forces)

    def internal(self, forces):
        """Tension, torsion, and the moments across at each point, in the axes of the virtual linkage."""
        f1, m1, f2, m2 = (self.axes @ part for part in forces.reshape(4, 3))
        return np.array([(f2[0] - f1[0]) / 2, (m2[0] - m1[0]) / 2, m1[1], m1[2], m2[1], m2[2]])


def object_state(f, case, v):
    R, position = f.pose("object")
    return sized(position=position, rotation=R, velocity=f.velocity("object"), drift=np.zeros(6),
                 drift_rate=np.zeros(6))


def object_forward_dynamics(f, case, v):
    chain = ClosedChain(f, case)
    qdd, forces, xdd, internal = chain.solve(v["tau"])
    size = np.max(terms(np.abs(chain.M) @ np.abs(qdd), chain.h, np.abs(chain.J.T) @ np.abs(forces)))
    held = np.full(12, np.max(np.abs(forces)))
    return {"qdd": (qdd, np.full(len(qdd), size), chain.M), "f_grasp": (forces, held),
            "xdd_object": (xdd, np.max(np.abs(chain.Lambda @ xdd) + np.abs(chain.own)), chain.Lambda),
            "internal": (internal, held[:6])}


def object_control_torque(f, case, v):
    """What the object does under these torques."""
    chain = ClosedChain(f, case)
    size = np.max(np.abs(v["xdd_object"])) + np.max(np.abs(v["qdd_0"]))
    forces = np.max(np.abs(chain.own)) + np.max(np.abs(v["internal"]))
    return {"tau": [(lambda tau: chain.solve(tau)[2], v["xdd_object"], size),
                    (lambda tau: chain.solve(tau)[3], v["internal"], forces)]}


EXPECTED = {"object_state": object_state, "object_control_torque": object_control_torque,
            "object_forward_dynamics": object_forward_dynamics}
