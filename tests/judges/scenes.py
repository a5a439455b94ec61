"""Scenes in which robots are judged: points, forces, contacts and supports on links that differ by robot."""

import numpy as np

from robot_file import rotation_from_rpy
from rows import ALL_ROWS, Loop, Point, Rolling, place_yaml, rows_jacobian

# What a support holds, one kind a robot in turn.
SUPPORTS = (ALL_ROWS, ("x", "y", "z"), ("z", "rx", "ry"))

MOTION = ("forward_kinematics jacobian bias_acceleration inverse_dynamics gravity nonlinear_effects mass_matrix "
          "forward_dynamics center_of_mass center_of_mass_jacobian center_of_mass_bias_acceleration coriolis_matrix "
          "kinetic_energy kinetic_energy_derivatives potential_energy inverse_dynamics_regressor energy_regressor "
          "centroidal_momentum_matrix centroidal_momentum centroidal_bias centroidal_momentum_derivatives "
          "centroidal_momentum_rate_derivatives subtree_masses_and_centers point_velocity point_acceleration "
          "point_velocity_derivatives point_acceleration_derivatives inverse_dynamics_derivatives "
          "forward_dynamics_derivatives").split()
FORCES = ("jacobian bias_acceleration inverse_dynamics lambda_inverse lambda control_torque "
          "dynamically_consistent_inverse null_space_projector operational_bias_force operational_gravity "
          "contact_motion contact_inverse_inertia effective_mass impulse_response constrained_forward_dynamics "
          "supported_control_torque constraint_jacobian link_inverse_inertias").split()
CENTER = "forward_kinematics jacobian bias_acceleration lambda_inverse lambda control_torque".split()
ACTIVITY = "control_torque constrained_forward_dynamics supported_control_torque".split()
LOOPS = "constrained_forward_dynamics constraint_jacobian constraint_errors".split()
# What a loop holds, one kind a robot in turn: a weld, a ball joint, a hinge about z.
CLOSINGS = (ALL_ROWS, ("x", "y", "z"), ("x", "y", "z", "rx", "ry"))
DRIVES = ("mass_matrix inverse_dynamics nonlinear_effects gravity forward_dynamics kinetic_energy "
          "potential_energy").split()

# Those of more velocities take minutes to compile.
LARGEST = {"forward_dynamics_derivatives": 20, "inverse_dynamics_derivatives": 36,
           "centroidal_momentum_rate_derivatives": 36, "null_space_projector": 45}


ROLLING = "constrained_forward_dynamics constraint_jacobian constraint_errors".split()
# Of Coulomb friction, rad/s or m/s.
WIDTH = 0.5


class Drives:
    """What sits in joints: rotor inertia, viscous and Coulomb friction, and springs as (stiffness, rest), by joint."""

    def __init__(self, robot):
        # Followers share a coordinate; what sits in their joints is the leader's.
        leaders = {robot.leader_of(j)[0].name for j in robot.joints.values() if j.leader is not None}
        plain = [j.name for j in robot.joints.values()
                 if j.type in ("revolute", "continuous", "prismatic") and j.leader is None and j.name not in leaders]
        self.armature = {name: 0.01 * (1 + i % 7) for i, name in enumerate(plain)}
        self.damping = {name: 0.3 * (1 + i % 5) for i, name in enumerate(plain)}
        self.dry = {name: 0.7 * (1 + i % 3) for i, name in enumerate(plain)}
        # Else the file's count, which no judge reads here.
        self.others = [j.name for j in robot.joints.values()
                       if j.type in ("revolute", "continuous", "prismatic") and j.name not in plain]
        self.springs = {name: (2.0 * (1 + i % 3), 0.1 * (i % 4)) for i, name in enumerate(plain)}

    def yaml(self):
        listed = lambda values: "{" + ", ".join(f'"{name}": {value}' for name, value in values.items()) + "}"
        friction = {name: f"{{damping: {d}, friction: {self.dry[name]}}}" for name, d in self.damping.items()}
        friction.update({name: "{damping: 0, friction: 0}" for name in self.others})
        springs = {name: f"{{stiffness: {k}, rest: {r}}}" for name, (k, r) in self.springs.items()}
        return (f"armature: {listed(self.armature)}\n"
                f"joint_friction: {{model: coulomb, width: {WIDTH}, joints: {listed(friction)}}}\n"
                f"joint_springs: {listed(springs)}\n")


