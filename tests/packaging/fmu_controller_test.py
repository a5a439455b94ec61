"""Would catch: units of a controller that importers refuse, values that are those of other members of its structs, steps
at other times than its period, and torques that are not those of the step in C."""

import os
import shutil
import subprocess
import unittest

import numpy as np
from fmpy import extract, read_model_description
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Slave
from fmpy.fmi3 import FMU3Slave
from fmpy.validation import validate_fmu

JOINTS = [f"joint{i}" for i in range(1, 7)]
START, MOVE_JOINTS = 4, 6
PERIOD = 0.001


class FmuControllerTest(unittest.TestCase):
    def open(self, version):
        file = os.path.join(os.environ["PACKAGES"], "controllers", version, "arm.fmu")
        self.assertEqual(validate_fmu(file), [])
        description, folder = read_model_description(file), extract(file)
        self.addCleanup(shutil.rmtree, folder)
        self.assertIsNone(description.modelExchange)
        self.assertEqual(float(description.defaultExperiment.stepSize), PERIOD)
        kind = FMU2Slave if version == "fmu" else FMU3Slave
        instance = kind(guid=description.guid, unzipDirectory=folder, modelIdentifier="arm", instanceName="arm")
        instance.instantiate()
        self.addCleanup(instance.freeInstance)
        if version == "fmu":
            instance.setupExperiment()
        instance.enterInitializationMode()
        instance.exitInitializationMode()
        references = {variable.name: variable.valueReference for variable in description.modelVariables}
        get, take = ((instance.getReal, instance.setReal) if version == "fmu" else
                     (instance.getFloat64, instance.setFloat64))
        return (instance, lambda names: get([references[name] for name in names]),
                lambda values: take([references[name] for name in values], list(values.values())))

    def measure(self, k):
        """A robot that is moved along sines, and what it is told at which step."""
        q = {f"{joint}.q": 0.02 * np.sin(0.01 * k * (i + 1)) for i, joint in enumerate(JOINTS)}
        qd = {f"{joint}.qd": 0.02 * 10 * (i + 1) * np.cos(0.01 * k * (i + 1)) for i, joint in enumerate(JOINTS)}
        kind = START if k < 20 else MOVE_JOINTS
        command = {"command.kind": kind, "command.sequence": 1 if k < 20 else 2, "command.duration": 0.5}
        return {**q, **qd, **command, **{f"{joint}.goal": 0.01 * (i + 1) for i, joint in enumerate(JOINTS)}}

    def test_steps_are_those_of_c(self):
        steps = [self.measure(k) for k in range(500)]
        lines = "\n".join(" ".join(map(repr, map(float, step.values()))) for step in steps)
        program = os.path.join(os.environ["PACKAGES"], "controllers", "step")
        printed = subprocess.run([program], input=lines, check=True, capture_output=True, text=True).stdout
        expected = [list(map(float, line.split())) for line in printed.splitlines()]
        modes = [line[6] for line in expected]
        self.assertEqual((len(expected), modes[0], modes[30]), (500, 1, 1))
        results = [f"{joint}.tau" for joint in JOINTS] + ["mode", "faults"]
        for version in ("fmu", "fmu3"):
            instance, get, take = self.open(version)
            for k, step in enumerate(steps):
                take(step)
                instance.doStep(k * PERIOD, PERIOD)
                self.assertEqual(get(results), expected[k], f"{version}, step {k}")

    def test_longer_steps_are_several(self):
        ends = []
        for count in (1, 5):
            instance, get, take = self.open("fmu")
            take(self.measure(0))
            for k in range(20 // count):
                instance.doStep(k * count * PERIOD, count * PERIOD)
            ends.append(get([f"{joint}.tau" for joint in JOINTS]))
        self.assertEqual(*ends)

    def test_refusals(self):
        instance, get, take = self.open("fmu")
        for duration in (0.0, 0.5 * PERIOD, 1.5 * PERIOD, float("nan")):
            with self.assertRaises(FMICallException, msg=f"{duration} s"):
                instance.doStep(0, duration)
        with self.assertRaises(FMICallException):
            take({"joint1.tau": 1.0})
        # Numbers that are none of a command: it is refused, and nothing is undefined.
        take({**self.measure(0), "command.kind": float("inf"), "command.sequence": -1.0})
        instance.doStep(0, PERIOD)
        self.assertEqual(get(["refused"]), [1.0])
        take({"joint2.q": float("nan"), "joint2.qd": float("nan")})
        instance.doStep(PERIOD, PERIOD)
        self.assertEqual(get(["brakes", "mode"]), [1.0, 3.0])


if __name__ == "__main__":
    unittest.main()
