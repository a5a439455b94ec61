"""Would catch: units that another importer than FMPy does not load (libcosim, by Modelon's FMI Library), and a robot and
its controller that move otherwise when it connects them than when each is stepped by hand."""

import os
import shutil
import unittest

from fmpy import extract, read_model_description
from fmpy.fmi2 import FMU2Slave
from libcosimpy.CosimExecution import CosimExecution
from libcosimpy.CosimManipulator import CosimManipulator
from libcosimpy.CosimObserver import CosimObserver
from libcosimpy.CosimSlave import CosimLocalSlave

UNITS = {name: os.path.join(os.environ["PACKAGES"], file)
         for name, file in (("robot", "units/puma560/puma560.fmu"), ("controller", "controllers/fmu/arm.fmu"))}
JOINTS = [f"joint{i}" for i in range(1, 7)]
RATE, STEPS = 1000, 2000  # 1/s
START, MOVE_JOINTS = 4, 6
CONNECTIONS = [(*ends, f"{joint}.{variable}") for joint in JOINTS
               for variable, *ends in (("q", "robot", "controller"), ("qd", "robot", "controller"),
                                       ("tau", "controller", "robot"))]
SEEN = [f"{joint}.{variable}" for joint in JOINTS for variable in ("q", "qd")]


def tell(k):
    """What the controller is told in step k. Without a new number it takes the commander for gone."""
    if k < 20:
        return {"command.kind": START, "command.sequence": k + 1}
    return {"command.kind": MOVE_JOINTS, "command.sequence": k + 1, "command.duration": 0.5,
            **{f"{joint}.goal": 0.05 * (i + 1) for i, joint in enumerate(JOINTS)}}


def references_of(name):
    return {variable.name: variable.valueReference for variable in read_model_description(UNITS[name]).modelVariables}


class FmuCosimTest(unittest.TestCase):
    def step_by_hand(self):
        """The states of the robot after each step of the two units, which FMPy loads."""
        units, references = {}, {name: references_of(name) for name in UNITS}
        for name, file in UNITS.items():
            description, folder = read_model_description(file), extract(file)
            self.addCleanup(shutil.rmtree, folder)
            units[name] = FMU2Slave(guid=description.guid, unzipDirectory=folder, instanceName=name,
                                    modelIdentifier=description.coSimulation.modelIdentifier)
            units[name].instantiate()
            self.addCleanup(units[name].freeInstance)
            units[name].setupExperiment()
            units[name].enterInitializationMode()
            units[name].exitInitializationMode()

        def exchange():
            for source, sink, name in CONNECTIONS:
                units[sink].setReal([references[sink][name]], units[source].getReal([references[source][name]]))

        states = []
        exchange()
        for k in range(STEPS):
            told = tell(k)
            units["controller"].setReal([references["controller"][name] for name in told], list(told.values()))
            for unit in units.values():
                unit.doStep(k / RATE, (k + 1) / RATE - k / RATE)  # as libcosim rounds times
            exchange()
            states.append(units["robot"].getReal([references["robot"][name] for name in SEEN]))
        return states

    def connect(self):
        """The same by libcosim."""
        execution = CosimExecution.from_step_size(1_000_000_000 // RATE)
        index = {name: execution.add_local_slave(CosimLocalSlave(fmu_path=file, instance_name=name))
                 for name, file in UNITS.items()}
        references = {name: references_of(name) for name in UNITS}
        for source, sink, name in CONNECTIONS:
            execution.connect_real_variables(index[source], references[source][name], index[sink], references[sink][name])
        manipulator, observer = CosimManipulator.create_override(), CosimObserver.create_last_value()
        execution.add_manipulator(manipulator)
        execution.add_observer(observer)
        controller, robot = references["controller"], references["robot"]
        states = []
        for k in range(STEPS):
            told = tell(k)
            manipulator.slave_real_values(index["controller"], [controller[name] for name in told], list(told.values()))
            self.assertTrue(execution.step())
            states.append(observer.last_real_values(index["robot"], [robot[name] for name in SEEN]))
        return states

    def test_a_connected_robot_moves_as_by_hand(self):
        states = self.connect()
        self.assertEqual(states, self.step_by_hand())
        for i, joint in enumerate(JOINTS):
            # It should be there after a quarter of the time.
            self.assertAlmostEqual(states[-1][SEEN.index(f"{joint}.q")], 0.05 * (i + 1), places=3, msg=joint)


if __name__ == "__main__":
    unittest.main()
