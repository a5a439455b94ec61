"""Would catch: wrong arguments that crash the interpreter, are read as something else, or are refused without saying
which and why; references that are lost or kept."""

import array
import sys
import unittest

import humanoid24_floating
import numpy as np
import ur10e
from robots import ROBOTS, Library, as_list, draw, python_name

SEED = 20261129


class RefusalsTest(unittest.TestCase):
    def setUp(self):
        self.q, self.qd, self.qdd = np.ones((3, 6))

    def refuses(self, exception, *parts, function=ur10e.inverse_dynamics, **arguments):
        values = {"q": self.q, "qd": self.qd, "qdd": self.qdd, **arguments}
        with self.assertRaises(exception) as caught:
            function(**values)
        for part in parts:
            self.assertIn(part, str(caught.exception))

    def test_types(self):
        self.refuses(TypeError, "q: wants numbers of float64", "<class 'list'>; numpy.asarray(q, \"float64\") converts", q=[0] * 6)
        self.refuses(TypeError, "qd: ", "<class 'NoneType'>", qd=None)
        self.refuses(TypeError, "qdd: ", "format d", "not of format f", qdd=np.ones(6, "float32"))
        self.refuses(TypeError, "q: ", "not of format l", q=np.ones(6, int))
        self.refuses(TypeError, "q: ", "not of format >d", q=np.ones(6, ">f8"))
        self.refuses(TypeError, "q: ", "not of format Zd", q=np.ones(6, complex))
        self.refuses(TypeError, "q: wants numbers of float64", q=np.ones(6, "M8[s]"))
        self.refuses(TypeError, "q: ", "not of format B", q=bytes(48))
        self.refuses(TypeError, "out: ", "not of format f", out=array.array("f", bytes(24)))
        self.refuses(TypeError, "threads: wants an integer", threads=2.0)
        self.refuses(TypeError, "threads: wants an integer", threads=None)
        q = np.ones(humanoid24_floating.nq)
        with self.assertRaisesRegex(TypeError, "wants numbers of float32 .*not of format d"):
            humanoid24_floating.mass_matrix(q)

    def test_shapes(self):
        self.refuses(ValueError, "q: has the shape (5,), wants (6,) or (N, 6)", q=self.q[:5])
        self.refuses(ValueError, "qd: has the shape (2, 3, 6), wants (6,) or (N, 6)", qd=np.ones((2, 3, 6)))
        self.refuses(ValueError, "q: has the shape (), wants", q=np.float64(1))
        self.refuses(ValueError, "q: has the shape (6, 1), wants", q=np.ones((6, 1)))
        self.refuses(ValueError, "qdd: has the shape (3, 6), wants (4, 6)", q=np.ones((4, 6)), qdd=np.ones((3, 6)))
        self.refuses(ValueError, "threads: is 0, wants 1 or more", threads=0)
        self.refuses(ValueError, "threads: is -7, wants 1 or more", threads=-7)
        with self.assertRaisesRegex(ValueError, r"out: has the shape \(5, 6\), wants \(6, 6\)"):
            ur10e.mass_matrix(self.q, out=np.ones((5, 6)))
        with self.assertRaisesRegex(ValueError, r"out: has the shape \(6, 6\), wants \(2, 6, 6\)"):
            ur10e.mass_matrix(np.ones((2, 6)), out=np.ones((6, 6)))

    def test_places_of_results(self):
        fixed = np.ones(6)
        fixed.flags.writeable = False
        self.refuses(ValueError, "out: can only be read", out=fixed)
        self.refuses(ValueError, "out: can only be read", out=memoryview(bytes(48)).cast("d"))
        self.refuses(ValueError, "out: is not contiguous", out=np.ones(12)[::2])
        self.refuses(ValueError, "out: is not contiguous", q=np.ones((2, 6)), out=np.ones((2, 7))[:, :6])
        self.refuses(ValueError, "out: is not contiguous and aligned", out=np.zeros(49, np.uint8)[1:].view(float))
        self.refuses(ValueError, "out: overlaps qd in memory", out=self.qd)
        room = np.ones(11)
        self.refuses(ValueError, "out: overlaps q in memory", q=room[:6], out=room[5:])
        self.refuses(ValueError, "out: overlaps q in memory", q=room[5::-1], out=room[:6])
        both = np.ones((3, 6))
        self.assertIs(ur10e.inverse_dynamics(both[0], both[1], self.qdd, out=both[2]).base, both)

    def test_several_results(self):
        shapes = [np.shape(result) for result in ur10e.forward_kinematics(self.q)]
        with self.assertRaisesRegex(TypeError, f"out: wants a tuple of {len(shapes)}"):
            ur10e.forward_kinematics(self.q, out=np.ones(shapes[0]))
        room = np.ones(11)
        with self.assertRaisesRegex(ValueError, "rotation: overlaps position in memory"):
            ur10e.forward_kinematics(self.q, out=(room[:3], room[2:]))
        first = np.ones(shapes[0])
        result = ur10e.forward_kinematics(self.q, out=(first,) + (None,) * (len(shapes) - 1))
        self.assertIs(result[0], first)
        self.assertIs(ur10e.forward_kinematics(self.q, out=result)[0], first)

    def test_names(self):
        for arguments, words in ((dict(q=self.q, qd=self.qd), "lacks the argument qdd"),
                                 (dict(q=self.q, qd=self.qd, qdd=self.qdd, tau=self.q), "no argument 'tau'")):
            with self.assertRaisesRegex(TypeError, words):
                ur10e.inverse_dynamics(**arguments)
        with self.assertRaisesRegex(TypeError, "takes 3 arguments without a name, not 4"):
            ur10e.inverse_dynamics(self.q, self.qd, self.qdd, self.q)
        with self.assertRaisesRegex(TypeError, "given 'q' twice"):
            ur10e.inverse_dynamics(self.q, self.qd, self.qdd, q=self.q)
        name = "".join(["qd", "d"])  # not interned
        ur10e.inverse_dynamics(self.q, self.qd, **{name: self.qdd})

    def test_states_that_no_memory_holds(self):
        with self.assertRaises((MemoryError, ValueError)):
            ur10e.inverse_dynamics(np.broadcast_to(self.q, (2**58, 6)), self.qd, self.qdd)

    def test_references(self):
        values = [self.q, self.qd, self.qdd, np.ones(6), array.array("d", bytes(48))]
        before = [sys.getrefcount(value) for value in values]
        for _ in range(100):
            ur10e.inverse_dynamics(*values[:3], out=values[3])
            ur10e.inverse_dynamics(values[4], *values[1:3])
            for out in (values[0], np.ones(5), values[4][:3], 7):
                with self.assertRaises((TypeError, ValueError)):
                    ur10e.inverse_dynamics(*values[:3], out=out)
        self.assertEqual([sys.getrefcount(value) for value in values], before)
        values[4].append(1.0)  # no buffer of it is held

    def test_random_arguments(self):
        random = np.random.default_rng(SEED)
        outcomes = {"computed": 0, "refused": 0}
        for robot in ROBOTS:
            library = Library(robot)
            for function in library.functions:
                for trial in range(400):
                    with self.subTest(robot=robot.__name__, function=function, trial=trial, seed=SEED):
                        self.try_random(robot, library, function, random, outcomes)
        self.assertGreater(outcomes["computed"], 500)
        self.assertGreater(outcomes["refused"], 500)

    def try_random(self, robot, library, function, random, outcomes):
        states = None if random.random() < 0.5 else int(random.integers(0, 5))
        values = draw(robot, library, function, random, states)
        results = [np.zeros(((states,) if states is not None else ()) + shape, robot.dtype)
                   for _, shape, is_result in library.functions[function] if is_result]
        arguments = dict(values)
        if random.random() < 0.7:
            arguments["out"] = tuple(results) if len(results) > 1 else results[0]
        for name in random.choice(list({**arguments, "out": 0, "threads": 0}), random.integers(0, 3), replace=False):
            arguments[str(name)] = spoil(arguments.get(name), robot, random)
        try:
            computed = as_list(getattr(robot, python_name(function))(**arguments))
        except (TypeError, ValueError, MemoryError) as refusal:
            self.assertRegex(str(refusal), r"^(\w+: |array is too big|Unable to allocate)")
            outcomes["refused"] += 1
            return
        outcomes["computed"] += 1
        packed = {name: np.array(value) if name in values else value for name, value in arguments.items()}
        packed.pop("out", None)
        packed.pop("threads", None)
        expected = as_list(getattr(robot, python_name(function))(**packed))
        for one, other in zip(computed, expected):
            self.assertEqual(np.asarray(one).tobytes(), np.asarray(other).tobytes())


