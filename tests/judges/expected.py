"""What each function must give, from the figures of one judge: outputs by symbol, each with the size of its terms.

Judges give M, b + g, g, J, accelerations, poses, momenta and energies, and what else they have of their own. What no
judge computes as such follows here from its definition by dense linear algebra.
"""

import numpy as np

from conventions import Lacking, Undetermined
from robot_file import inertials_of, rotation_from_rpy
from rows import constraint_errors, held_bias, held_jacobian, held_shares, row_shares, rows_bias, rows_jacobian

# Of the largest force, where small ones are rounded.
FLOOR = 1e-5


def terms(*summands):
    size = sum(np.abs(s) for s in summands)
    return size + FLOOR * np.max(size, initial=1e-3)


def of_size(value):
    """Relative to the largest entry."""
    return np.full(np.shape(value), max(1e-3, np.max(np.abs(value), initial=0)))


def sized(**outputs):
    return {symbol: (np.asarray(value), of_size(value)) for symbol, value in outputs.items()}


class Algebra:
    """M, J and what is made of them, at one state."""

    def __init__(self, figures, case):
        self.M, self.h, self.g = figures.mass_matrix(), figures.nonlinear_effects(), figures.gravity()
        self.J, self.bias = rows_jacobian(figures, case.points), rows_bias(figures, case.points)
        self.J_ext = rows_jacobian(figures, case.external)
        self.M_inverse = np.linalg.inv(self.M)
        self.Lambda_inv = self.J @ self.M_inverse @ self.J.T

    @property
    def Lambda(self):
        return np.linalg.inv(self.Lambda_inv)

    @property
    def Jbar(self):
        return self.M_inverse @ self.J.T @ self.Lambda


def size_of_M(M):
    size = np.sqrt(np.abs(np.diag(M)))
    return np.outer(size, size) + FLOOR * np.max(np.abs(M))


def forward_kinematics(f, case, v):
    poses = [point.pose(f) for point in case.points]
    position = np.concatenate([p for _, p in poses])
    return {"position": (position, np.full(position.shape, max(1, np.max(np.abs(position))))),
            **sized(rotation=np.concatenate([R.reshape(-1) for R, _ in poses]))}


def inverse_dynamics(f, case, v):
    tau, M, h = f.inverse_dynamics() + case.dry_friction(v["qd"]), f.mass_matrix(), f.nonlinear_effects()
    J = rows_jacobian(f, case.external)
    applied = J.T @ v.get("f_ext", np.zeros(0))
    return {"tau": (tau - applied, terms(np.abs(M) @ np.abs(v["qdd"]), h, tau,
                                         np.abs(J.T) @ np.abs(v.get("f_ext", np.zeros(0)))))}


def nonlinear_effects(f, case, v):
    h = f.nonlinear_effects() + case.dry_friction(v["qd"])
    return {"h": (h, terms(h, f.gravity(), np.abs(f.mass_matrix()) @ np.abs(f.T.T @ f.s.drift)))}


def gravity(f, case, v):
    g = f.gravity()
    return {"g": (g, terms(g))}


def mass_matrix(f, case, v):
    M = f.mass_matrix()
    return {"M": (M, size_of_M(M))}


def forward_dynamics(f, case, v):
    """Accelerations count as the forces that they take: the judge's M times both."""
    J, M, h = rows_jacobian(f, case.external), f.mass_matrix(), f.nonlinear_effects()
    applied = v["tau"] - case.dry_friction(v["qd"]) + J.T @ v.get("f_ext", np.zeros(0))
    qdd = f.forward_dynamics(applied)
    return {"qdd": (qdd, terms(np.abs(M) @ np.abs(qdd), h, applied), M)}


def forward_dynamics_by_algebra(f, case, v):
    a = Algebra(f, case)
    applied = v["tau"] - case.dry_friction(v["qd"]) + a.J_ext.T @ v.get("f_ext", np.zeros(0))
    qdd = a.M_inverse @ (applied - a.h)
    return {"qdd": (qdd, terms(np.abs(a.M) @ np.abs(qdd), a.h, applied), a.M)}


