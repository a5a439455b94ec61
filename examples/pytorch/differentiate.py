"""Forward and inverse dynamics of a UR10e as functions of PyTorch, whose gradients are emitted code: PyTorch checks them,
and finds torques that swing the arm to a goal.
"""

from pathlib import Path

import numpy as np
import torch
from torch.autograd.function import once_differentiable

import treeline

urdf = Path(__file__).parents[2] / "robots/ur10e/ur10e.urdf"
arm = treeline.load(urdf, functions=["forward_dynamics", "forward_dynamics_derivatives", "inverse_dynamics",
                                     "inverse_dynamics_derivatives", "gravity", "mass_matrix"])


class Dynamics(torch.autograd.Function):
    """A function of three vectors, or of N of each, and its derivatives by them."""

    @staticmethod
    def forward(context, function, derivatives, *arguments):
        context.derivatives = derivatives
        context.save_for_backward(*arguments)
        return torch.from_numpy(function(*(each.detach().numpy() for each in arguments)))

    @staticmethod
    @once_differentiable
    def backward(context, gradient):
        slopes = context.derivatives(*(each.detach().numpy() for each in context.saved_tensors))
        return None, None, *(torch.einsum("...i,...ij->...j", gradient, torch.from_numpy(each)) for each in slopes)


def forward_dynamics(q, qd, tau):
    return Dynamics.apply(arm.forward_dynamics, arm.forward_dynamics_derivatives, q, qd, tau)


def inverse_dynamics(q, qd, qdd):
    return Dynamics.apply(arm.inverse_dynamics, arm.inverse_dynamics_derivatives, q, qd, qdd)


torch.manual_seed(1)
states = [torch.randn(5, arm.nv, dtype=torch.double, requires_grad=True) for _ in range(3)]
print("forward dynamics:", torch.autograd.gradcheck(forward_dynamics, states))
print("inverse dynamics:", torch.autograd.gradcheck(inverse_dynamics, states))

# Torques for half a second, by descent through the motion that they make.
steps, dt = 50, 0.01
start = torch.tensor([0, -1, 1, 0, 0.5, 0], dtype=torch.double)
goal = torch.tensor([0.3, -0.8, 0.6, 0.2, 0.4, 0.1], dtype=torch.double)
weight = torch.from_numpy(arm.gravity(start.numpy()))
inertia = torch.from_numpy(arm.mass_matrix(start.numpy()))
pushes = torch.zeros(steps, arm.nv, dtype=torch.double, requires_grad=True)  # rad/s^2 where the arm starts
descent = torch.optim.LBFGS([pushes], max_iter=40, line_search_fn="strong_wolfe")


def roll():
    """The way to where the torques lead, and what that lacks of the goal, at rest."""
    q, qd, way = start, torch.zeros(arm.nv, dtype=torch.double), [start]
    for push in pushes:
        qd = qd + dt * forward_dynamics(q, qd, weight + inertia @ push)
        q = q + dt * qd
        way.append(q)
    return way, torch.square(q - goal).sum() + 0.01 * torch.square(qd).sum()


def learn():
    descent.zero_grad()
    _, cost = roll()
    cost.backward()
    return cost


before = descent.step(learn)
way, cost = roll()
print(f"cost {before:.3f}, after descent {cost:.3f}")
rows = [[dt * k, *q.tolist()] for k, q in enumerate(way)]
np.savetxt("swing.csv", rows, "%.9f", ",", header="time_s," + ",".join(f"q{i}" for i in range(arm.nv)), comments="")
