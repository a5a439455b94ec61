"""Figures of MuJoCo, in Treeline's conventions (conventions.py)."""

import re

import mujoco
import numpy as np

from conventions import Figures, JudgeJoint, JudgeState, Unavailable
from robot_file import inertials_of, name_for_judges, plain_text, rotation_from_rpy

mujoco.set_mju_user_warning(lambda message: None)  # else also a file in the working directory

# Lopsided, so that MuJoCo's compiler takes no short cut that only holds for simpler bodies.
PLACEHOLDER = ('<inertial><origin xyz="0.1 0.2 0.3" rpy="0.4 0.5 0.6"/><mass value="1"/>'
               '<inertia ixx="1" ixy="0.1" ixz="0.2" iyy="1.2" iyz="0.3" izz="1.4"/></inertial>')


def _replace_refused(text):
    """MuJoCo's compiler refuses inertias that no body has; its algorithms take any. They are set afterwards."""
    inertials = inertials_of(text)
    replaced = {}

    def replace(match):
        name = re.search(r'\bname\s*=\s*["\']([^"\']*)', match[0])[1]
        if name == "world" or inertials[name].is_of_a_body():
            return match[0]
        replaced[name] = inertials[name]
        return f'<link name="{name}">{PLACEHOLDER}</link>'

    return re.sub(r"<link\b[^>]*?/>|<link\b[^>]*>.*?</link\s*>", replace, text, flags=re.S), replaced


class Mujoco:
    """A robot as MuJoCo reads it. `points` are frames on links: name -> (link, xyz, rpy)."""

    name = "mujoco"

    def __init__(self, robot, floating, points, drives=None, gravity=(0, 0, -9.81)):
        self.floating = floating
        text, replaced = _replace_refused(plain_text(robot, floating))
        text = re.sub(r'type="ball"', 'type="spherical"', text)
        head = '<mujoco><compiler fusestatic="false" inertiafromgeom="false"/></mujoco>'
        if floating:
            head += ('<link name="world"/><joint name="base" type="floating"><parent link="world"/>'
                     f'<child link="{name_for_judges(robot.root, True)}"/></joint>')
        text = re.sub(r"<robot\b[^>]*>", lambda tag: tag[0] + head, text, count=1)
        try:
            spec = mujoco.MjSpec.from_string(text)
            for name, (link, xyz, rpy) in points.items():
                quaternion = np.zeros(4)
                mujoco.mju_mat2Quat(quaternion, rotation_from_rpy(rpy).reshape(-1))
                body = (spec.body(name_for_judges(link, floating))
                        or (spec.worldbody if link == robot.root else None))
                body.add_site(name="point " + name, pos=xyz, quat=quaternion)
            self.model = spec.compile()
        except (ValueError, mujoco.FatalError) as refusal:
            raise Unavailable(str(refusal).splitlines()[0]) from refusal
        self._set_inertias(replaced)
        self.model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
        kinds = {mujoco.mjtJoint.mjJNT_FREE: "floating", mujoco.mjtJoint.mjJNT_BALL: "ball"}
        kind_of = lambda i: kinds.get(mujoco.mjtJoint(self.model.jnt_type[i]), "single")
        self.joints = [JudgeJoint(self.model.joint(i).name, kind_of(i),
                                  self.model.jnt_qposadr[i], self.model.jnt_dofadr[i])
                       for i in range(self.model.njnt)]
        self.model.opt.gravity[:] = gravity
        self.set_drives(drives)
        self.data = mujoco.MjData(self.model)

    def set_drives(self, drives):
        if drives is None:
            return
        for i, joint in enumerate(self.joints):
            self.model.dof_armature[joint.at_v] = drives.armature.get(joint.name, 0)
            self.model.dof_damping[joint.at_v] = drives.damping.get(joint.name, 0)
            self.model.jnt_stiffness[i], self.model.qpos_spring[joint.at_q] = drives.springs.get(joint.name, (0, 0))

    def _set_inertias(self, replaced):
        model = self.model
        for link, inertial in replaced.items():
            try:
                body = model.body(link).id
            except KeyError:  # the root of a fixed base, which MuJoCo has as the world
                continue
            model.body_mass[body], model.body_ipos[body] = inertial.mass, inertial.center
            model.body_inertia[body] = inertial.moments
            mujoco.mju_mat2Quat(model.body_iquat[body], (rotation_from_rpy(inertial.rpy) @ inertial.axes).reshape(-1))
        model.body_subtreemass[:] = model.body_mass
        for body in range(model.nbody - 1, 0, -1):
            model.body_subtreemass[model.body_parentid[body]] += model.body_subtreemass[body]

    def at(self, freedoms, state):
        mapped = JudgeState(self.name, self.model.nq, self.model.nv, self.joints, freedoms, state)
        return MujocoFigures(self, mapped)


