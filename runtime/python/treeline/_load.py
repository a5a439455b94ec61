"""Functions of a robot as a module, compiled once."""

import hashlib
import importlib
import json
import os
import re
import sys
import tempfile
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any, Literal

from treeline import modules
from treeline._cache import find_folder, hash_file, lock, publish, read_entry
from treeline._commands import list_options
from treeline._compile import compile_extension, describe_compilation
from treeline._inputs import Inputs, RobotPath, Scene, read_inputs
from treeline._messages import Diagnostic, refuse, tell
from treeline._program import find_program, run_program

FORMAT = "1"  # of entries: those of another are not found
TRIES = 3  # where files change while they are read


def hash_parts(parts: Iterable[bytes]) -> str:
    """A name for a list of texts; each counts with its length, so that no two lists look the same."""
    digest = hashlib.sha256()
    for part in parts:
        digest.update(f"{len(part)}:".encode())
        digest.update(part)
    return digest.hexdigest()[:20]


def write_file(place: Path, text: str) -> None:
    """Writes a file of the cache at once."""
    with tempfile.NamedTemporaryFile("w", dir=place.parent, delete=False, encoding="utf-8") as file:
        file.write(text)
    os.replace(file.name, place)


def hash_program(folder: Path) -> str:
    """The hash of the program. It is kept, since the program has many megabytes, until the file changes."""
    program = Path(find_program()).resolve()
    status = program.stat()
    marks = [status.st_size, status.st_mtime_ns, status.st_ctime_ns, status.st_ino, status.st_dev]
    place = folder / f"program_{hash_parts([os.fsencode(program), *(str(mark).encode() for mark in marks)])}"
    try:
        kept = place.read_text(encoding="ascii")
    except (OSError, ValueError):
        kept = ""
    if re.fullmatch("[0-9a-f]{64}", kept):
        return kept
    digest = hash_file(program)
    write_file(place, digest)
    return digest


@dataclass(frozen=True)
class Request:
    """A module that is wanted."""

    inputs: Inputs
    options: list[str]

    def stem(self) -> str:
        """Names of entries begin with that of the robot's file."""
        return "m_" + re.sub(r"\W", "_", Path(self.inputs.robot).stem, flags=re.ASCII)

    def key(self, folder: Path) -> str:
        """Tells apart all that a module depends on but for files that the scene names."""
        facts = [FORMAT, *self.options, *(file.name for file in self.inputs.files()), hash_program(folder),
                 *describe_compilation()]
        return hash_parts([*self.inputs.read(), *map(os.fsencode, facts)])

    def folder_of_files(self) -> Path:
        return Path(self.inputs.robot).absolute().parent


def list_place(folder: Path, request: Request, key: str) -> Path:
    """Where the list of further files is kept, relative to that of the robot."""
    return folder / f"{request.stem()}_{key}.inputs"


def read_others(folder: Path, request: Request, key: str) -> list[str]:
    """Further files that the module was made from: robots that a scene lists. Empty where nothing is known of it."""
    try:
        others = json.loads(list_place(folder, request, key).read_text(encoding="utf-8"))
        return [str(other) for other in others] if isinstance(others, list) else []
    except (OSError, ValueError):
        return []


def name_entry(folder: Path, request: Request, key: str) -> str:
    """The name of the module, which follows from the content of all files."""
    contents = [key.encode()]
    for other in read_others(folder, request, key):
        place = request.folder_of_files() / other
        contents += [other.encode(), place.read_bytes() if place.is_file() else b"missing"]
    return f"{request.stem()}_{hash_parts(contents) if len(contents) > 1 else key}"


def read_depfile(text: str) -> list[str]:
    """The files that a rule of make depends on, whose blanks are escaped."""
    words = re.findall(r"(?:\\[ #]|\$\$|[^\s\\])+", text.partition(":")[2])
    return [re.sub(r"\\([ #])", r"\1", word).replace("$$", "$") for word in words]


def note_others(folder: Path, request: Request, key: str, files: Iterable[str]) -> None:
    """Keeps the list of further files, at once."""
    named = {str(file.absolute()) for file in request.inputs.files()}
    others = [os.path.relpath(file, request.folder_of_files()) for file in files
              if os.path.normpath(file) not in map(os.path.normpath, named)]
    if others:
        write_file(list_place(folder, request, key), json.dumps(others))


def generate(request: Request, work: Path) -> list[Diagnostic]:
    """Writes the package and the list of its inputs into a folder."""
    arguments = [*request.inputs.arguments(), *request.options, "--package=python", f"--output={work / 'package'}",
                 f"--depfile={work / 'inputs.d'}"]
    messages = run_program("generate", arguments, request.inputs.text).messages
    if not (work / "package" / "extension" / "build.json").is_file():
        raise refuse("the program is older than the package `treeline` of Python", "Install both from one release.",
                     find_program())
    return messages


def make_entry(folder: Path, request: Request, key: str) -> None:
    """Generates and compiles a module and puts it into its place."""
    with tempfile.TemporaryDirectory(dir=folder, prefix="making_") as work:
        messages = generate(request, Path(work))
        package = Path(work) / "package"
        (module,) = (package / "python").iterdir()
        compile_extension(package, module / "_native.abi3.so")
        if request.key(folder) != key:  # a file was written to meanwhile, and may be that of before or after
            return
        note_others(folder, request, key, read_depfile((Path(work) / "inputs.d").read_text(encoding="utf-8")))
        told = {severity: [each.text for each in messages if each.severity == severity]
                for severity in ("warning", "note")}
        publish(module, folder / name_entry(folder, request, key), told)


def find_entry(folder: Path, request: Request) -> tuple[str, dict[str, Any]]:
    """The entry of a module and its record; it is made where it is missing or damaged."""
    for _ in range(TRIES):
        key = request.key(folder)
        record = read_entry(folder / name_entry(folder, request, key))
        if record is None:
            with lock(folder, key):
                record = read_entry(folder / name_entry(folder, request, key))  # of another process, meanwhile
                if record is None:
                    make_entry(folder, request, key)
                    record = read_entry(folder / name_entry(folder, request, key))
        if record is not None:
            return name_entry(folder, request, key), record
    raise refuse("the file changes while it is read", "Load it when it is complete.", request.inputs.robot)


def import_entry(folder: Path, name: str) -> ModuleType:
    if str(folder) not in modules.__path__:  # the environment names another cache than before
        modules.__path__.append(str(folder))
    module = f"{modules.__name__}.{name}"
    if module not in sys.modules:
        importlib.invalidate_caches()
    return importlib.import_module(module)


def load(robot: RobotPath, scene: Scene = None, *, functions: Sequence[str] | None = None,
         real: Literal["double", "float"] | None = None) -> ModuleType:
    """The functions of a robot in a scene as a module, which `treeline generate --package python` describes: functions
    on NumPy arrays or other buffers, of one state or of many, names and limits of joints.

    `functions` and `real` go before what the scene says. The first call takes seconds, since it compiles; the module is
    kept, and later calls take milliseconds as long as robot, scene, program, compiler and flags (CC, CFLAGS, LDFLAGS)
    stay what they are. Modules lie in `python` in TREELINE_CACHE, else in XDG_CACHE_HOME/treeline, else in
    ~/.cache/treeline, and may be deleted there at any time.

    Raises `Error` where robot or scene are refused, or program, compiler or Python.h are missing. Warns by
    `InputWarning`; notes go to the logger "treeline".
    """
    request = Request(read_inputs(robot, scene), list_options(functions=functions, real=real))
    folder = find_folder()
    name, record = find_entry(folder, request)
    tell(record)
    return import_entry(folder, name)
