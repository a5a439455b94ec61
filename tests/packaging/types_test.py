"""Would catch: types of __init__.pyi that refuse what is right, accept what is wrong, or are not those of the compiled
module."""

import os
import re
import subprocess
import sys
import tempfile
import unittest

WITH_STRUCTS = ["puma_controlled", "humanoid_limited", "controller_alone"]
FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), "types")


class TypesTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.work = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.work.cleanup)

    def run_module(self, *arguments):
        """The program's exit code and lines, away from the tests' own modules."""
        run = subprocess.run([sys.executable, "-m", *arguments], cwd=self.work.name, capture_output=True, text=True,
                             check=False)
        return run.returncode, run.stdout + run.stderr

    def test_a_program_passes(self):
        code, output = self.run_module("mypy", "--strict", os.path.join(FOLDER, "right.py"))
        self.assertEqual(code, 0, output)

    def test_mistakes_are_found(self):
        file = os.path.join(FOLDER, "wrong.py")
        with open(file, encoding="utf-8") as lines:
            expected = {number: line.split("# ")[1].strip() for number, line in enumerate(lines, 1) if "  # " in line}
        code, output = self.run_module("mypy", "--strict", file)
        found = {int(number): kind for number, kind in re.findall(r"wrong\.py:(\d+): error: .* \[([\w-]+)\]", output)}
        self.assertEqual((code, found), (1, expected), output)

    def test_types_are_those_of_the_module(self):
        code, output = self.run_module("mypy.stubtest", "ur10e", "humanoid24_floating", *WITH_STRUCTS)
        self.assertEqual(code, 0, output)

    def test_what_is_written_in_python(self):
        code, output = self.run_module("mypy", "--strict", *(f"--package={package}" for package in WITH_STRUCTS))
        self.assertEqual(code, 0, output)


if __name__ == "__main__":
    unittest.main()
