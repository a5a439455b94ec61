"""All frames and conventions of the judges, and how they become Treeline's.

              coordinates of a floating base       velocities of a floating base
  Treeline    p, quaternion x y z w                linear over angular, both in the link's own axes
  Pinocchio   p, quaternion x y z w                linear over angular, both in the link's own axes
  MuJoCo      p, quaternion w x y z                linear in the parent's axes, angular in the link's own
  Drake       quaternion w x y z, p                angular over linear, both in the parent's axes

              coordinates of a ball joint          velocities of a ball joint
  Treeline    quaternion x y z w                   angular, in the link's own axes
  MuJoCo      quaternion w x y z                   angular, in the link's own axes
  Drake       roll, pitch, yaw                     angular, in the parent's axes

  Pinocchio reads no ball joints. It has cosine and sine of continuous joints as
  coordinates, and of planar ones, whose velocities are in the child's axes; Treeline has x, y and the angle.
  Mimic joints are independent for all judges (robot_file.py); Treeline has the leader's coordinate alone.
  Joints are matched by name: every program has its own order.

  Frames: rows `axes: world` are Pinocchio's LOCAL_WORLD_ALIGNED, rows `axes: local` its LOCAL, in which the
  derivative of R^T v is R^T a - w x R^T v. Accelerations are those of the origin, dv/dt, not spatial ones.
  Derivatives by q are by displacements in the velocities' coordinates, as Pinocchio's tangent space.

So a judge's velocities are T(q) qd, its accelerations T qdd + dT/dt qd, and joint forces come back by T^T.
"""

import copy

import numpy as np

from robot_file import RobotFile, range_of


class Unavailable(Exception):
    """The judge cannot compute this figure of this robot or state. Says why."""


class Undetermined(Exception):
    """At this state the result has no one value, or yields: nothing is to be compared."""


class Lacking(Exception):
    """The judge has no such figure of any robot."""


class Figures:
    """What not every judge has."""

    def _lacking(self, *_):
        raise Lacking()

    coriolis_symmetric_part = center_of_mass_bias = momentum_bias = subtrees = _lacking
    torque_regressor = energy_regressor = inverse_dynamics_derivatives = kinetic_energy_derivatives = _lacking
    momentum_by_displacements = momentum_rate_derivatives = _lacking
    constrained_acceleration = velocity_derivatives = acceleration_derivatives = _lacking


class JudgeJoint:
    """A joint as the judge lists it.

    `kind` is one of single, cosine_sine, planar_cosine_sine, floating, ball, ball_angles."""

    def __init__(self, name, kind, at_q, at_v):
        self.name, self.kind, self.at_q, self.at_v = name, kind, at_q, at_v


class State:
    """Arguments of functions, in Treeline's conventions."""

    def __init__(self, q, qd, qdd):
        self.q, self.qd, self.qdd = q, qd, qdd


class Freedoms:
    """Where joints are in the emitted code's q and qd. The base is called `base`."""

    def __init__(self, robot: RobotFile, coordinate_joints, velocity_joints):
        self.robot = robot
        self.nq, self.nv = len(coordinate_joints), len(velocity_joints)
        self.at_q, self.at_v = {}, {}
        for i, name in enumerate(coordinate_joints):
            self.at_q.setdefault(name, i)
        for i, name in enumerate(velocity_joints):
            self.at_v.setdefault(name, i)

    def of(self, robot):
        """Of another robot with these coordinates."""
        other = copy.copy(self)
        other.robot = robot
        return other

    def is_floating(self, name):
        return name not in self.robot.joints or self.robot.joints[name].type == "floating"

    def is_ball(self, name):
        return name in self.robot.joints and self.robot.joints[name].type in ("ball", "spherical")

    def draw(self, random):
        """A state within the limits of the file, at ordinary speeds."""
        q = np.zeros(self.nq)
        for name, at in self.at_q.items():
            if self.is_floating(name):
                turn = random.normal(size=4)
                q[at:at + 7] = np.concatenate([random.uniform(-1, 1, 3), turn / np.linalg.norm(turn)])
            elif self.is_ball(name):
                turn = random.normal(size=4)
                q[at:at + 4] = turn / np.linalg.norm(turn)
            elif self.robot.joints[name].type == "planar":
                q[at:at + 3] = random.uniform(-1, 1, 3)
            else:
                q[at] = random.uniform(*range_of(self.robot.joints[name]))
        return State(q, random.uniform(-3, 3, self.nv), random.uniform(-10, 10, self.nv))

    def _quaternions(self):
        """Where they begin in q."""
        for name, at in self.at_q.items():
            if self.is_floating(name):
                yield at + 3
            elif self.is_ball(name):
                yield at

    def normalized(self, q):
        q = np.array(q)
        for at in self._quaternions():
            q[at:at + 4] /= np.linalg.norm(q[at:at + 4])
        return q

    def near_home(self, q, share):
        """Coordinates shortened by so much, and turns about as much."""
        q = share * q
        for at in self._quaternions():
            q[at + 3] = 1
        return self.normalized(q)

    def displaced(self, q):
        """dq / d(displacement), nq x nv: displacements are in the velocities' coordinates."""
        rates = np.zeros((self.nq, self.nv))
        for name, at in self.at_q.items():
            v = self.at_v[name]
            if self.is_floating(name):
                rates[at:at + 3, v:v + 3] = rotation_from_quaternion(*q[at + 3:at + 7])
                rates[at + 3:at + 7, v + 3:v + 6] = turned_quaternion(*q[at + 3:at + 7])
            elif self.is_ball(name):
                rates[at:at + 4, v:v + 3] = turned_quaternion(*q[at:at + 4])
            else:
                size = 3 if self.robot.joints[name].type == "planar" else 1
                rates[at:at + size, v:v + size] = np.eye(size)
        return rates


