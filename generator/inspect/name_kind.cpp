#include "inspect/name_kind.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "inspect/end_names.hpp"

namespace treeline {
namespace {

/// How many limbs of each role a robot has. Wheels and propellers count that are links of the base,
/// as in files that leave out their joints.
struct LimbCounts {
  long legs = 0, arms = 0, fingers = 0, wheels = 0, propellers = 0;
};

LimbCounts count_limbs(const Robot& robot, const Body& base, const std::vector<Limb>& limbs) {
  std::map<LimbRole, long> number;
  LimbCounts counts;
  for (const Limb& limb : limbs) {
    const bool is_limb = limb.role == LimbRole::leg || limb.role == LimbRole::arm;
    if (limb.is_side_branch && is_limb) continue;
    ++number[limb.role];
    if (limb.role == LimbRole::unknown && limb.joints >= kJointsOfAnArm) ++counts.arms;
  }
  for (const int l : base.links) {
    const LimbRole role = limb_word(robot.links[static_cast<std::size_t>(l)].name);
    if (role == LimbRole::wheel || role == LimbRole::propeller) ++number[role];
  }
  counts.legs = number[LimbRole::leg];
  counts.arms += number[LimbRole::arm];
  counts.fingers = number[LimbRole::finger];
  counts.wheels = number[LimbRole::wheel];
  counts.propellers = number[LimbRole::propeller];
  return counts;
}

std::string plural(long number, const char* one, const char* many) {
  return number == 1 ? fmt::format("one {}", one) : fmt::format("{} {}", number, many);
}

std::string kind_with_legs(long legs, long arms) {
  if (legs == 2) return arms > 0 ? "a humanoid" : "a biped";
  const std::string name = legs == 4 ? "a quadruped" : "a robot of " + plural(legs, "leg", "legs");
  return arms > 0 ? name + " with " + plural(arms, "arm", "arms") : name;
}

/// The first word of a link's name that says that nothing holds the robot.
std::optional<std::string> find_word_of_flight(const Robot& robot) {
  for (const Link& link : robot.links) {
    if (const auto word = word_of_flight(link.name)) return word;
  }
  return word_of_flight(robot.name);
}

std::string kind_with_fingers(const Robot& robot, long fingers) {
  const long driven = std::count_if(robot.joints.begin(), robot.joints.end(), [](const Joint& j) {
    return j.type != JointType::fixed && !j.mimic;
  });
  return fingers == 1 ? "a finger" : fingers == 2 || driven <= 2 ? "a gripper" : "a hand";
}

}  // namespace

void name_kind(const Robot& robot, const Body& base, RecognisedRobot& found) {
  const LimbCounts has = count_limbs(robot, base, found.limbs);
  const std::string& root = robot.links[static_cast<std::size_t>(robot.root)].name;
  const auto take = [&](std::string kind, bool floats, std::string reason) {
    found.kind = std::move(kind);
    found.floats = floats;
    found.reason = std::move(reason);
  };
  if (has.legs >= 2) {
    take(kind_with_legs(has.legs, has.arms), true,
         fmt::format("it stands on {} legs that nothing holds to the ground", has.legs));
  } else if (has.propellers >= 2) {
    take(has.arms > 0 ? "a flying robot with an arm" : "a drone", true, "it flies by propellers");
  } else if (const auto word = find_word_of_flight(robot)) {
    take(has.arms > 0 ? "a flying or swimming robot with an arm" : "a flying or swimming robot",
         true, fmt::format("the file has the word \"{}\" in its names", *word));
  } else if (has.wheels >= 2) {
    take(has.arms > 0 ? "a mobile manipulator" : "a wheeled base", true,
         "it rolls on wheels; where it stands still while an arm works, fixed is enough");
  } else if (has.fingers > 0 && has.arms == 0) {
    take(kind_with_fingers(robot, has.fingers), false,
         fmt::format("an arm or a stand holds it by the root link \"{}\"", root));
  } else if (end_name(root).kind == EndKind::foot && has.arms > 0) {
    take("a robot that stands on its root link", false,
         fmt::format("it stands on the root link \"{}\"", root));
  } else if (found.limbs.empty()) {
    take("a single body", false, "nothing says that it floats");
  } else {
    take(has.arms == 0   ? "a mechanism"
         : has.arms == 1 ? "an arm"
                         : fmt::format("a robot of {} arms", has.arms),
         false,
         fmt::format("the file has no legs, wheels or propellers, and the root link \"{}\" is "
                     "taken as held by the ground",
                     root));
  }
}

}  // namespace treeline
