"""Would catch: code that is compiled again though nothing changed, code that is not though something did, files that are
damaged or of others and yet run, processes that see each other's half-written files, and leftovers."""

import os
import shutil
import subprocess
import sys
import time
import unittest
import warnings
from pathlib import Path

import numpy as np
from own_cache import OwnCacheTest

import treeline

LOAD = "import treeline; print(treeline.load('arm.urdf', functions=['gravity']).__name__)"


class CacheTest(OwnCacheTest):
    def load(self):
        return treeline.load("arm.urdf", functions=["gravity"])

    def identity(self):
        """Of the one library: another file is another number."""
        (entry,) = self.entries()
        return (entry / "_native.abi3.so").stat().st_ino

    def assert_tidy(self):
        """Nothing but entries and the cache's own files is left, and those have no folder of a build."""
        names = {place.name for place in (self.cache / "python").iterdir()}
        self.assertFalse([name for name in names if not name.startswith(("m_arm_", "program_", "lock"))], names)

    def test_the_next_process_compiles_nothing(self):
        first = self.run_python(LOAD)
        before = self.identity()
        self.assertEqual(self.run_python(LOAD), first)
        self.assertEqual(self.identity(), before)
        self.assert_tidy()

    def test_flags_and_programs_count(self):
        names = {self.run_python(LOAD, CFLAGS=flags) for flags in ("", "-O1")}
        names.add(self.run_python(LOAD, CC="gcc"))
        copy = self.folder / "treeline"
        copy.write_bytes(Path(os.environ["TREELINE"]).read_bytes())
        copy.chmod(0o755)
        self.assertIn(self.run_python(LOAD, TREELINE=str(copy)), names)  # the same program elsewhere
        with open(copy, "ab") as program:
            program.write(b"\0")
        names.add(self.run_python(LOAD, TREELINE=str(copy)))
        self.assertEqual(len(names), 4)
        self.assert_tidy()

    def test_damage_is_repaired(self):
        self.run_python(LOAD)
        (entry,) = self.entries()
        whole = {file.name: file.read_bytes() for file in entry.iterdir() if file.is_file()}
        self.assertEqual(set(whole), {"__init__.py", "__init__.pyi", "py.typed", "_native.abi3.so", "treeline.json"})
        library = whole["_native.abi3.so"]
        middle = len(library) // 2
        turned = library[:middle] + bytes([library[middle] ^ 1]) + library[middle + 1:]
        for name, damage in (("_native.abi3.so", b""), ("_native.abi3.so", library[:middle]), ("_native.abi3.so", turned),
                             ("_native.abi3.so", None), ("__init__.py", b"raise SystemExit(1)"), ("treeline.json", b"{"),
                             ("treeline.json", b"[]"), ("treeline.json", b'{"files": 3}'), ("treeline.json", None)):
            with self.subTest(name=name, damage=damage and damage[:20]):
                (entry / name).unlink()
                if damage is not None:
                    (entry / name).write_bytes(damage)
                before = (entry / "py.typed").stat().st_ino
                self.run_python(LOAD)
                self.assertNotEqual((entry / "py.typed").stat().st_ino, before)
                self.assertEqual((entry / "__init__.py").read_bytes(), whole["__init__.py"])
                self.assertGreater((entry / "_native.abi3.so").stat().st_size, middle)
                self.assert_tidy()

    def test_processes_at_once(self):
        """All come to one module, which one of them compiled."""
        start = time.time() + 2
        code = f"import time, treeline\ntime.sleep(max(0, {start} - time.time()))\n{LOAD}\nimport numpy\n" \
               "print(treeline.load('arm.urdf', functions=['gravity']).gravity(numpy.zeros(1)))"
        running = [subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE, stderr=subprocess.PIPE)
                   for _ in range(6)]
        outputs = [process.communicate() for process in running]
        self.assertEqual([process.returncode for process in running], [0] * 6, outputs)
        self.assertEqual(len({output for output, _ in outputs}), 1)
        self.assertEqual(len(self.entries()), 1)
        self.assert_tidy()

    def test_threads_at_once(self):
        code = ("import threading, treeline\nfound = []\n"
                "def load(i): found.append(treeline.load('arm.urdf', functions=['gravity', 'mass_matrix'][:1 + i % 2]))\n"
                "threads = [threading.Thread(target=load, args=(i,)) for i in range(8)]\n"
                "for thread in threads: thread.start()\n"
                "for thread in threads: thread.join()\nprint(len(found), len(set(found)))")
        self.assertEqual(self.run_python(code), "8 2\n")
        self.assert_tidy()

    def test_a_build_that_fails_leaves_nothing(self):
        with self.assertRaisesRegex(treeline.Error, "the compiler ended with 1"):
            self.set_environment(CFLAGS="-DNO_SUCH_THING=( -Dint=char*")
            self.load()
        self.assertEqual(self.entries(), [])
        self.assert_tidy()

    def test_where_it_lies(self):
        home = self.folder / "home"
        home.mkdir()
        self.set_environment(TREELINE_CACHE=None, XDG_CACHE_HOME=None, HOME=str(home))
        self.load()
        self.assertEqual(len(list((home / ".cache" / "treeline" / "python").glob("m_arm_*"))), 1)
        self.set_environment(XDG_CACHE_HOME=str(self.folder / "xdg"))
        self.load()
        self.assertEqual(len(list((self.folder / "xdg" / "treeline" / "python").glob("m_arm_*"))), 1)
        self.assertEqual((self.folder / "xdg" / "treeline" / "python").stat().st_mode & 0o777, 0o700)

    def test_without_a_cache(self):
        self.set_environment(TREELINE_CACHE="")
        output = self.run_python("import treeline, numpy\narm = treeline.load('arm.urdf', functions=['gravity'])\n"
                                 "print(arm.__file__, arm.gravity(numpy.zeros(1)).size)")
        path, size = output.split()
        self.assertEqual(size, "1")
        self.assertFalse(Path(path).parent.parent.exists())

    def test_children_do_not_take_the_folder_of_a_process_away(self):
        self.set_environment(TREELINE_CACHE="")
        output = self.run_python("import os, sys, treeline\n"
                                 "one = treeline.load('arm.urdf', functions=['gravity'])\n"
                                 "if os.fork() == 0: sys.exit()\nos.wait()\n"
                                 "print(treeline.load('arm.urdf', functions=['mass_matrix']) is not one)")
        self.assertEqual(output, "True\n")

    def test_a_folder_of_others_is_not_trusted(self):
        place = self.cache / "python"
        place.mkdir(parents=True)
        place.chmod(0o777)
        with warnings.catch_warnings(record=True) as told:
            warnings.simplefilter("always")
            arm = self.load()
        self.assertEqual([each.category for each in told], [treeline.InputWarning])
        self.assertIn(f"others may write to \"{place}\"", str(told[0].message))
        self.assertEqual(arm.gravity(np.zeros(1)).size, 1)
        self.assertEqual(list(place.iterdir()), [])

    def test_files_that_are_kept_can_go(self):
        name = self.load().__name__
        for place in (self.cache / "python").glob("program_*"):
            place.write_text("damaged", encoding="utf-8")
        self.assertEqual(self.run_python(LOAD).strip(), name)
        shutil.rmtree(self.cache)
        self.assertEqual(self.load().__name__, name)


if __name__ == "__main__":
    unittest.main()
