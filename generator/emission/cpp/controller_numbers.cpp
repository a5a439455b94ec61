#include "emission/cpp/controller_numbers.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "emission/c_family_syntax.hpp"
#include "emission/controller_unit.hpp"
#include "emission/cpp/syntax.hpp"

namespace treeline::cpp {
namespace {

/// Limits of the joints, over `part` of one.
std::string print_limits(const ControllerUnit& unit, const Syntax& syntax,
                         double ControllerUnit::Joint::*limit, double part = 1) {
  std::vector<std::string> entries;
  for (const ControllerUnit::Joint& joint : unit.joints) {
    const double value = joint.*limit / part;
    const std::string sign = value < 0 ? "-" : "";
    entries.push_back(sign +
                      (std::isfinite(value) ? syntax.literal(std::fabs(value)) : "kUnlimited"));
  }
  return fmt::format("{}", fmt::join(entries, ", "));
}

void add_limit_holes(const EmissionContext& context, const ControllerUnit& unit,
                     const Syntax& syntax, Holes& holes) {
  using Joint = ControllerUnit::Joint;
  holes["lower"] = print_limits(unit, syntax, &Joint::lower);
  holes["upper"] = print_limits(unit, syntax, &Joint::upper);
  holes["speed"] = print_limits(unit, syntax, &Joint::speed);
  holes["torque"] = print_limits(unit, syntax, &Joint::torque);
  holes["torque_rate"] = print_limits(unit, syntax, &Joint::torque, unit.settings.torque_rise);
  std::vector<std::string> turns;
  for (const Joint& joint : unit.joints) turns.emplace_back(joint.turns() ? "true" : "false");
  holes["turns"] = fmt::format("{}", fmt::join(turns, ", "));
  bool unlimited = false;
  for (const char* hole : {"lower", "upper", "speed", "torque"}) {
    unlimited = unlimited || holes[hole].find("kUnlimited") != std::string::npos;
  }
  const double most = context.single_precision
                          ? static_cast<double>(std::numeric_limits<float>::max())
                          : std::numeric_limits<double>::max();
  holes["unlimited"] =
      unlimited ? fmt::format("constexpr Real kUnlimited = {};", syntax.literal(most)) : "";
}

/// Default gains and thresholds, in the names of the configuration.
void add_default_holes(const EmissionContext& context, const ControllerUnit& unit,
                       const Syntax& syntax, Holes& holes) {
  const SceneController& own = unit.settings;
  const auto literal = [&](double value) { return syntax.literal(value); };
  holes["period"] = literal(own.period);
  holes["joint_frequency"] = literal(own.joint_frequency);
  holes["damping_ratio"] = literal(own.damping_ratio);
  holes["position_margin"] = literal(own.position_margin);
  holes["speed_margin"] = literal(own.speed_margin);
  holes["brake_damping"] = literal(own.brake_damping);
  holes["hold_frequency"] = literal(own.hold_frequency);
  holes["hold_reach"] = literal(own.hold_reach);
  holes["jump"] = literal(own.jump);
  holes["following"] = literal(own.following);
  holes["speed_rise"] = literal(own.speed_rise);
  constexpr double kRestSpeed = 1e-3;
  holes["rest_speed"] = literal(kRestSpeed);
  holes["fade"] = literal(own.fade);
  holes["saturation"] = name_in_capitals(context) + (own.clamps ? "_CLAMP" : "_SCALE");
  holes["stale_ticks"] = std::to_string(own.stale_ticks);
  holes["blind_ticks"] = std::to_string(own.blind_ticks);
  holes["task_defaults"] =
      unit.task_torque
          ? fmt::format(
                "for (int i = 0; i < (6 * Robot::kPoints); ++i) {{\n"
                "  config.task_frequency[i] = {};\n  config.task_damping[i] = {};\n}}\n"
                "for (int i = 0; i < Robot::kJoints; ++i) {{\n"
                "  config.posture_frequency[i] = {};\n}}\n"
                "config.point_speed = {};\nconfig.point_turn = {};\n",
                literal(own.task_frequency), literal(own.damping_ratio),
                literal(own.posture_frequency), literal(own.point_speed), literal(own.point_turn))
          : "";
  holes["force_defaults"] = own.force
                                ? fmt::format(
                                      "config.force_gain = {};\nconfig.force_rate = {};\n"
                                      "config.force_damping = {};\nconfig.largest_force = {};\n"
                                      "for (int i = 0; i < (6 * Robot::kPoints); ++i) {{\n"
                                      "  config.point_stiffness[i] = Real(0);\n"
                                      "  config.point_viscosity[i] = Real(0);\n}}\n",
                                      literal(own.force_gain), literal(own.force_rate),
                                      literal(own.force_damping), literal(own.largest_force))
                                : "";
}

void add_row_holes(const ControllerUnit& unit, Holes& holes) {
  std::vector<std::string> controls, own_axes;
  const auto name = [](bool on) { return on ? "true" : "false"; };
  for (const ControllerUnit::Point& point : unit.points) {
    const auto& on = point.rows;
    controls.push_back(fmt::format("{}, {}, {}, {}, {}, {}", name(on[0]), name(on[1]), name(on[2]),
                                   name(on[3]), name(on[4]), name(on[5])));
    own_axes.emplace_back(point.own_axes ? "true" : "false");
  }
  if (unit.points.empty()) controls = own_axes = {"false"};
  holes["control_count"] = std::to_string(std::max<std::size_t>(1, 6 * unit.points.size()));
  holes["controls"] = fmt::format("{}", fmt::join(controls, ",\n      "));
  holes["own_count"] = std::to_string(own_axes.size());
  holes["own_axes"] = fmt::format("{}", fmt::join(own_axes, ", "));
}

}  // namespace

void add_controller_numbers(const EmissionContext& context, const ControllerUnit& unit,
                            Holes& holes) {
  const Syntax syntax = make_syntax(context);
  add_row_holes(unit, holes);
  add_limit_holes(context, unit, syntax, holes);
  add_default_holes(context, unit, syntax, holes);
}

}  // namespace treeline::cpp
