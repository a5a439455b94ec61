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


class ExamplesTest(unittest.TestCase):
    def test_the_example_of_a_package_runs(self):
        for robot in ("ur10e", "humanoid24_floating"):
            example = os.path.join(os.environ["PACKAGES"], "with blanks", robot, "examples", f"{robot}_time.py")
            output = run(example)
            self.assertRegex(output, r"at home: .*(?s:.*)\n\d+ ns for one state\n\d+ ns for each of a thousand\n$")


if __name__ == "__main__":
    unittest.main()
