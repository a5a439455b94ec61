"""A robot whose functions are interpreted: nothing is compiled."""

import json
import math
import operator
import threading
from collections import namedtuple
from collections.abc import Callable, Sequence
from types import TracebackType
from typing import TYPE_CHECKING, Any, Self, TypeAlias

from treeline._commands import list_options
from treeline._conversation import Conversation
from treeline._inputs import RobotPath, Scene, read_inputs
from treeline._messages import Error, refuse, tell

if TYPE_CHECKING:
    import numpy as np
    from numpy.typing import NDArray

    Array: TypeAlias = NDArray[np.float64]

MOST_STATES = 1 << 16  # of one request
MOST_STEPS = 1 << 30
REAL = "float64"


class Argument:
    """An argument or a result of a function: a vector, or a matrix with more than one column."""

    def __init__(self, told: dict[str, Any]) -> None:
        self.name: str = told["name"]
        self.meaning: str = told["meaning"]
        self.size: int = told["rows"] * told["cols"]
        self.shape: tuple[int, ...] = (told["rows"], told["cols"]) if told["cols"] > 1 else (told["rows"],)

    def read(self, value: Any) -> "tuple[Array, int | None]":
        """The numbers as a row for each state; None: it is of one state, without a dimension of its own."""
        import numpy as np
        array = np.asarray(value, REAL)
        if array.shape in (self.shape, (self.size,)) or (array.shape == () and self.size == 1):
            return array.reshape(1, self.size), None
        if array.ndim > 1 and array.shape[1:] in (self.shape, (self.size,)):
            return array.reshape(array.shape[0], self.size), array.shape[0]
        wanted = ", ".join(map(str, self.shape))
        raise ValueError(f"{self.name}: has the shape {array.shape}, wants ({wanted}{',' * (len(self.shape) == 1)}) or "
                         f"(N, {wanted})")


class Interpreted:
    """A function of a `Model`. It takes its arguments in their order or by name, of one state or of N states with N in
    front; arguments without N hold for all states. Several results are a tuple with names."""

    def __init__(self, name: str, told: dict[str, Any], call: "Callable[[str, Array, str], Array]") -> None:
        self._name, self._call = name, call
        self.arguments = [Argument(each) for each in told["arguments"]]
        self.results = [Argument(each) for each in told["results"]]
        lines = [told["equation"]]
        for direction, group in (("in ", self.arguments), ("out", self.results)):
            lines += [f"{direction} {each.name} {each.shape}: {each.meaning}" for each in group]
        self.__doc__ = "\n".join(lines)
        self._tuple: Callable[..., Any] = namedtuple(name, [each.name for each in self.results])  # type: ignore[misc]

    def _order(self, values: Sequence[Any], named: dict[str, Any]) -> list[Any]:
        names = [each.name for each in self.arguments]
        if len(values) > len(names):
            raise TypeError(f"{self._name}() takes {len(names)} arguments without a name, not {len(values)}")
        given = dict(zip(names, values))
        for name, value in named.items():
            if name not in names or name in given:
                raise TypeError(f"{self._name}() {'is given' if name in given else 'has no argument'} '{name}'"
                                + " twice" * (name in given))
            given[name] = value
        missing = [name for name in names if name not in given]
        if missing:
            raise TypeError(f"{self._name}() lacks the argument {missing[0]}")
        return [given[name] for name in names]

    def __call__(self, *values: Any, **named: Any) -> Any:
        return self.compute(self._order(values, named))

    def compute(self, values: Sequence[Any], options: str = "") -> Any:
        """The results of all arguments in their order; `options` stand behind the number of states in a request."""
        import numpy as np
        rows, states = [], None
        for argument, value in zip(self.arguments, values):
            row, own = argument.read(value)
            if own is not None and states not in (None, own):
                raise ValueError(f"{argument.name}: has {own} states, and the arguments before it {states}")
            states = states if own is None else own
            rows.append(row)
        count = 1 if states is None else states
        numbers = np.concatenate([np.broadcast_to(row, (count, row.shape[1])) for row in rows], axis=1)
        parts = [self._call(self._name, numbers[i:i + MOST_STATES], options) for i in range(0, count, MOST_STATES)]
        results = np.concatenate([np.empty(0), *parts]).reshape(count, sum(each.size for each in self.results))
        return self._split(results, () if states is None else (states,))

    def _split(self, numbers: "Array", leading: tuple[int, ...]) -> Any:
        results, first = [], 0
        for each in self.results:
            results.append(numbers[:, first:first + each.size].reshape(leading + each.shape).copy())
            first += each.size
        return results[0] if len(results) == 1 else self._tuple(*results)


def sort_messages(told: dict[str, Any]) -> dict[str, list[str]]:
    """The texts of what is no error by severity."""
    return {severity: [each["text"] for each in told["messages"] if each["severity"] == severity]
            for severity in ("warning", "note")}


def list_limits(rows: Sequence[dict[str, Any]], key: str, otherwise: float) -> tuple[float, ...]:
    return tuple(otherwise if each[key] is None else each[key] for each in rows)


