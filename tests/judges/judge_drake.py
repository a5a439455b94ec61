"""Figures of Drake's MultibodyPlant, in Treeline's conventions (conventions.py)."""

import logging
import re

import numpy as np
from pydrake.autodiffutils import AutoDiffXd, ExtractGradient, InitializeAutoDiff
from pydrake.math import RigidTransform, RotationMatrix
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import MultibodyPlant
from pydrake.multibody.tree import (FixedOffsetFrame, JacobianWrtVariable, MultibodyForces, MultibodyForces_,
                                    PrismaticJoint, PrismaticSpring, RevoluteJoint, RevoluteSpring, SpatialInertia,
                                    UnitInertia)

from conventions import Figures, JudgeJoint, JudgeState, State, Unavailable
from robot_file import inertials_of, name_for_judges, plain_text, rotation_from_rpy

logging.getLogger("drake").setLevel(logging.ERROR)

# Drake keeps moments of inertia per mass. Where there are moments without mass this is the mass: a power of two.
NO_MASS = 2.0 ** -100


def _with_ball_joints(text):
    """Drake has them under a name of its own."""
    ball = r'<joint\b([^>]*type="(?:ball|spherical)"[^>]*>.*?)</joint\s*>'
    named = lambda joint: "<drake:joint" + joint[1].replace("spherical", "ball") + "</drake:joint>"
    text = re.sub(ball, named, text, flags=re.S)
    if "<drake:" not in text or "xmlns:drake" in text:
        return text
    return re.sub(r"<robot\b", '<robot xmlns:drake="http://drake.mit.edu"', text, count=1)


class Drake:
    """A robot as Drake reads it. `points` are frames on links: name -> (link, xyz, rpy)."""

    name = "drake"

    def __init__(self, robot, floating, points, drives=None, gravity=(0, 0, -9.81)):
        self.floating = floating
        self.plant = MultibodyPlant(0.0)
        try:
            instance, = Parser(self.plant).AddModelsFromString(_with_ball_joints(plain_text(robot, floating)), "urdf")
        except RuntimeError as refusal:
            raise Unavailable(str(refusal).splitlines()[0]) from refusal
        self.root = name_for_judges(robot.root, floating)
        if not floating and self.root != "world":
            self.plant.WeldFrames(self.plant.world_frame(), self.plant.GetFrameByName(self.root))
        for name, (link, xyz, rpy) in points.items():
            pose = RigidTransform(RotationMatrix(rotation_from_rpy(rpy)), np.array(xyz, dtype=float))
            body = self.plant.GetBodyByName(name_for_judges(link, floating)) if (
                floating or link != "world") else self.plant.world_body()
            self.plant.AddFrame(FixedOffsetFrame("point " + name, body.body_frame(), pose))
        self.plant.mutable_gravity_field().set_gravity_vector(gravity)
        self._add_drives(drives)
        try:
            self.plant.Finalize()
        except RuntimeError as refusal:
            raise Unavailable(str(refusal).splitlines()[0]) from refusal
        self.instance = instance
        self.joints = self._list_joints(robot)
        self.context = self.plant.CreateDefaultContext()
        self._set_inertias(inertials_of(plain_text(robot, floating)))
        self.bodies = self.plant.GetBodyIndices(instance)

    def _add_drives(self, drives):
        if drives is None:
            return
        for index in self.plant.GetJointIndices():
            joint = self.plant.get_joint(index)
            name = joint.name()
            if name in drives.damping:
                joint.set_default_damping_vector([drives.damping[name]])
            if name in drives.armature:
                motor = self.plant.AddJointActuator("motor of " + name, joint)
                motor.set_default_rotor_inertia(drives.armature[name])
                motor.set_default_gear_ratio(1.0)
            stiffness, rest = drives.springs.get(name, (0, 0))
            if stiffness and isinstance(joint, RevoluteJoint):
                self.plant.AddForceElement(RevoluteSpring(joint, rest, stiffness))
            elif stiffness and isinstance(joint, PrismaticJoint):
                self.plant.AddForceElement(PrismaticSpring(joint, rest, stiffness))

    def _set_inertias(self, inertials):
        """Drake's reader changes inertias that no body has; its algorithms take any."""
        for link, inertial in inertials.items():
            if inertial.is_of_a_body() or (link == "world" and not self.floating):
                continue
            to_link = rotation_from_rpy(inertial.rpy) @ inertial.axes
            central = to_link @ np.diag(inertial.moments) @ to_link.T
            c, m = inertial.center, inertial.mass or NO_MASS
            unit = (central + m * (c @ c * np.eye(3) - np.outer(c, c))) / m
            self.plant.GetBodyByName(link).SetSpatialInertiaInBodyFrame(self.context, SpatialInertia(
                m, c, UnitInertia(unit[0, 0], unit[1, 1], unit[2, 2], unit[0, 1], unit[0, 2], unit[1, 2]),
                skip_validity_check=True))

    def _list_joints(self, robot):
        joints = []
        for index in self.plant.GetJointIndices():
            joint = self.plant.get_joint(index)
            if joint.num_velocities() == 0:
                continue
            kind = {1: "single", 3: "ball_angles", 6: "floating"}.get(joint.num_velocities())
            if joint.type_name() == "planar":
                raise Unavailable("planar joints")
            own = joint.name() if kind != "floating" else self._floating_name(robot, joint.child_body().name())
            joints.append(JudgeJoint(own, kind, joint.position_start(), joint.velocity_start()))
        return joints

    def _floating_name(self, robot, link):
        """Drake has a body behind a floating joint as free in the world."""
        if link == self.root:
            return "base"
        if self.floating or self.root != robot.joint_above[link].parent:
            raise Unavailable("a floating joint whose parent moves")
        return robot.joint_above[link].name

    def at(self, freedoms, state):
        return DrakeFigures(self, self._map(freedoms, state), freedoms, state)

    def _map(self, freedoms, state):
        return JudgeState(self.name, self.plant.num_positions(), self.plant.num_velocities(), self.joints,
                          freedoms, state)

    def differentiating(self):
        """The plant and a context in numbers that carry their derivatives."""
        if not hasattr(self, "_differentiating"):
            plant = self.plant.ToAutoDiffXd()
            context = plant.CreateDefaultContext()
            context.SetTimeStateAndParametersFrom(self.context)
            self._differentiating = plant, context
        return self._differentiating


