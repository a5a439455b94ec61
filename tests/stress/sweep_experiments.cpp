#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "experiments.hpp"
#include "inspect/inspect_robot.hpp"

namespace treeline::stress {
namespace {

const std::vector<Function> kAll = {Function::inverse_dynamics, Function::mass_matrix,
                                    Function::forward_dynamics, Function::lambda_inverse,
                                    Function::control_torque};
const std::vector<Function> kJointSpace = {Function::inverse_dynamics, Function::mass_matrix,
                                           Function::forward_dynamics};

/// Error bound in ulp times the condition number, for robots with a few links. The loss beyond the
/// condition number grows with the number of operations along the tree.
constexpr double kAllowed = 16;

std::vector<double> range(double from, double to, double step) {
  std::vector<double> values;
  for (int i = 0; from + i * step <= to + 1e-9; ++i) values.push_back(from + i * step);
  return values;
}

int states(const Effort& effort) {
  return effort.quick ? 2 : 12;
}

/// The robot in states that the exponent changes.
template <class Change>
std::vector<Sample> sweep_states(const Bench& bench, const std::vector<double>& exponents,
                                 int count, Change change) {
  std::vector<Sample> samples;
  for (const double e : exponents) {
    samples.push_back({e, bench.measure(count, [&](State& state) { change(e, state); })});
  }
  return samples;
}

/// Another robot for each exponent.
template <class Make>
std::vector<Sample> sweep_robots(const std::vector<double>& exponents, int count,
                                 const std::vector<Function>& functions, Make make) {
  std::vector<Sample> samples;
  for (const double e : exponents) {
    samples.push_back({e, Bench(make_arm(make(e)), functions).measure(count)});
  }
  return samples;
}

/// Claims that every algorithm keeps this many digits of a function for all x.
void claim_digits(Function function, double least, Finding& finding) {
  double worst = 16;
  for (const Curve& curve : finding.curves) {
    if (curve.panel != function_name(function) || curve.dashed) continue;
    for (const double digits : curve.y) worst = std::min(worst, std::isnan(digits) ? 16 : digits);
  }
  claim(worst >= least,
        fmt::format("{} keeps {} digits (is {:.1f})", function_name(function), least, worst),
        finding);
}

/// Claims that ratios of masses cost nothing.
void claim_masses_cost_nothing(Finding& finding) {
  for (const Function function : kJointSpace) claim_digits(function, 15, finding);
}

/// `inspect` names joints whose inertias cost Lambda^-1 its digits exactly where they do.
template <class Make>
void claim_inspection(const std::vector<double>& exponents, double from, Make make,
                      Finding& finding) {
  for (const double e : exponents) {
    const Case arm = make_arm(make(e));
    const auto risks = inspect_robot(arm.robot, arm.scene).risks;
    const bool warned = std::any_of(risks.begin(), risks.end(),
                                    [](const RiskReport& risk) { return risk.kind == "mass"; });
    claim(warned == (e >= from),
          fmt::format("inspect {} of masses at 1e{}", e >= from ? "warns" : "is silent", e),
          finding);
  }
}
constexpr double kNever = 99;

/// The UR10e's elbow and wrist approach their singularities together.
Finding singularity(const Effort& effort) {
  const Bench bench(read_robot(effort.robots + "/ur10e/ur10e.urdf", "tool"),
                    {Function::forward_dynamics, Function::lambda_inverse, Function::lambda,
                     Function::control_torque});
  const auto near = [](double e, State& state) { state.q[2] = std::pow(10.0, -e); };
  const auto exponents = range(1, 16, effort.quick ? 3 : 1);
  Finding finding = make_finding("singularity", "UR10e near its elbow lock",
                                 "-log10 of the elbow's distance from the lock (rad)",
                                 sweep_states(bench, exponents, states(effort), near), kAllowed);
  for (const double e : exponents) {
    State state = bench.draw(0);
    near(e, state);
    state.q[4] = state.q[2];
    claim(bench.damped_torque_is_bounded(state),
          fmt::format("damped torque keeps its bound at 1e-{}", e), finding);
  }
  return finding;
}

Finding heavy_tip(const Effort& effort) {
  const auto make = [](double e) {
    ArmOptions arm;
    arm.mass_growth = std::pow(10.0, e / (arm.links - 1));
    return arm;
  };
  const auto exponents = range(0, 12, effort.quick ? 4 : 1);
  Finding finding = make_finding("heavy_tip", "Six links, each heavier than the one before",
                                 "log10 of the last mass over the first",
                                 sweep_robots(exponents, states(effort), kAll, make), kAllowed);
  claim_masses_cost_nothing(finding);
  claim_digits(Function::lambda_inverse, 12, finding);
  claim_inspection(exponents, kNever, make, finding);
  return finding;
}

Finding light_tip(const Effort& effort) {
  const auto make = [](double e) {
    ArmOptions arm;
    arm.mass_growth = std::pow(10.0, -e / (arm.links - 1));
    return arm;
  };
  const auto exponents = range(0, 12, effort.quick ? 4 : 1);
  Finding finding = make_finding("light_tip", "Six links, each lighter than the one before",
                                 "log10 of the first mass over the last",
                                 sweep_robots(exponents, states(effort), kAll, make), kAllowed);
  claim_masses_cost_nothing(finding);
  claim_inspection(exponents, 7, make, finding);
  return finding;
}

Finding light_link(const Effort& effort) {
  const auto make = [](double e) {
    ArmOptions arm;
    arm.light_link = 3;
    arm.light = e > 17 ? 0 : std::pow(10.0, -e);
    return arm;
  };
  const auto exponents = range(0, 18, effort.quick ? 6 : 2);
  Finding finding =
      make_finding("light_link", "The third of six links nearly massless, at 18 massless",
                   "-log10 of its mass over the others'",
                   sweep_robots(exponents, states(effort), kAll, make), kAllowed);
  claim_masses_cost_nothing(finding);
  claim_inspection(exponents, kNever, make, finding);
  return finding;
}

Finding thin_rods(const Effort& effort) {
  const auto make = [](double e) {
    ArmOptions arm;
    arm.slenderness = std::pow(10.0, -e);
    return arm;
  };
  return make_finding(
      "thin_rods", "Rods so thin that inertia about them vanishes", "-log10 of radius over length",
      sweep_robots(range(0, 8, effort.quick ? 4 : 1), states(effort), kAll, make), kAllowed);
}

Finding size(const Effort& effort) {
  const auto make = [](double e) {
    ArmOptions arm;
    arm.mass = 2 * std::pow(10.0, e);
    arm.length = 0.3 * std::pow(10.0, e / 3);
    return arm;
  };
  return make_finding("size", "The same arm in other sizes", "log10 of its mass over 2 kg a link",
                      sweep_robots(range(-9, 9, effort.quick ? 9 : 3), states(effort), kAll, make),
                      kAllowed);
}

Finding speed(const Effort& effort) {
  const Bench bench(make_arm({}), {Function::inverse_dynamics, Function::bias_acceleration,
                                   Function::forward_dynamics, Function::control_torque});
  const auto hurry = [](double e, State& state) {
    for (double& rate : state.qd) rate *= 0.5 * std::pow(10.0, e);
  };
  return make_finding(
      "speed", "Joint speeds", "log10 of the joints' speed (rad/s)",
      sweep_states(bench, range(0, 4, effort.quick ? 2 : 0.5), states(effort), hurry), kAllowed);
}

/// Beyond 2e8 rad, the sine in emitted code is that of an angle within two ulp of q (see
/// `core::sin_cos`). The interpreter uses the library's sine, which is accurate there.
Finding angle(const Effort& effort) {
  const Case arm = make_arm({});
  const Bench bench(arm, kAll);
  const auto turn = [](double e, State& state) {
    for (double& q : state.q) q *= std::pow(10.0, e);
  };
  std::vector<Sample> samples =
      sweep_states(bench, range(0, 9, effort.quick ? 4.5 : 1), states(effort), turn);
  for (Sample& sample : samples) {
    const double largest = 3.15 * std::pow(10.0, sample.x);
    if (largest < 2e8) continue;
    for (Loss& loss : sample.losses) {
      if (loss.algorithm.starts_with("graph:")) loss.ratio /= 2 * largest * ArmOptions{}.links;
    }
  }
  return make_finding("angle", "Joint angles of many turns", "log10 of the joints' angles (rad)",
                      samples, kAllowed);
}

/// The interpreter up to 500 links; graphs up to sizes for which straight-line code is sensible.
Finding chain(const Effort& effort) {
  std::vector<Sample> samples;
  const std::vector<int> lengths =
      effort.quick ? std::vector{2, 6, 20, 40} : std::vector{2, 4, 8, 16, 32, 64, 128, 256, 500};
  for (const int links : lengths) {
    ArmOptions arm;
    arm.links = links;
    arm.length = 0.1;
    const bool graphs = links <= (effort.quick ? 20 : 128);
    samples.push_back({std::log10(links),
                       Bench(make_arm(arm), kJointSpace, graphs).measure(links > 128 ? 1 : 2)});
  }
  return make_finding("chain", "Chains of links", "log10 of the number of links", samples,
                      kAllowed);
}

Finding tree(const Effort& effort) {
  std::vector<Sample> samples;
  for (int depth = 2; depth <= (effort.quick ? 4 : 7); ++depth) {
    ArmOptions arm;
    arm.links = (1 << depth) - 1;
    arm.binary_tree = true;
    const bool graphs = depth <= (effort.quick ? 3 : 5);
    Case made = make_arm(arm);
    if (depth < 4) {  // three rows a point are more than two joints can move
      for (auto& point : made.scene.operational_points) {
        point.rows = {true, depth > 2, depth > 2, false, false, false};
      }
    }
    samples.push_back(
        {static_cast<double>(depth), Bench(made, kAll, graphs).measure(effort.quick ? 1 : 3)});
  }
  return make_finding("tree", "Binary trees, points on two leaves", "depth", samples, kAllowed);
}

}  // namespace

std::vector<Experiment> sweep_experiments() {
  return {{"singularity", singularity},
          {"heavy_tip", heavy_tip},
          {"light_tip", light_tip},
          {"light_link", light_link},
          {"thin_rods", thin_rods},
          {"size", size},
          {"speed", speed},
          {"angle", angle},
          {"chain", chain},
          {"tree", tree}};
}

}  // namespace treeline::stress
