"""An environment of Gymnasium: a leg on a rail is to jump as high as it can. Gymnasium checks it; then a hand-made policy
jumps once.
"""

from pathlib import Path

import gymnasium
import numpy as np
from gymnasium.spaces import Box
from gymnasium.utils.env_checker import check_env

import treeline

FOLDER = Path(__file__).parent
DT, STEPS = 0.02, 10  # s of an action, and steps of the simulation in it


class Hopper(gymnasium.Env):
    """The action has a share of the largest torque of hip and knee; the observation q, qd and whether the foot touches."""

    def __init__(self):
        self.robot = treeline.Model(FOLDER / "hopper.urdf", FOLDER / "scene.yaml")
        self.torque = np.array(self.robot.effort_limits[1:])
        self.action_space = Box(-1, 1, (2,))
        self.observation_space = Box(-100, 100, (7,), np.float64)

    def observe(self, contacts):
        return np.concatenate([self.q, self.qd, contacts]).clip(-100, 100)

    def reset(self, *, seed=None, options=None):
        super().reset(seed=seed)
        bend = self.np_random.uniform(0.5, 0.7)
        self.q, self.qd = np.array([0.02 + 0.4 * np.cos(bend), bend, -2 * bend]), np.zeros(3)  # the foot on the ground
        return self.observe(np.zeros(1)), {}

    def step(self, action):
        tau = np.concatenate([[0], self.torque * np.clip(action, -1, 1)])
        moved = self.robot.step(self.q, self.qd, tau, seconds=DT / STEPS, steps=STEPS, stops=True)
        self.q, self.qd = moved.q, moved.qd
        reward = self.q[0] - 0.01 * np.square(action).sum()
        return self.observe(moved.contacts), float(reward), False, False, {"force": moved.force}

    def close(self):
        self.robot.close()


gymnasium.register("Hopper-on-rail-v0", Hopper, max_episode_steps=50)

if __name__ == "__main__":
    env = gymnasium.make("Hopper-on-rail-v0")
    check_env(env.unwrapped)
    print("Gymnasium has no complaint")
    observation, _ = env.reset(seed=1)
    way, ended = [], False
    while not ended:
        t = DT * len(way)
        way.append([t, *observation[:3]])
        bend = 1.0 if t < 0.4 else 0.2 if t < 0.5 else 0.7  # crouches, pushes, lands
        torque = 10 * (np.array([bend, -2 * bend]) - observation[1:3]) - 0.8 * observation[4:6]
        observation, reward, terminated, truncated, _ = env.step((torque / 6).astype(np.float32))
        ended = terminated or truncated
    top = max(way, key=lambda row: row[1])
    print(f"jumped to {top[1]:.2f} m at {top[0]:.1f} s")
    np.savetxt("jump.csv", way, "%.9f", ",", header="time_s,q0,q1,q2", comments="")
