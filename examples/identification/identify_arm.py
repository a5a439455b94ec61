"""Finds the base parameters of an arm and the friction of its joints from a log, by least squares, and foretells the
torques of the part of the log that it has not used. Usage: identify_arm.py URDF LOG
"""

import sys

import numpy as np

import treeline

scene = {"regressor": {"parameters": "base", "friction": "viscous"}, "functions": ["inverse_dynamics_regressor"]}
arm = treeline.load(sys.argv[1], scene)
log = np.genfromtxt(sys.argv[2], delimiter=",", names=True)
t = log["time_s"]
q, qd, tau = (np.stack([log[f"{symbol}{i}"] for i in range(arm.nv)], axis=1) for symbol in ("q", "qd", "tau"))

# A torque acts from one row to the next: means of these two states, and the acceleration between them.
qdd = np.diff(qd, axis=0) / np.diff(t)[:, None]
Y = arm.inverse_dynamics_regressor((q[1:] + q[:-1]) / 2, (qd[1:] + qd[:-1]) / 2, qdd)
tau = tau[:-1]

half = len(Y) // 2
rows = Y[:half].reshape(-1, Y.shape[2])
found, *_ = np.linalg.lstsq(rows, tau[:half].reshape(-1), rcond=None)
off = tau[half:] - Y[half:] @ found
noise = np.sqrt(np.square(off).mean())
spread = noise * np.sqrt(np.diag(np.linalg.inv(rows.T @ rows)))
print("friction", np.round(found[-arm.nv:], 1), "N m s/rad")
print(f"torques of the second half are foretold to {noise:.1f} N m")

told = treeline.inspect(sys.argv[1], scene, base_parameters=True)["base_parameters"][:-arm.nv]
sure = [(base, value) for base, value, its in zip(told, found, spread) if its < 0.05 * abs(value)]
print(f"{len(sure)} of {len(told)} base parameters are sure to 5 %, such as")
for base, value in sure[:3]:
    print(f"{base['name']}: {value:.2f} {base['unit']}, by the URDF {base['value']:.2f}")
