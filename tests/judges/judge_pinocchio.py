"""Figures of Pinocchio, in Treeline's conventions (conventions.py)."""

import numpy as np
import pinocchio as pin

from conventions import Figures, JudgeJoint, JudgeState, Lacking, Unavailable
from robot_file import name_for_judges, plain_text, rotation_from_rpy
from rows import Loop

WORLD = pin.ReferenceFrame.LOCAL_WORLD_ALIGNED
OWN = pin.ReferenceFrame.LOCAL


def _kind(joint):
    name = joint.shortname()
    if name.startswith(("JointModelRUB", "JointModelRevoluteUnbounded")):
        return "cosine_sine"
    return {"JointModelFreeFlyer": "floating", "JointModelPlanar": "planar_cosine_sine"}.get(name, "single")


class Pinocchio:
    """A robot as Pinocchio reads it. `points` are frames on links: name -> (link, xyz, rpy)."""

    name = "pinocchio"

    def __init__(self, robot, floating, points, drives=None, gravity=(0, 0, -9.81)):
        self.floating = floating
        text = plain_text(robot, floating)
        base = (pin.JointModelFreeFlyer(), "base") if floating else ()
        if any(joint.type in ("ball", "spherical") for joint in robot.joints.values()):
            raise Unavailable("Pinocchio reads no ball joints")
        self.model = pin.buildModelFromXML(text, *base)
        self.joints = [JudgeJoint(name, _kind(joint), joint.idx_q, joint.idx_v)
                       for name, joint in list(zip(self.model.names, self.model.joints))[1:]]
        self.frames = {}
        for name, (link, xyz, rpy) in points.items():
            self.frames[name] = self._add_frame(name, name_for_judges(link, floating), xyz, rpy)
        self.link_joints = {frame.name: frame.parentJoint for frame in self.model.frames
                            if frame.type == pin.FrameType.BODY}
        if drives is not None:
            armature = self.model.armature
            for joint in self.joints:
                if joint.name in drives.armature:
                    armature[joint.at_v] = drives.armature[joint.name]
            self.model.armature = armature
        self.has_drives = drives is not None
        self.model.gravity.linear = np.array(gravity)
        self.data = self.model.createData()

    def _add_frame(self, name, link, xyz, rpy):
        parent = self.model.getFrameId(link, pin.FrameType.BODY)
        frame = self.model.frames[parent]
        placement = frame.placement * pin.SE3(rotation_from_rpy(rpy), np.array(xyz, dtype=float))
        return self.model.addFrame(
            pin.Frame("point " + name, frame.parentJoint, parent, placement, pin.FrameType.OP_FRAME))

    def at(self, freedoms, state):
        mapped = JudgeState(self.name, self.model.nq, self.model.nv, self.joints, freedoms, state)
        return PinocchioFigures(self, mapped)


