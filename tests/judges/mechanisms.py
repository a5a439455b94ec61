"""Mechanisms with closed loops and belts, written for Treeline (tests/data/written): what closes each."""

import numpy as np

from conventions import State
from rows import Loop, constraint_errors, held_jacobian

FUNCTIONS = ("constrained_forward_dynamics supported_control_torque constraint_jacobian constraint_errors").split()


class Coupling:
    """The sum of factor times coordinate is held at 0."""

    def __init__(self, name, factors):
        self.name, self.factors = name, factors

    def yaml(self):
        listed = ", ".join(f"{joint}: {factor}" for joint, factor in self.factors.items())
        return f"  - {{name: {self.name}, joints: {{{listed}}}}}\n"


class Mechanism:
    """Loops as (link, xyz, other link, xyz, rows), couplings, and joints without motors."""

    def __init__(self, loops=(), couplings=(), passive=(), in_file=False):
        self.loops, self.couplings, self.passive, self.in_file = loops, couplings, passive, in_file

    def yaml(self):
        text = "base: fixed\npassive: [" + ", ".join(self.passive) + "]\n"
        if self.loops and not self.in_file:
            text += "constraints:\n" + "".join(
                f"  - {{name: loop{i}, between: [{one}, {other}], origin: {{xyz: {list(at)}}}, "
                f"other_origin: {{xyz: {list(other_at)}}}, rows: [{', '.join(rows)}]}}\n"
                for i, (one, at, other, other_at, rows) in enumerate(self.loops))
        if self.couplings:
            text += "couplings:\n" + "".join(coupling.yaml() for coupling in self.couplings)
        return text

    def hold(self, case):
        """Makes the case about this mechanism."""
        case.points, case.external, case.contacts, case.held = [], [], [], []
        case.couplings, case.passive = self.couplings, self.passive
        for i, (one, at, other, other_at, rows) in enumerate(self.loops):
            case.loop_frames.update({f"end {i}": (one, at, np.zeros(3)), f"other {i}": (other, other_at, np.zeros(3))})
            case.loops.append(Loop(f"end {i}", f"other {i}", rows))


BALL = ("x", "y", "z")
MECHANISMS = {
    "four_bar": Mechanism([("rocker", (0, 0, 0.25), "coupler", (0.3, 0, 0), ("x", "z"))],
                          passive=("coupler_joint", "rocker_joint")),
    "spatial_four_bar": Mechanism([("rocker", (0, 0, 0.4), "coupler", (0.6, 0, 0), BALL)],
                                  passive=("swing_joint", "lift_joint", "rocker_joint")),
    "delta": Mechanism([("rod_0", (0, 0, -0.5), "platform", (0.05, 0, 0), BALL),
                        ("rod_1", (0, 0, -0.5), "platform", (-0.025, 0.04330127018922193, 0), BALL),
                        ("rod_2", (0, 0, -0.5), "platform", (-0.025, -0.04330127018922193, 0), BALL)],
                       passive=[f"{joint}_{i}" for i in range(3) for joint in ("elbow", "sway")]
                       + ["slide_x", "slide_y", "slide_z"], in_file=True),
    "stewart": Mechanism([(f"rod_{i}", (0, 0, 0.1), "plate", (x, y, 0), BALL) for i, (x, y) in enumerate(
        ((-0.2393, 0.4145), (-0.3133, 0.4145), (-0.5526, 0.0), (-0.5157, -0.0641), (-0.037, -0.0641)), 1)],
                         passive=["rim"] + [f"{joint}_{i}" for i in range(6) for joint in ("yaw", "pitch")],
                         in_file=True),
    "belt_arm": Mechanism(couplings=[Coupling("elbow_belt", {"elbow_motor": 1, "elbow": -4}),
                                     Coupling("wrist_belt", {"wrist_motor": 1, "wrist": -5, "elbow": -5})],
                          passive=("elbow", "wrist")),
    "differential_wrist": Mechanism(couplings=[Coupling("sum", {"left": 0.5, "right": 0.5, "pitch": -1}),
                                               Coupling("difference", {"left": 0.5, "right": -0.5, "roll": -1})],
                                    passive=("pitch", "roll")),
}


def close(judge, freedoms, case, random):
    """A state in which all is closed, by Newton's method on the judge's frames, and velocities that keep it so."""
    for _ in range(50):
        state = freedoms.draw(random)
        state.q = freedoms.near_home(state.q, 0.3)
        for _ in range(60):
            figures = judge.at(freedoms, state)
            errors = constraint_errors(figures, case, state.q)
            if np.max(np.abs(errors)) < 1e-14:
                break
            step = freedoms.displaced(state.q) @ (np.linalg.pinv(held_jacobian(figures, case)) @ errors)
            state.q = freedoms.normalized(state.q - step)
        J = held_jacobian(judge.at(freedoms, state), case)
        if np.max(np.abs(errors)) < 1e-13 and np.linalg.svd(J, compute_uv=False)[-1] > 0.02:
            return State(state.q, state.qd - np.linalg.pinv(J) @ (J @ state.qd), state.qdd)
    raise RuntimeError("Newton's method does not close it")
