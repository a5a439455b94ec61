"""Would catch: code in the package that does not run or does not do what it says."""

import os
import subprocess
import sys
import tempfile
import unittest


def run(*arguments):
    with tempfile.TemporaryDirectory() as work:
        run = subprocess.run([sys.executable, *arguments], cwd=work, capture_output=True, text=True, check=False)
    return run.stdout + run.stderr


def run_example(package):
    return run(os.path.join(os.environ["PACKAGES"], "with blanks", package, "examples", f"{package}_time.py"))


class ExamplesTest(unittest.TestCase):
    def test_the_example_of_a_package_runs(self):
        for robot in ("ur10e", "humanoid24_floating"):
            self.assertRegex(run_example(robot),
                             r"at home: .*(?s:.*)\n\d+ ns for one state\n\d+ ns for each of a thousand\n$")

    def test_that_of_a_controller_alone_runs(self):
        self.assertRegex(run_example("controller_alone"), r"^torque at home: \[(?s:.*)\]\n\d+ ns for one step\n$")


if __name__ == "__main__":
    unittest.main()
