"""Compares code that Treeline emits with Pinocchio, Drake and MuJoCo.

  judge.py --treeline PROGRAM --work FOLDER ROBOT.urdf...

Every robot is judged on a fixed and a floating base, at random states, in nine scenes: motion; forces, with a support
and contacts; supports and tasks that come and go; drives in its joints; rotors that turn what carries them; inputs at
run time; a loop between two links; a wheel that rolls; an object in two hands. Scenes that a robot cannot have are left
out. disagreements.tsv lists what may differ or cannot be compared, with the reason; a row there that is not so fails as
well. Exit status 1: something differs.
"""

import argparse
import contextlib
import hashlib
import os
import re
import sys
import time

import numpy as np

import objects
from conventions import Freedoms, Lacking, State, Unavailable, Undetermined
from emitted import Emitted, Refused
from expected import EXPECTED, forward_dynamics_by_algebra
from inputs import FUNCTIONS as INPUTS, Inputs
from judge_drake import Drake
from judge_mujoco import Mujoco
from judge_pinocchio import Pinocchio
from mechanisms import FUNCTIONS, MECHANISMS, close
from report import Report
from robot_file import RobotFile
from rotors import FUNCTIONS as ROTORS, Rotors
from rows import Center, held_jacobian, rows_jacobian
from scenes import ACTIVITY, CENTER, CLOSINGS, DRIVES, FORCES, LARGEST, LOOPS, MOTION, ROLLING, Case, Drives

JUDGES = (Pinocchio, Drake, Mujoco)
STATES = 3


def largest_error(ours, expectation):
    """Relative to the size of terms."""
    if isinstance(expectation, list):
        return max(_relative(of(ours), value, size) for of, value, size in expectation)
    value, size, *metric = expectation
    return _relative(ours, value, size, *metric)


def _relative(ours, theirs, size, metric=None):
    theirs = np.asarray(theirs)
    difference = np.asarray(ours).reshape(theirs.shape) - theirs
    if metric is not None:
        difference = metric @ difference
    if difference.size == 0:
        return 0.0
    error = np.max(np.abs(difference) / size)
    return np.inf if np.isnan(error) else error


def draw_inputs(case, freedoms, state, figures, random):
    """Of every kind that functions take. Forces are of the size that the state's motion needs."""
    wrench = random.uniform(-20, 20, 6 * len(case.external))
    tau = np.abs(figures["pinocchio"].mass_matrix() @ state.qdd) if len(figures) == 1 else (
        next(f for name, f in figures.items() if name != "pinocchio").inverse_dynamics())
    rows = sum(len(point.rows) for point in case.points)
    anchored = sum(len(point.rows) for point in case.held)
    held = anchored + sum(len(loop.rows) for loop in case.loops) + len(case.couplings)
    normals = random.normal(size=(len(case.contacts), 3))
    return {"q": state.q, "qd": state.qd, "qdd": state.qdd, "f_ext": wrench,
            "tau": tau + 0.5 * np.abs(tau) * random.uniform(-1, 1, freedoms.nv),
            "xdd_object": random.uniform(-5, 5, 6), "internal": random.uniform(-20, 20, 6),
            "qdd_0": random.uniform(-10, 10, freedoms.nv), "xdd_cmd": random.uniform(-5, 5, rows),
            "heaviest": np.array([0.5 if index < 3 else 0.02 for point in case.points for index in point.indices]),
            "normals": normals / np.linalg.norm(normals, axis=1, keepdims=True),
            "impulse": random.uniform(-5, 5, 3 * len(case.contacts)),
            "stabilisation": random.integers(2) * np.array([7.0, 30.0]), "drift": random.uniform(-0.01, 0.01, anchored),
            "f_wanted": random.uniform(-50, 50, held)}


def inputs_for(name, case, values):
    """Derivatives hold forces as numbers in the axes of the scene; judges hold those in links' axes."""
    if not name.endswith("dynamics_derivatives"):
        return values
    held = values["f_ext"].copy()
    for i, point in enumerate(case.external):
        if point.axes == "world":
            held[6 * i:6 * i + 6] = 0
    return {**values, "f_ext": held}


def stem_of(path):
    return os.path.basename(path).removesuffix(".urdf")


