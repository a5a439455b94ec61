"""Records a UR10e that follows sines of several frequencies: q, qd and the torques of its motors, 100 times in a second.
The robot is the simulated one, whose joints have friction; encoders and torques are noisy.
"""

from pathlib import Path

import numpy as np

import treeline

urdf = Path(__file__).parents[2] / "robots/ur10e/ur10e.urdf"
joints = ["shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"]
damping = [8, 8, 5, 1, 1, 0.5]  # N m s/rad
friction = {"model": "viscous", "joints": {joint: {"damping": value} for joint, value in zip(joints, damping)}}
robot = treeline.Model(urdf, {"joint_friction": friction})
random = np.random.default_rng(1)
dt, n = 0.01, robot.nv
middle, swing = np.array([0, -1.2, 1, 0.3, 0.5, 0]), np.array([0.8, 0.7, 0.8, 0.8, 0.8, 0.8])
rate = 2 * np.pi * np.array([0.21, 0.33, 0.42, 0.55, 0.73, 0.64])  # rad/s
q, qd, rows = middle.copy(), swing * rate, []
for t in dt * np.arange(2000):
    goal, speed = middle + swing * np.sin(rate * t), swing * rate * np.cos(rate * t)
    tau = robot.inverse_dynamics(q, qd, 200 * (goal - q) + 28 * (speed - qd))
    noise = random.normal(size=(3, n)) * np.array([[1e-5], [1e-4], [0.3]])
    rows.append([t, *q + noise[0], *qd + noise[1], *tau + noise[2]])
    q, qd, *_ = robot.step(q, qd, tau, seconds=dt / 10, steps=10)
names = ["time_s", *(f"{symbol}{i}" for symbol in ("q", "qd", "tau") for i in range(n))]
np.savetxt("log.csv", rows, "%.6f", ",", header=",".join(names), comments="")
