"""Compares MJCF as Treeline reads it with MuJoCo's own reading of the same file.

  judge_mjcf.py --treeline PROGRAM --work FOLDER MODEL.xml...

`treeline convert` makes a URDF of each model. MuJoCo reads both: masses, centres, inertias, frames at random states,
mass matrices, bias forces, limits, efforts, damping, friction and rotors must be the same, and so must followers and
the ends of loops be where the model's equalities have them. Geoms whose mesh is not beside the model are removed
before MuJoCo compiles it: they must have no mass. Exit status 1: something differs.
"""

import argparse
import collections
import os
import subprocess
import sys
import xml.etree.ElementTree as ET

import mujoco
import numpy as np

from judge_mujoco import Mujoco
from robot_file import RobotFile, rotation_from_rpy

STATES = 5
# Relative to the largest entry. MuJoCo diagonalises inertias and turns them back, and Treeline composes poses of links;
# both round at 1e-16 a few dozen times.
TOLERANCE = 1e-12


def unused(name, taken):
    while name in taken:
        name += "_"
    taken.add(name)
    return name


def name_all(spec):
    """Gives bodies and joints without a name those of the reference page (docs/reference/mjcf.md)."""
    bodies = {body.name for body in spec.bodies if body.name}
    joints = {joint.name for joint in spec.joints if joint.name}
    for body in spec.bodies[1:]:
        body.name = body.name or unused(body.parent.name + "_child", bodies)
        for joint in body.joints:
            joint.name = joint.name or unused(body.name + "_joint", joints)


def original(path):
    """MuJoCo's model of the file."""
    spec = mujoco.MjSpec.from_file(path)
    folder = os.path.join(os.path.dirname(path), spec.compiler.meshdir)
    missing = {mesh.name: mesh for mesh in spec.meshes if not os.path.exists(os.path.join(folder, mesh.file))}
    for geom in list(spec.geoms):
        if geom.meshname in missing:
            spec.delete(geom)
    for asset in [*missing.values(), *spec.skins]:
        spec.delete(asset)
    for material in spec.materials:
        material.textures = [""] * len(material.textures)
    for texture in list(spec.textures):
        spec.delete(texture)
    name_all(spec)
    spec.compiler.fusestatic = False
    return spec.compile()


def full_inertia(model, body):
    R = np.zeros(9)
    mujoco.mju_quat2Mat(R, model.body_iquat[body])
    R = R.reshape(3, 3)
    return R @ np.diag(model.body_inertia[body]) @ R.T


def width_of(model, joint):
    """Coordinates and velocities."""
    kinds = {int(mujoco.mjtJoint.mjJNT_FREE): (7, 6), int(mujoco.mjtJoint.mjJNT_BALL): (4, 3)}
    return kinds.get(int(model.jnt_type[joint]), (1, 1))


