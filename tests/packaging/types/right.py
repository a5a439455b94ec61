"""What a user writes: mypy --strict has nothing to say."""

import array

import humanoid24_floating
import humanoid_limited
import numpy as np
import puma_controlled
import ur10e
from numpy.typing import NDArray

q: NDArray[np.float64] = np.array(ur10e.home)
tau: NDArray[np.float64] = ur10e.inverse_dynamics(q, qd=np.zeros(ur10e.nv), qdd=np.zeros(ur10e.nv))
same: NDArray[np.float64] = ur10e.gravity(q, out=tau)
flat: array.array[float] = ur10e.gravity(memoryview(array.array("d", q.tolist())), out=array.array("d", [0.0] * 6))
inertias: NDArray[np.float64] = ur10e.mass_matrix(np.tile(q, (10, 1)), threads=4)
pose: ur10e.ForwardKinematics = ur10e.forward_kinematics(q)
first, *others = ur10e.forward_kinematics(q, out=pose)
inverse: NDArray[np.float64] = ur10e.lambda_(q)
single: NDArray[np.float32] = humanoid24_floating.mass_matrix(np.array(humanoid24_floating.home, np.float32))
names: tuple[str, ...] = ur10e.coordinate_joints
reach: float = ur10e.upper_limits[0] - ur10e.lower_limits[0]
release: str = ur10e.__version__
controller = puma_controlled.Controller()
controller.command(puma_controlled.Kind.MOVE_JOINTS, goal=[0.0] * 6, duration=2)
controller.config.joint_damping = np.ones(6)
torque: NDArray[np.float64] = controller.step(q, qd=q).tau
is_broken: bool = puma_controlled.Fault.STALE in controller.output.faults
limits = humanoid_limited.TorqueLimits()
limits.torque[7] /= 2
rest = np.zeros(humanoid_limited.nv)
cut: humanoid_limited.LimitedControlTorque = humanoid_limited.limited_control_torque(
    np.array(humanoid_limited.home), rest, rest, np.zeros(3), np.zeros(12), limits=limits, limited=humanoid_limited.LimitedTorque())
