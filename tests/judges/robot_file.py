"""What a URDF says of its tree, and its text as every judge can read it: frames, joints and masses alone."""

import math
import re
import xml.etree.ElementTree as ET

import numpy as np

# Bodies that other programs take for the world are renamed where the world is above them.
RENAMED_WORLD = "link_named_world"
# Shapes, motors and simulators' own elements change no figure that is compared. Drake and MuJoCo read some
# of them, Treeline only if the scene asks for it. Mimic joints are independent for all judges:
# conventions.py joins them again.
UNNEEDED = ("visual|collision|gazebo|transmission|mujoco|dynamics|mimic|safety_controller|calibration|sensor|material|"
            "loop_joint")


class Joint:
    """One joint of the file."""

    def __init__(self, element):
        self.name = element.get("name")
        self.type = element.get("type")
        self.parent = element.find("parent").get("link")
        self.child = element.find("child").get("link")
        limit = element.find("limit")
        self.lower, self.upper = (
            (float(limit.get("lower", 0)), float(limit.get("upper", 0))) if limit is not None else (0, 0))
        self._origin, self._axis = element.find("origin"), element.find("axis")
        mimic = element.find("mimic")
        self.leader = None if mimic is None else mimic.get("joint")
        self.multiplier = 1.0 if mimic is None else float(mimic.get("multiplier", 1))
        self.offset = 0.0 if mimic is None else float(mimic.get("offset", 0))

    @property
    def axis(self):
        """Of length 1, in the joint's frame."""
        axis = np.array("1 0 0".split() if self._axis is None else self._axis.get("xyz").split(), dtype=float)
        return axis / np.linalg.norm(axis)

    @property
    def origin_text(self):
        return "" if self._origin is None else ET.tostring(self._origin, "unicode").strip()

    @property
    def moves(self):
        return self.type != "fixed"


LEAST_MASS = 1e-12


class Inertial:
    """Inertia of a link as the file has it; of a link without, nothing."""

    def __init__(self, link):
        numbers = lambda element, key: (np.zeros(3) if element is None or element.get(key) is None
                                        else np.array(element.get(key).split(), dtype=float))
        origin, mass, moments = (link.find("inertial/" + tag) for tag in ("origin", "mass", "inertia"))
        self.mass = 0.0 if mass is None else float(mass.get("value"))
        self.center, self.rpy = numbers(origin, "xyz"), numbers(origin, "rpy")
        xx, xy, xz, yy, yz, zz = (0.0 if moments is None else float(moments.get(key, 0))
                                  for key in ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"))
        self.moments, self.axes = np.linalg.eigh(np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]))
        if np.linalg.det(self.axes) < 0:
            self.axes = -self.axes

    def is_of_a_body(self):
        """Within what MuJoCo and Drake take: some rod, plate or solid has it."""
        a, b, c = self.moments
        return self.mass > LEAST_MASS and a > LEAST_MASS and a + b > c * (1 + 1e-9)


def inertials_of(text):
    """By link."""
    return {link.get("name"): Inertial(link) for link in ET.fromstring(text).findall("link")}