class Model:
    """A robot in a scene whose functions the program interprets, in double: any robot, at once, without a compiler. They
    have the names, arguments and results of the module that `load` gives, and take and give NumPy's arrays. A call waits
    for another process, some tens of microseconds; N states in one call wait once.

    Raises `Error` where robot or scene are refused, and warns by `InputWarning`.
    """

    dtype = REAL

    def __init__(self, robot: RobotPath, scene: Scene = None, *, functions: Sequence[str] | None = None) -> None:
        self._conversation = Conversation("interpret", read_inputs(robot, scene), list_options(functions=functions))
        self._one_at_a_time = threading.Lock()
        told = json.loads(self._conversation.first_line)
        tell(sort_messages(told))
        self._moved: Interpreted | None = None
        coordinates = told["coordinates"]
        self.name: str = told["name"]
        self.functions: tuple[str, ...] = tuple(map(python_name, told["functions"]))
        velocities = told["velocities"]
        self.nq, self.nv, self.task_rows = len(coordinates), len(velocities), int(told["task_rows"])
        self.coordinate_joints: tuple[str, ...] = tuple(each["joint"] for each in coordinates)
        self.coordinate_meanings: tuple[str, ...] = tuple(each["meaning"] for each in coordinates)
        self.velocity_joints: tuple[str, ...] = tuple(each["joint"] for each in velocities)
        self.velocity_names: tuple[str, ...] = tuple(each["name"] for each in velocities)
        self.home: tuple[float, ...] = tuple(each["home"] for each in coordinates)
        self.lower_limits = list_limits(coordinates, "lower", -math.inf)
        self.upper_limits = list_limits(coordinates, "upper", math.inf)
        self.velocity_limits = list_limits(velocities, "velocity", math.inf)
        self.effort_limits = list_limits(velocities, "effort", math.inf)

    def __getattr__(self, name: str) -> Interpreted:
        if name not in self.__dict__.get("functions", ()):
            have = ", ".join(self.__dict__.get("functions", ()))
            raise AttributeError(
                f"the model has no function {name}, but {have}; those of points need `operational_points` in the scene, "
                "others its key `functions`"
            )
        made = Interpreted(name, self._describe(name), self._call)
        self.__dict__[name] = made
        return made

    def step(self, q: Any, qd: Any, tau: Any, *, seconds: float, steps: int = 1, stops: bool = False) -> Any:
        """Moves the robot on by so many `steps` of so many `seconds`, in which the joint forces `tau` stay as they are:
        the simulation of `treeline simulate`, on the ground if the scene has one, and with `stops` between the limits of
        the joints. One state or N as for functions. Gives `q`, `qd`, the mean `force` (3) of the ground in N, world, and
        how many points it pressed in the last step, `contacts` (1); NaN where a motion does not stay finite.

        Entries of `tau` of a floating base are a force and a moment on it. Payloads and forces that the scene's functions
        take as arguments are none. `Error`: the scene has constraints, or a ground that nothing can touch."""
        count = operator.index(steps)
        if not 0 < seconds < math.inf or not 0 < count <= MOST_STEPS:
            raise ValueError(f"seconds: is {seconds}, wants more than 0, and steps: is {steps}, wants 1 to {MOST_STEPS}")
        if self._moved is None:
            told = self._describe("step")
            tell(sort_messages(told))
            self._moved = Interpreted("step", told, self._call)
        return self._moved.compute([q, qd, tau], f" {float(seconds)!r} {count} {str(bool(stops)).lower()}")

    def __dir__(self) -> list[str]:
        return [*super().__dir__(), *self.functions]

    def _describe(self, name: str) -> dict[str, Any]:
        told: dict[str, Any] = json.loads(self._ask(f"describe {name.removesuffix('_')}\n".encode(), lambda line: line))
        if "error" in told:
            raise Error(told["error"])
        return told

    def _call(self, name: str, numbers: "Array", options: str) -> "Array":
        import numpy as np
        request = f"call {name.removesuffix('_')} {len(numbers)}{options}\n".encode() + numbers.tobytes()
        return np.frombuffer(self._ask(request, self._read_numbers), REAL)

    def _read_numbers(self, line: bytes) -> bytes:
        told = json.loads(line)
        if "error" in told:
            raise refuse(told["error"], "Report this as a fault of Treeline.")
        return self._conversation.output.read(8 * told["numbers"])

    def _ask(self, request: bytes, read: Callable[[bytes], bytes]) -> bytes:
        """The answer to a request, whose first line `read` is given."""
        if not self._conversation.finish.alive:
            raise ValueError("the model is closed")
        with self._one_at_a_time:
            try:
                self._conversation.input.write(request)
                self._conversation.input.flush()
                line = self._conversation.output.readline()
            except BrokenPipeError:
                line = b""
            if not line:
                raise self._conversation.failure()
            return read(line)

    def close(self) -> None:
        """Ends the process that interprets; so does the end of the object, or of a `with` block."""
        self._conversation.finish()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()


def python_name(function: str) -> str:
    """`lambda` is a word of Python."""
    return "lambda_" if function == "lambda" else function
