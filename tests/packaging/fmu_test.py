"""Would catch: units of FMI that importers refuse, names, units and starts that are not the robot's, derivatives of
another state, an integration of a lower order, quaternions that turn otherwise than the robot does, and states that
are kept where they are set back."""

import os
import shutil
import subprocess
import tempfile
import types
import unittest
from xml.etree import ElementTree

import numpy as np
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Model, FMU2Slave
from fmpy.validation import validate_fmu
from robots import Library

SEED = 20261129
NAMES = ("puma560", "humanoid24", "ball_humanoid")


class Unit:
    """A unit of FMI, and the code in it as a library that ctypes calls."""

    def __init__(self, name):
        self.name = name
        self.file = os.path.join(os.environ["PACKAGES"], "units", name, f"{name}.fmu")
        self.library = Library(types.SimpleNamespace(__name__=name, dtype="float64"))
        self.description = read_model_description(self.file)
        self.references = {variable.name: variable.valueReference for variable in self.description.modelVariables}
        self.nq, self.nv = len(self.library.texts("coordinate_joints")), len(self.library.texts("velocity_joints"))
        self.states = [unknown.variable.derivative.name for unknown in self.description.derivatives]
        self.inputs = [variable.name for variable in self.description.modelVariables if variable.causality == "input"]

    def split(self, inputs):
        return {"tau": inputs[:self.nv], "f_ext": inputs[self.nv:]}

    def accelerations(self, state, inputs):
        return self.library.call("forward_dynamics", {"q": state[:self.nq].copy(), "qd": state[self.nq:].copy(),
                                                      **self.split(inputs)})[0]

    def energies(self, state):
        values = {"q": state[:self.nq].copy(), "qd": state[self.nq:].copy()}
        return [self.library.call(f"{kind}_energy", values)[0][0] for kind in ("kinetic", "potential")]

    def draw(self, random, largest=0.1):
        """A state at which the robot is not still, quaternions of length 1, and inputs of at most so many N m."""
        q, qd = random.uniform(-1, 1, self.nq), random.uniform(-0.5, 0.5, self.nv)
        meanings = self.library.texts("coordinate_meanings")
        for i, meaning in enumerate(meanings):
            if meaning == "quaternion x":
                q[i:i + 4] /= np.linalg.norm(q[i:i + 4])
        return np.concatenate([q, qd]), random.uniform(-largest, largest, len(self.inputs))


class FmuTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.units = {name: Unit(name) for name in NAMES}
        cls.folders = {name: extract(unit.file) for name, unit in cls.units.items()}
        for folder in cls.folders.values():
            cls.addClassCleanup(shutil.rmtree, folder)

    def instantiate(self, name, kind, guid=None, step=None):
        instance = kind(guid=guid or self.units[name].description.guid, unzipDirectory=self.folders[name],
                        modelIdentifier=name, instanceName="robot")
        instance.instantiate()
        instance.setupExperiment(startTime=0)
        instance.enterInitializationMode()
        if step is not None:
            instance.setReal([self.units[name].references["step"]], [step])
        instance.exitInitializationMode()
        if kind is FMU2Model:
            instance.newDiscreteStates()
            instance.enterContinuousTimeMode()
        self.addCleanup(instance.freeInstance)
        return instance

    def set_values(self, instance, name, state, inputs):
        unit = self.units[name]
        instance.setReal([unit.references[each] for each in unit.states + unit.inputs], [*state, *inputs])

    def simulate(self, name, state, inputs, duration, step):
        """The state after steps of co-simulation of 0.01 s."""
        instance = self.instantiate(name, FMU2Slave, step=step)
        self.set_values(instance, name, state, inputs)
        for i in range(round(duration / 0.01)):
            instance.doStep(0.01 * i, 0.01)
        return np.array(instance.getReal([self.units[name].references[each] for each in self.units[name].states]))

    def test_validation_finds_nothing(self):
        for unit in self.units.values():
            self.assertEqual(validate_fmu(unit.file), [])

    def test_variables_are_those_of_the_robot(self):
        for unit in self.units.values():
            variables = {variable.name: variable for variable in unit.description.modelVariables}
            joints, home = unit.library.texts("coordinate_joints"), unit.library.numbers("home")
            self.assertEqual([variables[each].name.split(".")[0] for each in unit.states],
                             joints + unit.library.texts("velocity_joints"))
            self.assertEqual([float(variables[each].start) for each in unit.states], home + [0.0] * unit.nv)
            meanings = [*unit.library.texts("coordinate_meanings"), *unit.library.texts("velocity_names")]
            for state, meaning in zip(unit.states, meanings, strict=True):
                self.assertEqual(variables[state].unit, meaning.split(", ")[1] if ", " in meaning else "1")
        puma = {variable.name: variable.unit for variable in self.units["puma560"].description.modelVariables}
        self.assertEqual([puma[f"joint3.{each}"] for each in ("q", "qd", "tau", "qdd")],
                         ["rad", "rad/s", "N.m", "rad/s2"])
        humanoid = {variable.name: variable.unit for variable in self.units["ball_humanoid"].description.modelVariables}
        self.assertEqual([humanoid[each] for each in ("base.tau[3]", "base.tau[4]", "push.f_ext[3]", "push.f_ext[4]")],
                         ["N", "N.m", "N", "N.m"])

    def test_derivatives_are_bits_of_the_code(self):
        """The same sources, compiled with the same flags."""
        random = np.random.default_rng(SEED)
        for name, unit in self.units.items():
            instance = self.instantiate(name, FMU2Model)
            for _ in range(20):
                state, inputs = unit.draw(random)
                self.set_values(instance, name, np.zeros_like(state), inputs)
                state_array, rates = (np.ascontiguousarray(each) for each in (state, np.zeros_like(state)))
                pointer = np.ctypeslib.as_ctypes
                instance.setContinuousStates(pointer(state_array), len(state))
                instance.getDerivatives(pointer(rates), len(rates))
                expected = unit.accelerations(state, inputs)
                self.assertEqual(rates[unit.nq:].tobytes(), expected.tobytes(), f"{name}, seed {SEED}")
                outputs = [unit.references[unknown.variable.name] for unknown in unit.description.outputs]
                self.assertEqual(instance.getReal(outputs), [*state, *expected])
                if unit.nq == unit.nv:
                    self.assertEqual(rates[:unit.nq].tobytes(), state[unit.nq:].tobytes())

    def test_co_simulation_is_the_method_of_runge_and_kutta(self):
        """The tolerance is what 1e-13 of the start makes of the end: some 2000 roundings of 1e-16 on the way."""
        random = np.random.default_rng(SEED)
        for name in ("puma560", "humanoid24"):
            unit = self.units[name]
            state, inputs = unit.draw(random)
            other = state * (1 + random.choice([-1e-13, 1e-13], state.shape))
            expected, spread = (integrate(unit, each, inputs, 0.001, 300) for each in (state, other))
            made = self.simulate(name, state, inputs, 0.3, None)
            self.assertGreater(np.abs(made - state).max(), 0.1)
            self.assertLessEqual(np.abs(made - expected).max(), np.abs(spread - expected).max() + 1e-13, name)

    def test_model_exchange_leads_to_the_same_state(self):
        """The tolerance is what 1e-6 of the start makes of the end: a thousand steps of CVODE, each of which may miss
        by several times 1e-10 of the state. Torques are small: of 0.1 N m the humanoid's hands get 5000 rad/s^2."""
        random = np.random.default_rng(SEED)
        for name in ("puma560", "humanoid24"):
            unit = self.units[name]
            state, inputs = unit.draw(random, 0.002)
            other = state * (1 + random.choice([-1e-6, 1e-6], state.shape))
            expected, spread = (integrate(unit, each, inputs, 0.0005, 600) for each in (state, other))
            start = dict(zip(unit.states + unit.inputs, [*state, *inputs], strict=True))
            result = simulate_fmu(unit.file, fmi_type="ModelExchange", stop_time=0.3, start_values=start,
                                  relative_tolerance=1e-10, output_interval=0.01)
            made = np.array([result[each][-1] for each in unit.states])
            self.assertLessEqual(np.abs(made - expected).max(), np.abs(spread - expected).max(), name)

    def test_energy_is_kept(self):
        """Without torque, friction and springs. Half the step leaves a sixteenth of the error, or less; 10 allows for
        terms of higher order. Kinetic and potential energy are functions of their own. A quaternion whose rate is not
        the robot's makes an error that no step makes smaller."""
        random = np.random.default_rng(SEED)
        for name, unit in self.units.items():
            state, inputs = unit.draw(random)
            before = sum(unit.energies(state))
            errors = []
            for step in (0.005, 0.0025):
                after = unit.energies(self.simulate(name, state, 0 * inputs, 0.3, step))
                errors.append(abs(sum(after) - before) / max(after[0], 1))
            self.assertLess(errors[1], max(errors[0] / 10, 1e-12), f"{name}: {errors}, seed {SEED}")
            self.assertLess(errors[0], 1e-3, f"{name}: {errors}, seed {SEED}")

    def test_quaternions_keep_their_length(self):
        """To 2 ulp: they are divided by their length at each step."""
        unit = self.units["ball_humanoid"]
        state = self.simulate("ball_humanoid", *unit.draw(np.random.default_rng(SEED)), 0.1, None)
        turns = [i for i, meaning in enumerate(unit.library.texts("coordinate_meanings")) if meaning == "quaternion x"]
        self.assertGreater(len(turns), 1)
        for i in turns:
            self.assertAlmostEqual(float(np.linalg.norm(state[i:i + 4])), 1, delta=4.5e-16)

    def test_gravity_torque_holds_the_arm(self):
        """What is left is rounding, which grows as an inverted pendulum does: 1e-15 rad by some 1e4 within a second."""
        unit = self.units["puma560"]
        state = np.concatenate([unit.draw(np.random.default_rng(SEED))[0][:6], np.zeros(6)])
        torque = unit.library.call("gravity", {"q": state[:6].copy()})[0]
        held = self.simulate("puma560", state, torque, 1, None)
        self.assertLess(np.abs(held - state).max(), 1e-11)
        self.assertGreater(np.abs(self.simulate("puma560", state, 0 * torque, 1, None) - state).max(), 0.1)

    def test_directional_derivatives(self):
        """Against central differences of 1e-6: their error is 1e-12 of third derivatives, and 1e-10 by rounding."""
        unit, random = self.units["puma560"], np.random.default_rng(SEED)
        self.assertTrue(unit.description.modelExchange.providesDirectionalDerivative)
        self.assertFalse(self.units["humanoid24"].description.modelExchange.providesDirectionalDerivative)
        instance = self.instantiate("puma560", FMU2Model)
        state, inputs = unit.draw(random)
        knowns = [unit.references[each] for each in unit.states + unit.inputs]
        unknowns = [unit.references[unknown.variable.name]
                    for unknown in unit.description.derivatives + unit.description.outputs]
        values, seed = np.concatenate([state, inputs]), random.uniform(-1, 1, len(knowns))
        ends = []
        for sign in (1, -1):
            instance.setReal(knowns, list(values + sign * 1e-6 * seed))
            ends.append(np.array(instance.getReal(unknowns)))
        instance.setReal(knowns, list(values))
        made = np.array(instance.getDirectionalDerivative(unknowns, knowns, list(seed)))
        difference = (ends[0] - ends[1]) / 2e-6
        self.assertLess(np.abs(made - difference).max(), 1e-7 * np.abs(difference).max())
        with self.assertRaises(FMICallException):
            instance.getDirectionalDerivative(unknowns, [unit.references["step"]], [1.0])

    def test_states_are_kept_and_set_back(self):
        unit = self.units["humanoid24"]
        instance = self.instantiate("humanoid24", FMU2Slave)
        references = [unit.references[unknown.variable.name] for unknown in unit.description.outputs]
        first = instance.getReal(references)
        instance.setReal([unit.references[unit.inputs[0]]], [3.0])
        kept = instance.getFMUstate()
        ends = []
        for _ in range(2):
            instance.doStep(0, 0.1)
            ends.append(instance.getReal(references))
            instance.setFMUstate(instance.deSerializeFMUstate(instance.serializeFMUstate(kept)))
        self.assertEqual(*ends)
        self.assertNotEqual(ends[0], first)
        instance.reset()
        self.assertEqual(instance.getReal(references), first)

    def test_refusals(self):
        unit = self.units["puma560"]
        with self.assertRaises(Exception, msg="another guid"):
            self.instantiate("puma560", FMU2Model, guid="0" * 64)
        for step in (0.0, -1.0, float("nan")):
            with self.assertRaises(FMICallException, msg=f"step {step}"):
                self.instantiate("puma560", FMU2Slave, step=step)
        instance = self.instantiate("puma560", FMU2Slave)
        for reference in (unit.references["joint1.qdd"], 10**6):
            with self.assertRaises(FMICallException):
                instance.setReal([reference], [1.0])
        instance.setReal([unit.references["joint1.tau"]], [float("inf")])
        with self.assertRaises(FMICallException):
            instance.doStep(0, 0.01)

    def test_binaries_export_the_interface_alone(self):
        wanted = {name for kind in (FMU2Model, FMU2Slave) for name in dir(kind) if name.startswith("fmi2")}
        for name, folder in self.folders.items():
            binary = os.path.join(folder, "binaries", "linux64", f"{name}.so")
            lines = subprocess.run(["nm", "-D", "--defined-only", binary], check=True, capture_output=True, text=True)
            exported = {line.split()[2] for line in lines.stdout.splitlines()}
            self.assertLessEqual(wanted, exported)
            self.assertEqual({each for each in exported if not each.startswith("fmi2")}, set())

    def test_sources_are_whole(self):
        """As a compiler has them that knows nothing but modelDescription.xml."""
        for name, folder in self.folders.items():
            root = ElementTree.parse(os.path.join(folder, "modelDescription.xml")).getroot()
            for kind in ("ModelExchange", "CoSimulation"):
                files = [file.get("name") for file in root.findall(f"{kind}/SourceFiles/File")]
                with tempfile.TemporaryDirectory() as work:
                    library = os.path.join(work, "unit.so")
                    subprocess.run(["cc", "-std=c99", "-shared", "-fPIC", f"-DFMI2_FUNCTION_PREFIX={name}_",
                                    "-o", library, *files, "-lm"], check=True, cwd=os.path.join(folder, "sources"))
                    names = subprocess.run(["nm", "-D", library], check=True, capture_output=True, text=True).stdout
                    self.assertIn(f" {name}_fmi2DoStep\n", names)


def integrate(unit, state, inputs, step, count):
    """The classical method of Runge and Kutta, for robots whose dq/dt is qd."""
    def rates(at):
        return np.concatenate([at[unit.nq:], unit.accelerations(at, inputs)])
    for _ in range(count):
        first = rates(state)
        second = rates(state + step / 2 * first)
        third = rates(state + step / 2 * second)
        state = state + step / 6 * (first + 2 * second + 2 * third + rates(state + step * third))
    return state


if __name__ == "__main__":
    unittest.main()
