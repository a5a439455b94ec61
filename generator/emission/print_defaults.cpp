#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "emission/backend.hpp"
#include "emission/c_family_syntax.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emitted_text.hpp"
#include "emission/print_files.hpp"

namespace treeline {
namespace {

/// A member of the configuration and its default.
struct Member {
  const char* name;
  std::vector<std::string> values;
  bool is_array = false;
};

/// The configuration's members as they are told, in the order of NAME_controller.h.
class Members {
 public:
  Members(const EmissionContext& context, const ControllerUnit& unit)
      : syntax_(backend_of(context.language).syntax(context)),
        unit_(unit),
        largest_(context.single_precision ? static_cast<double>(std::numeric_limits<float>::max())
                                          : std::numeric_limits<double>::max()) {}

  void add(const char* name, double value) { list_.push_back({name, {print(value)}}); }
  void add(const char* name, std::string value) { list_.push_back({name, {std::move(value)}}); }
  void add(const char* name, const std::vector<double>& values) {
    Member& member = list_.emplace_back(Member{name, {}, true});
    for (const double value : values) member.values.push_back(print(value));
  }
  void add_to_all(const char* name, std::size_t count, double value) {
    list_.push_back({name, std::vector(count, print(value)), true});
  }
  /// Limits of the joints, over `part` of one.
  void add(const char* name, double ControllerUnit::Joint::*limit, double part = 1) {
    Member& member = list_.emplace_back(Member{name, {}, true});
    for (const auto& joint : unit_.joints) member.values.push_back(print(joint.*limit / part));
  }
  [[nodiscard]] const std::vector<Member>& list() const { return list_; }

 private:
  [[nodiscard]] std::string print(double value) const {
    return signed_literal(syntax_, std::isfinite(value) ? value : std::copysign(largest_, value));
  }
  Syntax syntax_;
  const ControllerUnit& unit_;
  double largest_;  ///< in place of a limit that there is not
  std::vector<Member> list_;
};

void add_task(const SceneController& own, std::size_t joints, std::size_t rows, Members& members) {
  members.add_to_all("task_frequency", rows, own.task_frequency);
  members.add_to_all("task_damping", rows, own.damping_ratio);
  members.add_to_all("posture_frequency", joints, own.posture_frequency);
  members.add("point_speed", own.point_speed);
  members.add("point_turn", own.point_turn);
}

/// Shares of the points whose tasks come and go, behaviour by behaviour.
std::vector<double> list_shares(const ControllerUnit& unit) {
  std::vector<double> shares;
  for (const SceneBehaviour& behaviour : unit.settings.behaviours) {
    std::vector<double> row(unit.count_shares());
    for (const ControllerUnit::Point& point : unit.points) {
      const auto& tasks = behaviour.tasks;
      const bool done = std::find(tasks.begin(), tasks.end(), point.name) != tasks.end();
      if (done) row[static_cast<std::size_t>(point.share)] = 1;
    }
    shares.insert(shares.end(), row.begin(), row.end());
  }
  return shares;
}

void add_force(const SceneController& own, std::size_t rows, Members& members) {
  members.add("force_gain", own.force_gain);
  members.add("force_rate", own.force_rate);
  members.add("force_damping", own.force_damping);
  members.add("largest_force", own.largest_force);
  members.add_to_all("point_stiffness", rows, 0);
  members.add_to_all("point_viscosity", rows, 0);
}

std::vector<Member> list_defaults(const EmissionContext& context, const ControllerUnit& unit) {
  using Joint = ControllerUnit::Joint;
  constexpr double kComplyDamping = 3;  // 1/s
  constexpr double kRestSpeed = 1e-3;
  const SceneController& own = unit.settings;
  const std::size_t joints = unit.joints.size();
  const std::size_t rows = 6 * unit.points.size();
  Members members(context, unit);
  members.add("period", own.period);
  members.add("lower", &Joint::lower);
  members.add("upper", &Joint::upper);
  members.add("speed", &Joint::speed);
  members.add("torque", &Joint::torque);
  members.add("torque_rate", &Joint::torque, own.torque_rise);
  if (unit.tells_currents()) members.add("torque_per_ampere", &Joint::torque_per_ampere);
  members.add("position_margin", own.position_margin);
  members.add("speed_margin", own.speed_margin);
  members.add_to_all("joint_frequency", joints, own.joint_frequency);
  members.add_to_all("joint_damping", joints, own.damping_ratio);
  members.add("comply_damping", kComplyDamping);
  members.add_to_all("joint_stiffness", joints, 0);
  members.add_to_all("joint_viscosity", joints, 0);
  members.add_to_all("joint_damping_ratio", joints, 0);
  if (unit.task_torque) add_task(own, joints, rows, members);
  if (unit.behaves()) members.add("behaviour_share", list_shares(unit));
  if (own.force) add_force(own, rows, members);
  members.add("brake_damping", own.brake_damping);
  members.add("hold_frequency", own.hold_frequency);
  members.add("hold_reach", own.hold_reach);
  members.add("observer", own.observer);
  members.add("rest_speed", kRestSpeed);
  members.add("jump", own.jump);
  members.add("following", own.following);
  members.add("speed_rise", own.speed_rise);
  members.add("fade", own.fade);
  members.add("saturation", name_in_capitals(context) + (own.clamps ? "_CLAMP" : "_SCALE"));
  members.add("stale_ticks", std::to_string(own.stale_ticks));
  members.add("blind_ticks", std::to_string(own.blind_ticks));
  return members.list();
}

void add_defaults(const EmissionContext& context, const ControllerUnit& unit, Holes& holes) {
  constexpr std::size_t kIndentation = 4;  // of the template
  std::string values, copies;
  for (const Member& member : list_defaults(context, unit)) {
    const std::string list = fmt::format("{}", fmt::join(member.values, ", "));
    const std::string value = member.is_array ? "{" + list + "}" : list;
    values += wrap_in_hole(fmt::format("/* {} */ {},", member.name, value), kIndentation) + "\n";
    copies += member.is_array ? fmt::format(
                                    "tl_copy_numbers(&TL_DEFAULTS.{0}[0], {1}, "
                                    "&config->{0}[0]);\n",
                                    member.name, member.values.size())
                              : fmt::format("config->{0} = TL_DEFAULTS.{0};\n", member.name);
  }
  values.erase(values.rfind(','));
  holes["defaults"] = values;
  holes["set_defaults"] = copies;
}

std::string list_flags(const std::vector<bool>& flags) {
  return fmt::format("{}", fmt::join(flags, ", "));
}

}  // namespace

void add_controller_numbers(const EmissionContext& context, const ControllerUnit& unit,
                            Holes& holes) {
  std::vector<bool> turns, controls, own_axes;
  std::vector<int> shares;
  for (const ControllerUnit::Joint& joint : unit.joints) turns.push_back(joint.turns());
  for (const ControllerUnit::Point& point : unit.points) {
    controls.insert(controls.end(), point.rows.begin(), point.rows.end());
    own_axes.push_back(point.own_axes);
    shares.push_back(point.share);
  }
  holes["turns"] = list_flags(turns);
  holes["controls"] = list_flags(controls);
  holes["own_axes"] = list_flags(own_axes);
  holes["shares"] = fmt::format("{}", fmt::join(shares, ", "));
  add_defaults(context, unit, holes);
}

}  // namespace treeline