class Comparison:
    def __init__(self, treeline, path, work):
        self.urdf = os.path.join(work, os.path.basename(path).removesuffix(".xml") + ".urdf")
        run = subprocess.run([treeline, "convert", path, "--output", self.urdf, "--warnings", "all"],
                             capture_output=True, text=True, check=False)
        self.messages = run.stderr
        if run.returncode != 0:
            raise ValueError(run.stderr)
        self.ours = original(path)
        self.floats = bool(self.ours.njnt) and self.ours.jnt_type[0] == mujoco.mjtJoint.mjJNT_FREE
        self.robot = RobotFile(self.urdf)
        self.theirs = Mujoco(self.robot, self.floats, {}).model
        self.elements = {joint.get("name"): joint for joint in ET.parse(self.urdf).findall("joint")}
        self.errors = collections.defaultdict(float)
        for model in (self.ours, self.theirs):
            model.opt.disableflags |= mujoco.mjtDisableBit.mjDSBL_CONSTRAINT
        self.theirs.opt.gravity, self.theirs.opt.disableflags = self.ours.opt.gravity, self.ours.opt.disableflags

    def note(self, figure, ours, theirs, least=1e-6):
        """`least`: below that, errors count relative to it."""
        ours, theirs = np.asarray(ours, dtype=float), np.asarray(theirs, dtype=float)
        size = max(np.max(np.abs(ours), initial=0), least)
        error = np.max(np.abs(ours - theirs), initial=0) / size
        self.errors[figure] = max(self.errors[figure], error) if error == error else np.inf

    def run(self):
        names = [self.ours.body(b).name for b in range(self.ours.nbody)]
        theirs = {self.theirs.body(b).name: b for b in range(self.theirs.nbody)}
        # Mocap bodies, and what lies in the world of a floating robot, are no part of it: they have no joint.
        self.pairs = [(b, theirs[name]) for b, name in enumerate(names)
                      if b > 0 and (name in theirs or self.ours.body_mocapid[b] < 0 and self.ours.body_weldid[b] != 0)]
        self.compare_bodies()
        self.compare_joints()
        self.compare_equalities()
        mujoco.mj_setConst(self.theirs, mujoco.MjData(self.theirs))  # with rotors: it keeps M of simple bodies
        self.compare_motion(np.random.default_rng(7))

    def compare_bodies(self):
        for a, b in self.pairs:
            self.note("mass", self.ours.body_mass[a], self.theirs.body_mass[b])
            if self.ours.body_mass[a] > 0:
                self.note("center", self.ours.body_ipos[a], self.theirs.body_ipos[b], 1e-3)
                self.note("inertia", full_inertia(self.ours, a), full_inertia(self.theirs, b))

    def compare_joints(self):
        for j in range(self.ours.njnt):
            name = self.ours.joint(j).name
            if width_of(self.ours, j) != (1, 1):
                continue
            element, dof = self.elements[name], self.ours.jnt_dofadr[j]
            limit, dynamics = element.find("limit"), element.find("dynamics")
            stated = lambda key: 0.0 if dynamics is None else float(dynamics.get(key, 0))
            if self.ours.jnt_limited[j]:
                self.note("range", self.ours.jnt_range[j], [float(limit.get("lower")), float(limit.get("upper"))])
            self.note("damping", self.ours.dof_damping[dof], stated("damping"))
            self.note("friction", self.ours.dof_frictionloss[dof], stated("friction"))
            m = self.ours
            motors = sum(m.actuator_armature[u] * m.actuator_gear[u, 0] ** 2 for u in self.motors_of(j))
            self.note("armature", m.dof_armature[dof] + motors, stated("armature"))
            self.theirs.dof_armature[self.theirs.joint(name).dofadr[0]] = stated("armature")
            self.note("effort", min(self.effort_of(j), 1e9), min(float(limit.get("effort")), 1e9))

    def compare_equalities(self):
        """Where followers are by MuJoCo's polynomial, and where its anchors are in bodies."""
        loops = {loop.get("name"): loop for loop in ET.parse(self.urdf).findall("loop_joint")}
        taken = set()
        for e in range(self.ours.neq):
            kind, data = int(self.ours.eq_type[e]), self.ours.eq_data[e]
            if not self.ours.eq_active0[e]:
                continue
            if kind == int(mujoco.mjtEq.mjEQ_JOINT) and self.ours.eq_obj2id[e] >= 0:
                follower, leader = (self.ours.joint(i) for i in (self.ours.eq_obj1id[e], self.ours.eq_obj2id[e]))
                joint = self.robot.joints[follower.name]
                for x in (-0.7, 0.4):
                    y = follower.qpos0[0] + np.polyval(data[4::-1], x - leader.qpos0[0])
                    self.note("followers", y, joint.multiplier * x + joint.offset)
            elif kind in (int(mujoco.mjtEq.mjEQ_CONNECT), int(mujoco.mjtEq.mjEQ_WELD)):
                loop = loops[unused(self.ours.equality(e).name or ("connect" if kind == 0 else "weld"), taken)]
                ends = [self.pose_of(loop.find(end)) for end in ("link1", "link2")]
                if kind == int(mujoco.mjtEq.mjEQ_CONNECT):
                    if self.ours.eq_objtype[e] == mujoco.mjtObj.mjOBJ_SITE:
                        sites = (self.ours.eq_obj1id[e], self.ours.eq_obj2id[e])
                        data = np.concatenate([self.ours.site_pos[site] for site in sites])
                    self.note("anchors", data[:6], np.concatenate([p for _, p in ends]))
                else:
                    R, quaternion = np.zeros(9), data[6:10]
                    mujoco.mju_quat2Mat(R, quaternion)
                    (R1, p1), (R2, p2) = ends
                    self.note("welds", R.reshape(3, 3), R1 @ R2.T)
                    self.note("welds", data[3:6], p1 - R1 @ R2.T @ p2 + R1 @ R2.T @ data[:3])

    @staticmethod
    def pose_of(end):
        numbers = lambda key: np.array(end.get(key).split(), dtype=float)
        return rotation_from_rpy(numbers("rpy")), numbers("xyz")

    def motors_of(self, j):
        m, of_joints = self.ours, (int(mujoco.mjtTrn.mjTRN_JOINT), int(mujoco.mjtTrn.mjTRN_JOINTINPARENT))
        return [u for u in range(m.nu) if int(m.actuator_trntype[u]) in of_joints and m.actuator_trnid[u, 0] == j]

    def effort_of(self, j):
        """The least that its motors can do either way, at the ends of their controls."""
        m, drives = self.ours, []
        # Of ends that differ the smaller one; of an actuator that acts one way the other.
        least = lambda ends: np.min(ends) or np.max(ends)
        bound = lambda limited, ends: least(np.abs(ends)) if limited else np.inf
        for u in self.motors_of(j):
            force = bound(m.actuator_forcelimited[u], m.actuator_forcerange[u])
            if m.actuator_plugin[u] >= 0:
                drives.append(abs(m.actuator_gear[u, 0]) * force)
                continue
            kind = (m.actuator_gaintype[u], m.actuator_biastype[u], m.actuator_dyntype[u])
            if tuple(map(int, kind)) == (int(mujoco.mjtGain.mjGAIN_FIXED), int(mujoco.mjtBias.mjBIAS_NONE),
                                         int(mujoco.mjtDyn.mjDYN_NONE)):
                force = min(force, m.actuator_gainprm[u, 0] * bound(m.actuator_ctrllimited[u], m.actuator_ctrlrange[u]))
            drives.append(abs(m.actuator_gear[u, 0]) * force)
        together = sum(drives) if drives else np.inf
        return min(together, bound(m.jnt_actfrclimited[j], m.jnt_actfrcrange[j]))

    def compare_motion(self, random):
        ours, theirs = mujoco.MjData(self.ours), mujoco.MjData(self.theirs)
        columns = []
        for j in range(self.ours.njnt):
            name = self.ours.joint(j).name
            k = self.theirs.joint("base" if self.floats and j == 0 else name).id
            columns.append((j, k))
        order = np.concatenate([self.theirs.jnt_dofadr[k] + np.arange(width_of(self.ours, j)[1]) for j, k in columns])
        for _ in range(STATES):
            ours.qpos[:] = random.uniform(-1, 1, self.ours.nq)
            ours.qvel[:] = random.uniform(-2, 2, self.ours.nv)
            mujoco.mj_normalizeQuat(self.ours, ours.qpos)
            for j, k in columns:
                size = width_of(self.ours, j)[0]
                a, b = self.ours.jnt_qposadr[j], self.theirs.jnt_qposadr[k]
                theirs.qpos[b:b + size] = ours.qpos[a:a + size]
            theirs.qvel[order] = ours.qvel
            mujoco.mj_forward(self.ours, ours)
            mujoco.mj_forward(self.theirs, theirs)
            for a, b in self.pairs:
                self.note("place", ours.xpos[a], theirs.xpos[b])
                self.note("rotation", ours.xmat[a], theirs.xmat[b])
            M = [np.zeros((model.nv, model.nv)) for model in (self.ours, self.theirs)]
            mujoco.mj_fullM(self.ours, ours, M[0])
            mujoco.mj_fullM(self.theirs, theirs, M[1])
            self.note("mass matrix", M[0], M[1][np.ix_(order, order)])
            self.note("bias force", ours.qfrc_bias, theirs.qfrc_bias[order],
                      1e-2 * np.max(np.abs(M[0])))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--treeline", required=True)
    parser.add_argument("--work", required=True)
    parser.add_argument("model", nargs="+")
    given = parser.parse_args()
    os.makedirs(given.work, exist_ok=True)
    faults = 0
    for path in given.model:
        comparison = Comparison(given.treeline, path, given.work)
        comparison.run()
        worst = {figure: error for figure, error in comparison.errors.items() if not error <= TOLERANCE}
        print(f"{os.path.basename(path)}: " + ", ".join(f"{figure} {error:.1e}"
                                                        for figure, error in comparison.errors.items()))
        for figure, error in worst.items():
            print(f"  {figure} differs by {error:.2g}")
        faults += len(worst)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