class Trial:
    """One robot on one base."""

    def __init__(self, treeline, path, floating, work, report):
        self.treeline, self.path, self.report = treeline, path, report
        self.robot = RobotFile(path)
        self.name = stem_of(path) + ("_floating" if floating else "_fixed")
        self.folder = os.path.join(work, self.name)
        self.random = np.random.default_rng(int(hashlib.sha256(self.name.encode()).hexdigest()[:8], 16))
        self.case = Case(self.robot, floating, self.random)

    def run(self):
        try:
            if stem_of(self.path) in MECHANISMS:
                self.judge_mechanism(MECHANISMS[stem_of(self.path)])
                return
            self.judge_motion()
            self.judge_forces()
            self.judge_drives()
            self.judge_rotors()
            self.judge_inputs()
            self.judge_loops()
            self.judge_rolling()
            self.judge_object()
            self.judge_center()
        except Refused as refusal:
            self.report.skip(self.name, "all", "treeline", str(refusal).splitlines()[0])

    def emit(self, scene, functions, kind, file=None):
        """Without what Treeline refuses: single functions, and what needs the inverse of a singular mass matrix."""
        try:
            return Emitted(self.treeline, file or self.path, scene, functions, os.path.join(self.folder, kind))
        except Refused as refusal:
            if "mass matrix is singular" in str(refusal):
                self.confirm_singular(kind)
                refused = set(functions) & {"forward_dynamics", "forward_dynamics_derivatives"}
            else:
                refused = set(re.findall(r"^error: (\w+): .* the function is not written", str(refusal), re.M))
                for name in refused:
                    self.report.skip(self.name, f"{kind} {name}", "treeline", "refused: it has too few digits")
            left = [name for name in functions if name not in refused]
            if not refused:
                raise
            return self.emit(scene, left, kind + "_", file) if left else None

    def confirm_singular(self, kind):
        """That the first judge's mass matrix has no inverse either."""
        drives = Drives(self.robot) if kind == "drives" else None
        judge = Pinocchio(self.robot, self.case.floating, {}, drives, self.case.gravity())
        M = judge.at(self.freedoms, self.freedoms.draw(self.random)).mass_matrix()
        error = 0.0 if np.linalg.cond(M) > 1e13 else np.inf
        self.report.note(self.name, f"{kind} singular mass matrix", judge.name, error)

    def judges(self, drives=None):
        found = []
        for judge in JUDGES:
            try:
                found.append(judge(self.robot, self.case.floating, self.case.frames(), drives,
                                   self.case.gravity()))
            except Unavailable as reason:
                self.report.skip(self.name, "all", judge.name, reason)
        return found

    def within_size(self, functions, nv):
        return [name for name in functions if nv <= LARGEST.get(name, 1000)]

    def judge_motion(self):
        self.count_freedoms()
        functions = self.within_size(MOTION, self.freedoms.nv)
        emitted = self.emit(self.case.motion_yaml(), functions, "motion")
        self.case.parameter_links = self.parameter_links = emitted.links
        self.compare(emitted, self.judges(), "motion")

    def count_freedoms(self):
        counted = Emitted(self.treeline, self.path, self.case.base_yaml(), ["gravity"],
                          os.path.join(self.folder, "counted"))
        self.freedoms = Freedoms(self.robot, counted.coordinate_joints, counted.velocity_joints)

    def judge_forces(self):
        judges = self.judges()
        states = [self.freedoms.draw(self.random) for _ in range(STATES)]
        if np.linalg.cond(judges[0].at(self.freedoms, states[0]).mass_matrix()) > 1e13:
            return
        self.case.keep_independent_rows([judges[0].at(self.freedoms, state) for state in states])
        if not self.case.held or not self.case.points:
            self.report.left_out[self.name, "forces"] = "no row of a support or of the task can be moved ordinarily"
            return
        self.hold_rows(judges[0], states[0])
        self.case.freedoms = self.freedoms
        functions = self.within_size(FORCES, self.freedoms.nv)
        emitted = self.emit(self.case.forces_yaml(), functions, "forces")
        if emitted is not None:
            self.compare(emitted, judges, "forces", states)
            self.judge_activity(judges, states)

    def judge_activity(self, judges, states):
        """Supports and tasks that come and go: in part, then some of them whole and the others gone."""
        emitted = self.emit(self.case.activity_yaml(), ACTIVITY, "activity")
        for state, in_part in zip(states, (True, False)) if emitted is not None else ():
            self.case.draw_shares(self.random, in_part)
            self.compare(emitted, judges, "activity", [state])
        self.case.shares = {}

    def hold_rows(self, judge, state):
        """Takes from the velocities what moves held rows."""
        J = held_jacobian(judge.at(self.freedoms, state), self.case)
        state.qd = state.qd - np.linalg.pinv(J) @ (J @ state.qd)

    def judge_drives(self):
        drives = Drives(self.robot)
        if not drives.armature:
            return
        emitted = self.emit(self.case.base_yaml() + drives.yaml(), DRIVES, "drives")
        self.case.external, self.case.drives, self.case.freedoms = [], drives, self.freedoms
        self.compare(emitted, self.judges(drives), "drives")
        self.case.drives = None

    @contextlib.contextmanager
    def reading(self, robot):
        """Judges read this file meanwhile, with what the scene adds to Treeline's. Its coordinates are the same."""
        own = self.robot, self.freedoms
        self.robot, self.freedoms = robot, self.freedoms.of(robot)
        try:
            yield
        finally:
            self.robot, self.freedoms = own

    def judge_rotors(self):
        rotors = Rotors(self.robot)
        if not rotors.joints:
            return
        file = os.path.join(self.folder, "resting_rotors.urdf")
        rotors.at_rest(self.robot).write(file)
        emitted = self.emit(self.case.base_yaml() + rotors.yaml(), ROTORS, "rotors", file)
        if emitted is not None:
            with self.reading(rotors.turning(self.robot)):
                self.compare(emitted, self.judges(), "rotors")

    def judge_inputs(self):
        self.case = Case(self.robot, self.case.floating, self.random)
        self.case.inputs = inputs = Inputs(self.case, self.random)
        with self.reading(inputs.told(self.robot)):
            judges, state = self.judges(), self.freedoms.draw(self.random)
            figures = judges[0].at(self.freedoms, state)
            if np.linalg.cond(figures.mass_matrix()) > 1e13:
                return
            self.case.keep_independent_rows([figures])
            emitted = self.emit(inputs.yaml(self.case), INPUTS, "inputs") if self.case.points else None
            if emitted is not None:
                self.compare(emitted, judges, "inputs", [state])

    def judge_loops(self):
        """At one pose, in which the loop is closed, with velocities that keep it so and others."""
        self.case = Case(self.robot, self.case.floating, self.random)
        state = self.freedoms.draw(self.random)
        open_robot = self.judges()[0].at(self.freedoms, state)
        if self.case.points[0].link == self.case.points[1].link or np.linalg.cond(open_robot.mass_matrix()) > 1e13:
            return
        self.case.close_a_loop(open_robot, CLOSINGS[self.random.integers(len(CLOSINGS))])
        judges = self.judges()
        figures = judges[0].at(self.freedoms, state)
        J = held_jacobian(figures, self.case)
        if np.linalg.svd(J, compute_uv=False)[-1] < 0.05:
            return  # rows that depend on each other: forces have no one answer
        emitted = self.emit(self.case.loop_yaml(), LOOPS, "loops")
        if emitted is not None:
            moving = State(state.q, state.qd.copy(), state.qdd)
            self.hold_rows(judges[0], moving)
            self.compare(emitted, judges, "loops", [moving, state])

    def judge_mechanism(self, mechanism):
        """At poses that close it."""
        self.count_freedoms()
        mechanism.hold(self.case)
        self.case.freedoms = self.freedoms
        judges = self.judges()
        states = [close(judges[0], self.freedoms, self.case, self.random) for _ in range(STATES)]
        self.compare(self.emit(mechanism.yaml(), FUNCTIONS, "mechanism"), judges, "mechanism", states)

    def judge_rolling(self):
        """At one pose, in which it touches, with velocities that roll and others."""
        self.case = Case(self.robot, self.case.floating, self.random)
        state = self.freedoms.draw(self.random)
        figures = self.judges()[0].at(self.freedoms, state)
        if np.linalg.cond(figures.mass_matrix()) > 1e13:
            return
        self.case.roll(figures, self.random)
        J = held_jacobian(figures, self.case)
        if np.linalg.svd(J, compute_uv=False)[-1] < 0.05:
            return  # rows that depend on each other: forces have no one answer
        emitted = self.emit(self.case.loop_yaml(), ROLLING, "rolling")
        if emitted is not None:
            judges, moving = self.judges(), State(state.q, state.qd.copy(), state.qdd)
            self.hold_rows(judges[0], moving)
            self.compare(emitted, judges, "rolling", [moving, state])

    def judge_object(self):
        """At one pose, in which both hands hold it, moving as one."""
        self.case = Case(self.robot, self.case.floating, self.random)
        state = self.freedoms.draw(self.random)
        figures = self.judges()[0].at(self.freedoms, state)
        J = rows_jacobian(figures, self.case.points)
        singular = np.linalg.cond(figures.mass_matrix()) > 1e13
        if singular or np.linalg.svd(J, compute_uv=False)[-1] < 0.05 or len(J) > self.freedoms.nv:
            return  # hands that cannot do it
        self.case.object = objects.HeldObject(self.case, figures, self.random)
        self.case.loop_frames = {"object": self.case.object.frame()}
        judges = self.judges()
        chain = objects.ClosedChain(judges[0].at(self.freedoms, state), self.case)
        apart = chain.J[6:] - chain.C[6:] @ np.linalg.inv(chain.C[:6]) @ chain.J[:6]
        state.qd = state.qd - np.linalg.pinv(apart) @ (apart @ state.qd)
        emitted = self.emit(self.case.object.yaml(self.case), objects.FUNCTIONS, "object")
        self.case.external = []
        self.compare(emitted, judges, "object", [state])

    def judge_center(self):
        """A task of the centre of mass before one of a point."""
        self.case = Case(self.robot, self.case.floating, self.random)
        self.case.points, self.case.held = [Center("center"), self.case.points[0]], []
        judges, state = self.judges(), self.freedoms.draw(self.random)
        figures = judges[0].at(self.freedoms, state)
        if np.linalg.cond(figures.mass_matrix()) > 1e13:
            return
        self.case.keep_independent_rows([figures])
        if not self.case.points or self.case.points[0].link is not None:
            return  # nothing moves the centre of mass ordinarily
        emitted = self.emit(self.case.motion_yaml(), CENTER, "center")
        if emitted is not None:
            self.compare(emitted, judges, "center", [state])

    def compare(self, emitted, judges, kind, states=None):
        for state in states or [self.freedoms.draw(self.random) for _ in range(STATES)]:
            figures = {judge.name: judge.at(self.freedoms, state) for judge in judges}
            values = draw_inputs(self.case, self.freedoms, state, figures, self.random)
            values.update(self.case.inputs.values if self.case.inputs else {})
            values.update(self.case.shares)
            for name, function in emitted.functions.items():
                ours = function(inputs_for(name, self.case, values))
                for judge in judges:
                    at = figures[judge.name]
                    if name == "forward_dynamics_derivatives":
                        at = self.at_acceleration_of(emitted, judge, state, inputs_for(name, self.case, values))
                    else:
                        at = judge.at(self.freedoms, state)
                    self.compare_one(kind + " " + name, name, ours, judge, at, inputs_for(name, self.case, values))

    def at_acceleration_of(self, emitted, judge, state, values):
        state.qdd, before = emitted.functions["forward_dynamics"](values)["qdd"], state.qdd
        figures = judge.at(self.freedoms, state)
        state.qdd = before
        return figures

    def compare_one(self, label, name, ours, judge, figures, values):
        try:
            expectations = {**EXPECTED, **objects.EXPECTED}[name](figures, self.case, values)
        except Lacking:
            if not label.startswith("drives"):
                self.report.lacking.add((name, judge.name))
            return
        except Undetermined as reason:
            self.report.left_out[self.name, label] = str(reason)
            return
        except Unavailable as reason:
            if name != "forward_dynamics":
                self.report.skip(self.name, label, judge.name, reason)
                return
            expectations = forward_dynamics_by_algebra(figures, self.case, values)
        self.report.had.add((name, judge.name))
        for symbol, result in ours.items():
            self.report.note(self.name, label, judge.name, largest_error(result, expectations[symbol]))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--treeline", required=True)
    parser.add_argument("--work", required=True)
    parser.add_argument("urdf", nargs="+")
    given = parser.parse_args()
    report, cases = Report(os.path.join(os.path.dirname(__file__), "disagreements.tsv")), []
    for path in given.urdf:
        for floating in (False,) if stem_of(path) in MECHANISMS else (False, True):
            begin = time.monotonic()
            trial = Trial(given.treeline, path, floating, given.work, report)
            trial.run()
            report.print_case(trial.name, time.monotonic() - begin)
            cases.append(trial.name)
    faults = [*report.faults(cases), *report.faults_of_table(os.path.join(os.path.dirname(__file__), "../README.md"))]
    print(*faults, sep="\n")
    print(f"{len(cases)} robots on a base, {len(report.errors)} figures compared, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