class DrakeFigures(Figures):
    """What Drake computes at one state."""

    def __init__(self, judge, mapped, freedoms, state):
        self.judge, self.plant, self.context, self.s, self.T = judge, judge.plant, judge.context, mapped, mapped.T
        self.freedoms, self.state = freedoms, State(state.q, state.qd, state.qdd)
        self.plant.SetPositions(self.context, mapped.q)
        self.plant.SetVelocities(self.context, mapped.v)
        self.world = self.plant.world_frame()

    def mass_matrix(self):
        return self.T.T @ self.plant.CalcMassMatrix(self.context) @ self.T

    def _inverse(self, a):
        forces = MultibodyForces(self.plant)
        self.plant.CalcForceElementsContribution(self.context, forces)
        return self.T.T @ self.plant.CalcInverseDynamics(self.context, a, forces)

    def inverse_dynamics(self):
        return self._inverse(self.s.a)

    def nonlinear_effects(self):
        return self._inverse(self.s.drift)

    def gravity(self):
        self.plant.SetVelocities(self.context, 0 * self.s.v)
        g = self._inverse(0 * self.s.v)
        self.plant.SetVelocities(self.context, self.s.v)
        return g

    def forward_dynamics(self, tau):
        if self.T.shape[0] != self.T.shape[1]:
            raise Unavailable("mimic joints are constraints in Drake")
        port = self.plant.get_applied_generalized_force_input_port()
        port.FixValue(self.context, np.linalg.solve(self.T.T, tau))
        self._fix_actuation()
        try:
            rates = self.plant.EvalTimeDerivatives(self.context).CopyToVector()
        except RuntimeError as refusal:  # of links without mass
            raise Unavailable(str(refusal).splitlines()[0]) from refusal
        return np.linalg.solve(self.T, rates[self.plant.num_positions():] - self.s.drift)

    def _fix_actuation(self):
        if self.plant.num_actuators():
            self.plant.get_actuation_input_port().FixValue(self.context, np.zeros(self.plant.num_actuators()))

    def _frame(self, point):
        return self.plant.GetFrameByName("point " + point)

    def pose(self, point):
        pose = self._frame(point).CalcPoseInWorld(self.context)
        return pose.rotation().matrix(), pose.translation()

    def jacobian(self, point):
        J = self.plant.CalcJacobianSpatialVelocity(self.context, JacobianWrtVariable.kV, self._frame(point),
                                                   np.zeros(3), self.world, self.world)
        return np.vstack([J[3:], J[:3]]) @ self.T

    def velocity(self, point):
        twist = self._frame(point).CalcSpatialVelocityInWorld(self.context)
        return np.concatenate([twist.translational(), twist.rotational()])

    def acceleration(self, point, with_qdd):
        bias = self.plant.CalcBiasSpatialAcceleration(self.context, JacobianWrtVariable.kV, self._frame(point),
                                                      np.zeros(3), self.world, self.world)
        J = self.plant.CalcJacobianSpatialVelocity(self.context, JacobianWrtVariable.kV, self._frame(point),
                                                   np.zeros(3), self.world, self.world)
        a = J @ (self.s.a if with_qdd else self.s.drift)
        return np.concatenate([bias.translational() + a[3:], bias.rotational() + a[:3]])

    def kinetic_energy(self):
        return self.plant.CalcKineticEnergy(self.context)

    def potential_energy(self):
        return self.plant.CalcPotentialEnergy(self.context)

    def center_of_mass(self):
        return self.plant.CalcCenterOfMassPositionInWorld(self.context)

    def center_of_mass_jacobian(self):
        return self.plant.CalcJacobianCenterOfMassTranslationalVelocity(
            self.context, JacobianWrtVariable.kV, self.world, self.world) @ self.T

    def center_of_mass_bias(self):
        J = self.plant.CalcJacobianCenterOfMassTranslationalVelocity(
            self.context, JacobianWrtVariable.kV, self.world, self.world)
        return J @ self.s.drift + self.plant.CalcBiasCenterOfMassTranslationalAcceleration(
            self.context, JacobianWrtVariable.kV, self.world, self.world)

    def momentum_matrix(self):
        """By columns: the momentum at unit velocities."""
        columns = []
        for i in range(self.T.shape[1]):
            self.plant.SetVelocities(self.context, self.T[:, i])
            momentum = self.plant.CalcSpatialMomentumInWorldAboutPoint(self.context, self.center_of_mass())
            columns.append(np.concatenate([momentum.translational(), momentum.rotational()]))
        self.plant.SetVelocities(self.context, self.s.v)
        return np.array(columns).T

    def _differentiate(self, figure):
        """Derivatives of figure(plant, context, mapped state, T) by q, qd and qdd."""
        plant, context = self.judge.differentiating()
        n = self.freedoms.nv
        state = State(*(InitializeAutoDiff(value, gradient) for value, gradient in (
            (self.state.q, np.hstack([self.freedoms.displaced(self.state.q), np.zeros((self.freedoms.nq, 2 * n))])),
            (self.state.qd, np.hstack([np.zeros((n, n)), np.eye(n), np.zeros((n, n))])),
            (self.state.qdd, np.hstack([np.zeros((n, 2 * n)), np.eye(n)])))))
        for name in ("q", "qd", "qdd"):
            setattr(state, name, getattr(state, name).reshape(-1))
        mapped = self.judge._map(self.freedoms, state)
        numbers = lambda array: np.array([x if isinstance(x, AutoDiffXd) else AutoDiffXd(x) for x in array])
        plant.SetPositions(context, numbers(mapped.q))
        plant.SetVelocities(context, numbers(mapped.v))
        gradient = ExtractGradient(np.array(figure(plant, context, mapped, numbers)).reshape(-1, 1))
        if gradient.shape[1] == 0:
            gradient = np.zeros((gradient.shape[0], 3 * n))
        return [gradient[:, :n], gradient[:, n:2 * n], gradient[:, 2 * n:]]

    def inverse_dynamics_derivatives(self, local_wrenches):
        """By q, qd, qdd. Wrenches act in the axes of frames: frame -> force over moment."""
        def figure(plant, context, mapped, numbers):
            forces = MultibodyForces_[AutoDiffXd](plant)
            plant.CalcForceElementsContribution(context, forces)
            tau = plant.CalcInverseDynamics(context, numbers(mapped.a), forces)
            for point, wrench in local_wrenches.items():
                frame = plant.GetFrameByName("point " + point)
                J = plant.CalcJacobianSpatialVelocity(context, JacobianWrtVariable.kV, frame,
                                                      numbers(np.zeros(3)), plant.world_frame(), frame)
                tau = tau - J.T @ np.concatenate([wrench[3:], wrench[:3]])
            return mapped.T.T @ tau
        return self._differentiate(figure)

    def kinetic_energy_derivatives(self):
        return [D[0] for D in self._differentiate(
            lambda plant, context, mapped, numbers: [plant.CalcKineticEnergy(context)])[:2]]

    def _momentum(self, plant, context, mapped, numbers):
        momentum = plant.CalcSpatialMomentumInWorldAboutPoint(context, plant.CalcCenterOfMassPositionInWorld(context))
        return np.concatenate([momentum.translational(), momentum.rotational()])

    def momentum_by_displacements(self):
        return self._differentiate(self._momentum)[0]

    def momentum_bias(self):
        return self.momentum_by_displacements() @ self.state.qd

    def velocity_derivatives(self, point):
        def figure(plant, context, mapped, numbers):
            twist = plant.GetFrameByName("point " + point).CalcSpatialVelocityInWorld(context)
            return np.concatenate([twist.translational(), twist.rotational()])
        return self._differentiate(figure)[:2]

    def acceleration_derivatives(self, point):
        def figure(plant, context, mapped, numbers):
            frame, world = plant.GetFrameByName("point " + point), plant.world_frame()
            arguments = context, JacobianWrtVariable.kV, frame, numbers(np.zeros(3)), world, world
            bias = plant.CalcBiasSpatialAcceleration(*arguments)
            a = plant.CalcJacobianSpatialVelocity(*arguments) @ mapped.a
            return np.concatenate([bias.translational() + a[3:], bias.rotational() + a[:3]])
        return self._differentiate(figure)
