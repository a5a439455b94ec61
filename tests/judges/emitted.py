"""Code that Treeline emits, compiled and called: what is judged."""

import ctypes
import os
import re
import shutil
import subprocess

import numpy as np
from read_arguments import read_arguments


class Refused(Exception):
    """`treeline generate` writes no code for this scene, and says why."""


class EmittedFunction:
    """One function of the C library: arguments are (symbol, shape, whether it is a result)."""

    def __init__(self, library, name, arguments):
        self.arguments = arguments
        self._call = getattr(library, f"judged_{name}")

    def __call__(self, values):
        """Values by symbol, in and out. Arrays have the shapes that the header states."""
        arrays, results = [], {}
        for symbol, shape, is_result in self.arguments:
            if is_result:
                results[symbol] = array = np.full(shape, np.nan)
            else:
                array = np.ascontiguousarray(values[symbol], dtype=float).reshape(-1)
                if array.size != int(np.prod(shape)):
                    raise ValueError(f"{symbol} has {array.size} entries, the header asks for {shape}")
            arrays.append(array)
        self._call(*(array.ctypes.data_as(ctypes.c_void_p) for array in arrays))
        return results


class Emitted:
    """The functions of one robot and scene."""

    def __init__(self, treeline, urdf, scene, functions, folder):
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        text = "name: judged\nlanguage: c\n" + scene + f"functions: [{', '.join(functions)}]\n"
        scene_file = os.path.join(folder, "scene.yaml")
        with open(scene_file, "w", encoding="utf-8") as file:
            file.write(text)
        output = os.path.join(folder, "code")
        run = subprocess.run([treeline, "generate", urdf, scene_file, "--output", output, "--warnings", "none"],
                             capture_output=True, text=True, check=False)
        if run.returncode != 0:
            raise Refused(run.stderr.strip())
        self._read_joints(os.path.join(output, "judged_joints.h"))
        header = ""
        for name in ("judged.h", "judged_damped.h"):
            if os.path.exists(os.path.join(output, name)):
                with open(os.path.join(output, name), encoding="utf-8") as file:
                    header += file.read()
        self.links = re.findall(r"^p \d+\.\.\d+: m, .*? of link (\S+)",
                                header.replace("\n//   ", " ").replace("// p ", "p "), flags=re.M)
        library = ctypes.CDLL(_compile(output))
        self.functions = {name: EmittedFunction(library, name, arguments)
                          for name, arguments in read_arguments(header, "judged", "double")}

    def _read_joints(self, path):
        with open(path, encoding="utf-8") as file:
            text = file.read()
        names = {kind: re.findall(r'"([^"]*)"', re.search(rf"{kind}_joints\[\d+\] = \{{(.*?)\}};", text, re.S)[1])
                 for kind in ("coordinate", "velocity")}
        self.coordinate_joints, self.velocity_joints = names["coordinate"], names["velocity"]


def _compile(folder):
    """Without optimisation: the operations are written in their order, and compilers of large functions are slow."""
    library = os.path.join(folder, "judged.so")
    sources = sorted(os.path.join(folder, name) for name in os.listdir(folder) if name.endswith(".c"))
    compiler = os.environ.get("CC", "cc")
    subprocess.run([compiler, "-std=c99", "-O0", "-ffp-contract=off", "-fPIC", "-shared", "-o", library, *sources],
                   check=True)
    return library
