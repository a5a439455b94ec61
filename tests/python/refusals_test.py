"""Would catch: errors of the program that do not arrive, arrive without place or advice, or in other words than the
program prints; and tools that are missing without a word on what to install."""

import contextlib
import os
import pickle
import shutil
import subprocess
import sysconfig
import traceback
import unittest
from pathlib import Path
from unittest import mock

from own_cache import OwnCacheTest

import treeline


class RefusalsTest(OwnCacheTest):
    def refusal(self, *arguments, call=treeline.load, **options):
        with self.assertRaises(treeline.Error) as caught:
            call(*arguments, **options)
        self.assertIsInstance(caught.exception, RuntimeError)
        return caught.exception

    def printed(self, *arguments):
        """What the program prints of the same; it tells an advice once for several faults in a row."""
        ran = subprocess.run([os.environ["TREELINE"], *arguments], capture_output=True, text=True, check=False)
        return ran.stderr

    def test_a_key_that_there_is_not(self):
        Path("scene.yaml").write_text("name: arm\ngravty: [0, 0, 1]\n", encoding="utf-8")
        error = self.refusal("arm.urdf", "scene.yaml")
        self.assertEqual((error.file, error.line, error.place), ("scene.yaml", 2, "gravty"))
        self.assertIn("gravity", error.advice)
        self.assertEqual(len(error.diagnostics), 1)
        self.assertEqual(str(error) + "\n", self.printed("generate", "arm.urdf", "scene.yaml", "-o", "out"))
        for part in (error.message, error.advice, "scene.yaml:2: error: "):
            self.assertIn(part, str(error))
        self.assertFalse(Path("out").exists())

    def test_several_faults(self):
        Path("scene.yaml").write_text("real: half\nlanes: many\n", encoding="utf-8")
        error = self.refusal("arm.urdf", "scene.yaml")
        self.assertEqual([(each.severity, each.line, each.place) for each in error.diagnostics],
                         [("error", 1, "real"), ("error", 2, "lanes")])
        self.assertEqual((error.line, error.place), (1, "real"))
        self.assertEqual(str(error).count("error: "), 2)

    def test_a_robot_at_fault(self):
        text = Path("arm.urdf").read_text(encoding="utf-8")
        Path("arm.urdf").write_text(text.replace('child link="forearm"', 'child link="fore"'), encoding="utf-8")
        error = self.refusal("arm.urdf")
        self.assertEqual(error.file, "arm.urdf")
        self.assertGreater(error.line, 0)
        self.assertTrue(error.message and error.advice)

    def test_dictionaries(self):
        error = self.refusal("arm.urdf", {"operational_points": [{"name": "tip", "link": "wrist"}]})
        self.assertIn("operational_points", error.place)
        self.assertIn("wrist", error.message)
        self.assertNotEqual(error.file, "")
        for scene, fault in (({"gravity": [0, 0, float("nan")]}, ValueError), ({"gravity": {1, 2}}, TypeError)):
            with self.assertRaises(fault):
                treeline.load("arm.urdf", scene)

    def test_files_that_are_not_there(self):
        for arguments, file in ((("none.urdf",), "none.urdf"), (("arm.urdf", "none.yaml"), "none.yaml"),
                                (("-.urdf",), "./-.urdf")):
            for call in (treeline.load, treeline.inspect, treeline.draw, treeline.drive):
                with self.subTest(file=file, call=call.__name__):
                    options = {"browser": False} if call is treeline.drive else {}
                    error = self.refusal(*arguments, call=call, **options)
                    self.assertEqual(error.file, file)
                    self.assertTrue(error.advice)

    def test_what_an_error_looks_like(self):
        """Would catch: another error told before it, and the name of a module which callers do not know."""
        told = "".join(traceback.format_exception(self.refusal("none.urdf")))
        self.assertTrue(told.startswith("treeline.Error: none.urdf: error: "), told)

    def test_options(self):
        error = self.refusal("arm.urdf", functions=["gravty"])
        self.assertEqual(error.place, "--functions")
        self.assertIn("gravity", error.advice)
        self.assertIn("half", str(self.refusal("arm.urdf", real="half")))

    def test_a_program_that_is_missing(self):
        self.set_environment(TREELINE=None, PATH=str(self.folder))
        error = self.refusal("arm.urdf")
        self.assertIn("`treeline` is not found", error.message)
        self.assertIn("PATH", error.advice)
        self.set_environment(TREELINE=str(self.folder / "nothing"))
        self.assertIn("TREELINE names", self.refusal("arm.urdf").message)

    def test_where_the_program_is_found(self):
        program = os.environ["TREELINE"]
        self.set_environment(TREELINE=str(self.folder), PATH=os.path.dirname(program))  # a folder, as in the tutorial
        self.assertEqual(treeline.inspect("arm.urdf")["robot"], "arm")
        place = self.folder / "bin" / "treeline"
        place.parent.mkdir()
        place.symlink_to(program)
        package = self.folder / "share" / "treeline" / "python"  # as CMake installs it
        shutil.copytree(os.path.dirname(treeline.__file__), package / "treeline")
        self.set_environment(TREELINE=None, PATH="/usr/bin:/bin", PYTHONPATH=str(package))
        self.assertEqual(self.run_python("import treeline; print(treeline.inspect('arm.urdf')['robot'])"), "arm\n")

    def test_a_program_of_another_machine(self):
        other = self.folder / "treeline"
        other.write_bytes(b"\x7fELF of another machine")
        other.chmod(0o755)
        self.set_environment(TREELINE=str(other))
        self.assertIn("cannot be run", self.refusal("arm.urdf").message)

    def test_a_program_that_is_older(self):
        """It writes text where it is asked for JSON, and no list of sources."""
        older = self.folder / "treeline"
        older.write_text(f"#!/bin/sh\nunset TREELINE_MESSAGES\n'{os.environ['TREELINE']}' \"$@\" || exit $?\n"
                         "for word; do case $word in --output=*) rm -f \"${word#*=}/extension/build.json\";; esac; done\n",
                         encoding="utf-8")
        older.chmod(0o755)
        self.set_environment(TREELINE=str(older))
        self.assertIn("older", self.refusal("arm.urdf").message)
        Path("scene.yaml").write_text("gravty: [0, 0, 1]\n", encoding="utf-8")
        error = self.refusal("arm.urdf", "scene.yaml")
        self.assertIn("scene.yaml:1: error: gravty", str(error))

    def test_a_compiler_that_is_missing(self):
        self.set_environment(CC="no-such-compiler")
        error = self.refusal("arm.urdf")
        self.assertIn('CC names "no-such-compiler"', error.message)
        self.assertIn("apt-get install gcc", error.advice)
        self.set_environment(CC=None, PATH=str(self.folder))
        error = self.refusal("arm.urdf")
        self.assertIn("no compiler of C", error.message)

    def test_headers_that_are_missing(self):
        with mock.patch.object(sysconfig, "get_path", lambda *_: str(self.folder)):
            error = self.refusal("arm.urdf")
        self.assertIn("Python.h is missing", error.message)
        self.assertIn("python3-dev", error.advice)

    def test_warnings(self):
        """Are told again by a module that was kept."""
        text = Path("arm.urdf").read_text(encoding="utf-8")
        Path("arm.urdf").write_text(text.replace('name="base"', 'name="base" colour="red"'), encoding="utf-8")
        for _ in range(2):
            with self.assertWarnsRegex(treeline.InputWarning, "colour"):
                treeline.load("arm.urdf", functions=["gravity"])
        with self.assertLogs("treeline", "INFO") as told:
            self.write_arm(2)
            treeline.load("arm.urdf", {"batch": 4}, functions=["gravity"])
        self.assertIn("several states", "".join(told.output))

    def test_errors_can_be_handed_on(self):
        error = self.refusal("arm.urdf", {"gravty": 1})
        again = pickle.loads(pickle.dumps(error))
        self.assertEqual((str(again), again.place, again.diagnostics), (str(error), error.place, error.diagnostics))
        with contextlib.suppress(ValueError):
            raise ValueError from error


if __name__ == "__main__":
    unittest.main()
