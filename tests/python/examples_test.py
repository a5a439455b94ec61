"""Would catch: examples that do not run, or whose results mean nothing."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

EXAMPLES = Path(os.environ["SOURCES"]) / "examples" / "python"


def output_of(example):
    """Away from the sources, with a cache of its own; an error ends it with its text."""
    with tempfile.TemporaryDirectory() as work:
        run = subprocess.run([sys.executable, "-W", "error", EXAMPLES / f"{example}.py", Path(os.environ["SOURCES"]) / "robots"],
                             cwd=work, capture_output=True, text=True, check=False,
                             env={**os.environ, "TREELINE_CACHE": os.path.join(work, "cache")})
    return run.stdout + run.stderr


class ExamplesTest(unittest.TestCase):
    def test_every_example_has_a_test(self):
        tested = set(re.findall(r'output_of\("(\w+)"\)', Path(__file__).read_text(encoding="utf-8")))
        self.assertEqual(tested, {example.stem for example in EXAMPLES.glob("*.py")})

    def test_the_page(self):
        """Its code runs, and prints what stands beside it."""
        page = (Path(os.environ["SOURCES"]) / "runtime" / "python" / "README.md").read_text(encoding="utf-8")
        blocks = re.findall(r"```python\n(.*?)```", page, re.S)
        promised = [line.split("# ")[1] for line in "".join(blocks).splitlines() if "print(" in line]
        self.assertEqual((len(blocks), len(promised)), (3, 2))
        with tempfile.TemporaryDirectory() as work:
            shutil.copy(Path(os.environ["SOURCES"]) / "robots" / "ur10e" / "ur10e.urdf", Path(work) / "arm.urdf")
            run = subprocess.run([sys.executable, "-W", "error", "-c", "".join(blocks)], cwd=work, capture_output=True,
                                 text=True, check=False, env={**os.environ, "TREELINE_CACHE": os.path.join(work, "cache")})
        self.assertEqual(run.stdout.splitlines(), promised, run.stderr)

    def test_energy_is_balanced(self):
        """The simulation had 0.2 N m s/rad. What lacks is of differences and sums over steps of 1 ms."""
        output = output_of("balance_energy")
        friction = [float(number) for number in re.search(r"friction \[(.*)\]", output)[1].split()]
        self.assertEqual(friction, [0.2] * 6, output)
        change, work = map(float, re.findall(r"-\d+\.\d+", output))
        self.assertLess(change, -10)
        self.assertAlmostEqual(change, work, delta=1e-3 * abs(change))

    def test_sampling_reaches(self):
        """The goal is 1 rad away in each joint; noise leaves a tenth. Torques beyond the limits cost."""
        output = output_of("reach_by_sampling")
        distance, torque = map(float, re.findall(r"\d\.\d\d", output))
        self.assertLess(distance, 0.2, output)
        self.assertTrue(0.01 < torque <= 1, output)

    def test_lqr_converges(self):
        output = output_of("iterate_lqr")
        costs = [float(cost) for cost in re.findall(r"cost ([\d.]+)", output)]
        self.assertEqual(costs, sorted(costs, reverse=True))
        self.assertLess(costs[-1], costs[0] / 20, output)
        distance, speed, torque = map(float, re.search(r"([\d.]+) rad .* at ([\d.]+) rad/s, (\d+) N m", output).groups())
        self.assertLess(distance, 0.01)
        self.assertLess(speed, 0.05)
        self.assertGreater(torque, 50)  # it carries its weight


if __name__ == "__main__":
    unittest.main()
