"""Moves a simulated PUMA by the controller that its scene emits, until an encoder is lost."""

from pathlib import Path

import numpy as np

import treeline

urdf = Path(__file__).parents[2] / "robots/puma560/puma560.urdf"
arm = treeline.load(urdf, {"controller": {"laws": "joint_impedance"}, "functions": ["forward_dynamics"]})
controller = arm.Controller()
controller.config.stale_ticks = 0  # commands may be hours apart
q, qd, way = np.array([0, -0.7, 0.4, 0, 0.3, 0]), np.zeros(arm.nv), []
for tick in range(3000):
    if tick == 100:
        controller.command(arm.Kind.START)
    if tick == 200:
        controller.command(arm.Kind.MOVE_JOINTS, goal=[1.2, -1.3, 1, 0.5, 0.8, 0], duration=1.5)
    measured = q.copy()
    if tick >= 2000:
        measured[1] = np.nan
    output = controller.step(measured, qd)
    if tick in (0, 1000, 1999, 2000, 2999):
        print(f"{output.mode.name}, {output.reason!r}, brakes {output.brakes}, {np.abs(qd).max():.2f} rad/s")
    qd = qd + 1e-3 * arm.forward_dynamics(q, qd, output.tau)
    q = q + 1e-3 * qd
    way.append([1e-3 * tick, *q])
np.savetxt("way.csv", way[::50], "%.9f", ",", header="time_s,q0,q1,q2,q3,q4,q5", comments="")
