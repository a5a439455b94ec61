"""Would catch: members of structs that are missing or read at other places than C's, steps that are not those of C, states of
a batch that are mixed up, and wrong values that crash, are taken, or are refused without saying why."""

import array
import copy
import ctypes
import os
import pickle
import pydoc
import unittest

import humanoid_limited
import numpy as np
import puma_controlled
from puma_controlled import Controller, Fault, Kind, Mode, Refusal

SEED = 20261130
DT = 1e-3


def library_of(robot):
    return ctypes.CDLL(os.path.join(os.environ["PACKAGES"], f"{robot.__name__}.so"))


def pointers(*arrays):
    return [each.ctypes.data_as(ctypes.c_void_p) for each in arrays]


def memories(controller):
    return [part._memory for part in (controller.config, controller.state, controller.input, controller.output)]


def structs_of(robot):
    return [each for each in vars(robot.structs).values()
            if isinstance(each, type) and issubclass(each, robot.structs.Struct) and each._struct]


class Plant:
    """An arm with ideal motors."""

    def __init__(self):
        self.q, self.qd = np.array([0, -0.7, 0.4, 0, 0.3, 0]), np.zeros(6)

    def move(self, tau):
        self.qd = self.qd + DT * puma_controlled.forward_dynamics(self.q, self.qd, tau)
        self.q = self.q + DT * self.qd


class LayoutTest(unittest.TestCase):
    def test_members_fill_their_structs(self):
        """But for what C leaves between members and at the end, less than a number."""
        for robot, least in ((puma_controlled, 5), (humanoid_limited, 3)):
            structs = structs_of(robot)
            self.assertGreaterEqual(len(structs), least)
            for struct in structs:
                size, members = robot._native._layouts[struct._struct]
                end = 0
                for name, _, offset, room, _ in members:
                    self.assertTrue(0 <= offset - end < 8, (struct, name))
                    end = offset + room
                self.assertTrue(0 <= size - end < 8, struct)

    def test_defaults_are_those_of_c(self):
        config = Controller().config
        self.assertEqual(config.period, DT)
        torque = list(puma_controlled.effort_limits)
        torque[1] = 150  # by the scene
        self.assertEqual(config.torque.tolist(), torque)
        self.assertEqual((config.stale_ticks, config.blind_ticks, config.saturation), (200, 100, 0))
        limits = humanoid_limited.TorqueLimits()
        given = np.array(humanoid_limited.effort_limits)
        self.assertEqual(limits.torque.tolist(), np.where(np.isinf(given), 1e30, given).tolist())
        self.assertEqual(limits.cones.shape, (22,))
        self.assertGreater(np.abs(limits.cones["coefficients"]).sum(), 20)

    def test_help(self):
        self.assertIn("help(puma_controlled.structs): Controller, Fault, Kind, Mode,", puma_controlled.__doc__)
        self.assertTrue("rad/s: how stiffly it is led" in pydoc.plain(pydoc.render_doc(puma_controlled.structs)))

    def test_enumerators(self):
        with open(os.path.join(os.environ["PACKAGES"], "with blanks", "puma_controlled", "src",
                               "puma_controlled_controller.h"), encoding="utf-8") as file:
            header = file.read()
        self.assertEqual([fault.value for fault in Fault], [1 << i for i in range(len(Fault))])
        for enumeration, prefix in ((Mode, ""), (Fault, "FAULT_"), (Kind, ""), (Refusal, ""),
                                    (puma_controlled.Unmet, "UNMET_")):
            self.assertGreater(len(enumeration), 3)
            for each in enumeration:
                self.assertIn(f"PUMA_CONTROLLED_{prefix}{each.name} = {each.value}", header)


