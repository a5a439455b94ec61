"""The robots of the packages: as Python has them, and as a library of C that ctypes calls."""

import ctypes
import os
import re
import sys

import humanoid24_floating
import numpy as np
import ur10e

sys.path.insert(0, os.path.join(os.path.dirname(__file__), "..", "judges"))
from read_arguments import read_arguments  # noqa: E402

ROBOTS = [ur10e, humanoid24_floating]


class Library:
    """Functions of C by name. Shapes are those that the headers state: arguments and results of each function."""

    def __init__(self, robot):
        self.name = robot.__name__
        self.real = "float" if robot.dtype == "float32" else "double"
        folder = os.path.join(os.environ["PACKAGES"], "with blanks", self.name, "src")
        self.headers = ""
        for file in (f"{self.name}.h", f"{self.name}_damped.h", f"{self.name}_joints.h"):
            if os.path.exists(os.path.join(folder, file)):
                with open(os.path.join(folder, file), encoding="utf-8") as header:
                    self.headers += header.read()
        self._library = ctypes.CDLL(os.path.join(os.environ["PACKAGES"], f"{self.name}.so"))
        self.functions = dict(read_arguments(self.headers, self.name, self.real))

    def call(self, function, values):
        """Results of a function as list, that which it returns last."""
        results, pointers = [], []
        for symbol, shape, is_result in self.functions[function]:
            array = values.get(symbol)
            if is_result:
                array = np.full(shape, np.nan, "float32" if self.real == "float" else "float64")
                results.append(array)
            elif symbol == "heaviest":
                array = np.array(self.numbers("heaviest"))
            pointers.append(array.ctypes.data_as(ctypes.c_void_p))
        called = getattr(self._library, f"{self.name}_{function}")
        called.restype = ctypes.c_double if function == "damped_control_torque" else None
        returned = called(*pointers)
        return results if returned is None else [*results, np.array([returned])]

    def numbers(self, array):
        """The numbers in a constant of the headers."""
        return [float(number.rstrip("fF")) for number in self._entries(array).replace("\n", " ").split(",")]

    def texts(self, array):
        return re.findall(r'"((?:[^"\\]|\\.)*)"', self._entries(array))

    def _entries(self, array):
        return re.search(rf"{self.name}_{array}\[\d+\] = \{{(.*?)\}};", self.headers, re.S)[1]


def draw(robot, library, function, random, states=None):
    """Random arguments of a function, by symbol."""
    leading = () if states is None else (states,)
    return {symbol: random.uniform(-2, 2, leading + shape).astype(robot.dtype)
            for symbol, shape, is_result in library.functions[function] if not is_result and symbol != "heaviest"}


def python_name(function):
    return "lambda_" if function == "lambda" else function


def as_list(results):
    return list(results) if isinstance(results, tuple) else [results]
