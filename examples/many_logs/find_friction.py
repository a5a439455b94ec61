"""Friction of a fleet of arms, of as many logs as there are. Each is read and summed up by a process of Dask, and a few
numbers come back. Usage: find_friction.py URDF LOG...
"""

import sys

import dask.bag
import numpy as np

import treeline


def sum_up(file, urdf):
    """The friction of each joint by one log."""
    arm = treeline.load(urdf, functions=["inverse_dynamics"])  # as compiled below
    log = np.genfromtxt(file, delimiter=",", names=True)
    q = np.stack([log[f"q{i}"] for i in range(6)], axis=1)
    qd = np.stack([log[f"qd{i}"] for i in range(6)], axis=1)
    qdd = np.gradient(qd, log["time_s"], axis=0, edge_order=2)
    tau = arm.inverse_dynamics(q, qd, qdd)
    return -(tau * qd).sum(axis=0) / (qd**2).sum(axis=0)  # least squares


if __name__ == "__main__":
    urdf, *logs = sys.argv[1:]
    treeline.load(urdf, functions=["inverse_dynamics"])  # compiled once: the processes find it
    bag = dask.bag.from_sequence(logs, npartitions=len(logs))
    friction = np.array(bag.map(sum_up, urdf).compute(scheduler="processes", num_workers=2))

    usual = np.median(friction, axis=0)
    print(len(logs), "logs: friction", np.round(usual, 2), "N m s/rad")
    for log, own in zip(logs, friction):
        if np.abs(own / usual - 1).max() > 0.1:
            print(f"{log}: {np.round(own, 2)}")
