"""What mypy has to refuse: each line, by the code behind it."""

import numpy as np
import puma_controlled
import ur10e

q = np.array(ur10e.home)
ur10e.gravity([0.0] * 6)  # call-overload
ur10e.gravity(q, q)  # call-overload
ur10e.inverse_dynamics(q, q)  # call-overload
ur10e.gravity(q, threads="2")  # call-overload
ur10e.forward_kinematics(q, out=q)  # arg-type
ur10e.nq = 7  # misc
ur10e.torque(q)  # attr-defined
puma_controlled.Controller().command("START")  # arg-type
puma_controlled.Controller().config.torques  # attr-defined
puma_controlled.Controller().config.torque = np.sin  # assignment