def coriolis_matrix(f, case, v):
    """C qd = b and C + C^T = dM/dt."""
    b = f.nonlinear_effects() - f.gravity()
    found = [(lambda C: C @ v["qd"], b, terms(f.nonlinear_effects(), b))]
    try:
        rate = f.coriolis_symmetric_part()
        found.append((lambda C: C + C.T, rate, of_size(rate)))
    except Lacking:
        pass
    return {"C": found}


def kinetic_energy(f, case, v):
    return sized(energy=np.array([f.kinetic_energy()]))


def kinetic_energy_derivatives(f, case, v):
    by_q, by_qd = f.kinetic_energy_derivatives()
    return sized(dT_dq=by_q, dT_dqd=by_qd)


def parameters(f, case):
    """The ten parameters of each link with what is fixed to it, from the file's inertias."""
    inertials, listed = inertials_of(case.robot.text), []
    for link in case.parameter_links:
        R, p = f.pose("link " + link)
        whole, moment, inertia = 0.0, np.zeros(3), np.zeros((3, 3))
        for part in case.robot.fixed_to(link):
            body = inertials[part]
            R_part, p_part = f.pose("link " + part)
            turn = R.T @ R_part
            c = R.T @ (p_part - p) + turn @ body.center
            axes = turn @ rotation_from_rpy(body.rpy) @ body.axes
            inertia += axes @ np.diag(body.moments) @ axes.T + body.mass * (c @ c * np.eye(3) - np.outer(c, c))
            whole, moment = whole + body.mass, moment + body.mass * c
        order = [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)]
        listed.append([whole, *moment, *(inertia[at] for at in order)])
    return np.array(listed).reshape(-1)


def inverse_dynamics_regressor(f, case, v):
    """Y p, and Y itself where the judge has it."""
    p, tau = parameters(f, case), f.inverse_dynamics()
    found = [(lambda Y: Y @ p, tau, terms(np.abs(f.mass_matrix()) @ np.abs(v["qdd"]), f.nonlinear_effects(), tau))]
    try:
        Y = f.torque_regressor(case.parameter_links)
        found.append((lambda ours: ours, Y, of_size(Y)))
    except Lacking:
        pass
    return {"Y": found}


def energy_regressor(f, case, v):
    """T of E p, and both rows where the judge has them: what is fixed to the world has energy but no column."""
    p, energy = parameters(f, case), f.kinetic_energy()
    found = [(lambda E: (E @ p)[0], energy, of_size(energy))]
    try:
        E = f.energy_regressor(case.parameter_links)
        found.append((lambda ours: ours, E, np.maximum(1e-3, np.abs(E).max(axis=1, keepdims=True))))
    except Lacking:
        pass
    return {"E": found}


def wrenches(case, v):
    """External forces in own axes. Those in world axes are zero where derivatives are compared."""
    f_ext, found, at = v.get("f_ext", np.zeros(0)), {}, 0
    for point in case.external:
        if point.axes == "local":
            found[point.name] = f_ext[at:at + 6]
        at += 6
    return found


def inverse_dynamics_derivatives(f, case, v):
    by_q, by_qd, by_qdd = f.inverse_dynamics_derivatives(wrenches(case, v))
    return sized(dtau_dq=by_q, dtau_dqd=by_qd, dtau_dqdd=by_qdd)


def forward_dynamics_derivatives(f, case, v):
    """Accelerations count as the forces that they take. State.qdd is that of tau here."""
    by_q, by_qd, by_qdd = f.inverse_dynamics_derivatives(wrenches(case, v))
    M = f.mass_matrix()
    inverse = np.linalg.inv(M)
    return {"dqdd_dq": (-inverse @ by_q, of_size(by_q), M), "dqdd_dqd": (-inverse @ by_qd, of_size(by_qd), M),
            "dqdd_dtau": (inverse, of_size(np.eye(len(M))), M)}


def centroidal_momentum_derivatives(f, case, v):
    return sized(dh_dq=f.momentum_by_displacements(), dh_dqd=f.momentum_matrix())


def centroidal_momentum_rate_derivatives(f, case, v):
    by_q, by_qd, by_qdd = f.momentum_rate_derivatives()
    return sized(dhd_dq=by_q, dhd_dqd=by_qd, dhd_dqdd=by_qdd)


