"""Finds mass and centre of what a gripper holds, from noisy torques along a motion that excites them."""

from pathlib import Path

import numpy as np

import treeline

urdf = Path(__file__).parents[2] / "robots/ur10e/ur10e.urdf"
arm = treeline.load(urdf, {"regressor": {"parameters": "none", "payload": "tool"},
                           "inputs": {"payload": "tool"},
                           "functions": ["inverse_dynamics", "inverse_dynamics_regressor"]})

# The motion: sines of several frequencies in every joint, 10 s, 500 states.
t = np.linspace(0, 10, 500)
middle, swing = np.array([0, -1, 1, 0.3, 0.5, 0]), np.array([0.6, 0.3, 0.5, 0.8, 0.8, 0.8])
rate = 2 * np.pi * np.array([0.2, 0.3, 0.4, 0.5, 0.7, 0.6])  # rad/s
q = middle + swing * np.sin(np.outer(t, rate))
qd = swing * rate * np.cos(np.outer(t, rate))
qdd = -swing * rate**2 * np.sin(np.outer(t, rate))
rows = np.column_stack([t, q])
np.savetxt("motion.csv", rows, "%.9f", ",", header="time_s," + ",".join(f"q{i}" for i in range(6)), comments="")

# The measurement: torques of an arm that holds 2 kg at (0.05, 0, 0.1) m, with noise of 0.5 N m.
m, c = 2.0, np.array([0.05, 0.0, 0.1])
about = 0.01 * np.eye(3) + m * (c @ c * np.eye(3) - np.outer(c, c))
load = np.array([m, *(m * c), about[0, 0], about[0, 1], about[1, 1], about[0, 2], about[1, 2], about[2, 2]])
noise = np.random.default_rng(1).normal(scale=0.5, size=q.shape)
measured = arm.inverse_dynamics(q, qd, qdd, payload=load) + noise

# The law is linear in the ten parameters: torques without a load, and Y times them.
missing = measured - arm.inverse_dynamics(q, qd, qdd, payload=np.zeros(10))
Y = arm.inverse_dynamics_regressor(q, qd, qdd).reshape(-1, 10)
found, *_ = np.linalg.lstsq(Y, missing.reshape(-1), rcond=None)
print(f"mass   {found[0]:.2f} kg, in truth {m:.2f}")
print("centre", np.round(found[1:4] / found[0], 2) + 0.0, "m, in truth", c)
spread = 0.5 * np.sqrt(np.diag(np.linalg.inv(Y.T @ Y)))
print(f"expected of the noise: {spread[0]:.3f} kg, {spread[1:4].max() / m:.4f} m")
