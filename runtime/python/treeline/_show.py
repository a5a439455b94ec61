"""A control loop in the page of `treeline drive --robot controller:HOST:PORT`: `show/show.h` in Python.

The standard library alone, and nothing of the package: the file may be copied to where a robot is controlled.
"""

import hmac
import socket
import struct
import time
from collections.abc import Iterable
from types import TracebackType
from typing import Self

_HEAD = struct.Struct("<4sHHQQQQ")  # see show/packet.h
_REQUEST, _MOTION, _GOAL = 3, 4, 5
_SEAL = 16  # bytes
_LONGEST = 40 + 8 * 1024 + _SEAL  # bytes


class Show:
    """Shows what a robot does, and gets the goals, Start and STOP of the page. No method waits.

        with treeline.Show(nq=6, nv=6) as show:
            while True:
                enabled = show.receive()
                ...  # go to show.q, or brake unless enabled
                show.send(q, qd, tau, error=error)

    Coordinates and velocities are in the order and the units of the generated code.
    """

    enabled = False  #: go to the goals; else brake: after STOP or a fault, or in silence
    mode = 0  #: 0 idle, 1 running, 2 stopping, 3 faulted
    control = 0  #: goals are of 0 the joints, 1 the points, 2 nothing: be led by hand
    q: tuple[float, ...] = ()  #: goals of the joints
    qd: tuple[float, ...] = ()  #: their velocities
    points: tuple[tuple[float, ...], ...] = ()  #: goals of the points: x y z qx qy qz qw, in the world

    def __init__(self, nq: int, nv: int, host: str = "127.0.0.1", port: int = 7000, secret: str = "") -> None:
        """Listens at an address of this machine. Who does not prove to know `secret` is not heard; "" proves nothing."""
        self._sizes = (nq, nv)
        self._secret = secret.encode()
        self._run = time.time_ns()
        self._peer: tuple[str, int] | None = None
        self._robot = self._newest = self._sent = 0
        self._heard = self._led = float("-inf")  # s: when somebody asked, and when goals came
        self._socket = socket.socket(socket.AF_INET, socket.SOCK_DGRAM)
        self._socket.bind((host, port))
        self._socket.setblocking(False)

    def receive(self) -> bool:
        """Takes what has come, and returns `enabled`. Who is silent for 0.1 s no longer enables anything."""
        for _ in range(64):  # a flood is not to hold the loop
            try:
                packet, peer = self._socket.recvfrom(_LONGEST)
            except BlockingIOError:
                break
            self._open(packet, peer)
        self.enabled = self.mode == 1 and time.monotonic() - self._led < 0.1
        return self.enabled

    def send(self, q: Iterable[float], qd: Iterable[float], tau: Iterable[float], **shown: float) -> None:
        """Shows a motion: positions and velocities of the joints, their torques or forces, and at most 16 numbers by
        names of at most 16 bytes. Nobody is sent anything who has not asked within the last second."""
        if self._peer is None or time.monotonic() - self._heard > 1:
            return
        numbers = [*q, *qd, *tau]
        if len(numbers) != self._sizes[0] + 2 * self._sizes[1]:
            raise ValueError(f"q, qd and tau have {len(numbers)} numbers, nq and nv are {self._sizes}")
        self._sent += 1
        packet = _HEAD.pack(b"TLRB", 2, _MOTION, self._robot, self._sent, self._newest, self._run)
        packet += struct.pack(f"<{len(numbers)}d", *numbers)
        for name, number in list(shown.items())[:16]:
            packet += struct.pack("<16sd", name.encode(), number)
        try:
            self._socket.sendto(packet + self._seal(packet), self._peer)
        except OSError:  # the next one follows a lost one
            pass

    def close(self) -> None:
        """Lets go of the address; the page then says that the robot is no longer connected."""
        self._socket.close()

    def _seal(self, packet: bytes) -> bytes:
        return hmac.digest(self._secret, packet, "sha256")[:_SEAL] if self._secret else b""

    def _open(self, packet: bytes, peer: tuple[str, int]) -> None:
        """Reads a packet of somebody who knows the secret."""
        if self._secret:
            packet, seal = packet[:-_SEAL], packet[-_SEAL:]
            if not hmac.compare_digest(seal, self._seal(packet)):
                return
        if len(packet) < _HEAD.size or len(packet) % 8 != 0:
            return
        name, version, kind, robot, sequence, _, run = _HEAD.unpack_from(packet)
        goal = struct.unpack_from(f"<{(len(packet) - _HEAD.size) // 8}d", packet, _HEAD.size)
        is_goal = kind == _GOAL and run == self._run and self._is_goal(goal)
        if name == b"TLRB" and version == 2 and (is_goal or (kind == _REQUEST and not goal)):
            self._obey(robot, sequence, goal, peer)

    def _is_goal(self, goal: tuple[float, ...]) -> bool:
        """Whether these numbers are goals for this robot."""
        points = len(goal) - 2 - sum(self._sizes)
        return points >= 0 and points % 7 == 0 and 0 <= goal[0] <= 3 and 0 <= goal[1] <= 2

    def _obey(self, robot: int, sequence: int, goal: tuple[float, ...], peer: tuple[str, int]) -> None:
        """Obeys a drive that may lead: the one that does, or, after a silence of 1 s, another."""
        now = time.monotonic()
        if peer != self._peer and now - self._led < 1:
            return
        if (peer == self._peer or self._secret) and sequence <= self._newest:
            return
        self._peer, self._robot, self._newest, self._heard = peer, robot, sequence, now
        if goal:
            joints, end = 2 + self._sizes[0], 2 + sum(self._sizes)
            self.mode, self.control = int(goal[0]), int(goal[1])
            self.q, self.qd = goal[2:joints], goal[joints:end]
            self.points = tuple(goal[i:i + 7] for i in range(end, len(goal), 7))
            self._led = now

    def __enter__(self) -> Self:
        return self

    def __exit__(self, kind: type[BaseException] | None, fault: BaseException | None,
                 trace: TracebackType | None) -> None:
        self.close()
