#include <numeric>
#include <vector>

#include "interpreter/prioritized_control_torque.hpp"
#include "oracle/equations.hpp"

namespace treeline {
namespace {

namespace ip = interpreter;
using At = EquationAt;

Vector50 bias(const At& at) {
  return differentiate_rows(at, [&](const Vector50& q) {
    return ip::jacobian<Digits50>(at.model, at.subject.points, q);
  });
}

Digits50 size_of_accelerations(const At& at) {
  return at.rate * at.rate;
}

/// mu, from Lambda^-1 mu = J M^-1 b - Jd qd.
EquationSides bias_force(const At& at) {
  const Matrix50 Lambda_inverse = ip::lambda_inverse<Digits50>(at.model, at.subject.points, at.q);
  if (!are_independent(Lambda_inverse)) return {};
  const Vector50 b =
      ip::nonlinear_effects<Digits50>(ip::without_gravity<Digits50>(at.model), at.q, at.qd);
  const Vector50 qdd = ip::mass_matrix<Digits50>(at.model, at.q).ldlt().solve(b);
  const Vector50 driven = ip::jacobian<Digits50>(at.model, at.subject.points, at.q) * qdd;
  const Vector50 moved = bias(at);
  return {Lambda_inverse * at.value, driven - moved,
          size_of_accelerations(at) + largest_of(driven) + largest_of(moved)};
}

/// A row yields to those before it by the eighth power of border over inverse inertia: where this
/// is so many borders it does not, to all digits of differences.
constexpr int kBordersInFull = 1000;

/// Rows of a task in strict priority that are done in full: all before the first that yields to
/// those above it.
std::vector<Eigen::Index> rows_in_full(const At& at, Matrix50 left) {
  const auto& points = at.subject.points;
  const Vector50 borders = ip::relaxation_borders<Digits50>(points, Vector50(left.diagonal()));
  std::vector<Eigen::Index> rows;
  for (const int row : ip::rows_by_priority(points)) {
    const Digits50 mobility = left(row, row);
    if (mobility <= kBordersInFull * borders(row)) break;
    left -= (left.col(row) * left.row(row) / mobility).eval();
    rows.push_back(row);
  }
  return rows;
}

/// The rows of tasks that are done whole accelerate as they are told to, by the torque that is the
/// value, beside 1 m/s^2 or 1 rad/s^2: at rest nothing is left of what holds the weight.
EquationSides commanded(const At& at) {
  const auto& points = at.subject.points;
  const auto shares = ip::task_shares<Digits50>(points);
  const Matrix50 A =
      ip::with_shares<Digits50>(ip::lambda_inverse<Digits50>(at.model, points, at.q), shares);
  std::vector<Eigen::Index> rows;
  if (ip::has_priorities(points)) {
    rows = rows_in_full(at, A);
  } else if (are_independent(A)) {
    rows.resize(static_cast<std::size_t>(A.rows()));
    std::iota(rows.begin(), rows.end(), 0);
  }
  std::erase_if(rows, [&](Eigen::Index row) { return shares.s(row) != Digits50(1); });
  const Vector50 qdd = ip::forward_dynamics<Digits50>(at.model, at.q, at.qd, at.value,
                                                      at.subject.external, at.f_ext);
  const Vector50 moved = ip::jacobian<Digits50>(at.model, points, at.q) * qdd + bias(at);
  return {at.xdd_cmd(rows), moved(rows), Digits50(1) + size_of_accelerations(at) + largest_of(qdd)};
}

constexpr auto kEquationsOfPoints = std::to_array<Equation>({
    {Function::jacobian, "J qd = d/dt of the poses",
     [](const At& at) {
       const Vector50 found = differentiate_poses(at, at.subject.points);
       return EquationSides{at.block(0, found.size(), at.model.nv) * at.qd, found, at.rate};
     }},
    {Function::bias_acceleration, "Jd qd = d/dt (J qd) at qdd = 0",
     [](const At& at) {
       return EquationSides{at.value, bias(at), size_of_accelerations(at)};
     }},
    {Function::point_velocity, "[v; w] = d/dt of the poses",
     [](const At& at) {
       return EquationSides{at.value,
                            differentiate_poses(at, ip::with_all_rows<Digits50>(at.subject.points)),
                            at.rate};
     }},
    {Function::point_acceleration, "[dv/dt; dw/dt] = d/dt [v; w]",
     [](const At& at) {
       const auto twists = [&](const Vector50& q, const Vector50& qd) {
         return ip::point_velocity<Digits50>(at.model, at.subject.points, q, qd);
       };
       return EquationSides{at.value, rate_along(at, at.qd, at.qdd, twists),
                            size_of_accelerations(at) + largest_of(at.qdd)};
     }},
    {Function::point_velocity_derivatives, "d/dq, d/dqd of [v; w]",
     [](const At& at) {
       return along_one_direction(
           at, Vector50(), [&](const Vector50& q, const Vector50& qd, const Vector50&) {
             return ip::point_velocity<Digits50>(at.model, at.subject.points, q, qd);
           });
     }},
    {Function::point_acceleration_derivatives, "d/dq, d/dqd, d/dqdd of [dv/dt; dw/dt]",
     [](const At& at) {
       return along_one_direction(
           at, at.qdd, [&](const Vector50& q, const Vector50& qd, const Vector50& qdd) {
             return ip::point_acceleration<Digits50>(at.model, at.subject.points, q, qd, qdd);
           });
     }},
    {Function::operational_bias_force, "Lambda^-1 mu = J M^-1 b - d/dt (J qd)", bias_force},
    {Function::control_torque, "J qdd + d/dt (J qd) = xdd_cmd", commanded},
    {Function::contact_motion, "velocity = d/dt position",
     [](const At& at) {
       const Eigen::Index half = at.value.size() / 2;
       return EquationSides{at.value.tail(half),
                            rate_along(at, at.qd,
                                       [&](const Vector50& q) {
                                         return ip::contact_motion<Digits50>(
                                                    at.model, at.subject.contacts, q, at.qd)
                                             .position;
                                       }),
                            at.rate};
     }},
});

}  // namespace

std::span<const Equation> equations_of_points() {
  return kEquationsOfPoints;
}

}  // namespace treeline
