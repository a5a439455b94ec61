"""Compares rotors and friction of joints that follow others with Pinocchio.

  followers.py --treeline PROGRAM --work FOLDER

Of one scene, `inverse_dynamics`, the regressor times the parameters that the scene states, the base regressor times the
values that `inspect` tells, and `inverse_dynamics` with these values as its argument are one torque: that of
Pinocchio's inverse dynamics of the open tree, plus rotor and friction of each joint at its own rate. Exit status 1:
one is another.
"""

import argparse
import json
import os
import re
import subprocess
import sys

import numpy as np

from conventions import Freedoms
from emitted import Emitted
from judge_pinocchio import Pinocchio
from report import TOLERANCE
from robot_file import RobotFile

STATES = 4
WIDTH = 0.2
# Joint: type, parent, x of its origin, axis, and what it follows, how many times and with which offset.
JOINTS = {
    "turn": ("continuous", "base", 0.0, "0 0 1", None),
    "geared": ("continuous", "turn", 0.4, "0 1 0", ("turn", -2, 0.3)),
    "rack": ("prismatic", "geared", 0.3, "1 0 0", ("geared", -0.25, 0.1)),
    "elbow": ("revolute", "rack", 0.2, "0 1 0", None),
    "mirror": ("revolute", "rack", -0.2, "0 1 0", ("elbow", -1, 0)),
    "lift": ("prismatic", "mirror", 0.1, "0 0 1", None),
    "pinion": ("continuous", "lift", 0.1, "1 0 0", ("lift", 9, -0.2)),
}
ARMATURE, DAMPING, DRY = ({name: scale * (1 + 3 * i % 7) for i, name in enumerate(JOINTS)} for scale in (0.04, 0.3, 0.7))


def write_urdf(path):
    """Each link is named after the joint that carries it."""
    text = '<robot name="followers">\n'
    for i, name in enumerate(("base", *JOINTS)):
        text += (f'<link name="{name}"><inertial><origin xyz="0.1 {0.02 * i} -0.03" rpy="0.1 0.2 {0.1 * i}"/>'
                 f'<mass value="{1 + 0.3 * i}"/><inertia ixx="0.02" ixy="0" ixz="0" iyy="0.03" iyz="0" izz="0.04"/>'
                 "</inertial></link>\n")
    for name, (kind, parent, x, axis, follows) in JOINTS.items():
        limit = "" if kind == "continuous" else '<limit lower="-1" upper="1" effort="100" velocity="10"/>'
        mimic = "" if follows is None else '<mimic joint="{}" multiplier="{}" offset="{}"/>'.format(*follows)
        text += (f'<joint name="to_{name}" type="{kind}"><parent link="{parent}"/><child link="{name}"/>'
                 f'<origin xyz="{x} 0 0.1" rpy="0 0.2 0"/><axis xyz="{axis}"/>{limit}'
                 f'{mimic.replace("joint=" + chr(34), "joint=" + chr(34) + "to_")}</joint>\n')
    with open(path, "w", encoding="utf-8") as file:
        file.write(text + "</robot>\n")


def scene_of(floating, parameters, drives=True):
    listed = lambda values: "{" + ", ".join(f"to_{name}: {value}" for name, value in values.items()) + "}"
    friction = {name: f"{{damping: {DAMPING[name]}, friction: {DRY[name]}}}" for name in JOINTS}
    text = f"base: {'floating' if floating else 'fixed'}\n"
    if drives:
        text += (f"armature: {listed(ARMATURE)}\n"
                 f"joint_friction: {{model: coulomb, width: {WIDTH}, joints: {listed(friction)}}}\n")
    return text + f"regressor: {{parameters: {parameters}, rotors: true, friction: coulomb, width: {WIDTH}}}\n"


def smooth_sign(x):
    ahead, behind = (1 + x / 128) ** 128, (1 - x / 128) ** 128
    return (ahead - behind) / (ahead + behind)


