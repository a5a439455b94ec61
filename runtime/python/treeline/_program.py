"""The program `treeline`: where it is, and how it is run."""

import os
import shutil
import subprocess
from collections.abc import Sequence
from dataclasses import dataclass

from treeline._messages import Diagnostic, error_of, read_messages, refuse

#: Where the program is if this package lies in share/treeline/python, or in lib/python3.x/site-packages, below a folder.
BESIDE = os.path.normpath(os.path.join(os.path.realpath(__file__), *[os.pardir] * 5, "bin", "treeline"))


def find_program() -> str:
    """The program that the environment variable TREELINE names, else the one installed with this package, else that
    of PATH. Where TREELINE names a folder, as in the tutorial, it is of no matter here."""
    named = os.environ.get("TREELINE", "")
    if named and not os.path.isdir(named):
        found = shutil.which(named)
        if found is None:
            raise refuse(f"TREELINE names \"{named}\", which is no program", "Name the built program `treeline`.")
        return found
    found = shutil.which(BESIDE) or shutil.which("treeline")
    if found is None:
        raise refuse("the program `treeline` is not found",
                     "Build and install it as its README says, and put it on PATH or name it in the environment "
                     "variable TREELINE.")
    return found


@dataclass(frozen=True)
class Run:
    """What a run of the program gave."""

    output: bytes
    messages: list[Diagnostic]


def run_program(command: str, arguments: Sequence[str], text: bytes = b"", fine: Sequence[int] = (0,)) -> Run:
    """Runs a command to its end with `text` as standard input. An exit code that is not `fine` is an `Error`."""
    try:
        ran = subprocess.run([find_program(), command, *arguments], input=text, capture_output=True, check=False,
                             env={**os.environ, "TREELINE_MESSAGES": "json"})
    except OSError as fault:
        raise refuse(f"the program `treeline` cannot be run: {fault.strerror}",
                     "Build it for this machine.", str(fault.filename or "")) from fault
    messages = read_messages(ran.stderr.decode(errors="replace"))
    if ran.returncode not in fine:
        raise error_of(messages, f"treeline {command} ended with {ran.returncode}")
    return Run(ran.stdout, messages)
