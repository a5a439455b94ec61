"""Treeline from Python: a robot's dynamics as compiled functions, and what the program `treeline` tells of a robot.

`load` gives the functions of a robot in a scene, compiled; a `Model` the same interpreted, without a compiler.
`inspect`, `check`, `bench` and `simulate` give what the commands of that name report as dictionaries and lists, `draw` a
picture, `drive` the page in which the robot is driven. `Show` shows a control loop of yours there.

A robot is the path of a URDF, SDF or MJCF file, or of a scene that lists robots. A scene is the path of a YAML file, or a
dictionary with the same keys. What is wrong with either is an `Error` that tells the file, the place and what to do.
"""

from treeline._commands import Drawing, bench, check, draw, inspect, simulate
from treeline._drive import Drive, drive
from treeline._inputs import RobotPath, Scene
from treeline._load import load
from treeline._messages import Diagnostic, Error, InputWarning
from treeline._model import Model
from treeline._show import Show

for each in (Diagnostic, Drawing, Drive, Error, InputWarning, Model, Show):
    each.__module__ = __name__  # tracebacks and help name them as callers do: treeline.Error
del each

__all__ = [
    "Diagnostic",
    "Drawing",
    "Drive",
    "Error",
    "InputWarning",
    "Model",
    "RobotPath",
    "Scene",
    "Show",
    "bench",
    "check",
    "draw",
    "drive",
    "inspect",
    "load",
    "simulate",
]
