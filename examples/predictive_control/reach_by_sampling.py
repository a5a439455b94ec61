"""Moves a UR10e by model-predictive path integrals: a thousand motions of 20 steps, each weighed by its distance from
the goal, and by torques beyond the limits.
"""

from pathlib import Path

import numpy as np

import treeline

urdf = Path(__file__).parents[2] / "robots/ur10e/ur10e.urdf"
arm = treeline.load(urdf, functions=["inverse_dynamics"])
random = np.random.default_rng(1)
dt, steps, motions = 0.05, 20, 1000
q, qd = np.array(arm.home), np.zeros(arm.nv)
goal = q + np.array([1, -1, 1, -1, 1, 1])
plan = np.zeros((steps, arm.nv))  # accelerations, rad/s^2
hardest = np.zeros(arm.nv)
way = []
for _ in range(60):
    tried = plan + 2 * random.normal(size=(motions, steps, arm.nv))
    Q, Qd, cost = np.tile(q, (motions, 1)), np.tile(qd, (motions, 1)), np.zeros(motions)
    for k in range(steps):
        tau = arm.inverse_dynamics(Q, Qd, tried[:, k], threads=4)
        Qd += dt * tried[:, k]
        Q += dt * Qd
        cost += ((Q - goal) ** 2).sum(axis=1) + (np.abs(tau) > arm.effort_limits).sum(axis=1)
    weights = np.exp(cost.min() - cost)
    plan = np.tensordot(weights / weights.sum(), tried, 1)
    hardest = np.maximum(hardest, np.abs(arm.inverse_dynamics(q, qd, plan[0])))
    qd += dt * plan[0]
    q += dt * qd
    way.append([dt * len(way), *q])
    plan = np.roll(plan, -1, axis=0)
print(f"{np.abs(q - goal).max():.2f} rad from the goal, {(hardest / arm.effort_limits).max():.2f} of the torque")
np.savetxt("reach.csv", way, "%.9f", ",", header="time_s," + ",".join(f"q{i}" for i in range(arm.nv)), comments="")
