"""Tests with a cache and a folder of their own."""

import os
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROBOTS = Path(os.environ["SOURCES"]) / "robots"
ARM = """<robot name="arm">
  <link name="base"/>
  <joint name="elbow" type="revolute"><parent link="base"/><child link="forearm"/>
    <axis xyz="0 1 0"/><limit lower="-1" upper="1" effort="9" velocity="3"/></joint>
  <link name="forearm"><inertial><origin xyz="0.2 0 0"/><mass value="{mass}"/>
    <inertia ixx="0.1" ixy="0" ixz="0" iyy="0.1" iyz="0" izz="0.1"/></inertial></link>
</robot>
"""


class OwnCacheTest(unittest.TestCase):
    """`self.folder` is the working folder, with `arm.urdf`: a pendulum of 2 kg whose centre is at 0.2 m."""

    def setUp(self):
        work = tempfile.TemporaryDirectory()
        self.addCleanup(work.cleanup)
        self.folder = Path(work.name).resolve() / "work"
        self.folder.mkdir()
        self.cache = self.folder.parent / "cache"
        self.set_environment(TREELINE_CACHE=str(self.cache))
        before = os.getcwd()
        self.addCleanup(os.chdir, before)
        os.chdir(self.folder)
        self.write_arm(2)

    def set_environment(self, **values):
        """Sets variables for this test; None: not set."""
        for name, value in values.items():
            self.addCleanup(assign, name, os.environ.get(name))
            assign(name, value)

    def write_arm(self, mass, path="arm.urdf"):
        Path(path).write_text(ARM.format(mass=mass), encoding="utf-8")

    def entries(self):
        return sorted(place for place in (self.cache / "python").iterdir() if place.is_dir())

    def run_python(self, code, *arguments, **environment):
        """Output of a program in a process of its own, which has to end well."""
        ran = subprocess.run([sys.executable, "-c", code, *arguments], env={**os.environ, **environment},
                             capture_output=True, text=True, check=False)
        self.assertEqual(ran.returncode, 0, ran.stderr)
        return ran.stdout


def assign(name, value):
    if value is None:
        os.environ.pop(name, None)
    else:
        os.environ[name] = value
