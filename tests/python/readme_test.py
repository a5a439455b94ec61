"""Would catch: code of the package's page that does not run, or prints something else than stands beside it."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path


class ReadmeTest(unittest.TestCase):
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


if __name__ == "__main__":
    unittest.main()
