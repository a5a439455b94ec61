"""Rotors that turn what carries them: armature for Treeline, bodies on geared joints of their own for judges."""

import numpy as np

from robot_file import inertial_of_body
from scenes import DRIVES

FUNCTIONS = DRIVES + ["coriolis_matrix", "kinetic_energy_derivatives"]
RATIOS = (-7.0, 0.5, 12.0)
MASS = 0.3


class Rotors:
    """Up to three, about the axes of their joints. A ball turns for the judges; what it has across the axis, and its
    mass, are of the carrier for Treeline."""

    def __init__(self, robot):
        plain = [joint for joint in robot.joints.values()
                 if joint.type in ("revolute", "continuous", "prismatic") and joint.leader is None]
        places = sorted({0, len(plain) // 2, len(plain) - 1}) if plain else []
        self.joints = [plain[i] for i in places]
        self.inertias = [0.01 * (1 + i) for i in range(len(places))]

    def yaml(self):
        listed = ", ".join(
            f'"{joint.name}": {{rotor_inertia: {inertia}, gear_ratio: {ratio}, gyroscopic: true}}'
            for joint, inertia, ratio in zip(self.joints, self.inertias, RATIOS))
        return f"armature: {{{listed}}}\n"

    def at_rest(self, robot):
        across = lambda joint: np.eye(3) - np.outer(joint.axis, joint.axis)
        return self._with_bodies(robot, across, lambda joint, ratio: 'type="fixed">')

    def turning(self, robot):
        return self._with_bodies(robot, lambda joint: np.eye(3), lambda joint, ratio: (
            f'type="continuous"><axis xyz="{" ".join(map(repr, map(float, joint.axis)))}"/>'
            f'<mimic joint="{joint.name}" multiplier="{ratio}"/>'))

    def _with_bodies(self, robot, shape, kind):
        text = ""
        for i, (joint, inertia, ratio) in enumerate(zip(self.joints, self.inertias, RATIOS)):
            body = inertial_of_body(MASS, np.zeros(3), inertia * shape(joint))
            text += (f'<link name="rotor {i}">{body}</link><joint name="rotor {i}" {kind(joint, ratio)}'
                     f'<parent link="{joint.parent}"/><child link="rotor {i}"/>{joint.origin_text}</joint>')
        return robot.with_added(text)
