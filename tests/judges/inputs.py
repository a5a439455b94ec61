"""What functions take at run time, and the robot's file that says the same: gravity, bodies, a tool, a contact."""

import numpy as np

from conventions import rotation_from_quaternion
from robot_file import inertial_of_body
from rows import Point
from scenes import rpy_of

FUNCTIONS = ("inverse_dynamics gravity nonlinear_effects mass_matrix forward_dynamics forward_kinematics jacobian "
             "bias_acceleration lambda_inverse control_torque operational_gravity center_of_mass kinetic_energy "
             "centroidal_momentum contact_motion effective_mass").split()


class Inputs:
    """Arguments of one call. The payload is on the first point's link; another body replaces that of a link that moves
    and to which nothing else is fixed, if there is one."""

    def __init__(self, case, random):
        robot, tool, contact = case.robot, case.points[0], case.contacts[0]
        self.loaded = tool.link
        alone = [joint.child for joint in robot.joints.values()
                 if joint.moves and robot.fixed_to(joint.child) == [joint.child]]
        self.replaced = alone[len(alone) // 2] if alone else None
        turn = random.normal(size=4)
        self.values = {"gravity": random.uniform(-10, 10, 3), "payload": _draw_body(random),
                       "parameters": _draw_body(random), "tool": random.uniform(-0.3, 0.3, 3),
                       "tool_orientation": turn, "contact": random.uniform(-0.3, 0.3, 3)}
        tool.xyz, tool.axes = self.values["tool"], "local"
        tool.rpy = rpy_of(rotation_from_quaternion(*(turn / np.linalg.norm(turn))))
        contact.xyz = self.values["contact"]
        case.points, case.contacts, case.external = [tool], [contact], []

    def yaml(self, case):
        """Frames of the scene are others, which arguments replace, as far from the link: by the scene's the program
        measures how much rows move ordinarily, so which of them yield near singularities."""
        tool, contact = case.points[0], case.contacts[0]
        elsewhere = Point(tool.name, tool.link, -np.asarray(tool.xyz), np.ones(3), tool.axes, tool.rows)
        parameters = f'  parameters: ["{self.replaced}"]\n' if self.replaced else ""
        return (f'{case.base_yaml()}operational_points:\n  - {elsewhere.yaml()}\n'
                f'contacts:\n  - {{name: {contact.name}, link: "{contact.link}"}}\n'
                f'inputs:\n  gravity: true\n  payload: {{link: "{self.loaded}", mass: 3, reach: 0.3}}\n{parameters}'
                f"  tool: {{point: {tool.name}, orientation: true}}\n  contact: {contact.name}\n")

    def told(self, robot):
        """The robot with these bodies in its file."""
        if self.replaced:
            robot = robot.with_inertial(self.replaced, inertial_of_body(*_body_of(self.values["parameters"])))
        return robot.with_added(
            f'<link name="payload">{inertial_of_body(*_body_of(self.values["payload"]))}</link><joint name="payload" '
            f'type="fixed"><parent link="{self.loaded}"/><child link="payload"/></joint>')


def _draw_body(random):
    """Mass, its moments, and the tensor about the origin, of a body of some extent."""
    m, c, (a, b, d) = random.uniform(1, 3), random.uniform(-0.1, 0.1, 3), random.uniform(0.001, 0.02, 3)
    I = m * (np.diag([b + d, a + d, a + b]) + c @ c * np.eye(3) - np.outer(c, c))
    return np.array([m, *(m * c), *(I[at] for at in ((0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)))])


def _body_of(parameters):
    m, moment, (xx, xy, yy, xz, yz, zz) = parameters[0], parameters[1:4], parameters[4:]
    c = moment / m
    return m, c, np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]) - m * (c @ c * np.eye(3) - np.outer(c, c))