def torques(figures):
    """Of the tree alone, and of rotors and friction, each at the rate of its own joint."""
    own = np.zeros(len(figures.s.v))
    for joint in figures.judge.joints:
        name = joint.name.removeprefix("to_")
        if name in JOINTS:
            rate = figures.s.v[joint.at_v]
            own[joint.at_v] = (ARMATURE[name] * figures.s.a[joint.at_v] + DAMPING[name] * rate
                               + DRY[name] * smooth_sign(rate / WIDTH))
    return figures.inverse_dynamics(), figures.T.T @ own


def stated(folder):
    """Values of the columns for rotors and friction, by what the contract says of each."""
    with open(os.path.join(folder, "code", "judged.h"), encoding="utf-8") as file:
        named = re.findall(r"^// +p (\d+): to_(\w+) (rotor|viscous|coulomb)", file.read(), flags=re.M)
    if [int(at) for at, *_ in named] != list(range(len(named))) or len(named) != 3 * len(JOINTS):
        sys.exit(f"columns of rotors and friction are {named}")
    return np.array([{"rotor": ARMATURE, "viscous": DAMPING, "coulomb": DRY}[kind][name] for _, name, kind in named])


def judge(treeline, work, floating):
    """The errors of the four, relative to the largest torque."""
    urdf = os.path.join(work, "followers.urdf")
    write_urdf(urdf)
    robot = RobotFile(urdf)
    folder = lambda name: os.path.join(work, f"{name}_{'floating' if floating else 'fixed'}")
    plain = Emitted(treeline, urdf, scene_of(floating, "none"), ["inverse_dynamics", "inverse_dynamics_regressor"],
                    folder("none"))
    base = Emitted(treeline, urdf, scene_of(floating, "base"), ["inverse_dynamics_regressor"], folder("base"))
    told = Emitted(treeline, urdf, scene_of(floating, "base", False) + "inputs: {base_parameters: true}\n",
                   ["inverse_dynamics"], folder("told"))
    run = subprocess.run([treeline, "inspect", urdf, os.path.join(folder("base"), "scene.yaml"), "--base-parameters",
                          "--json"], check=True, capture_output=True, text=True)
    values = np.array([each["value"] for each in json.loads(run.stdout)["base_parameters"]])
    freedoms = Freedoms(robot, plain.coordinate_joints, plain.velocity_joints)
    pinocchio = Pinocchio(robot, floating, {})
    random, errors = np.random.default_rng(1), {}
    for _ in range(STATES):
        state = freedoms.draw(random)
        state.qd *= 0.2  # where friction has not its full size
        tree, of_joints = torques(pinocchio.at(freedoms, state))
        v = {"q": state.q, "qd": state.qd, "qdd": state.qdd, "base_parameters": values}
        results = {
            "inverse_dynamics": plain.functions["inverse_dynamics"](v)["tau"],
            "regressor": plain.functions["inverse_dynamics_regressor"](v)["Y"] @ stated(folder("none")) + tree,
            "base regressor": base.functions["inverse_dynamics_regressor"](v)["Y"] @ values,
            "inverse_dynamics of base parameters": told.functions["inverse_dynamics"](v)["tau"],
        }
        expected = tree + of_joints
        for name, tau in results.items():
            error = np.max(np.abs(tau.reshape(-1) - expected)) / np.max(np.abs(expected))
            errors[name] = max(errors.get(name, 0), error)
    return errors


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("--treeline", required=True)
    parser.add_argument("--work", required=True)
    asked = parser.parse_args()
    os.makedirs(asked.work, exist_ok=True)
    bad = False
    for floating in (False, True):
        for name, error in judge(asked.treeline, asked.work, floating).items():
            bad = bad or not error <= TOLERANCE
            print(f"{'floating' if floating else 'fixed'}  {name}: {error:.1e}")
    return int(bad)


if __name__ == "__main__":
    sys.exit(main())
