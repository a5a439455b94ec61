"""Compares impulses at contacts with those of Pinocchio's solvers, ADMM and projected Gauss-Seidel.

Usage: contacts.py PROGRAM PROBLEMS [--table]. PROGRAM prints problems and its own impulses as JSON, one a line. Residuals
are computed here, by the criteria of Le Lidec et al., arXiv 2304.06372. --table prints time and residual of each solver.

Would catch: `converged` beside a law that does not hold, and fewer problems solved than by Pinocchio, of any kind.
"""

import json
import statistics
import subprocess
import sys

import numpy as np
import pinocchio as pin

SOLVED = 1e-9  # a residual of which Pinocchio's impulses count as a solution
EXACT = 1e-10  # what ContactSolver promises


def frames(normals):
    """Rotations whose columns are two directions across each normal, and the normal."""
    for n in normals:
        across = np.eye(3)[np.argmin(abs(n))]
        first = np.cross(across, n)
        first /= np.linalg.norm(first)
        yield np.column_stack([first, np.cross(n, first), n])


class Problem:
    """Of contacts in their own axes, the normal last."""

    def __init__(self, line):
        told = json.loads(line)
        self.kind, self.count = told["kind"], told["contacts"]
        self.frictions = np.array(told["frictions"])
        turn = np.zeros((3 * self.count, 3 * self.count))
        for i, R in enumerate(frames(np.reshape(told["normals"], (-1, 3)))):
            turn[3 * i : 3 * i + 3, 3 * i : 3 * i + 3] = R
        self.A = turn.T @ np.reshape(told["A"], turn.shape) @ turn
        self.A = (self.A + self.A.T) / 2
        self.v = turn.T @ told["v"]
        self.own = (turn.T @ told["y"], told["microseconds"], told["converged"])

    def residual(self, y):
        """The largest violation of the cone of impulses, of its dual with De Saxce's term, and of complementarity."""
        largest = max(1e-300, abs(y).max())
        speed = (abs(self.v) + abs(self.A) @ abs(y)).max()
        worst = 0.0
        for own, u, friction in zip(y.reshape(-1, 3), (self.v + self.A @ y).reshape(-1, 3), self.frictions):
            pushed, slid = np.linalg.norm(own[:2]), np.linalg.norm(u[:2])
            work = own @ u + friction * own[2] * slid
            if not np.isfinite(work):
                return np.inf
            worst = max(worst, (pushed - friction * own[2]) / largest, -own[2] / largest, -u[2] / speed,
                        abs(work) / (largest * speed))
        return worst

    def models(self):
        models, datas = pin.StdVec_ConstraintModel(), pin.StdVec_ConstraintData()
        robot = pin.buildSampleModelManipulator()
        for friction in self.frictions:
            contact = pin.PointContactConstraintModel(robot, 1)
            contact.setFriction(float(friction))
            models.append(pin.ConstraintModel(contact))
            datas.append(models[len(models) - 1].createData())
        return models, datas

    def solve(self, solver, settings, result):
        """Impulses of a solver of Pinocchio's, with as many iterations as bring most to rounding, and microseconds."""
        settings.absolute_feasibility_tol = settings.absolute_complementarity_tol = 1e-11
        settings.relative_feasibility_tol = settings.relative_complementarity_tol = 1e-14
        settings.max_iterations = 5000
        settings.measure_timings = True
        models, datas = self.models()
        solver.solve(pin.DelassusOperatorDense(self.A), self.v, models, datas, settings, result)
        return result.retrieveConstraintImpulses(), solver.getElapsedTime()


def answers(problem):
    """Name, impulses and microseconds of each solver."""
    yield ("Treeline", *problem.own[:2])
    size = 3 * problem.count
    yield ("ADMM", *problem.solve(pin.ADMMConstraintSolver(size), pin.ADMMSolverSettings(), pin.ADMMSolverResult()))
    yield ("PGS", *problem.solve(pin.PGSConstraintSolver(size), pin.PGSSolverSettings(), pin.PGSSolverResult()))


def print_table(rows):
    print(f"{'problems':22}{'solver':10}{'us: median':>12}{'worst':>10}{'residual: median':>18}{'worst':>10}{'> 1e-9':>9}")
    for (kind, count, name), found in rows.items():
        times, residuals = zip(*found)
        unsolved = sum(residual > SOLVED for residual in residuals)
        print(f"{kind + ', ' + str(count):22}{name:10}{statistics.median(times):12.1f}{max(times):10.1f}"
              f"{statistics.median(residuals):18.1e}{max(residuals):10.1e}{unsolved:4} of {len(found)}")


def main():
    program, problems = sys.argv[1:3]
    lines = subprocess.run([program, problems], check=True, capture_output=True, text=True).stdout
    rows, failures = {}, []
    for number, line in enumerate(lines.splitlines()):
        problem = Problem(line)
        converged = problem.own[2]
        for name, y, microseconds in answers(problem):
            with np.errstate(over="ignore", invalid="ignore"):
                residual = problem.residual(y)
            rows.setdefault((problem.kind, problem.count, name), []).append((microseconds, residual))
            if name == "Treeline" and converged and residual > EXACT:
                failures.append(f"problem {number}: converged, and a residual of {residual:.1e}")
    if "--table" in sys.argv:
        print_table(rows)
    solved = {key: sum(residual < SOLVED for _, residual in found) for key, found in rows.items()}
    for (kind, count, name), many in solved.items():
        if many > solved[kind, count, "Treeline"]:
            failures.append(f"{kind}, {count} contacts: {name} solves {many}, Treeline {solved[kind, count, 'Treeline']}")
    for name in ("Treeline", "ADMM", "PGS"):
        print(f"{name}: {sum(many for key, many in solved.items() if key[2] == name)} of {number + 1} solved")
    print(*failures, sep="\n")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
