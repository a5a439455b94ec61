#include "oracle/equation_at.hpp"

#include <algorithm>
#include <random>

#include "oracle/equations.hpp"
#include "oracle/interpret.hpp"

namespace treeline {

namespace ip = interpreter;

namespace {

Vector50 vector50(const std::vector<Digits50>& entries) {
  return Eigen::Map<const Vector50>(entries.data(), static_cast<Eigen::Index>(entries.size()));
}

/// Numbers from -1 to 1, the same at each state of an index.
Vector50 random_direction(int size, int seed) {
  std::mt19937_64 engine(static_cast<std::uint64_t>(seed) + 1);
  Vector50 direction(size);
  for (Eigen::Index i = 0; i < size; ++i) {
    direction(i) = Digits50(static_cast<double>(engine() >> 12) * 0x1p-51 - 1);
  }
  return direction;
}

/// Rate of the momenta p = M qd, along the direction, that comes from the turning of the axes in
/// which joints have their velocities.
Digits50 turning_of_axes(const EquationAt& at, const Vector50& qd, const Vector50& p) {
  Digits50 sum = 0;
  for (const auto& body : at.model.bodies) {
    const bool floats = body.kind == ip::JointKind::floating;
    if (!floats && body.kind != ip::JointKind::spherical) continue;
    const int angular = body.v + (floats ? 3 : 0);
    const ip::Vector3<Digits50> w = qd.segment<3>(angular);
    ip::Vector3<Digits50> moment = ip::cross<Digits50>(w, p.segment<3>(angular));
    if (floats) {
      const ip::Vector3<Digits50> force = p.segment<3>(body.v);
      moment += ip::cross<Digits50>(qd.segment<3>(body.v), force);
      sum += at.direction.segment<3>(body.v).dot(ip::cross<Digits50>(w, force));
    }
    sum += at.direction.segment<3>(angular).dot(moment);
  }
  return sum;
}

}  // namespace

EquationAt::EquationAt(const Subject<Digits50>& of, const State& at,
                       const std::vector<Digits50>& results)
    : subject(of),
      model(of.model),
      state(at),
      value(vector50(results)),
      q(vector_of<Digits50>(at.q)),
      qd(vector_of<Digits50>(at.qd)),
      qdd(vector_of<Digits50>(at.qdd)),
      tau(vector_of<Digits50>(at.tau)),
      xdd_cmd(vector_of<Digits50>(at.xdd_cmd)),
      f_ext(vector_of<Digits50>(at.f_ext)),
      direction(random_direction(of.model.nv, at.index)),
      rate(largest_of(qd)) {}

Matrix50 EquationAt::block(Eigen::Index at, Eigen::Index rows, Eigen::Index cols) const {
  return Eigen::Map<const Matrix50>(value.data() + at, rows, cols);
}

Vector50 EquationAt::other(Quantity quantity) const {
  return vector_of<Digits50>(values_of(state, quantity));
}

bool are_independent(const Matrix50& Lambda_inverse) {
  if (Lambda_inverse.size() == 0) return true;
  const Vector50 pivots = Lambda_inverse.ldlt().vectorD();
  return pivots.minCoeff() > Digits50(1e-15) * pivots.maxCoeff();
}

Vector50 differentiate_poses(const EquationAt& at, const ip::Points<Digits50>& points) {
  const auto poses = [&](const Vector50& q) {
    std::vector<Digits50> entries;
    for (const auto& pose : ip::forward_kinematics<Digits50>(at.model, points, q)) {
      append(pose.position, entries);
      append(pose.rotation, entries);
    }
    return vector50(entries);
  };
  const Vector50 rates = rate_along(at, at.qd, poses);
  const Vector50 here = poses(at.q);
  std::vector<Digits50> velocities;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto from = static_cast<Eigen::Index>(12 * k);
    const ip::Matrix3<Digits50> R = Eigen::Map<const Matrix50>(here.data() + from + 3, 3, 3);
    const ip::Matrix3<Digits50> moved = Eigen::Map<const Matrix50>(rates.data() + from + 3, 3, 3);
    const ip::Matrix3<Digits50> spin = moved * R.transpose();
    ip::Vector3<Digits50> v = rates.segment<3>(from);
    ip::Vector3<Digits50> w{spin(2, 1), spin(0, 2), spin(1, 0)};
    if (points[k].axes == ip::PointAxes::local) {
      v = (R.transpose() * v).eval();
      w = (R.transpose() * w).eval();
    }
    for (int i = 0; i < 6; ++i) {
      if (points[k].rows[static_cast<std::size_t>(i)]) {
        velocities.push_back(i < 3 ? v(i) : w(i - 3));
      }
    }
  }
  return vector50(velocities);
}

LagrangianForce lagrangian_force(const EquationAt& at, const Vector50& qd, const Vector50& qdd) {
  const auto momenta = [&](const Vector50& q, const Vector50& v) {
    return Vector50(ip::mass_matrix<Digits50>(at.model, q) * v);
  };
  EquationAt moving = at;
  moving.qd = qd;
  const Digits50 inertial = at.direction.dot(rate_along(moving, qd, qdd, momenta)) +
                            turning_of_axes(at, qd, momenta(at.q, qd));
  const Vector50 energies = rate_along(at, at.direction, [&](const Vector50& q) {
    return joined(only(ip::kinetic_energy<Digits50>(at.model, q, qd)),
                  only(ip::potential_energy<Digits50>(at.model, q)));
  });
  return {inertial - energies(0) + energies(1),
          abs(inertial) + abs(energies(0)) + abs(energies(1))};
}

const Equation* find_equation(Function function) {
  for (const auto rows : {equations_of_robot(), equations_of_points(), equations_of_constraints(),
                          equations_of_objects()}) {
    const auto found = std::find_if(rows.begin(), rows.end(),
                                    [=](const Equation& row) { return row.function == function; });
    if (found != rows.end()) return &*found;
  }
  return nullptr;
}

std::optional<double> equation_residual(Function function, const Subject<Digits50>& subject,
                                        const State& state, const std::vector<Digits50>& results) {
  const Equation* const equation = find_equation(function);
  if (equation == nullptr) return std::nullopt;
  const EquationSides sides = equation->sides(EquationAt(subject, state, results));
  if (sides.stated.size() == 0) return std::nullopt;
  const Digits50 terms =
      std::max({sides.terms, largest_of(sides.stated), largest_of(sides.differentiated)});
  if (terms == 0) return 0;
  if (!isfinite(terms)) return std::nullopt;
  return static_cast<double>(Digits50(largest_of(sides.stated - sides.differentiated) / terms));
}

std::optional<double> equation_residual(Function function, const Subject<Digits50>& subject,
                                        const State& state) {
  if (find_equation(function) == nullptr) return std::nullopt;
  return equation_residual(function, subject, state, interpret<Digits50>(function, subject, state));
}

}  // namespace treeline
