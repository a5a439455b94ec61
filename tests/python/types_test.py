"""Would catch: types of the package that mypy --strict refuses, that refuse what is right, or accept what is wrong."""

import os
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

import treeline

FOLDER = Path(__file__).resolve().parent / "types"


class TypesTest(unittest.TestCase):
    def run_mypy(self, *arguments):
        with tempfile.TemporaryDirectory() as work:
            run = subprocess.run([sys.executable, "-m", "mypy", "--strict", *map(str, arguments)], cwd=work,
                                 capture_output=True, text=True, check=False,
                                 env={**os.environ, "MYPYPATH": os.path.dirname(os.path.dirname(treeline.__file__))})
        return run.returncode, run.stdout + run.stderr

    def test_the_package(self):
        code, output = self.run_mypy("-p", "treeline")
        self.assertEqual(code, 0, output)
        self.assertIn("no issues", output)

    def test_a_program_passes(self):
        code, output = self.run_mypy(FOLDER / "right.py")
        self.assertEqual(code, 0, output)

    def test_mistakes_are_found(self):
        lines = (FOLDER / "wrong.py").read_text(encoding="utf-8").splitlines()
        expected = {number: line.split("# ")[1].strip() for number, line in enumerate(lines, 1) if "  # " in line}
        code, output = self.run_mypy(FOLDER / "wrong.py")
        found = {int(number): kind for number, kind in re.findall(r"wrong\.py:(\d+): error: .* \[([\w-]+)\]", output)}
        self.assertEqual((code, found), (1, expected), output)

    def test_every_public_thing_is_explained(self):
        for name in treeline.__all__:
            self.assertTrue(getattr(treeline, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()