def subtree_masses_and_centers(f, case, v):
    mass, center = f.subtrees(case.parameter_links)
    return sized(mass=mass, center=center.reshape(-1))


def _stacked(points, parts, symbols):
    """Derivatives of all points, one below the other, by symbol."""
    return sized(**{symbol: np.vstack(blocks) for symbol, blocks in zip(symbols, zip(*map(parts, points)))})


def point_velocity_derivatives(f, case, v):
    return _stacked(case.points, lambda p: f.velocity_derivatives(p.name), ("dv_dq", "dv_dqd"))


def point_acceleration_derivatives(f, case, v):
    return _stacked(case.points, lambda p: f.acceleration_derivatives(p.name), ("da_dq", "da_dqd", "da_dqdd"))


def link_inverse_inertias(f, case, v):
    inverse, blocks = np.linalg.inv(f.mass_matrix()), []
    for link in case.parameter_links:
        J, R = f.jacobian("link " + link), f.pose("link " + link)[0]
        J = np.vstack([R.T @ J[:3], R.T @ J[3:]])
        blocks.append((J @ inverse @ J.T).reshape(-1))
    return sized(Omega=np.concatenate(blocks))


def contact_rows(f, case):
    return np.vstack([f.jacobian(contact.name)[:3] for contact in case.contacts])


def contact_motion(f, case, v):
    return sized(position=np.concatenate([f.pose(c.name)[1] for c in case.contacts]),
                 velocity=np.concatenate([f.velocity(c.name)[:3] for c in case.contacts]))


def contact_inverse_inertia(f, case, v):
    J = contact_rows(f, case)
    return sized(Lambda_c_inv=J @ np.linalg.solve(f.mass_matrix(), J.T))


def effective_mass(f, case, v):
    J = contact_rows(f, case)
    Lambda_inv = J @ np.linalg.solve(f.mass_matrix(), J.T)
    normals = v["normals"].reshape(-1, 3)
    inverse = np.array([n @ Lambda_inv[3 * i:3 * i + 3, 3 * i:3 * i + 3] @ n for i, n in enumerate(normals)])
    moved = inverse > 3e-3 * np.max(np.linalg.eigvalsh(Lambda_inv))
    if not np.any(moved):
        raise Undetermined("contacts that can hardly be moved")
    return {"mass": [(lambda mass: mass[moved], 1 / inverse[moved], 1 / inverse[moved])]}


def impulse_response(f, case, v):
    M, J = f.mass_matrix(), contact_rows(f, case)
    impulse = J.T @ v["impulse"]
    return {"dqd": (np.linalg.solve(M, impulse), terms(np.abs(J.T) @ np.abs(v["impulse"])), M)}


def task_force(a, case, v):
    """s^2 times the error of a task that is done to a share s is (1 - s^2) times its own inverse inertia times F."""
    s = row_shares(case.points, v.get("active_tasks"))
    owner = np.repeat(np.arange(len(case.points)), [len(point.rows) for point in case.points])
    own = np.where(owner[:, None] == owner, a.Lambda_inv, 0)
    weakened = s[:, None] * a.Lambda_inv * s + (1 - s * s) * own
    return s * np.linalg.solve(weakened, s * (v["xdd_cmd"] - a.bias - a.J @ v["qdd_0"]))


def control_torque(f, case, v):
    a = Algebra(f, case)
    F, posture = task_force(a, case, v), a.M @ v["qdd_0"]
    applied = a.J_ext.T @ v.get("f_ext", np.zeros(0))
    return {"tau": (a.J.T @ F + posture + a.h - applied, of_size(terms(np.abs(a.J.T) @ np.abs(F), posture, a.h)))}


def lambda_inverse(f, case, v):
    return sized(Lambda_inv=Algebra(f, case).Lambda_inv)


def operational(f, case, v):
    """Lambda, Jbar, N, mu and p by their symbols."""
    a = Algebra(f, case)
    Jbar, b = a.Jbar, a.h - a.g
    mu, p = Jbar.T @ b - a.Lambda @ a.bias, Jbar.T @ a.g
    return {**sized(Lambda=a.Lambda, Jbar=Jbar, N=np.eye(len(a.M)) - Jbar @ a.J),
            "mu": (mu, of_size(terms(np.abs(Jbar.T) @ np.abs(b), np.abs(a.Lambda) @ np.abs(a.bias)))),
            "p": (p, of_size(np.abs(Jbar.T) @ np.abs(a.g)))}


