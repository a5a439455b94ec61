"""The page in which a robot is driven."""

import webbrowser
from types import TracebackType
from typing import Any, Self

from treeline._commands import list_options
from treeline._conversation import Conversation
from treeline._inputs import RobotPath, Scene, read_inputs


class Drive:
    """A robot that is driven, until `stop` or the end of a `with` block brakes it to rest."""

    url: str  #: the address of the page

    def __init__(self, conversation: Conversation) -> None:
        self._conversation = conversation
        self.url = conversation.first_line

    def say(self, command: str) -> None:
        """Gives a command such as `joint elbow to 45 deg`; what is wrong with it, and `help`, is told in `messages`."""
        self._conversation.input.write(command.encode() + b"\n")
        self._conversation.input.flush()

    def messages(self) -> str:
        """What has been said since the start."""
        return "\n".join(each.text for each in self._conversation.messages())

    def stop(self) -> None:
        """Brakes to rest and ends."""
        self._conversation.finish()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.stop()


def drive(robot: RobotPath, scene: Scene = None, *, browser: bool = True, **options: Any) -> Drive:
    """Drives a simulated robot: generates and compiles its code with a control loop, and opens the page, in a browser
    unless told otherwise. Options are those of `treeline drive` with `_` for `-`: `port=8080`, `q=[0, 1, 0]`.

        with treeline.drive("robot.urdf", "scene.yaml") as robot:
            robot.say("joint elbow to 45 deg")
            input("Enter ends")
    """
    named = {name.replace("_", "-"): value for name, value in options.items()}
    started = Drive(Conversation("drive", read_inputs(robot, scene), list_options(**named), by_signal=True))
    if browser:
        webbrowser.open(started.url)
    return started
