// The torque of a hopper on its sole, judged by programs that share nothing with its law: the
// motion and the forces that it causes are solved from M, h and J, dJ/dt is a difference of J along
// the motion. Would catch: torque without a motor, forces that are not those that act, a sole that
// accelerates, and a motion that is not the nearest one to what is wanted.
#include <cmath>
#include <cstdio>
#include <utility>

#include "hopper.hpp"

constexpr int nv = hopper::kVelocities, nq = hopper::kCoordinates, rows = 6, size = nv + rows;

/// Gauss's elimination with pivots; b becomes the solution.
template <int n>
void solve(double (&A)[n][n], double (&b)[n]) {
  for (int j = 0; j < n; ++j) {
    int pivot = j;
    for (int i = j; i < n; ++i) pivot = std::fabs(A[i][j]) > std::fabs(A[pivot][j]) ? i : pivot;
    std::swap(A[j], A[pivot]);
    std::swap(b[j], b[pivot]);
    for (int i = 0; i < n; ++i) {
      if (i == j) continue;
      const double factor = A[i][j] / A[j][j];
      for (int k = j; k < n; ++k) A[i][k] -= factor * A[j][k];
      b[i] -= factor * b[j];
    }
  }
  for (int j = 0; j < n; ++j) b[j] /= A[j][j];
}

/// q after a short time at qd: the base's velocities are in its own axes.
void move(const double (&q)[nq], const double (&qd)[nv], double time, double (&to)[nq]) {
  const double x = q[3], y = q[4], z = q[5], w = q[6];
  const double R[3][3] = {{1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)},
                          {2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)},
                          {2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)}};
  for (int i = 0; i < 3; ++i) {
    to[i] = q[i];
    for (int k = 0; k < 3; ++k) to[i] += time * R[i][k] * qd[k];
  }
  const double a = qd[3] / 2, b = qd[4] / 2, c = qd[5] / 2;
  to[3] = x + time * (w * a + y * c - z * b);
  to[4] = y + time * (w * b + z * a - x * c);
  to[5] = z + time * (w * c + x * b - y * a);
  to[6] = w - time * (x * a + y * b + z * c);
  to[7] = q[7] + time * qd[6];
}

/// The motion n that the sole leaves free: J n = 0 with the knee at 1.
void find_free_motion(const double (&J)[rows * nv], double (&n)[nv]) {
  double J_base[rows][rows], n_base[rows];
  for (int r = 0; r < rows; ++r) {
    for (int k = 0; k < rows; ++k) J_base[r][k] = J[r * nv + k];
    n_base[r] = -J[r * nv + 6];
  }
  solve(J_base, n_base);
  for (int k = 0; k < rows; ++k) n[k] = n_base[k];
  n[6] = 1;
}

int main() {
  const double q[nq] = {0.3, -0.2, 0.5, 0.1, -0.3, 0.2, std::sqrt(0.86), 0.4};
  const double qd[nv] = {0.7, -0.4, 0.2, 1.1, -0.6, 0.9, -1.3};
  const double wanted[nv] = {1, -2, 3, 2, 4, -1, 5}, f_wanted[rows] = {1, 2, 3, 4, 5, 6};
  const double none[nv] = {};
  double tau[nv], f[rows], M[nv * nv], h[nv], J[rows * nv], before[rows * nv], after[rows * nv];
  hopper::supported_control_torque(q, qd, wanted, f_wanted, tau, f);
  hopper::mass_matrix(q, M);
  hopper::inverse_dynamics(q, qd, none, h);
  hopper::constraint_jacobian(q, J);
  constexpr double step = 1e-5;
  double q_before[nq], q_after[nq];
  move(q, qd, -step, q_before);
  move(q, qd, step, q_after);
  hopper::constraint_jacobian(q_before, before);
  hopper::constraint_jacobian(q_after, after);

  // M qdd - J^T f = tau - h, J qdd = -dJ/dt qd.
  double A[size][size] = {}, motion[size] = {};
  for (int i = 0; i < nv; ++i) {
    for (int k = 0; k < nv; ++k) A[i][k] = M[i * nv + k];
    for (int r = 0; r < rows; ++r) A[i][nv + r] = -J[r * nv + i];
    motion[i] = tau[i] - h[i];
  }
  for (int r = 0; r < rows; ++r) {
    for (int k = 0; k < nv; ++k) {
      A[nv + r][k] = J[r * nv + k];
      motion[nv + r] -= (after[r * nv + k] - before[r * nv + k]) / (2 * step) * qd[k];
    }
  }
  solve(A, motion);

  double n[nv], nearest = 0, scale = 0;
  find_free_motion(J, n);
  for (int i = 0; i < nv; ++i) {
    for (int k = 0; k < nv; ++k) {
      nearest += n[i] * M[i * nv + k] * (motion[k] - wanted[k]);
      scale += std::fabs(n[i] * M[i * nv + k] * (motion[k] - wanted[k]));
    }
  }
  // Central differences err by the square of the step, times third derivatives of order 10.
  constexpr double kDifferences = 1e-7;
  bool right = std::fabs(nearest) <= kDifferences * scale && std::fabs(tau[6]) > 1e-3;
  for (int i = 0; i < 6; ++i) right = right && tau[i] == 0;
  for (int r = 0; r < rows; ++r)
    right = right && std::fabs(motion[nv + r] - f[r]) <= kDifferences * 100;
  std::printf("n^T M (qdd - qdd_0) = %g of %g, torque of the knee %g N m\n", nearest, scale,
              tau[6]);
  for (int r = 0; r < rows; ++r)
    std::printf("force %g, which acts with %g\n", f[r], motion[nv + r]);
  return right ? 0 : 1;
}
