"""Robots and scenes as callers name them."""

import json
import os
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any, TypeAlias

from treeline._messages import refuse

#: A URDF, SDF or MJCF file, or a scene that lists robots.
RobotPath: TypeAlias = str | os.PathLike[str]
#: A YAML file, or a dictionary with the same keys; None: the functions of the joints alone.
Scene: TypeAlias = str | os.PathLike[str] | Mapping[str, Any] | None


def as_plain(value: Any) -> Any:
    """Paths and arrays of a scene as JSON has them."""
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    if hasattr(value, "tolist"):
        return value.tolist()
    raise TypeError(f"a scene has no {type(value).__name__}: {value!r}")


@dataclass(frozen=True)
class Inputs:
    """The files of a command line, and what it reads from standard input."""

    robot: str
    scene: str | None  #: "-": it is `text`
    text: bytes  #: a scene that lies in no file

    def arguments(self) -> list[str]:
        return [self.robot] if self.scene is None else [self.robot, self.scene]

    def files(self) -> list[Path]:
        return [Path(file) for file in self.arguments() if file != "-"]

    def read(self) -> list[bytes]:
        """The contents of the files, and the text."""
        try:
            return [*(read_file(file) for file in self.arguments() if file != "-"), self.text]
        except OSError as fault:
            raise refuse(f"the file cannot be read: {fault.strerror}", "Name a file that is there.",
                         str(fault.filename)) from None


def read_file(path: str) -> bytes:
    with open(path, "rb") as file:
        return file.read()


def read_path(path: str | os.PathLike[str]) -> str:
    """A path that is no option and not standard input."""
    text = os.fspath(path)
    return os.path.join(".", text) if text.startswith("-") else text


def read_inputs(robot: RobotPath, scene: Scene) -> Inputs:
    """What is given to the program for a robot in a scene; YAML has JSON in it."""
    if scene is None:
        return Inputs(read_path(robot), None, b"")
    if isinstance(scene, Mapping):
        text = json.dumps(scene, default=as_plain, ensure_ascii=False, allow_nan=False, indent=1)
        return Inputs(read_path(robot), "-", text.encode())
    return Inputs(read_path(robot), read_path(scene), b"")