def turned_quaternion(x, y, z, w):
    """Its rates by angular velocities in the turned axes."""
    return 0.5 * np.array([[w, -z, y], [z, w, -x], [-y, x, w], [-x, -y, -z]])


def cross(a, b):
    return np.array([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])


def rotation_from_quaternion(x, y, z, w):
    return np.array([[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
                     [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
                     [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]])


class JudgeState:
    """A state in a judge's conventions: q, v = T qd, and drift = dT/dt qd."""

    def __init__(self, library, nq, nv, joints, freedoms, state):
        number = np.result_type(state.q)  # or objects that differentiate
        self.q, self.T, self.drift = (np.zeros(shape, number) for shape in (nq, (nv, freedoms.nv), nv))
        self.constant = True  # whether T is constant
        for joint in joints:
            if freedoms.is_floating(joint.name):
                self._set_floating(library, joint, freedoms, state)
            elif joint.kind in ("ball", "ball_angles"):
                self._set_ball(joint, freedoms, state)
            elif joint.kind == "planar_cosine_sine":
                self._set_planar(joint, freedoms, state)
            else:
                self._set_single(joint, freedoms, state)
        self.v = self.T @ state.qd
        self.a = self.T @ state.qdd + self.drift

    def _set_single(self, joint, freedoms, state):
        leader, factor, offset = freedoms.robot.leader_of(freedoms.robot.joints[joint.name])
        value = factor * state.q[freedoms.at_q[leader.name]] + offset
        if joint.kind == "cosine_sine":
            self.q[joint.at_q:joint.at_q + 2] = np.cos(value), np.sin(value)
        else:
            self.q[joint.at_q] = value
        self.T[joint.at_v, freedoms.at_v[leader.name]] = factor

    def _set_planar(self, joint, freedoms, state):
        at_q, at_v = freedoms.at_q[joint.name], freedoms.at_v[joint.name]
        x, y, angle = state.q[at_q:at_q + 3]
        c, s = np.cos(angle), np.sin(angle)
        self.q[joint.at_q:joint.at_q + 4] = x, y, c, s
        to_child = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]])
        rate = state.qd[at_v + 2] * np.array([[-s, c, 0], [-c, -s, 0], [0, 0, 0]])
        self.T[joint.at_v:joint.at_v + 3, at_v:at_v + 3] = to_child
        self.drift[joint.at_v:joint.at_v + 3] = rate @ state.qd[at_v:at_v + 3]
        self.constant = False

    def _set_ball(self, joint, freedoms, state):
        at_q, at_v = freedoms.at_q[joint.name], freedoms.at_v[joint.name]
        x, y, z, w = state.q[at_q:at_q + 4]
        block = np.eye(3)
        if joint.kind == "ball":
            self.q[joint.at_q:joint.at_q + 4] = w, x, y, z
        else:
            from pydrake.math import atan2, sqrt  # of floats and of numbers with derivatives
            block = rotation_from_quaternion(x, y, z, w)
            self.q[joint.at_q:joint.at_q + 3] = (
                atan2(block[2, 1], block[2, 2]),
                atan2(-block[2, 0], sqrt(block[2, 1] * block[2, 1] + block[2, 2] * block[2, 2])),
                atan2(block[1, 0], block[0, 0]))
            self.constant = False
        self.T[joint.at_v:joint.at_v + 3, at_v:at_v + 3] = block

    def _set_floating(self, library, joint, freedoms, state):
        at_q, at_v = freedoms.at_q[joint.name], freedoms.at_v[joint.name]
        p, (x, y, z, w) = state.q[at_q:at_q + 3], state.q[at_q + 3:at_q + 7]
        linear, angular = state.qd[at_v:at_v + 3], state.qd[at_v + 3:at_v + 6]
        R = rotation_from_quaternion(x, y, z, w)
        turned = R @ cross(angular, linear)
        quaternion = (x, y, z, w) if library == "pinocchio" else (w, x, y, z)
        pose = [quaternion, p] if library == "drake" else [p, quaternion]
        self.q[joint.at_q:joint.at_q + 7] = np.concatenate(pose)
        rows = {"pinocchio": [(0, np.eye(3), 0), (3, np.eye(3), 3)],
                "mujoco": [(0, R, 0), (3, np.eye(3), 3)],
                "drake": [(0, R, 3), (3, R, 0)]}[library]
        for row, block, column in rows:
            self.T[joint.at_v + row:joint.at_v + row + 3, at_v + column:at_v + column + 3] = block
        if library != "pinocchio":
            at = joint.at_v + (3 if library == "drake" else 0)
            self.drift[at:at + 3] = turned
            self.constant = False
