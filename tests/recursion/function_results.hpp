#pragma once

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "functions/function.hpp"
#include "interpreter/instances.hpp"
#include "random_state.hpp"

/// Results of a scene's functions by the interpreter, which is independent of mechanisms,
/// recursions and graphs: the oracle for all of them.
namespace treeline::tests {

using interpreter::Digits50;

/// Arguments of all functions.
template <class Scalar>
struct Inputs {
  std::vector<Scalar> q, qd, qdd, tau, xdd_cmd, f_ext;
};

/// Results in the form of a program: one list for each result, row-major.
template <class Scalar>
using Results = std::vector<std::vector<Scalar>>;

template <class To, class From>
std::vector<To> rounded_to(const std::vector<From>& values) {
  std::vector<To> result;
  for (const From& x : values) result.push_back(static_cast<To>(x));
  return result;
}
template <class To, class From>
Inputs<To> rounded_to(const Inputs<From>& in) {
  return {rounded_to<To>(in.q),   rounded_to<To>(in.qd),      rounded_to<To>(in.qdd),
          rounded_to<To>(in.tau), rounded_to<To>(in.xdd_cmd), rounded_to<To>(in.f_ext)};
}

template <class Derived>
auto listed(const Eigen::MatrixBase<Derived>& A) {
  std::vector<typename Derived::Scalar> values;
  for (Eigen::Index i = 0; i < A.rows(); ++i) {
    for (Eigen::Index j = 0; j < A.cols(); ++j) values.push_back(A(i, j));
  }
  return values;
}

/// A robot in a scene in the interpreter's form: every link is a body, nothing is reduced. Compiled
/// for 50 digits.
template <class Scalar>
class Oracle {
 public:
  Oracle(const Robot& robot, const Scene& scene);

  [[nodiscard]] const interpreter::Model<Scalar>& model() const { return model_; }
  [[nodiscard]] bool has_points() const { return !points_.empty(); }
  [[nodiscard]] int task_rows() const { return interpreter::row_count(points_); }

  /// Draws angles, displacements, rates, forces and accelerations up to `size`.
  [[nodiscard]] Inputs<Scalar> random_inputs(Rng& rng, double size = 3) const;
  [[nodiscard]] interpreter::Matrix<Scalar> mass_matrix(const Inputs<Scalar>& in) const;
  [[nodiscard]] interpreter::Matrix<Scalar> lambda_inverse(const Inputs<Scalar>& in) const;
  [[nodiscard]] Results<Scalar> results(Function function, const Inputs<Scalar>& in) const;

 private:
  [[nodiscard]] Results<Scalar> poses(const Inputs<Scalar>& in) const;

  interpreter::Model<Scalar> model_;
  interpreter::Points<Scalar> points_, forces_;
};

/// Ratio of the largest to the smallest singular value; infinite for a singular matrix.
double condition(const Eigen::MatrixXd& A);
template <class Derived>
double condition(const Eigen::MatrixBase<Derived>& A) {
  using T = typename Derived::Scalar;
  return condition(Eigen::MatrixXd(A.unaryExpr([](const T& x) { return static_cast<double>(x); })));
}

/// Scales for the errors of functions at one state.
struct Yardstick {
  double force = 1;           ///< size of M's entries: forces that need not cancel are of this size
  double condition_M = 1;     ///< of M
  double condition_task = 1;  ///< of Lambda^-1; infinite where the task is singular

  [[nodiscard]] double least_scale(Function function) const {
    switch (function) {
      case Function::forward_kinematics:
      case Function::jacobian:
      case Function::bias_acceleration:
        return 1;  // of one metre, of one turn
      case Function::inverse_dynamics:
      case Function::gravity:
      case Function::nonlinear_effects:
      case Function::control_torque:
      case Function::coriolis_matrix:
      case Function::kinetic_energy:
      case Function::potential_energy:
        return force;
      default:
        return 0;
    }
  }
  /// Factor by which a solve may amplify rounding.
  [[nodiscard]] double growth(Function function) const {
    switch (function) {
      case Function::forward_dynamics:
      case Function::lambda_inverse:
        return condition_M;
      case Function::lambda:
      case Function::control_torque:
        return std::max(condition_M, condition_task);
      default:
        return 1;
    }
  }
};

template <class Scalar>
Yardstick yardstick(const Oracle<Scalar>& oracle, const Inputs<Scalar>& in);

/// Whether the scene and the state permit the function: points if it needs them, and a task that
/// the robot can do.
inline bool permits(Function function, bool has_points, const Yardstick& size) {
  switch (function) {
    case Function::forward_kinematics:
    case Function::jacobian:
    case Function::bias_acceleration:
    case Function::lambda_inverse:
      return has_points;
    case Function::lambda:
    case Function::control_torque:
      return has_points && size.condition_task < 1e7;
    default:
      return true;
  }
}

/// Largest difference between two results relative to the size of the expected one, which is at
/// least `least_scale`. Zero results must be exact. Infinite for a NaN or a wrong shape.
template <class Actual, class Expected>
double relative_error(const Results<Actual>& actual, const Results<Expected>& expected,
                      double least_scale) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  if (actual.size() != expected.size()) return kInfinity;
  double worst = 0;
  for (std::size_t k = 0; k < expected.size(); ++k) {
    if (actual[k].size() != expected[k].size()) return kInfinity;
    Expected scale(least_scale), difference(0);
    for (std::size_t i = 0; i < expected[k].size(); ++i) {
      using std::abs;
      const Expected off = abs(Expected(Expected(actual[k][i]) - expected[k][i]));
      if (!(off < Expected(1e300))) return kInfinity;
      difference = std::max(difference, off);
      scale = std::max(scale, Expected(abs(expected[k][i])));
    }
    if (difference != 0) {
      worst = std::max(worst, scale == 0 ? kInfinity : static_cast<double>(difference / scale));
    }
  }
  return worst;
}

/// Describes a case, `name, seed 7 (...)`, so that a failure can be reproduced.
inline std::string described(std::uint64_t seed, const RandomOptions& options) {
  return "random_mechanism seed " + std::to_string(seed) + ", joints " +
         std::to_string(options.joints) + (options.floating_base ? ", floating base" : "") +
         ", branching " + std::to_string(options.branching) + ", points " +
         std::to_string(options.operational_points);
}

}  // namespace treeline::tests
