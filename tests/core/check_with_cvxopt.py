"""Compares solutions of quadratic programs with cvxopt's, an interior-point method.

Usage: check_with_cvxopt.py PROGRAM, which prints a program and its solution as JSON a line.
Exit status 1 where a cost or a point differs.
"""

import json
import math
import subprocess
import sys

from cvxopt import matrix, solvers

solvers.options.update(show_progress=False, abstol=1e-12, reltol=1e-12, feastol=1e-12)


def by_columns(rows, width):
    return matrix([[row[k] for row in rows] for k in range(width)])


def one_sided(program):
    """Rows G x <= h and E x = e."""
    n, m = program["n"], program["m"]
    unit = [[1.0 if i == k else 0.0 for k in range(n)] for i in range(n)]
    rows = unit + [program["A"][i * n : (i + 1) * n] for i in range(m)]
    lower = program["lowest"] + program["lower"]
    upper = program["highest"] + program["upper"]
    G, h, E, e = [], [], [], []
    for row, low, high in zip(rows, lower, upper):
        if low == high:
            E.append(row)
            e.append(low)
            continue
        if math.isfinite(high):
            G.append(row)
            h.append(high)
        if math.isfinite(low):
            G.append([-entry for entry in row])
            h.append(-low)
    return G, h, E, e


def solve(program):
    n = program["n"]
    H = matrix(program["H"], (n, n))
    G, h, E, e = one_sided(program)
    equations = (by_columns(E, n), matrix(e)) if E else ()
    return solvers.qp(H, matrix(program["g"]), by_columns(G, n), matrix(h), *equations)


def main():
    lines = subprocess.run(sys.argv[1:], check=True, capture_output=True, text=True).stdout
    worst, compared = 0.0, 0
    for number, line in enumerate(lines.splitlines()):
        program = json.loads(line)
        try:
            solution = solve(program)
        except ValueError:
            continue  # dependent equations, which cvxopt does not take
        if solution["status"] != "optimal":
            continue  # nor rows that leave no inner point
        size = max(abs(entry) for entry in solution["x"])
        off = max(abs(a - b) for a, b in zip(solution["x"], program["x"])) / size
        compared += 1
        worst = max(worst, off)
        if off > 1e-5:  # of an interior point at the tolerances above, where rows are degenerate
            print(f"program {number}: {off:.1e} from cvxopt's point")
            return 1
    print(f"{compared} programs, at most {worst:.1e} from cvxopt's points")
    return 0 if compared > 40 else 1


if __name__ == "__main__":
    sys.exit(main())
