"""Swings a UR10e to a goal in a second by iterative LQR: each iteration linearises the motion by the derivatives of
forward dynamics, which one call computes for all steps.
"""

from pathlib import Path

import numpy as np

import treeline

urdf = Path(__file__).parents[2] / "robots/ur10e/ur10e.urdf"
arm = treeline.load(urdf, functions=["forward_dynamics", "forward_dynamics_derivatives", "gravity", "mass_matrix"])
n, steps, dt = arm.nv, 50, 0.02
goal = np.concatenate([np.array([0.3, -0.8, 0.6, 0.2, 0.4, 0.1]), np.zeros(n)])  # and at rest
start = np.concatenate([[0, -1, 1, 0, 0.5, 0], np.zeros(n)])
M = arm.mass_matrix(start[:n])
R = 1e-5 * np.linalg.inv(M)  # cost of torques: a joint that moves little takes little
end = np.diag([100.0] * n + [10.0] * n)  # cost of what lacks at the end
np.seterr(over="ignore", invalid="ignore")  # of motions that are tried


def roll(x, taus, feed=None, gains=None, xs=None, share=1.0):
    """The motion by these torques, corrected by a share of the step that was found; and its cost."""
    path, used = [x], []
    for k, tau in enumerate(taus):
        if feed is not None:
            tau = tau + share * feed[k] + gains[k] @ (path[k] - xs[k])
        qd = path[k][n:] + dt * arm.forward_dynamics(path[k][:n], path[k][n:], tau)
        path.append(np.concatenate([path[k][:n] + dt * qd, qd]))
        used.append(tau)
    path, used = np.array(path), np.array(used)
    return path, used, np.einsum("ki,ij,kj", used, R, used) + (path[-1] - goal) @ end @ (path[-1] - goal)


xs, taus, cost = roll(start, np.tile(arm.gravity(start[:n]), (steps, 1)))
print(f"cost {cost:.4f}")
for _ in range(30):
    slope = arm.forward_dynamics_derivatives(xs[:-1, :n], xs[:-1, n:], taus, threads=4)
    by_qd = np.concatenate([slope[0], slope[1] + np.eye(n) / dt], axis=2) * dt  # of the next qd
    A = np.concatenate([np.eye(n, 2 * n) + dt * by_qd, by_qd], axis=1)
    B = np.concatenate([dt * dt * slope[2], dt * slope[2]], axis=1)
    v, V, feed, gains = end @ (xs[-1] - goal), end, [], []
    for k in reversed(range(steps)):
        H = R + B[k].T @ V @ B[k]
        feed.append(-np.linalg.solve(H, R @ taus[k] + B[k].T @ v))
        gains.append(-np.linalg.solve(H, B[k].T @ V @ A[k]))
        v = A[k].T @ v + A[k].T @ V @ B[k] @ feed[-1]
        V = A[k].T @ V @ (A[k] + B[k] @ gains[-1])
    tries = [roll(start, taus, feed[::-1], gains[::-1], xs, share) for share in 0.5 ** np.arange(8)]
    best = min(tries, key=lambda tried: np.nan_to_num(tried[2], nan=np.inf))
    if not best[2] < cost * (1 - 1e-6):
        break
    xs, taus, cost = best
    print(f"cost {cost:.4f}")
lacks = np.abs(xs[-1] - goal)
print(f"{lacks[:n].max():.4f} rad from the goal at {lacks[n:].max():.4f} rad/s, {np.abs(taus).max():.0f} N m at most")