class ControllerTest(unittest.TestCase):
    def test_steps_are_those_of_c(self):
        """Of a motion, and of an encoder that is lost on the way."""
        controller, plant, library = Controller(), Plant(), library_of(puma_controlled)
        twin = [each.copy() for each in memories(controller)]
        goal = np.array([1.2, -1.3, 1.0, 0.5, 0.8, 0])
        controller.config.stale_ticks = 0
        for tick in range(4000):
            if tick == 100:
                controller.command(Kind.START)
            if tick == 200:
                controller.command(Kind.MOVE_JOINTS, goal=goal, duration=1.5)
            q = plant.q.copy()
            if tick > 2500:
                q[1] = np.nan
            for part, ours in zip(twin, memories(controller)):
                part[:] = ours
            output = controller.step(q, plant.qd)
            twin[2][:] = controller.input._memory
            library.puma_controlled_step(*pointers(*twin))
            for part, ours in zip(twin, memories(controller)):
                self.assertEqual(part.tobytes(), ours.tobytes())
            if tick == 2500:
                np.testing.assert_allclose(plant.q, goal, atol=1e-3)
                self.assertEqual((output.mode, output.faults, bool(output.brakes)), (Mode.RUNNING, Fault(0), False))
            plant.move(output.tau)
        self.assertEqual((output.mode, output.reason, output.brakes), (Mode.FAULTED, Fault.MEASUREMENT, 1))
        self.assertLess(np.abs(plant.qd).max(), 0.1)

    def test_commands(self):
        controller = Controller()
        q = np.array([0, -0.7, 0.4, 0, 0.3, 0])
        self.assertEqual(controller.step(q, np.zeros(6)).mode, Mode.IDLE)
        controller.command(Kind.MOVE_JOINTS, duration=1.0)
        self.assertEqual(controller.step().refused, Refusal.REFUSED_MODE)
        controller.command(Kind.START)
        self.assertEqual(controller.step().mode, Mode.RUNNING)
        sequence = controller.input.command.sequence
        for members, fault in (({"goals": q}, TypeError), ({"sequence": 3}, TypeError), ({"goal": q[:5]}, ValueError),
                               ({"duration": "1 s"}, TypeError), ({"point": 1.5}, TypeError)):
            with self.assertRaises(fault):
                controller.command(Kind.MOVE_JOINTS, **members)
        self.assertEqual(controller.input.command.sequence, sequence)  # nothing was told
        controller.input.command.sequence = 2**32 - 1
        controller.command(Kind.EMERGENCY_STOP)
        self.assertEqual(controller.step().faults, Fault.EMERGENCY)
        self.assertIn("EMERGENCY", repr(controller.output))

    def test_a_configuration_that_is_not_sound(self):
        controller = Controller()
        controller.check()
        controller.config.joint_damping[3] = -1
        with self.assertRaisesRegex(ValueError, r"config.joint_damping: entry 3, -1.0, cannot be used"):
            controller.check()
        self.assertIn(Fault.CONFIG, controller.step(np.zeros(6), np.zeros(6)).faults)

    def test_many_controllers(self):
        random = np.random.default_rng(SEED)
        many, single = Controller(50), [Controller() for _ in range(50)]
        for tick in range(30):
            q, qd = random.uniform(-0.5, 0.5, (50, 6)), random.uniform(-1, 1, (50, 6))
            if tick == 5:
                many.command(Kind.START)
            output = many.step(q, qd, threads=3)
            for i, one in enumerate(single):
                if tick == 5:
                    one.command(Kind.START)
                self.assertEqual(one.step(q[i], qd[i]).tau.tobytes(), output.tau[i].tobytes())
                self.assertEqual(one.output.faults, output.faults[i])
        self.assertEqual(many.input.command.sequence.tolist(), [1] * 50)

    def test_values_that_are_refused(self):
        controller = Controller()
        config, given = controller.config, controller.input
        for struct, member, value, fault, text in (
                (config, "period", None, TypeError, "period: wants numbers of float64, not of object"),
                (config, "period", "1", TypeError, "period: wants"),
                (config, "period", 2**200, TypeError, "period: wants"),
                (config, "period", [1e-3], ValueError, r"period: has the shape \(1,\), wants \(\)"),
                (config, "stale_ticks", 2.0, TypeError, "stale_ticks: wants numbers of int32, not of float64"),
                (config, "stale_ticks", 2**40, ValueError, "stale_ticks: 1099511627776 does not fit into int32"),
                (config, "torque", np.ones(5), ValueError, r"torque: has the shape \(5,\), wants \(6,\)"),
                (config, "torque", np.ones((6, 1)), ValueError, "torque: has the shape"),
                (config, "torque", 1.0, ValueError, "torque: has the shape"),
                (config, "torque", np.ones(6, complex), TypeError, "torque: wants numbers"),
                (given.command, "sequence", -1, ValueError, "does not fit into uint32"),
                (given, "q", [[0.0] * 6] * 2, ValueError, "q: has the shape"),
                (given, "gravitation", 1.0, AttributeError, "gravitation"),
                (given, "command", 1.0, AttributeError, "command")):
            before = [each.tobytes() for each in memories(controller)]
            with self.subTest(member=member, value=value), self.assertRaisesRegex(fault, text):
                setattr(struct, member, value)
            self.assertEqual([each.tobytes() for each in memories(controller)], before)
        given.q = np.arange(12, dtype="f4")[::-2]
        self.assertEqual(given.q.tolist(), [11, 9, 7, 5, 3, 1])
        given.q = array.array("d", [1.0] * 6)
        self.assertEqual(given.q.sum(), 6)

    def test_counts(self):
        self.assertEqual(Controller(0).step(np.zeros((0, 6)), np.zeros((0, 6))).tau.shape, (0, 6))
        for count, fault in ((-1, ValueError), (2**60, (ValueError, MemoryError)), ("2", TypeError), (1.5, TypeError)):
            with self.assertRaises(fault):
                Controller(count)
        for threads, fault in ((0, ValueError), (None, TypeError)):
            with self.assertRaises(fault):
                Controller(3).step(threads=threads)

    def test_copies(self):
        controller = Controller()
        controller.config.jump = 0.125
        for made in (copy.deepcopy(controller), pickle.loads(pickle.dumps(controller))):
            self.assertEqual([each.tobytes() for each in memories(made)],
                             [each.tobytes() for each in memories(controller)])
            made.config.jump = 0.5
            self.assertEqual(made.config.jump, 0.5)
        self.assertEqual(controller.config.jump, 0.125)

    def test_random_memory(self):
        """The extension takes what fits and refuses the rest, whatever it is given."""
        random = np.random.default_rng(SEED)
        outcomes = {"computed": 0, "refused": 0}
        native = puma_controlled._native
        for trial in range(3000):
            arguments = memories(Controller(None if random.random() < 0.5 else int(random.integers(0, 4))))
            for i in random.choice(4, random.integers(0, 3), replace=False):
                arguments[i] = spoil(arguments[i], random)
            if trial % 7 == 0:
                arguments[int(random.integers(4))] = arguments[int(random.integers(4))]
            try:
                native._step(*arguments[:3], out=arguments[3])
                outcomes["computed"] += 1
            except (TypeError, ValueError) as refusal:
                self.assertRegex(str(refusal), r"^\w+: ")
                outcomes["refused"] += 1
        self.assertGreater(min(outcomes.values()), 500)


