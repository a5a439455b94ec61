"""A control loop of one's own, which the page of `treeline drive` shows, leads and stops."""

import os
import sys
import time
from pathlib import Path

import numpy as np

import treeline

arm = treeline.load(Path(__file__).parents[2] / "robots/ur10e/ur10e.urdf")
secret = os.environ.get("TREELINE_ROBOT_SECRET", "")
q, qd, period = np.array([0, -0.9, 1.5, -0.6, 1.2, 0]), np.zeros(6), 5e-3  # s
with treeline.Show(nq=6, nv=6, secret=secret) as page:
    while True:
        was_enabled = page.enabled
        if page.receive():
            qdd = 225 * (np.array(page.q) - q) + 30 * (np.array(page.qd) - qd)
        else:
            qdd = -20 * qd
        tau = arm.inverse_dynamics(q, qd, qdd)
        page.send(q, qd, tau, power=tau @ qd)
        if was_enabled and not page.enabled:
            print(f"stopped: elbow at {q[2]:.2f} rad", file=sys.stderr)
        # Your motors and encoders take the place of this.
        qd = qd + period * arm.forward_dynamics(q, qd, tau)
        q = q + period * qd
        time.sleep(period)