class PinocchioFigures(Figures):
    """What Pinocchio computes at one state."""

    def __init__(self, judge, mapped):
        self.judge, self.model, self.data, self.s = judge, judge.model, judge.data, mapped
        self.T = mapped.T

    def mass_matrix(self):
        M = pin.crba(self.model, self.data, self.s.q)
        M = np.triu(M) + np.triu(M, 1).T
        return self.T.T @ M @ self.T

    def _without_friction_and_springs(self):
        """Pinocchio has rotors alone."""
        if self.judge.has_drives:
            raise Lacking()

    def inverse_dynamics(self):
        self._without_friction_and_springs()
        return self.T.T @ pin.rnea(self.model, self.data, self.s.q, self.s.v, self.s.a)

    def nonlinear_effects(self):
        self._without_friction_and_springs()
        return self.T.T @ pin.rnea(self.model, self.data, self.s.q, self.s.v, self.s.drift)

    def gravity(self):
        self._without_friction_and_springs()
        return self.T.T @ pin.computeGeneralizedGravity(self.model, self.data, self.s.q)

    def _is_renaming(self):
        """Whether T only puts velocities into another order."""
        square = self.T.shape[0] == self.T.shape[1]
        return self.s.constant and square and np.allclose(self.T @ self.T.T, np.eye(len(self.T)))

    def forward_dynamics(self, tau):
        if not self._is_renaming():
            raise Unavailable("articulated bodies of mimic joints")
        return self.T.T @ pin.aba(self.model, self.data, self.s.q, self.s.v, self.T @ tau)

    def constrained_acceleration(self, case, tau):
        """By its own constraints of points and frames, at velocities that keep them."""
        held = [(point.name, None, point.rows) for point in case.held]
        if not all(isinstance(loop, Loop) for loop in case.loops):
            raise Lacking()
        held += [(loop.first, loop.second, loop.rows) for loop in case.loops]
        whole = all(len(rows) == 6 or rows == ("x", "y", "z") for *_, rows in held)
        if case.couplings or not whole or not self._is_renaming():
            raise Lacking()
        constraints = pin.StdVec_RigidConstraintModel()
        for first, second, rows in held:
            kind = pin.ContactType.CONTACT_6D if len(rows) == 6 else pin.ContactType.CONTACT_3D
            one = self.model.frames[self.judge.frames[first]]
            other = () if second is None else (self.model.frames[self.judge.frames[second]],)
            ends = [part for frame in (one, *other) for part in (frame.parentJoint, frame.placement)]
            constraints.append(pin.RigidConstraintModel(kind, self.model, *ends, pin.ReferenceFrame.LOCAL))
        data = pin.StdVec_RigidConstraintData()
        data.extend([constraint.createData() for constraint in constraints])
        pin.initConstraintDynamics(self.model, self.data, constraints, data)
        settings = pin.ProximalSettings(1e-14, 0.0, 20)
        return self.T.T @ pin.constraintDynamics(self.model, self.data, self.s.q, self.s.v, self.T @ tau,
                                                 constraints, data, settings)

    def coriolis_symmetric_part(self):
        """C + C^T = dM/dt."""
        if not self.s.constant:
            raise Unavailable("velocities are others")
        C = self.T.T @ pin.computeCoriolisMatrix(self.model, self.data, self.s.q, self.s.v) @ self.T
        return C + C.T

    def pose(self, point):
        pin.framesForwardKinematics(self.model, self.data, self.s.q)
        pose = self.data.oMf[self.judge.frames[point]]
        return pose.rotation, pose.translation

    def jacobian(self, point):
        pin.computeJointJacobians(self.model, self.data, self.s.q)
        return pin.getFrameJacobian(self.model, self.data, self.judge.frames[point], WORLD) @ self.T

    def acceleration(self, point, with_qdd):
        pin.forwardKinematics(self.model, self.data, self.s.q, self.s.v, self.s.a if with_qdd else self.s.drift)
        return pin.getFrameClassicalAcceleration(self.model, self.data, self.judge.frames[point], WORLD).vector

    def velocity(self, point):
        pin.forwardKinematics(self.model, self.data, self.s.q, self.s.v)
        return pin.getFrameVelocity(self.model, self.data, self.judge.frames[point], WORLD).vector

    def kinetic_energy(self):
        if self.judge.has_drives:  # Pinocchio's own leaves out rotors of joints whose axis is not along x, y or z
            M = pin.crba(self.model, self.data, self.s.q)
            return 0.5 * self.s.v @ (np.triu(M) + np.triu(M, 1).T) @ self.s.v
        return pin.computeKineticEnergy(self.model, self.data, self.s.q, self.s.v)

    def potential_energy(self):
        """Matter that is fixed to the world counts too."""
        self._without_friction_and_springs()
        pin.framesForwardKinematics(self.model, self.data, self.s.q)
        fixed = self.model.inertias[0]
        return (pin.computePotentialEnergy(self.model, self.data, self.s.q)
                - fixed.mass * self.model.gravity.linear @ fixed.lever)

    def center_of_mass(self):
        com = pin.centerOfMass(self.model, self.data, self.s.q)
        return (self._moving_mass() * com + self._fixed_moment()) / self._mass()

    def center_of_mass_jacobian(self):
        J = pin.jacobianCenterOfMass(self.model, self.data, self.s.q)
        return J @ self.T * (self._moving_mass() / self._mass())

    def center_of_mass_bias(self):
        pin.centerOfMass(self.model, self.data, self.s.q, self.s.v, self.s.drift)
        return self.data.acom[0] * (self._moving_mass() / self._mass())

    def _fixed_moment(self):
        return self.model.inertias[0].mass * self.model.inertias[0].lever

    def _moving_mass(self):
        return sum(inertia.mass for inertia in self.model.inertias[1:])

    def _mass(self):
        return self._moving_mass() + self.model.inertias[0].mass

    def _to_own_center(self):
        """From Pinocchio's centre of mass, which leaves out what is fixed to the world, to that of everything."""
        center = pin.centerOfMass(self.model, self.data, self.s.q)
        return (self._moving_mass() * center + self._fixed_moment()) / self._mass() - center

    def _about_own_center(self, momentum):
        """Of columns: forces, or momenta, over moments."""
        moved = np.array(momentum)
        moved[3:] -= np.cross(self._to_own_center(), moved[:3], axisb=0).T.reshape(moved[3:].shape)
        return moved

    def momentum_matrix(self):
        return self._about_own_center(pin.computeCentroidalMap(self.model, self.data, self.s.q)) @ self.T

    def momentum_bias(self):
        """Both centres move along the momentum, so that the arm's rate has no moment."""
        pin.computeCentroidalMomentumTimeVariation(self.model, self.data, self.s.q, self.s.v, self.s.drift)
        return self._about_own_center(self.data.dhg.vector)

    def subtrees(self, links):
        """Masses and centres of mass of what joints carry."""
        pin.centerOfMass(self.model, self.data, self.s.q, True)
        joints = [self.judge.link_joints[name_for_judges(link, self.judge.floating)] for link in links]
        return (np.array([self.data.mass[j] for j in joints]),
                np.array([self.data.oMi[j].act(self.data.com[j]) for j in joints]))

    def _blocks(self, links):
        joints = [self.judge.link_joints[name_for_judges(link, self.judge.floating)] for link in links]
        return np.concatenate([np.arange(10 * (j - 1), 10 * j) for j in joints])

    def torque_regressor(self, links):
        Y = pin.computeJointTorqueRegressor(self.model, self.data, self.s.q, self.s.v, self.s.a)
        return self.T.T @ Y[:, self._blocks(links)]

    def energy_regressor(self, links):
        kinetic = pin.computeKineticEnergyRegressor(self.model, self.data, self.s.q, self.s.v)
        potential = pin.computePotentialEnergyRegressor(self.model, self.data, self.s.q)
        return np.array([np.asarray(kinetic).reshape(-1), np.asarray(potential).reshape(-1)])[:, self._blocks(links)]

    def _derivatives_by_constant_map(self):
        if not self.s.constant:
            raise Unavailable("velocities are others")

    def inverse_dynamics_derivatives(self, local_wrenches):
        """By q, qd, qdd. Wrenches act in the axes of frames: frame -> force over moment."""
        self._derivatives_by_constant_map()
        forces = [pin.Force.Zero() for _ in self.model.joints]
        for point, wrench in local_wrenches.items():
            frame = self.model.frames[self.judge.frames[point]]
            forces[frame.parentJoint] += frame.placement.act(pin.Force(np.array(wrench)))
        vector = pin.StdVec_Force()
        vector.extend(forces)
        pin.computeRNEADerivatives(self.model, self.data, self.s.q, self.s.v, self.s.a, vector)
        M = np.triu(self.data.M) + np.triu(self.data.M, 1).T
        return [self.T.T @ D @ self.T for D in (self.data.dtau_dq, self.data.dtau_dv, M)]

    def _momentum_derivatives(self):
        """Of h_G by q, and of its rate by q, qd, qdd. The arm between the centres turns with q."""
        self._derivatives_by_constant_map()
        found = pin.computeCentroidalDynamicsDerivatives(self.model, self.data, self.s.q, self.s.v, self.s.a)
        momentum, rate = self.data.hg.linear.copy(), self.data.dhg.linear.copy()
        derivatives = [self._about_own_center(D) for D in found]
        share = 1 - self._moving_mass() / self._mass()
        arm = share * pin.jacobianCenterOfMass(self.model, self.data, self.s.q)
        for D, force in zip(derivatives[:2], (momentum, rate)):
            D[3:] += np.cross(arm, force, axisa=0).T
        return [D @ self.T for D in derivatives]

    def momentum_by_displacements(self):
        return self._momentum_derivatives()[0]

    def momentum_rate_derivatives(self):
        return self._momentum_derivatives()[1:]

    def velocity_derivatives(self, point):
        self._derivatives_by_constant_map()
        pin.computeForwardKinematicsDerivatives(self.model, self.data, self.s.q, self.s.v, self.s.a)
        frame = self.model.frames[self.judge.frames[point]]
        linear = pin.getPointVelocityDerivatives(self.model, self.data, frame.parentJoint, frame.placement, WORLD)
        angular = pin.getFrameVelocityDerivatives(self.model, self.data, self.judge.frames[point], WORLD)
        return [np.vstack([l, a[3:]]) @ self.T for l, a in zip(linear, angular)]

    def acceleration_derivatives(self, point):
        """Of dv/dt at the origin, which is no spatial acceleration, and of dw/dt, by q, qd, qdd.

        The latter from the link's own axes: below a free joint that is not the base, Pinocchio's rows for the world's
        axes differ by a tenth and more from differences of its own accelerations."""
        self._derivatives_by_constant_map()
        pin.computeForwardKinematicsDerivatives(self.model, self.data, self.s.q, self.s.v, self.s.a)
        index = self.judge.frames[point]
        frame = self.model.frames[index]
        linear = pin.getPointClassicAccelerationDerivatives(
            self.model, self.data, frame.parentJoint, frame.placement, WORLD)[1:]
        own = [np.array(D) for D in pin.getFrameAccelerationDerivatives(self.model, self.data, index, OWN)[1:]]
        turns = pin.getFrameVelocityDerivatives(self.model, self.data, index, OWN)[1][3:]
        rate = pin.getFrameAcceleration(self.model, self.data, index, OWN).angular
        own[0][3:] += np.cross(turns, rate, axisa=0).T
        R = pin.updateFramePlacement(self.model, self.data, index).rotation
        return [np.vstack([l, R @ a[3:]]) @ self.T for l, a in zip(linear, own)]
