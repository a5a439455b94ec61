"""Commands of the program, whose results are data."""

import csv
import json
import os
from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from treeline._inputs import RobotPath, Scene, read_inputs, read_path
from treeline._program import run_program

BOUNDS_EXCEEDED = 3  # exit code of a report with something stale or out of bounds


def list_options(**given: Any) -> list[str]:
    """Options of the command line: lists with commas, True as a flag, None and False as nothing."""
    options = []
    for name, value in given.items():
        if value is None or value is False:
            continue
        if value is True:
            options.append(f"--{name}")
        elif isinstance(value, (str, os.PathLike)):
            options.append(f"--{name}={os.fspath(value)}")
        elif hasattr(value, "__iter__"):
            options.append(f"--{name}=" + ",".join(print_value(each) for each in value))
        else:
            options.append(f"--{name}=" + print_value(value))
    return options


def print_value(value: Any) -> str:
    """A number to all of its digits, also where it is one of NumPy."""
    return value if isinstance(value, str) else str(value) if isinstance(value, int) else repr(float(value))


def report(command: str, robot: RobotPath, scene: Scene, options: Sequence[str],
           fine: Sequence[int] = (0,)) -> str:
    inputs = read_inputs(robot, scene)
    return run_program(command, [*inputs.arguments(), *options], inputs.text, fine).output.decode()


def inspect(robot: RobotPath, scene: Scene = None, *, base_parameters: bool = False) -> dict[str, Any]:
    """What a robot is: tree, joints, masses, reductions, conditioning, as `treeline inspect --json` tells; or the
    combinations of inertial parameters on which its motion depends."""
    options = list_options(json=True, **{"base-parameters": base_parameters})
    told: dict[str, Any] = json.loads(report("inspect", robot, scene, options))
    return told


def check(robot: RobotPath, scene: Scene = None, *, states: int | None = None, seed: int | None = None,
          functions: Sequence[str] | None = None, real: str | None = None, target: str | None = None) -> dict[str, Any]:
    """Compiles the code of a robot and compares it with the interpreter in 50 digits: the report of `treeline check
    --json`. `passed` in it says whether all functions are within their bounds; where they are not, nothing is raised.
    """
    options = list_options(json=True, states=states, seed=seed, functions=functions, real=real, target=target)
    told: dict[str, Any] = json.loads(report("check", robot, scene, options, (0, BOUNDS_EXCEEDED)))
    return told


def bench(robot: RobotPath, scene: Scene = None, *, functions: Sequence[str] | None = None, real: str | None = None,
          quick: bool = False, cold: bool = False) -> list[dict[str, Any]]:
    """Times the functions of a robot, as C++, on this machine: the lines of `treeline bench --json`. The first tells
    of the machine, each of the others of a variant of a function."""
    options = list_options(json=True, functions=functions, real=real, quick=quick, cold=cold)
    return [json.loads(line) for line in report("bench", robot, scene, options).splitlines()]


def simulate(robot: RobotPath, scene: Scene = None, *, seconds: float | None = None, step: float | None = None,
             integrator: str | None = None, q: Sequence[float] | None = None, qd: Sequence[float] | None = None,
             hold: bool = False, damping: float | None = None) -> dict[str, list[float]]:
    """Lets a robot go, from `q` and `qd`, and records it: the columns of `treeline simulate --csv` by their names. Joint
    forces are none, or cancel gravity (`hold`), less `damping` times the velocity."""
    options = list_options(csv="-", seconds=seconds, step=step, integrator=integrator, q=q, qd=qd, hold=hold,
                           damping=damping)
    names, *rows = csv.reader(report("simulate", robot, scene, options).splitlines())
    return {name: [float(row[i]) for row in rows] for i, name in enumerate(names)}


@dataclass(frozen=True)
class Drawing:
    """A picture of a robot, which notebooks show."""

    svg: str

    def _repr_svg_(self) -> str:
        return self.svg

    def save(self, path: str | os.PathLike[str]) -> None:
        Path(path).write_text(self.svg, encoding="utf-8")


def draw(robot: RobotPath, scene: Scene = None, *, q: Sequence[float] | None = None,
         motion: str | os.PathLike[str] | None = None, times: Sequence[float] | None = None,
         pictures: int | None = None, path: str | Sequence[str] | None = None, azimuth: float | None = None,
         elevation: float | None = None, width: float | None = None, animate: bool = False,
         to: Sequence[float] | None = None, seconds: float | None = None, fps: float | None = None) -> Drawing:
    """Draws a robot at `q` (at rest if not given), or moments of a motion side by side: a table of `treeline simulate
    --csv` or a record of `treeline drive`, at `times` in s or in so many `pictures`, with the `path` of operational
    points or links. To `animate` makes one picture that moves: the motion, or from `q` to the state `to` and back, in
    so many `seconds`. The camera is at `azimuth` about z and `elevation` over the ground, in rad."""
    options = list_options(q=q, motion=None if motion is None else read_path(motion), times=times, pictures=pictures,
                           path=path, azimuth=azimuth, elevation=elevation, width=width, animate=animate, to=to,
                           seconds=seconds, fps=fps)
    return Drawing(report("draw", robot, scene, options))
