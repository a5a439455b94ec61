"""Would catch: names and limits that differ from C's header, a digest of other files, help that does not say what the
contract says, functions that are missing, and packages that disturb each other or need NumPy."""

import inspect
import json
import math
import os
import pickle
import pydoc
import subprocess
import sys
import unittest

import humanoid24_floating
import numpy as np
import ur10e
from robots import ROBOTS, Library, python_name


def run(code, **environment):
    return subprocess.run([sys.executable, "-c", code], env={**os.environ, **environment}, capture_output=True,
                          text=True, check=False)


class AttributesTest(unittest.TestCase):
    def test_names_and_limits_are_those_of_the_header(self):
        for robot in ROBOTS:
            library = Library(robot)
            for name in ("coordinate_joints", "coordinate_meanings", "velocity_joints", "velocity_names", "task_row_names"):
                self.assertEqual(list(getattr(robot, name)), library.texts(name))
            for name in ("home", "lower_limits", "upper_limits", "velocity_limits", "effort_limits"):
                entries = library._entries(name).replace("\n", " ").split(",")
                for entry, number in zip(entries, getattr(robot, name), strict=True):
                    if "UNLIMITED" in entry:
                        self.assertEqual(number, -math.inf if "-" in entry else math.inf)
                    else:
                        self.assertEqual(number, float(np.dtype(robot.dtype).type(entry.strip().rstrip("fF"))))
            self.assertEqual((robot.nq, robot.nv), (len(robot.coordinate_joints), len(robot.velocity_joints)))
            self.assertEqual(robot.task_rows, len(robot.task_row_names))
        self.assertEqual((humanoid24_floating.nq, humanoid24_floating.nv), (31, 30))
        self.assertIn(math.inf, humanoid24_floating.upper_limits)

    def test_versions(self):
        for robot in ROBOTS:
            with open(os.path.join(os.environ["PACKAGES"], "with blanks", robot.__name__, "src", "manifest.json"),
                      encoding="utf-8") as file:
                manifest = json.load(file)
            self.assertEqual(robot.digest, manifest["digest"])
            self.assertTrue(robot.__version__.endswith("+" + manifest["digest"][:12]))
            self.assertEqual(manifest["language"], "c")

    def test_help_says_what_the_contract_says(self):
        for robot in ROBOTS:
            library = Library(robot)
            listed = {name for name, member in vars(robot).items() if inspect.isbuiltin(member)}
            self.assertEqual(listed, {python_name(function) for function in library.functions})
            text = pydoc.plain(pydoc.render_doc(robot))
            for function, arguments in library.functions.items():
                call = getattr(robot, python_name(function))
                given = [symbol for symbol, _, is_result in arguments if not is_result and symbol != "heaviest"]
                self.assertEqual(list(inspect.signature(call).parameters), [*given, "out", "threads"])
                header = library.headers[:library.headers.index(f" {robot.__name__}_{function}(")].split("\n\n")[-1]
                contract = [line[4:] for line in header.split("\n") if line.startswith("///")]
                self.assertGreater(len(contract), 3)
                self.assertIn("\n".join(contract), call.__doc__)
                self.assertIn(contract[0].strip(), text)
            for words in ("Joints, in the order of q", "Gravity", "Bounds of rounding errors", robot.dtype):
                self.assertIn(words, text)
        self.assertIn("in  qdd (6): joint accelerations, rad/s^2", ur10e.inverse_dynamics.__doc__)

    def test_processes_can_hand_them_on(self):
        result = ur10e.forward_kinematics(np.ones(6))
        again = pickle.loads(pickle.dumps(result))
        self.assertIsInstance(again, ur10e.ForwardKinematics)
        self.assertTrue(all((one == other).all() for one, other in zip(result, again)))
        self.assertIs(pickle.loads(pickle.dumps(ur10e.gravity)), ur10e.gravity)

    def test_packages_do_not_disturb_each_other(self):
        q, p = np.ones(ur10e.nq), np.ones(humanoid24_floating.nq, "float32")
        together = ur10e.mass_matrix(q).tobytes().hex(), humanoid24_floating.mass_matrix(p).tobytes().hex()
        for name, real, size, expected in (("ur10e", "float64", q.size, together[0]),
                                           ("humanoid24_floating", "float32", p.size, together[1])):
            alone = run(f"import numpy, {name}\n"
                        f"print({name}.mass_matrix(numpy.ones({size}, '{real}')).tobytes().hex())")
            self.assertEqual(alone.stdout.strip(), expected, alone.stderr)

    def test_without_numpy(self):
        code = ("import array, sys\nsys.modules['numpy'] = None\nimport ur10e\n"
                "q = array.array('d', bytes(48))\ng = array.array('d', bytes(48))\n"
                "ur10e.gravity(q, out=g)\nprint(g[1])\n"
                "try:\n    ur10e.gravity(q)\nexcept TypeError as refusal:\n    print(refusal)")
        alone = run(code)
        self.assertEqual(alone.stdout.splitlines(), [repr(float(ur10e.gravity(np.zeros(6))[1])),
                                                     "out: is needed, as NumPy cannot be imported"], alone.stderr)

    def test_numpy_is_loaded_where_it_is_needed(self):
        alone = run("import sys, ur10e\nassert 'numpy' not in sys.modules\n"
                    "import array\nprint(type(ur10e.gravity(array.array('d', bytes(48)))))")
        self.assertEqual(alone.stdout.strip(), "<class 'numpy.ndarray'>", alone.stderr)

    def test_numpy_with_another_interface(self):
        """Its arrays are buffers then, and numpy.empty makes new ones."""
        code = ("import numpy as np, ur10e\nimport numpy._core._multiarray_umath as core\n"
                "Q = np.random.default_rng(1).uniform(-2, 2, (9, 6))\n{}\n"
                "for q in (Q, Q[0], Q[:, ::-1]):\n"
                "    print(ur10e.mass_matrix(q).tobytes().hex(), ur10e.lambda_(q, out=np.empty(q.shape + (6,))).sum())\n"
                "try:\n    ur10e.gravity(Q, out=Q)\nexcept ValueError as refusal:\n    print(refusal)")
        usual, other = run(code.format("")), run(code.format("core._ARRAY_API = None"))
        self.assertIn("overlaps", usual.stdout, usual.stderr)
        self.assertEqual(other.stdout, usual.stdout, other.stderr)

    def test_threads_of_python(self):
        alone = run("import threading, numpy as np, ur10e\n"
                    "Q = np.random.default_rng(1).uniform(-2, 2, (20000, 6))\n"
                    "expected = ur10e.mass_matrix(Q)\nwrong = []\n"
                    "def check():\n"
                    "    for _ in range(5):\n"
                    "        if not (ur10e.mass_matrix(Q, threads=3) == expected).all(): wrong.append(1)\n"
                    "threads = [threading.Thread(target=check) for _ in range(8)]\n"
                    "for thread in threads: thread.start()\n"
                    "for thread in threads: thread.join()\nprint(wrong)")
        self.assertEqual(alone.stdout.strip(), "[]", alone.stderr)


if __name__ == "__main__":
    unittest.main()
