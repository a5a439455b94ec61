#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "inspect/draw_states.hpp"
#include "inspect/inspect_robot.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/draw_state.hpp"
#include "oracle/leave_out_singular.hpp"
#include "oracle/model_from_robot.hpp"
#include "oracle/symmetric_matrices.hpp"

namespace treeline {
namespace {

using interpreter::Model;
using interpreter::Points;
using interpreter::Vector;

constexpr int kInertiaStates = 32;
constexpr int kSweptStates = 4;
constexpr double kInertiaDigits = 3;

/// Digits that a condition number costs; all of double's if it is infinite.
double digits_lost(double condition) {
  return condition > 0 ? std::min(kMostDigits, std::max(0.0, std::log10(condition))) : kMostDigits;
}

/// Reports what makes M singular in every pose. Returns false if nothing does.
bool inspect_massless(const Robot& robot, const Scene& scene, Report& report) {
  for (const MasslessDirections& each : find_massless_directions(robot, scene)) {
    const std::string lock = each.one_degree ? ", or lock it in the scene" : "";
    report.risks.push_back(
        {each.joint.empty() ? "base" : each.joint, "inertia", kMostDigits,
         fmt::format("no inertia resists {}: M is singular", each.what),
         fmt::format("Give link \"{}\" mass and inertia{}.", each.links.front(), lock)});
  }
  return !report.risks.empty();
}

void inspect_inertia(const Model<double>& model, DrawnStates& states, Report& report) {
  std::vector<double> worst(states.joints().size(), 1);
  for (int k = 0; k < kInertiaStates; ++k) {
    const Eigen::MatrixXd M = interpreter::mass_matrix<double>(model, states.draw());
    const Eigen::VectorXd d = M.diagonal();
    for (std::size_t i = 0; i < worst.size(); ++i) {
      if (!(d[states.joints()[i]->v] > 0)) worst[i] = std::numeric_limits<double>::infinity();
    }
    if (d.minCoeff() <= 0) continue;
    const Eigen::VectorXd s = d.cwiseSqrt().cwiseInverse();
    const Eigen::MatrixXd inverse = inverse_of_symmetric(s.asDiagonal() * M * s.asDiagonal());
    for (std::size_t i = 0; i < worst.size(); ++i) {
      const int v = states.joints()[i]->v;
      const double felt = inverse(v, v);
      worst[i] = felt > 0 ? std::max(worst[i], felt) : std::numeric_limits<double>::infinity();
    }
  }
  for (std::size_t i = 0; i < worst.size(); ++i) {
    const double digits = digits_lost(worst[i]);
    if (digits < kInertiaDigits) continue;
    const std::string finding =
        std::isinf(worst[i])
            ? "next to nothing moves with it: M is singular"
            : fmt::format("feels 1e{:.1f} times lighter when the other joints are free", digits);
    report.risks.push_back({states.joints()[i]->name, "inertia", digits, finding,
                            "Give the links behind it their masses, or lock it in the scene."});
  }
}

/// The largest condition number of Lambda^-1 along one joint's range, and where it occurs.
struct Peak {
  double condition = 0, usual = 0, at = 0;
};

Peak find_peak(const Model<double>& model, const Points<double>& points, Vector<double> q,
               const JointReport& joint) {
  const double low = DrawnStates::lower(joint), high = DrawnStates::upper(joint);
  const auto at = [&](double value) {
    q[joint.q] = value;
    return unit_condition(interpreter::lambda_inverse<double>(model, points, q));
  };
  std::vector<double> all;
  Peak peak;
  for (int i = 0; i <= kRangeSteps; ++i) {
    const double value = low + (high - low) * i / kRangeSteps;
    all.push_back(at(value));
    if (all.back() > peak.condition) peak = {all.back(), 0, value};
  }
  std::nth_element(all.begin(), all.begin() + kRangeSteps / 2, all.end());
  peak.usual = all[kRangeSteps / 2];
  for (double step = (high - low) / kRangeSteps / 2; step > 1e-9; step /= 2) {
    for (const double value : {peak.at - step, peak.at + step}) {
      if (value < low || value > high) continue;
      const double found = at(value);
      if (found > peak.condition) peak = {found, peak.usual, value};
    }
  }
  return peak;
}

constexpr const char* kSingularAdvice =
    "Ask for `damped` in the scene, control fewer `rows`, or keep the joint away from there.";

/// Whether Lambda^-1 is singular in all states, so that no joint is to blame.
bool is_always_singular(const Model<double>& model, const Points<double>& points,
                        const std::vector<Vector<double>>& states) {
  return std::all_of(states.begin(), states.end(), [&](const Vector<double>& q) {
    return digits_lost(unit_condition(interpreter::lambda_inverse<double>(model, points, q))) > 12;
  });
}

std::string joint_of(int v, const Report& report) {
  for (const JointReport& joint : report.joints) {
    if (joint.follows.empty() && v >= joint.v && v < joint.v + joint.nv) return joint.name;
  }
  return "the base";
}

/// Reports joints whose very different inertias cost the digits of Lambda^-1 in all states.
/// Otherwise this would look like an impossible task. Returns whether there are such joints.
bool inspect_mass_ratio(const Model<double>& model, const Points<double>& points,
                        const std::vector<Vector<double>>& states, Report& report) {
  const auto ratio = find_mass_ratio(model, points, states);
  if (!ratio || digits_lost(ratio->condition) < kSingularDigits) return false;
  report.risks.push_back(
      {joint_of(ratio->light, report), "mass", digits_lost(ratio->condition),
       fmt::format(
           "moves the points 1e{:.1f} times more easily than {} does: Lambda^-1 hardly knows "
           "what that adds",
           std::log10(ratio->share), joint_of(ratio->heavy, report)),
       "Ask for `damped` in the scene, control fewer `rows`, or check the masses."});
  return true;
}

void inspect_singularities(const Model<double>& model, const Points<double>& points,
                           DrawnStates& states, Report& report) {
  std::vector<Vector<double>> drawn;
  for (int k = 0; k < kSweptStates; ++k) drawn.push_back(states.draw());
  if (inspect_mass_ratio(model, points, drawn, report)) return;
  if (is_always_singular(model, points, drawn)) {
    report.risks.push_back({"", "task", kMostDigits,
                            "Lambda^-1 is singular everywhere: the rows of all points together "
                            "ask for more than the joints can do",
                            "Control fewer `rows`, or give the points a `priority` each."});
    return;
  }
  for (const JointReport* joint : states.joints()) {
    Peak worst;
    int closed = 0;
    for (const Vector<double>& q : drawn) {
      const Peak peak = find_peak(model, points, q, *joint);
      const bool closes =
          digits_lost(peak.condition) >= kSingularDigits && peak.condition > 100 * peak.usual;
      closed += closes ? 1 : 0;
      if (closes && peak.condition > worst.condition) worst = peak;
    }
    if (closed == 0) continue;
    report.risks.push_back(
        {joint->name, "singularity", digits_lost(worst.condition),
         fmt::format("makes Lambda^-1 singular, as at {:.4g} {}, from {} of {} poses of the others",
                     std::abs(worst.at) < 1e-6 ? 0 : worst.at, joint->unit, closed, kSweptStates),
         kSingularAdvice});
  }
}

void inspect_angles(const Robot& robot, const Scene& scene, Report& report) {
  const bool single = scene.real == Real::float32;
  const Mechanism mechanism = build_mechanism(robot, scene);
  std::string far;
  for (const MovingLink& link : mechanism.links) {
    if (!link.turns_by_angle() || link.spins) continue;
    if (largest_angle(mechanism, link) <= farthest_angle(single)) continue;
    far += (far.empty() ? "" : ", ") + link.joint;
  }
  if (far.empty()) return;
  report.risks.push_back({far, "angle", 0,
                          fmt::format("may turn further than {} rad, where sines lose digits",
                                      single ? "4000" : "2e8"),
                          "Take whole turns off before that."});
}

}  // namespace

void inspect_risks(const Robot& robot, const Scene& scene, Report& report) {
  const auto model = model_from_robot<double>(robot, scene);
  if (model.nv == 0) return;
  DrawnStates states(model, report);
  if (!inspect_massless(robot, scene, report)) inspect_inertia(model, states, report);
  const bool inertia_serves =
      std::none_of(report.risks.begin(), report.risks.end(),
                   [](const RiskReport& risk) { return risk.digits_lost >= kMostDigits; });
  if (inertia_serves && !scene.operational_points.empty()) {
    inspect_singularities(model, points_from_scene(model, scene.operational_points), states,
                          report);
  }
  inspect_angles(robot, scene, report);
}

}  // namespace treeline