class RobotFile:
    """The tree of a URDF. Links are in the order of the file."""

    def __init__(self, path):
        with open(path, encoding="utf-8") as file:
            self._read(file.read())

    @classmethod
    def of_text(cls, text):
        robot = cls.__new__(cls)
        robot._read(text)
        return robot

    def _read(self, text):
        self.text = text
        root = ET.fromstring(self.text)
        self.name = root.get("name")
        self.joints = {j.name: j for j in map(Joint, root.findall("joint"))}
        self.links = [link.get("name") for link in root.findall("link")]
        self.masses = {link.get("name"): _mass_of(link) for link in root.findall("link")}
        self.joint_above = {j.child: j for j in self.joints.values()}
        self.root = next(link for link in self.links if link not in self.joint_above)

    def write(self, path):
        with open(path, "w", encoding="utf-8") as file:
            file.write(self.text)

    def with_added(self, elements):
        """The robot with more links and joints."""
        end = self.text.rindex("</robot")
        return RobotFile.of_text(self.text[:end] + elements + self.text[end:])

    def with_inertial(self, link, inertial):
        """The robot with this inertia of a link."""
        body = re.compile(rf'(<link\b[^>]*\bname\s*=\s*"{re.escape(link)}"[^>]*?)(/>|>.*?</link\s*>)', re.S)
        return RobotFile.of_text(body.sub(lambda found: f"{found[1]}>{inertial}</link>", self.text, count=1))

    def leader_of(self, joint):
        """The independent joint behind mimics, and by which factor and offset `joint` follows it."""
        factor, offset = 1.0, 0.0
        while joint.leader is not None:
            offset += factor * joint.offset
            factor *= joint.multiplier
            joint = self.joints[joint.leader]
        return joint, factor, offset

    def moves_against_world(self, link, floating):
        """Whether some joint is between the link and the world."""
        while link in self.joint_above:
            if self.joint_above[link].moves:
                return True
            link = self.joint_above[link].parent
        return floating

    def fixed_to(self, link):
        """The link and all that fixed joints hold to it."""
        held = [link]
        for joint in self.joints.values():
            held += [] if joint.moves or joint.parent != link else self.fixed_to(joint.child)
        return held

    def depth(self, link):
        """How many joints that move are between the link and the root."""
        count = 0
        while link in self.joint_above:
            count += self.joint_above[link].moves
            link = self.joint_above[link].parent
        return count

    def carriers(self, link):
        """The link and all above it."""
        above = [link]
        while above[-1] in self.joint_above:
            above.append(self.joint_above[above[-1]].parent)
        return above

    def tips(self):
        """Links that carry no other, the deepest first."""
        parents = {j.parent for j in self.joints.values()}
        ends = [link for link in self.links if link not in parents and link != self.root]
        return sorted(ends, key=lambda link: -self.depth(link))


def _mass_of(link):
    mass = link.find("inertial/mass")
    return 0.0 if mass is None else float(mass.get("value"))


def inertial_of_body(m, c, I):
    """The element of a URDF, of the tensor about the centre."""
    numbers = lambda values: " ".join(repr(float(x)) for x in values)
    moments = " ".join(f'{key}="{float(x)!r}"' for key, x in zip(
        ("ixx", "ixy", "ixz", "iyy", "iyz", "izz"), (I[0, 0], I[0, 1], I[0, 2], I[1, 1], I[1, 2], I[2, 2])))
    return f'<inertial><origin xyz="{numbers(c)}"/><mass value="{float(m)!r}"/><inertia {moments}/></inertial>'


def plain_text(robot, floating):
    """The URDF with frames, joints and inertias alone."""
    text = re.sub(r"<!--.*?-->", "", robot.text, flags=re.S)
    text = re.sub(rf"<({UNNEEDED})\b(?:[^>]*?/>|[^>]*>.*?</\1\s*>)", "", text, flags=re.S)
    text = re.sub(r"<drake:[\w_]+\b[^>]*/>", "", text)
    # MuJoCo and Drake hold joints within limits of effort and position only in motion, but refuse reversed ones.
    text = re.sub(r"<limit\b[^>]*?/>|<limit\b[^>]*>\s*</limit\s*>",
                  '<limit lower="-3" upper="3" effort="1e3" velocity="1e3"/>', text)
    if floating:
        text = re.sub(r'(<(?:link|parent|child)\b[^>]*?")world"', rf'\1{RENAMED_WORLD}"', text)
    return text


def name_for_judges(link, floating):
    """What a link is called in `plain_text`."""
    return RENAMED_WORLD if floating and link == "world" else link


def rotation_from_rpy(rpy):
    """Rz(yaw) Ry(pitch) Rx(roll)."""
    (sr, sp, sy), (cr, cp, cy) = np.sin(rpy), np.cos(rpy)
    return np.array([[cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
                     [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
                     [-sp, cp * sr, cp * cr]])


def range_of(joint):
    """Positions to draw from: the limits, or a turn or a metre where there are none that permit motion."""
    widest = 1.0 if joint.type == "prismatic" else math.pi
    if joint.type == "continuous" or not joint.upper > joint.lower:
        return -widest, widest
    return max(joint.lower, -2 * math.pi), min(joint.upper, 2 * math.pi)