def spoil(value, robot, random):
    """Something else in the place of an argument: sometimes another form of the same."""
    if not isinstance(value, np.ndarray):
        value = np.ones(int(random.integers(0, 8)), robot.dtype)
    fixed = value.copy()
    fixed.flags.writeable = False
    forms = [
        lambda: None, lambda: 3, lambda: "text", lambda: b"bytes", lambda: object(), lambda: [1.0], lambda: int,
        lambda: -1, lambda: 2**70, lambda: {}, lambda: (value,), lambda: (None, None), lambda: value.tobytes(),
        lambda: value.astype(str(random.choice(["float16", "float32", "float64", "int8", "int64", "bool", "complex128",
                                                "object", "S8", "U8", ">f8", ">f4"]))),
        lambda: value.reshape(-1), lambda: value.T, lambda: value[..., None], lambda: value[None], lambda: value[..., :0],
        lambda: value[::-1], lambda: value[..., ::2], lambda: np.asfortranarray(value), lambda: fixed,
        lambda: np.broadcast_to(value, (int(random.integers(0, 5)),) + value.shape),
        lambda: np.broadcast_to(value, (2**50,) + value.shape) if value.ndim == 1 else value,
        lambda: np.zeros((), robot.dtype), lambda: np.zeros((1,) * 20, robot.dtype), lambda: np.float64(1),
        lambda: np.ma.masked_array(value), lambda: value.view(np.recarray), lambda: memoryview(value),
        lambda: memoryview(value)[::-1] if value.ndim == 1 else memoryview(value),
        lambda: array.array(str(random.choice(list("bBhHiIlLqQfdu")))),
        lambda: np.frombuffer(bytearray(value.nbytes + 9), robot.dtype, value.size, 1).reshape(value.shape),
        lambda: np.zeros(3, "f4,f8"), lambda: np.lib.stride_tricks.as_strided(value, strides=(0,) * value.ndim),
    ]
    return forms[random.integers(len(forms))]()


if __name__ == "__main__":
    unittest.main()