class MujocoFigures(Figures):
    """What MuJoCo computes at one state."""

    def __init__(self, judge, mapped):
        self.judge, self.model, self.data, self.s, self.T = judge, judge.model, judge.data, mapped, mapped.T
        self.data.qpos[:], self.data.qvel[:] = mapped.q, mapped.v
        mujoco.mj_fwdPosition(self.model, self.data)
        mujoco.mj_fwdVelocity(self.model, self.data)

    def _full(self):
        M = np.zeros((self.model.nv, self.model.nv))
        mujoco.mj_fullM(self.model, self.data, M)
        return M

    def mass_matrix(self):
        return self.T.T @ self._full() @ self.T

    def _inverse(self, a):
        self.data.qacc[:] = a
        mujoco.mj_inverse(self.model, self.data)
        return self.T.T @ self.data.qfrc_inverse

    def inverse_dynamics(self):
        return self._inverse(self.s.a)

    def nonlinear_effects(self):
        return self._inverse(self.s.drift)

    def gravity(self):
        self.data.qvel[:] = 0
        mujoco.mj_fwdVelocity(self.model, self.data)
        g = self._inverse(np.zeros(self.model.nv))
        self.data.qvel[:] = self.s.v
        mujoco.mj_fwdVelocity(self.model, self.data)
        return g

    def forward_dynamics(self, tau):
        if self.T.shape[0] != self.T.shape[1]:
            raise Unavailable("mimic joints are constraints in MuJoCo")
        self.data.qfrc_applied[:] = np.linalg.solve(self.T.T, tau)
        mujoco.mj_forward(self.model, self.data)
        self.data.qfrc_applied[:] = 0
        warning = self.data.warning[mujoco.mjtWarning.mjWARN_INERTIA]
        if warning.number > 0:
            warning.number = 0
            raise Unavailable("MuJoCo takes the inertia matrix for singular")
        return np.linalg.solve(self.T, self.data.qacc - self.s.drift)

    def _site(self, point):
        return self.model.site("point " + point).id

    def pose(self, point):
        site = self._site(point)
        return self.data.site_xmat[site].reshape(3, 3).copy(), self.data.site_xpos[site].copy()

    def jacobian(self, point):
        linear, angular = np.zeros((3, self.model.nv)), np.zeros((3, self.model.nv))
        mujoco.mj_jacSite(self.model, self.data, linear, angular, self._site(point))
        return np.vstack([linear, angular]) @ self.T

    def velocity(self, point):
        six = np.zeros(6)
        mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_SITE, self._site(point), six, 0)
        return np.concatenate([six[3:], six[:3]])

    def acceleration(self, point, with_qdd):
        """MuJoCo's acceleration is felt: without gravity for what cannot move, else with it."""
        self.data.qacc[:] = self.s.a if with_qdd else self.s.drift
        mujoco.mj_rnePostConstraint(self.model, self.data)
        six, site = np.zeros(6), self._site(point)
        mujoco.mj_objectAcceleration(self.model, self.data, mujoco.mjtObj.mjOBJ_SITE, site, six, 0)
        if self.model.body_weldid[self.model.site_bodyid[site]] != 0:
            six[3:] += self.model.opt.gravity
        return np.concatenate([six[3:], six[:3]])

    def kinetic_energy(self):
        mujoco.mj_energyVel(self.model, self.data)
        return self.data.energy[1]

    def potential_energy(self):
        mujoco.mj_energyPos(self.model, self.data)
        return self.data.energy[0]

    def center_of_mass(self):
        return self.data.subtree_com[0].copy()

    def center_of_mass_jacobian(self):
        J = np.zeros((3, self.model.nv))
        mujoco.mj_jacSubtreeCom(self.model, self.data, J, 0)
        return J @ self.T

    def center_of_mass_bias(self):
        """The mean over the masses of what bodies feel, see `acceleration`."""
        self.data.qacc[:] = self.s.drift
        mujoco.mj_rnePostConstraint(self.model, self.data)
        six, total = np.zeros(6), np.zeros(3)
        for body in np.flatnonzero(self.model.body_weldid):
            mujoco.mj_objectAcceleration(self.model, self.data, mujoco.mjtObj.mjOBJ_BODY, body, six, 0)
            total += self.model.body_mass[body] * (six[3:] + self.model.opt.gravity)
        return total / self.model.body_subtreemass[0]

    def momentum_matrix(self):
        A = np.zeros((3, self.model.nv))
        mujoco.mj_angmomMat(self.model, self.data, A, 0)
        linear = self.model.body_subtreemass[0] * self.center_of_mass_jacobian()
        return np.vstack([linear, A @ self.T])

    def subtrees(self, links):
        bodies = [self.model.body(name_for_judges(link, self.judge.floating)).id for link in links]
        return self.model.body_subtreemass[bodies].copy(), self.data.subtree_com[bodies].copy()