def damped_control_torque(f, case, v):
    """Delta is that of damped_solve.h: what feels heavier than `heaviest` yields."""
    a = Algebra(f, case)
    S = np.sqrt(v["heaviest"])
    shares, axes = np.linalg.eigh(S[:, None] * a.Lambda_inv * S)
    eased = shares + np.where(shares < 1, (1 - np.minimum(shares, 1)) ** 3, 0)
    wanted = v["xdd_cmd"] - a.bias - a.J @ v["qdd_0"]
    F = S * (axes @ ((axes.T @ (S * wanted)) / eased))
    applied = a.J_ext.T @ v.get("f_ext", np.zeros(0))
    return {"tau": (a.J.T @ F + a.M @ v["qdd_0"] + a.h - applied,
                    of_size(terms(np.abs(a.J.T) @ np.abs(F), a.M @ v["qdd_0"], a.h)))}


def constrained_forward_dynamics(f, case, v):
    """The saddle point of M and the held rows, and where they are at rest what the judge has of its own."""
    a = Algebra(f, case)
    J, bias = held_jacobian(f, case), held_bias(f, case)
    drift = np.concatenate([v["drift"], constraint_errors(f, case, v["q"])])
    wanted = -bias - v["stabilisation"][0] * (J @ v["qd"]) - v["stabilisation"][1] * drift
    free = a.M_inverse @ (v["tau"] + a.J_ext.T @ v.get("f_ext", np.zeros(0)) - a.h)
    held_inverse = J @ a.M_inverse @ J.T
    moved = np.linalg.eigvalsh(held_inverse)
    if moved[0] < 1e-10 * max(moved[-1], np.max(np.diag(a.M_inverse)) * 1e-6):
        raise Undetermined("held rows that depend on each other, or that nothing moves")
    # Of a row held to a share w: w times what it lacks is (1 - w) times its own inverse inertia times its force.
    w = held_shares(case, v.get("active"))
    weakened = w[:, None] * held_inverse + np.diag((1 - w) * np.diag(held_inverse))
    forces = np.linalg.solve(weakened, w * (wanted - J @ free))
    qdd = free + a.M_inverse @ (J.T @ forces)
    size = of_size(terms(np.abs(a.M) @ np.abs(qdd), a.h, v["tau"], np.abs(J.T) @ np.abs(forces)))
    weighed = [(lambda ours: a.M @ ours, a.M @ qdd, size)]
    if np.all(w == 1) and not np.any(v["stabilisation"]) and np.max(np.abs(J @ v["qd"]), initial=0) < 1e-9:
        try:
            own = f.constrained_acceleration(case, v["tau"] + a.J_ext.T @ v.get("f_ext", np.zeros(0)))
            weighed.append((lambda ours: a.M @ ours, a.M @ own, size))
        except Lacking:
            pass
    return {"qdd": weighed, "f": (forces, np.full(len(forces), np.max(size)))}


def supported_control_torque(f, case, v):
    """Of (qdd, forces) that motors and supports permit: nearest to qdd_0 by M, then to f_wanted. Of what comes and goes
    the sets alone have an answer."""
    a, n = Algebra(f, case), len(v["qdd_0"])
    J, bias = held_jacobian(f, case), held_bias(f, case)
    w = held_shares(case, v.get("active"))
    s = row_shares(case.points, v.get("active_tasks"))
    if not np.all(np.isin(np.concatenate([w, s]), (0, 1))):
        raise Undetermined("what is held or done in part")
    is_held, done = w == 1, s == 1
    J, bias = J[is_held], bias[is_held]
    passive = case.passive_velocities()
    h = a.h - a.J_ext.T @ v.get("f_ext", np.zeros(0))
    A = np.block([[J, np.zeros((len(J), len(J)))], [a.J[done], np.zeros((np.sum(done), len(J)))],
                  [a.M[passive], -J.T[passive]]])
    b = np.concatenate([-bias, (v["xdd_cmd"] - a.bias)[done], -h[passive]])
    # A moment counts as a force at 0.1 m.
    weight = np.array([1.0 if index < 3 else 10.0 for held in case.held + case.loops for index in held.indices]
                      + [1.0 for _ in case.couplings])[is_held]
    root = np.linalg.cholesky(a.M).T
    x = _nearest(A, b, [(np.hstack([root, np.zeros((n, len(J)))]), root @ v["qdd_0"]),
                        (np.hstack([np.zeros((len(J), n)), np.diag(weight)]), weight * v["f_wanted"][is_held])])
    tau = a.M @ x[:n] + h - J.T @ x[n:]
    size = of_size(terms(a.M @ x[:n], h, np.abs(J.T) @ np.abs(x[n:])))
    forces = np.zeros(len(w))
    forces[is_held] = x[n:]
    return {"tau": (tau, size), "f": (forces, np.full(len(w), np.max(size)))}


