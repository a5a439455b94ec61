#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "experiments.hpp"
#include "interpreter/instances.hpp"
#include "interpreter/propagate_inertia.hpp"
#include "oracle/subject.hpp"

namespace treeline::stress {
namespace {

using interpreter::Digits50;
using Matrix = interpreter::Matrix<double>;
using Matrix50 = interpreter::Matrix<Digits50>;

/// Largest error of an entry over sqrt(A_ii A_jj), in ulp. A is positive semidefinite.
template <class Actual>
double error_in_ulp(const Actual& actual, const Matrix50& exact) {
  using std::sqrt;
  Digits50 worst = 0;
  for (Eigen::Index i = 0; i < exact.rows(); ++i) {
    for (Eigen::Index j = 0; j < exact.cols(); ++j) {
      const Digits50 size = sqrt(Digits50(exact(i, i) * exact(j, j)));
      const Digits50 error = abs(Digits50(Digits50(actual(i, j)) - exact(i, j)));
      if (size > 0) worst = std::max(worst, Digits50(error / size));
    }
  }
  return static_cast<double>(worst) * 0x1p52;
}

struct Pair {
  explicit Pair(const Case& of, int state = 0)
      : exact(make_subject<Digits50>(of.robot, of.scene)), rounded(cast<double>(exact)) {
    for (int i = 0; i < rounded.model.nq; ++i) q.push_back(0.4 + 0.37 * std::sin(5.0 * i + state));
    for (const auto& body : rounded.model.bodies) {
      if (body.kind != interpreter::JointKind::floating) continue;
      const double unit[4] = {0.48, -0.36, 0.64, 0.48};
      std::copy(unit, unit + 4, q.begin() + body.q + 3);
    }
  }
  template <class Scalar>
  interpreter::Vector<Scalar> at() const {
    return interpreter::Vector<double>::Map(q.data(), static_cast<Eigen::Index>(q.size()))
        .template cast<Scalar>();
  }
  Subject<Digits50> exact;
  Subject<double> rounded;
  std::vector<double> q;
};

/// Chang table 5.1 for the UR10e: its fixed base as one with ever larger inertia.
Finding big_base(const Effort& effort) {
  const Pair fixed(read_robot(effort.robots + "/ur10e/ur10e.urdf", "tool"));
  ArmOptions flying;
  flying.floating = true;
  const Pair floating(make_arm(flying));
  const auto& model = fixed.rounded.model;
  const auto& points = fixed.rounded.points;
  const Matrix50 truth = interpreter::lambda_inverse<Digits50>(
      fixed.exact.model, fixed.exact.points, fixed.at<Digits50>());
  const Matrix by_5_3 = interpreter::lambda_inverse<double>(model, points, fixed.at<double>());
  const Matrix50 floating_truth = interpreter::lambda_inverse<Digits50>(
      floating.exact.model, floating.exact.points, floating.at<Digits50>());
  const double forces = error_in_ulp(by_5_3, truth);
  const double behind_floating =
      error_in_ulp(interpreter::lambda_inverse_by_inertia_propagation<double>(
                       floating.rounded.model, floating.rounded.points, floating.at<double>(), 1.0),
                   floating_truth);
  Finding finding{"big_base",
                  "Chang table 5.1 with a big base, and without",
                  "log10 of the base's inertia (kg, kg m^2)",
                  kDigitsLeft,
                  {},
                  {},
                  {},
                  {}};
  Curve in_double{"Lambda^-1", "table 5.1, fixed base as a big one", {}, false};
  Curve formula{"Lambda^-1", "the same in 50 digits", {}, true};
  Curve propagation{"Lambda^-1", "table 5.3", {}, false};
  Curve exact_base{"Lambda^-1", "table 5.1, base that floats", {}, false};
  for (int e = 1; e <= 18; ++e) {
    const double size = std::pow(10.0, e);
    finding.x.push_back(e);
    in_double.y.push_back(
        digits_left(error_in_ulp(interpreter::lambda_inverse_by_inertia_propagation<double>(
                                     model, points, fixed.at<double>(), size),
                                 truth)));
    formula.y.push_back(digits_left(error_in_ulp(
        interpreter::lambda_inverse_by_inertia_propagation<Digits50>(
            fixed.exact.model, fixed.exact.points, fixed.at<Digits50>(), Digits50(size)),
        truth)));
    propagation.y.push_back(digits_left(forces));
    exact_base.y.push_back(digits_left(behind_floating));
  }
  const double best = *std::max_element(in_double.y.begin(), in_double.y.end());
  finding.said.push_back(fmt::format(
      "best of all bases {:.1f} digits, table 5.3 {:.1f}, table 5.1 behind a floating base {:.1f}",
      best, digits_left(forces), digits_left(behind_floating)));
  claim(best < 11, "no big base leaves 11 digits", finding);
  claim(digits_left(forces) > 13 && digits_left(behind_floating) > 13,
        "table 5.3, and table 5.1 behind a floating base, leave 13 digits", finding);
  claim(std::abs(formula.y[9] - formula.y[5] - 4) < 0.1,
        "the formula's own error is 1 over the base's inertia", finding);
  finding.curves = {in_double, formula, propagation, exact_base};
  return finding;
}

/// Errors of all links in several states, in ulp: of table 8.1, and of the inverse recursion.
std::pair<double, double> link_inertia_errors(const Case& of) {
  double worst_table = 0;
  double worst_inverse = 0;
  for (int state = 0; state < 6; ++state) {
    const Pair pair(of, state);
    const auto& model = pair.rounded.model;
    const auto Lambda = interpreter::link_inertias<double>(model, pair.at<double>(), 0.0);
    const auto Omega = interpreter::link_inverse_inertias<double>(model, pair.at<double>());
    const auto Lambda_exact =
        interpreter::link_inertias<Digits50>(pair.exact.model, pair.at<Digits50>(), Digits50(0));
    const auto Omega_exact =
        interpreter::link_inverse_inertias<Digits50>(pair.exact.model, pair.at<Digits50>());
    for (int i = 0; i < model.size(); ++i) {
      worst_table = std::max(worst_table, error_in_ulp(Lambda[i], Matrix50(Lambda_exact[i])));
      worst_inverse = std::max(worst_inverse, error_in_ulp(Omega[i], Matrix50(Omega_exact[i])));
    }
  }
  return {worst_table, worst_inverse};
}

/// Table 8.1 subtracts a body's subtree from the whole robot, at the parent's origin.
Finding subtraction(const Effort& effort) {
  Finding finding{"subtraction",
                  "Inertias of all links: table 8.1 against the inverse recursion",
                  "log10 of the way between balls over their radius",
                  kDigitsLeft,
                  {},
                  {},
                  {},
                  {}};
  Curve by_table{"all links, worst entry", "table 8.1: the subtree subtracted", {}, false};
  Curve inverse{"all links, worst entry", "inverse recursion", {}, false};
  for (double e = 0; e <= 6; e += effort.quick ? 3 : 1) {
    ArmOptions arm;
    arm.floating = true;
    arm.balls = true;
    arm.links = 5;
    arm.slenderness = std::pow(10.0, -e);
    const auto [worst_table, worst_inverse] = link_inertia_errors(make_arm(arm));
    finding.x.push_back(e);
    by_table.y.push_back(digits_left(worst_table));
    inverse.y.push_back(digits_left(worst_inverse));
  }
  const double least = *std::min_element(inverse.y.begin(), inverse.y.end());
  finding.said.push_back(fmt::format("at 1e6: table 8.1 leaves {:.1f} digits, the inverse {:.1f}",
                                     by_table.y.back(), inverse.y.back()));
  claim(least > 13, "the inverse recursion leaves 13 digits everywhere", finding);
  claim(std::abs(by_table.y.front() - by_table.y.back() - 12) < 1,
        "table 8.1 loses with the square of the way over the size", finding);
  finding.curves = {by_table, inverse};
  return finding;
}

/// Two points on one link that approach each other until they coincide: twelve rows with six
/// joints, Lambda^-1 only semidefinite.
Finding redundant(const Effort& effort) {
  std::vector<Sample> samples;
  std::vector<std::string> broken;
  for (double e = 1; e <= 17; e += effort.quick ? 4 : 1) {
    Case arm = make_arm({});
    ScenePoint second = arm.scene.operational_points.front();
    second.name = "twin";
    if (e < 17) second.origin.xyz[2] += std::pow(10.0, -e);
    arm.scene.operational_points.push_back(second);
    const Bench bench(arm, {Function::lambda_inverse});
    samples.push_back({e, bench.measure(effort.quick ? 1 : 6)});
    if (!bench.damped_torque_is_bounded(bench.draw(0))) {
      broken.push_back(fmt::format("damped torque keeps its bound at 1e-{}", e));
    }
  }
  Finding finding =
      make_finding("redundant", "Two operational points on one link",
                   "-log10 of the distance between the points (m), at 17 none", samples, 16);
  finding.broken.insert(finding.broken.end(), broken.begin(), broken.end());
  return finding;
}

}  // namespace

std::vector<Experiment> table_experiments() {
  return {{"big_base", big_base}, {"subtraction", subtraction}, {"redundant", redundant}};
}

}  // namespace treeline::stress