class Case:
    """A robot on a base with what its scenes are about."""

    def __init__(self, robot, floating, random):
        self.robot, self.floating = robot, floating
        links = [link for link in robot.tips() if robot.moves_against_world(link, floating)]
        # Beside tips, a link half way to the first.
        if links:
            above = [link for link in robot.carriers(links[0]) if robot.moves_against_world(link, floating)]
            links.append(above[len(above) // 2])
        else:
            links = [robot.root]
        place = lambda name, i, axes, rows=ALL_ROWS: Point(
            name, links[i % len(links)], random.uniform(-0.2, 0.2, 3), random.uniform(-1, 1, 3), axes, rows)
        self.points = [place("first", 0, "world"), place("second", 1, "local")]
        self.external = [place("push", 1, "world"), place("grip", 0, "local")]
        self.contacts = [place("touch", 0, "world"), place("knock", 1, "world")]
        self.held = [place("support", 2, "local" if random.integers(2) else "world",
                           SUPPORTS[random.integers(len(SUPPORTS))])]
        self.loops, self.loop_frames = [], {}
        self.couplings, self.passive, self.freedoms, self.drives, self.inputs = [], (), None, None, None
        self.parameter_links, self.shares = [], {}

    def coupling_rows(self):
        rows = []
        for coupling in self.couplings:
            row = np.zeros((1, self.freedoms.nv))
            for joint, factor in coupling.factors.items():
                row[0, self.freedoms.at_v[joint]] = factor
            rows.append(row)
        return rows

    def dry_friction(self, qd):
        """Which no judge has: the smooth sign tanh(128 artanh(x / 128)) of x = qd / width, as a share of powers."""
        forces = np.zeros(len(qd))
        for joint, largest in ({} if self.drives is None else self.drives.dry).items():
            x = qd[self.freedoms.at_v[joint]] / WIDTH
            ahead, behind = (1 + x / 128) ** 128, (1 - x / 128) ** 128
            forces[self.freedoms.at_v[joint]] = largest * (ahead - behind) / (ahead + behind)
        return forces

    def passive_velocities(self):
        """Velocities of a base that floats, of floating joints, and of joints that the scene names as passive."""
        found = list(range(6)) if self.floating else []
        for joint in self.robot.joints.values():
            if joint.type == "floating":
                found += range(self.freedoms.at_v[joint.name], self.freedoms.at_v[joint.name] + 6)
        for joint in self.passive:
            at = self.freedoms.at_v[joint]
            found += range(at, at + (3 if self.freedoms.is_ball(joint) else 1))
        return np.array(found, dtype=int)

    def gravity(self):
        return np.array([0, 0, -9.81]) if self.inputs is None else self.inputs.values["gravity"]

    def frames(self):
        """Of everything, by name, as judges take them."""
        every = [point for point in self.points if point.link is not None]
        every += self.external + self.contacts + self.held
        frames = {point.name: (point.link, point.xyz, point.rpy) for point in every}
        frames.update(self.loop_frames)
        frames.update({"link " + link: (link, np.zeros(3), np.zeros(3)) for link in self.robot.links
                       if self.robot.moves_against_world(link, self.floating)})
        return frames

    def base_yaml(self):
        return f"base: {'floating' if self.floating else 'fixed'}\n"

    def motion_yaml(self):
        return (self.base_yaml() + _list("operational_points", self.points)
                + _list("external_forces", self.external, False))

    def held_yaml(self):
        held = "".join("  - " + h.yaml().replace(f'link: "{h.link}"', f'between: ["{h.link}", world]') + "\n"
                       for h in self.held)
        return self.motion_yaml() + "constraints:\n" + held

    def forces_yaml(self):
        contacts = "".join(f'  - {{name: {c.name}, link: "{c.link}", origin: {place_yaml(c.xyz, c.rpy)}}}\n'
                           for c in self.contacts)
        return self.held_yaml() + "contacts:\n" + contacts + "damped: {mass: 0.5, inertia: 0.02}\n"

    def activity_yaml(self):
        """All tasks and supports come and go."""
        names = ", ".join(point.name for point in self.points + self.held)
        return self.held_yaml() + f"inputs: {{active: [{names}]}}\n"

    def draw_shares(self, random, in_part):
        draw = (lambda count: random.uniform(0, 1, count)) if in_part else (
            lambda count: random.integers(2, size=count).astype(float))
        self.shares = {"active": draw(len(self.held)), "active_tasks": draw(len(self.points))}

    def keep_independent_rows(self, figures_at_states):
        """Rows that support and task can move ordinarily at all these states: nothing is relaxed then."""
        chosen = []
        for points in (self.held, self.points):
            for point in points:
                rows, point.rows = point.rows, ()
                for row in rows:
                    point.rows = point.rows + (row,)
                    listed = [p for p in self.held + self.points if p.rows and (p in chosen or p is point)]
                    if min(_least_pivot(f, listed) for f in figures_at_states) < 0.05:
                        point.rows = point.rows[:-1]
                chosen.append(point)
        self.held = [point for point in self.held if point.rows]
        self.points = [point for point in self.points if point.rows]

    def close_a_loop(self, figures, rows):
        """Between the first two tips, closed where the figures are: the second frame is put onto the first."""
        first, second = self.points
        (R1, p1), (R2, p2) = figures.pose(first.name), figures.pose("link " + second.link)
        near = Point("closing", second.link, R2.T @ (p1 - p2), rpy_of(R2.T @ R1), "local")
        self.loop_frames = {p.name: (p.link, p.xyz, p.rpy) for p in (first, near)}
        self.loops, self.held, self.contacts = [Loop(first.name, near.name, rows)], [], []
        self.loop_text = (f'constraints:\n  - {{name: loop, between: ["{first.link}", "{near.link}"], '
                          f"origin: {place_yaml(first.xyz, first.rpy)}, "
                          f"other_origin: {place_yaml(near.xyz, near.rpy)}, rows: [{', '.join(rows)}]}}\n")
        self.points = []

    def roll(self, figures, random):
        """A ball or a disc around the first point, on a plane that touches it where the figures are."""
        wheel = self.points[0]
        axis = None if random.integers(2) else _unit(random.normal(size=3))
        rolling = Rolling(wheel.name, random.uniform(0.05, 0.3), axis)
        rolling.touch(figures, rotation_from_rpy(random.uniform(-1, 1, 3)))
        self.loop_frames = {wheel.name: (wheel.link, wheel.xyz, wheel.rpy)}
        self.loops, self.held, self.contacts, self.points = [rolling], [], [], []
        thin = "" if axis is None else f", axis: [{', '.join(repr(float(x)) for x in axis)}]"
        self.loop_text = (f'constraints:\n  - {{name: wheel, between: ["{wheel.link}", world], '
                          f"origin: {place_yaml(wheel.xyz, wheel.rpy)}, "
                          f"other_origin: {place_yaml(rolling.plane[1], rpy_of(rolling.plane[0]))}, "
                          f"rolling: {{radius: {rolling.radius}{thin}}}}}\n")

    def loop_yaml(self):
        return self.base_yaml() + _list("external_forces", self.external, False) + self.loop_text


def _unit(vector):
    return vector / np.linalg.norm(vector)


def rpy_of(R):
    """Roll, pitch and yaw of a rotation."""
    return np.array([np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0])),
                     np.arctan2(R[1, 0], R[0, 0])])


def _list(key, points, with_rows=True):
    return f"{key}:\n" + "".join(f"  - {point.yaml(with_rows)}\n" for point in points)


def _least_pivot(figures, points):
    """Of the inverse inertia of the rows: the least share of a row's that those before it leave."""
    J = rows_jacobian(figures, points)
    remaining = J @ np.linalg.solve(figures.mass_matrix(), J.T)
    whole, least = np.diag(remaining).copy(), 1.0
    linear = np.array([index < 3 for point in points for index in point.indices])
    typical = np.array([np.median(whole[linear == own]) for own in linear])
    for i in range(len(J)):
        if whole[i] < 1e-3 * typical[i] or remaining[i, i] <= 0:
            return 0.0
        least = min(least, remaining[i, i] / whole[i])
        remaining = remaining - np.outer(remaining[:, i], remaining[i]) / remaining[i, i]
    return least
