"""Would catch: units of FMI 3.0 that importers refuse or that call functions otherwise than FMI's headers do, and motion,
derivatives and states that are not those of the units of FMI 2.0, which fmu_test.py compares with the robot's code."""

import os
import re
import shutil
import subprocess
import tempfile
import unittest
from xml.etree import ElementTree

import fmpy
import fmu_test
import numpy as np
from fmpy import extract, read_model_description, simulate_fmu
from fmpy.fmi1 import FMICallException
from fmpy.fmi2 import FMU2Model
from fmpy.fmi3 import FMU3Model, FMU3Slave
from fmpy.validation import validate_fmu
from lxml import etree

SEED = 20261129
NAMES = ("puma560", "ball_humanoid")
HEADERS = os.path.join(os.path.dirname(fmpy.__file__), "c-code")
# These take functions that FMI calls back, of which units call the one that logs alone.
WITH_CALLBACKS = {"fmi3InstantiateCoSimulation", "fmi3InstantiateScheduledExecution"}


class Fmu3Test(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.second = {name: fmu_test.Unit(name) for name in NAMES}
        cls.files = {name: os.path.join(os.environ["PACKAGES"], "units3", name, f"{name}.fmu") for name in NAMES}
        cls.descriptions = {name: read_model_description(file) for name, file in cls.files.items()}
        cls.references = {name: {variable.name: variable.valueReference for variable in description.modelVariables}
                          for name, description in cls.descriptions.items()}
        cls.folders = {name: extract(file) for name, file in cls.files.items()}
        for folder in cls.folders.values():
            cls.addClassCleanup(shutil.rmtree, folder)

    def instantiate(self, name, kind, token=None, start=0.0, step=None):
        instance = kind(guid=token or self.descriptions[name].guid, unzipDirectory=self.folders[name],
                        modelIdentifier=name, instanceName="robot")
        instance.instantiate()
        self.addCleanup(instance.freeInstance)
        instance.enterInitializationMode(startTime=start)
        if step is not None:
            instance.setFloat64([self.references[name]["step"]], [step])
        instance.exitInitializationMode()
        instance.enterContinuousTimeMode() if kind is FMU3Model else instance.enterStepMode()
        return instance

    def draw(self, name):
        unit = self.second[name]
        state, inputs = unit.draw(np.random.default_rng(SEED))
        return state, inputs, dict(zip(unit.states + unit.inputs, [*state, *inputs], strict=True))

    def test_validation_finds_nothing(self):
        schema = os.path.join(os.path.dirname(fmpy.__file__), "schema", "fmi3", "fmi3BuildDescription.xsd")
        for name, file in self.files.items():
            self.assertEqual(validate_fmu(file), [])
            build = os.path.join(self.folders[name], "sources", "buildDescription.xml")
            etree.XMLSchema(etree.parse(schema)).assertValid(etree.parse(build))

    def test_variables_are_those_of_the_second_version(self):
        def facts(description, of):
            return [(variable.name, variable.causality, variable.variability, variable.unit, variable.start,
                     variable.derivative and variable.derivative.name) for variable in description.modelVariables
                    if variable.type == of and variable.causality != "independent"]
        for name, description in self.descriptions.items():
            second = self.second[name].description
            self.assertEqual(facts(description, "Float64"), facts(second, "Real"))
            for kind in ("outputs", "derivatives", "initialUnknowns"):
                self.assertEqual([each.variable.name for each in getattr(description, kind)],
                                 [each.variable.name for each in getattr(second, kind)])

    def test_simulations_are_those_of_the_second_version(self):
        for name in NAMES:
            _, _, start = self.draw(name)
            for kind in ("CoSimulation", "ModelExchange"):
                ends = [simulate_fmu(file, fmi_type=kind, stop_time=0.1, output_interval=0.01, start_values=start,
                                     relative_tolerance=None if kind == "CoSimulation" else 1e-9)
                        for file in (self.second[name].file, self.files[name])]
                for state in self.second[name].states:
                    self.assertEqual(ends[0][state].tobytes(), ends[1][state].tobytes(), f"{name} {kind} {state}")
                self.assertNotEqual(ends[0][state][0], ends[0][state][-1])

    def test_derivatives_are_bits_of_the_code(self):
        for name in NAMES:
            unit, (state, inputs, start) = self.second[name], self.draw(name)
            instance = self.instantiate(name, FMU3Model)
            self.assertEqual(instance.getNumberOfContinuousStates(), len(state))
            instance.setFloat64([self.references[name][each] for each in start], list(start.values()))
            rates = np.zeros_like(state)
            instance.getContinuousStateDerivatives(np.ctypeslib.as_ctypes(rates), len(rates))
            self.assertEqual(rates[unit.nq:].tobytes(), unit.accelerations(state, inputs).tobytes())

    def test_directional_derivatives_are_those_of_the_second_version(self):
        unit, (_, _, start) = self.second["puma560"], self.draw("puma560")
        for name in NAMES:  # FMPy knows the name that the attribute has in FMI 2.0
            root = ElementTree.parse(os.path.join(self.folders[name], "modelDescription.xml")).getroot()
            offers = [root.find(kind).get("providesDirectionalDerivatives") for kind in ("ModelExchange", "CoSimulation")]
            self.assertEqual(offers, 2 * ["true" if name == "puma560" else None])
        seed = np.random.default_rng(SEED).uniform(-1, 1, len(start))
        folder = extract(unit.file)
        self.addCleanup(shutil.rmtree, folder)
        old = FMU2Model(guid=unit.description.guid, unzipDirectory=folder, modelIdentifier="puma560",
                        instanceName="robot")
        old.instantiate()
        self.addCleanup(old.freeInstance)
        new, made = self.instantiate("puma560", FMU3Model), []
        for instance, set_values, references in ((old, old.setReal, unit.references),
                                                 (new, new.setFloat64, self.references["puma560"])):
            knowns = [references[each] for each in start]
            unknowns = [references[each.variable.name] for each in unit.description.derivatives]
            set_values(knowns, list(start.values()))
            made.append(instance.getDirectionalDerivative(unknowns, knowns, list(seed)))
        self.assertEqual(*made)
        self.assertGreater(np.abs(made[0]).max(), 1)

    def test_states_are_kept_and_set_back(self):
        name = "puma560"
        instance = self.instantiate(name, FMU3Slave, start=2.0)
        references = [self.references[name][each] for each in [*self.second[name].states, "time"]]
        first = instance.getFloat64(references)
        self.assertEqual(first[-1], 2.0)
        instance.setFloat64([self.references[name]["joint1.tau"]], [3.0])
        kept, ends = instance.getFMUState(), []
        for _ in range(2):
            instance.doStep(2.0, 0.125)
            ends.append(instance.getFloat64(references))
            state = instance.deserializeFMUState(instance.serializeFMUState(kept))
            instance.setFMUState(state)
            instance.freeFMUState(state)
        instance.freeFMUState(kept)
        self.assertEqual(*ends)
        self.assertEqual(ends[0][-1], 2.125)
        self.assertNotEqual(ends[0][:-1], first[:-1])
        instance.reset()
        self.assertEqual(instance.getFloat64(references)[:-1], first[:-1])

    def test_refusals(self):
        name = "puma560"
        with self.assertRaises(Exception, msg="another token"):
            self.instantiate(name, FMU3Model, token="0" * 64)
        for step in (0.0, -1.0, float("nan")):
            with self.assertRaises(FMICallException, msg=f"step {step}"):
                self.instantiate(name, FMU3Slave, step=step)
        instance = self.instantiate(name, FMU3Slave)
        for reference in (self.references[name]["joint1.qdd"], self.references[name]["time"], 10**6):
            with self.assertRaises(FMICallException):
                instance.setFloat64([reference], [1.0])
        with self.assertRaises(FMICallException):
            instance.getInt32([0])
        with self.assertRaises(FMICallException):
            instance.getFloat64([self.references[name]["time"] + 1])
        instance.setFloat64([self.references[name]["joint1.tau"]], [float("inf")])
        with self.assertRaises(FMICallException):
            instance.doStep(0, 0.01)

    def test_functions_are_those_of_the_headers_of_fmi(self):
        """Every function is there, with the arguments that FMI's own headers state, and nothing else is exported. Enums
        stand for whole numbers, and `const` is left out: neither changes a call."""
        with open(os.path.join(HEADERS, "fmi3FunctionTypes.h"), encoding="utf-8") as file:
            types = file.read()
        functions = {name.removesuffix("TYPE") for name in re.findall(r"\b(fmi3\w+TYPE)\b", types)}
        self.assertGreater(len(functions), 60)
        types = re.sub(r"typedef enum \{[^}]*\} fmi3Status;", "typedef unsigned fmi3Status;", types)
        types = re.sub(r"typedef enum \{[^}]*\} (\w+);", r"typedef int \1;", types)
        for name, folder in self.folders.items():
            binary = os.path.join(folder, "binaries", "x86_64-linux", f"{name}.so")
            lines = subprocess.run(["nm", "-D", "--defined-only", binary], check=True, capture_output=True, text=True)
            self.assertEqual({line.split()[2] for line in lines.stdout.splitlines()}, functions)
        with tempfile.TemporaryDirectory() as work:
            with open(os.path.join(work, "types.h"), "w", encoding="utf-8") as file:
                file.write(types)
            with open(os.path.join(work, "check.c"), "w", encoding="utf-8") as file:
                file.write('#include <math.h>\n#include <stdlib.h>\n#include <string.h>\n#define const\n'
                           '#include "fmu.c"\n#include "types.h"\n')
                file.writelines(f"{function}TYPE* check_{function} = {function};\n"
                                for function in sorted(functions - WITH_CALLBACKS))
            subprocess.run(["cc", "-std=c99", "-fsyntax-only", "-Werror=incompatible-pointer-types", "-I", work,
                            "-I", os.path.join(self.folders["puma560"], "sources"), "-I", HEADERS, "check.c"],
                           check=True, cwd=work)

    def test_sources_are_whole(self):
        """As a compiler has them that knows nothing but buildDescription.xml."""
        for name, folder in self.folders.items():
            sources = os.path.join(folder, "sources")
            root = ElementTree.parse(os.path.join(sources, "buildDescription.xml")).getroot()
            files = [file.get("name") for file in root.iter("SourceFile")]
            libraries = [f"-l{library.get('name')}" for library in root.iter("Library")]
            with tempfile.TemporaryDirectory() as work:
                library = os.path.join(work, "unit.so")
                subprocess.run(["cc", "-std=c99", "-shared", "-fPIC", f"-DFMI3_FUNCTION_PREFIX={name}_", "-Wl,-z,defs",
                                "-o", library, *files, *libraries], check=True, cwd=sources)
                names = subprocess.run(["nm", "-D", library], check=True, capture_output=True, text=True).stdout
                self.assertIn(f" {name}_fmi3DoStep\n", names)


if __name__ == "__main__":
    unittest.main()
