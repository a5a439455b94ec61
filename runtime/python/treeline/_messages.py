"""What the program says, as objects."""

import json
import logging
import warnings
from collections.abc import Iterable, Sequence
from dataclasses import dataclass


@dataclass(frozen=True)
class Diagnostic:
    """One thing that the program says of an input."""

    severity: str  #: "note", "warning" or "error"
    file: str  #: as the caller named it; empty: it is about no file
    line: int  #: from 1 on; 0: unknown
    place: str  #: of the element or key, such as `robot/joint[elbow]/axis`; may be empty
    message: str  #: what is wrong
    advice: str  #: what to do about it; may be empty
    text: str  #: all of that as the program prints it


class InputWarning(UserWarning):
    """A robot or a scene is accepted, and something about it is odd."""


class Error(RuntimeError):
    """A robot or a scene is refused, or something is missing that would work on it.

    The message is what the program prints. `file`, `line`, `place`, `message` and `advice` are those of the first error
    in `diagnostics`, which has all that was said.
    """

    def __init__(self, text: str, diagnostics: Sequence[Diagnostic] = ()) -> None:
        super().__init__(text)
        self.diagnostics = tuple(diagnostics)
        errors = [each for each in self.diagnostics if each.severity == "error"]
        first = errors[0] if errors else Diagnostic("error", "", 0, "", text, "", text)
        self.file, self.line, self.place = first.file, first.line, first.place
        self.message, self.advice = first.message, first.advice


def refuse(message: str, advice: str, file: str = "") -> Error:
    """An error that this package finds, in the form of the program's."""
    text = f"{file + ': ' if file else ''}error: {message}\n  {advice}"
    return Error(text, [Diagnostic("error", file, 0, "", message, advice, text)])


def read_messages(output: str) -> list[Diagnostic]:
    """The messages on the program's standard error. Lines that are no JSON are of a program that could not go on."""
    found = []
    for line in filter(None, output.splitlines()):
        try:
            told = json.loads(line)
            found.append(Diagnostic(told["severity"], told["file"], told["line"], told["element"], told["fault"],
                                    told["remedy"], told["text"]))
        except (ValueError, KeyError, TypeError):
            mild = line.startswith(" ") or "note: " in line or "warning: " in line
            found.append(Diagnostic("note" if mild else "error", "", 0, "", line, "", line))
    return found


def error_of(diagnostics: Iterable[Diagnostic], otherwise: str) -> Error:
    """The error of a run that failed; `otherwise` is its text where no error was told."""
    told = list(diagnostics)
    errors = [each.text for each in told if each.severity == "error"]
    return Error("\n".join(errors) or otherwise, told)


def tell(texts: dict[str, list[str]]) -> None:
    """Tells the caller of the function that calls this what is no error, by severity."""
    for text in texts.get("warning", []):
        warnings.warn(text, InputWarning, stacklevel=3)
    for text in texts.get("note", []):
        logging.getLogger("treeline").info(text)