def spoil(memory, random):
    fixed = memory.copy()
    fixed.flags.writeable = False
    forms = [lambda: None, lambda: 2**80, lambda: "text", lambda: memory[..., :-1], lambda: memory[..., ::2],
             lambda: memory[..., ::-1], lambda: memory.astype("f4"), lambda: memory[None], lambda: fixed,
             lambda: np.broadcast_to(memory, (3, *memory.shape)), lambda: memory.tobytes(), lambda: memory,
             lambda: random.normal(size=memory.shape), lambda: random.integers(0, 256, memory.nbytes, np.uint8)
             .view(float).reshape(memory.shape), lambda: np.zeros(memory.nbytes + 8, np.uint8)[1:-7].view(float)
             .reshape(memory.shape)]
    return forms[random.integers(len(forms))]()


class LimitedTest(unittest.TestCase):
    def draw(self, random, states):
        home = np.array(humanoid_limited.home)
        q = np.tile(home, (states, 1))
        q[:, 7:] += random.uniform(-0.3, 0.3, (states, humanoid_limited.nq - 7))
        qd = random.uniform(-0.5, 0.5, (states, humanoid_limited.nv))
        rest = np.zeros(humanoid_limited.nv)
        return q, qd, rest, random.uniform(-15, 15, (states, humanoid_limited.task_rows)), np.zeros(12)

    def call(self, arguments, **others):
        return humanoid_limited.limited_control_torque(*arguments, **others)

    def test_torques_are_those_of_c_and_within_limits(self):
        random, library = np.random.default_rng(SEED), library_of(humanoid_limited)
        limited, limits = humanoid_limited.LimitedTorque(), humanoid_limited.TorqueLimits()
        warm, cut = limited._memory.copy(), 0
        largest = np.array(humanoid_limited.effort_limits)
        for state in zip(*(np.broadcast_to(each, (40, each.shape[-1])) for each in self.draw(random, 40))):
            arguments = [np.ascontiguousarray(each) for each in state]
            results = self.call(arguments, limited=limited)
            tau, f = np.full(humanoid_limited.nv, np.nan), np.full(12, np.nan)
            library.humanoid_limited_limited_control_torque(*pointers(*arguments, tau, f, warm, limits._memory))
            self.assertEqual((results.tau.tobytes(), results.f.tobytes()), (tau.tobytes(), f.tobytes()))
            self.assertEqual(limited._memory.tobytes(), warm.tobytes())
            self.assertTrue((np.abs(tau) <= largest * (1 + 1e-12)).all())
            cut += limited.limited
        self.assertGreater(cut, 5)
        self.assertIsInstance(limited.limited, bool)

    def test_limits_that_are_changed(self):
        arguments = [each[0] if each.ndim > 1 else each for each in self.draw(np.random.default_rng(SEED), 1)]
        limits = humanoid_limited.TorqueLimits()
        free = self.call(arguments, limited=humanoid_limited.LimitedTorque())
        joint = int(np.abs(free.tau[6:]).argmax()) + 6
        limits.torque[joint] = abs(free.tau[joint]) / 2
        limited = humanoid_limited.LimitedTorque()
        weak = self.call(arguments, limited=limited, limits=limits)
        self.assertLessEqual(abs(weak.tau[joint]), limits.torque[joint] * (1 + 1e-12))
        self.assertTrue(limited.limited)

    def test_batches(self):
        arguments = self.draw(np.random.default_rng(SEED), 20)
        many = humanoid_limited.LimitedTorque(20)
        for _ in range(2):  # the second begins where the first ended
            together = self.call(arguments, limited=many, threads=2)
        for i in range(20):
            one = humanoid_limited.LimitedTorque()
            for _ in range(2):
                alone = self.call([each if each.ndim == 1 else each[i] for each in arguments], limited=one)
            self.assertEqual((alone.tau.tobytes(), alone.f.tobytes()), (together.tau[i].tobytes(), together.f[i].tobytes()))
            self.assertEqual(one.slack, many.slack[i])
        for limited in (humanoid_limited.LimitedTorque(), humanoid_limited.LimitedTorque(19)):
            with self.assertRaisesRegex(ValueError, r"limited_torque: has the shape"):
                self.call(arguments, limited=limited)
        for wrong in ({"limited": None}, {"limited": humanoid_limited.LimitedTorque(20), "limits": [1.0]}):
            with self.assertRaisesRegex(TypeError, f"{list(wrong)[-1]}: wants a "):
                self.call(arguments, **wrong)


if __name__ == "__main__":
    unittest.main()
