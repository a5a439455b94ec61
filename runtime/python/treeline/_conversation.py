"""A run of the program that goes on while Python talks with it."""

import os
import subprocess
import tempfile
import threading
import weakref
from collections.abc import Sequence
from typing import IO

from treeline._inputs import Inputs
from treeline._messages import Diagnostic, Error, error_of, read_messages
from treeline._program import find_program


def listen(stream: IO[bytes], said: list[bytes]) -> None:
    """Keeps what the program says, until it ends."""
    for line in stream:
        said.append(line)


def end(process: subprocess.Popen[bytes], listener: threading.Thread, by_signal: bool) -> None:
    """Ends the program, by a signal or by the end of its input, and waits for that."""
    if by_signal and process.poll() is None:
        process.terminate()  # not SIGINT, which what a script starts in the background ignores
    elif process.stdin is not None and not process.stdin.closed:
        try:
            process.stdin.close()
        except BrokenPipeError:  # it has ended
            pass
    listener.join()
    with process:
        pass


class Conversation:
    """The program with a command, which has printed its first line. `finish` ends it, else the end of this object."""

    def __init__(self, command: str, inputs: Inputs, options: Sequence[str], by_signal: bool = False) -> None:
        self._command = command
        self._said: list[bytes] = []
        with tempfile.NamedTemporaryFile(suffix=".yaml") as scene:  # which is read before the first line is printed
            scene.write(inputs.text)
            scene.flush()
            self._scene = scene.name
            words = [scene.name if word == "-" else word for word in inputs.arguments()]
            process = subprocess.Popen([find_program(), command, *words, *options], stdin=subprocess.PIPE,
                                       stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                       env={**os.environ, "TREELINE_MESSAGES": "json"})
            assert process.stdin is not None and process.stdout is not None and process.stderr is not None
            listener = threading.Thread(target=listen, args=(process.stderr, self._said), daemon=True)
            listener.start()
            self.finish = weakref.finalize(self, end, process, listener, by_signal)
            self.input, self.output = process.stdin, process.stdout
            self._process = process
            self.first_line = self._rename(self.output.readline()).strip()
        if not self.first_line:
            raise self.failure()

    def _rename(self, said: bytes) -> str:
        """What the program says, with the name that a dictionary has where it is read from standard input."""
        return said.decode(errors="replace").replace(self._scene, "standard input")

    def messages(self) -> list[Diagnostic]:
        """What has been said since the start."""
        return read_messages(self._rename(b"".join(self._said)))

    def failure(self) -> Error:
        """The error of a program that ended though it should not have."""
        self.finish()
        return error_of(self.messages(), f"treeline {self._command} ended with {self._process.returncode}")
