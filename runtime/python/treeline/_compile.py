"""Compiles the extension of a package that `treeline generate --package python` wrote, with a compiler alone."""

import hashlib
import json
import os
import shlex
import shutil
import subprocess
import sys
import sysconfig
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import Any

from treeline._messages import Error, refuse

#: How compilers link what Python loads.
LINK_FLAGS = ["-bundle", "-undefined", "dynamic_lookup"] if sys.platform == "darwin" else ["-shared"]


def find_compiler() -> list[str]:
    """The compiler of C as a command: CC, else that of Python where it is there, else cc, gcc or clang."""
    named = os.environ.get("CC", "")
    own = str(sysconfig.get_config_var("CC") or "")
    for command in [named] if named else [own, "cc", "gcc", "clang"]:
        words = shlex.split(command)
        if words and shutil.which(words[0]) is not None:
            return words
    missing = f"CC names \"{named}\", which is no program" if named else "no compiler of C is found"
    raise refuse(missing, "Install one (Debian: `apt-get install gcc`), or name it in the environment variable CC.")


def find_headers() -> str:
    """The folder of Python.h."""
    folder = sysconfig.get_path("include")
    if not os.path.isfile(os.path.join(folder, "Python.h")):
        raise refuse(f"Python.h is missing in {folder}",
                     "Install the headers of this Python (Debian: `apt-get install python3-dev`).")
    return folder


def describe_compilation() -> list[str]:
    """All that compiled code depends on beside its sources: compiler, flags, Python and machine."""
    words = find_compiler()
    facts = [*words, os.environ.get("CFLAGS", ""), os.environ.get("LDFLAGS", ""), find_headers(),
             sysconfig.get_platform(), str(sysconfig.get_config_var("EXT_SUFFIX"))]
    for program in filter(None, map(shutil.which, words)):
        path = os.path.realpath(program)
        status = os.stat(path)
        facts += [path, str(status.st_size), str(status.st_mtime_ns)]
    return facts


def run_compiler(command: list[str], folder: Path) -> None:
    ran = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace", check=False)
    if ran.returncode != 0:
        raise Error(f"error: the compiler ended with {ran.returncode}: {shlex.join(command)}\n{ran.stderr.strip()}")


def compile_extension(package: Path, library: Path) -> None:
    """Compiles the sources of a package, several at a time, and links them to a library."""
    with open(package / "extension" / "build.json", encoding="utf-8") as file:
        build: dict[str, Any] = json.load(file)
    compiler = find_compiler()
    flags = [*shlex.split(os.environ.get("CFLAGS", "")), *build["flags"], "-fPIC", f"-I{find_headers()}"]
    objects = [hashlib.sha256(source.encode()).hexdigest()[:16] + ".o" for source in build["sources"]]
    commands = [[*compiler, *flags, *build["flags_of_sources"].get(source, []), "-c", source, "-o", object_]
                for source, object_ in zip(build["sources"], objects)]
    with ThreadPoolExecutor(os.cpu_count()) as threads:
        list(threads.map(run_compiler, commands, [package] * len(commands)))
    run_compiler([*compiler, *LINK_FLAGS, *objects, "-o", str(library), *shlex.split(os.environ.get("LDFLAGS", "")),
                  "-lm"], package)