def _nearest(A, b, levels):
    """x with A x = b that is nearest in the first level, and of these in the next."""
    scale = np.linalg.norm(A, axis=1)
    if np.any(scale < 1e-9 * np.max(scale, initial=0)):
        raise Undetermined("rows that nothing moves")
    U, s, V = np.linalg.svd(A / scale[:, None])
    if len(A) > A.shape[1] or np.min(s, initial=1) < 1e-3 * np.max(s, initial=1):
        raise Undetermined("tasks and supports at a singularity")
    x, free = V[:len(s)].T @ ((U.T @ (b / scale)) / s), V[len(s):].T
    for matrix, goal in levels:
        if free.shape[1] == 0:
            break
        U, s, V = np.linalg.svd(matrix @ free)
        rank = int(np.sum(s > 1e-9 * s[0])) if len(s) and s[0] > 0 else 0
        x = x + free @ (V[:rank].T @ ((U[:, :rank].T @ (goal - matrix @ x)) / s[:rank]))
        free = free @ V[rank:].T
    return x


BY_NAME = (
    forward_kinematics, inverse_dynamics, gravity, nonlinear_effects, mass_matrix, forward_dynamics, lambda_inverse,
    control_torque, contact_motion, contact_inverse_inertia, effective_mass, impulse_response,
    constrained_forward_dynamics, supported_control_torque, link_inverse_inertias, inverse_dynamics_derivatives,
    forward_dynamics_derivatives, coriolis_matrix, kinetic_energy, kinetic_energy_derivatives,
    inverse_dynamics_regressor, energy_regressor, centroidal_momentum_derivatives,
    centroidal_momentum_rate_derivatives, subtree_masses_and_centers, point_velocity_derivatives,
    point_acceleration_derivatives, damped_control_torque)

EXPECTED = {
    **{function.__name__: function for function in BY_NAME},
    **dict.fromkeys(("lambda", "dynamically_consistent_inverse", "null_space_projector", "operational_bias_force",
                     "operational_gravity"), operational),
    "jacobian": lambda f, case, v: sized(J=rows_jacobian(f, case.points)),
    "bias_acceleration": lambda f, case, v: sized(bias=rows_bias(f, case.points)),
    "constraint_jacobian": lambda f, case, v: sized(J_s=held_jacobian(f, case)),
    "constraint_errors": lambda f, case, v: {"error": (constraint_errors(f, case, v["q"]), 1.0)},
    "center_of_mass": lambda f, case, v: sized(com=f.center_of_mass()),
    "center_of_mass_jacobian": lambda f, case, v: sized(J_com=f.center_of_mass_jacobian()),
    "potential_energy": lambda f, case, v: sized(energy=np.array([f.potential_energy()])),
    "centroidal_momentum_matrix": lambda f, case, v: sized(A_G=f.momentum_matrix()),
    "centroidal_momentum": lambda f, case, v: sized(h_G=f.momentum_matrix() @ v["qd"]),
    "centroidal_bias": lambda f, case, v: sized(bias=f.momentum_bias()),
    "center_of_mass_bias_acceleration": lambda f, case, v: sized(bias=f.center_of_mass_bias()),
    "point_velocity": lambda f, case, v: sized(velocity=np.concatenate([f.velocity(p.name) for p in case.points])),
    "point_acceleration": lambda f, case, v: sized(
        acceleration=np.concatenate([f.acceleration(p.name, True) for p in case.points])),
}
