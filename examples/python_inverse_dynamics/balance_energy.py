"""Joint torques of a recorded motion, and the energy that they take away. Of the log alone, inverse dynamics finds the
torques, these the friction, and their work the energy that was lost. Usage: balance_energy.py URDF LOG
"""

import sys

import numpy as np

import treeline

log = np.genfromtxt(sys.argv[2], delimiter=",", names=True)
t = log["time_s"]
q = np.stack([log[f"q{i}"] for i in range(6)], axis=1)
qd = np.stack([log[f"qd{i}"] for i in range(6)], axis=1)
qdd = np.gradient(qd, t, axis=0, edge_order=2)

arm = treeline.load(sys.argv[1], functions=["inverse_dynamics", "kinetic_energy", "potential_energy"])
tau = arm.inverse_dynamics(q, qd, qdd, threads=4)  # all rows of the log in one call
energy = (arm.kinetic_energy(q, qd) + arm.potential_energy(q))[:, 0]

friction = -(tau * qd).sum(axis=0) / (qd**2).sum(axis=0)  # least squares, for each joint
power = (tau * qd).sum(axis=1)
work = ((power[1:] + power[:-1]) / 2 * np.diff(t)).sum()
print("friction", np.round(friction, 3), "N m s/rad")
print(f"energy changed by {energy[-1] - energy[0]:.3f} J, work of the torques {work:.3f} J")
