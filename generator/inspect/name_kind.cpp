#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "inspect/end_names.hpp"
#include "inspect/recognise_robot.hpp"

namespace treeline {
namespace {

/// How many limbs of each role a robot has. Wheels and propellers count that are links of the base,
/// as in files that leave out their joints.
struct LimbCounts {
  long legs = 0, arms = 0, fingers = 0, wheels = 0, propellers = 0, surfaces = 0, furniture = 0;
};

LimbCounts count_limbs(const Robot& robot, const Body& base, const std::vector<Limb>& limbs) {
  std::map<LimbRole, long> number;
  LimbCounts counts;
  for (const Limb& limb : limbs) {
    const bool is_limb = limb.role == LimbRole::leg || limb.role == LimbRole::arm;
    if (limb.is_side_branch && is_limb) continue;
    ++number[limb.role];
    if (limb.role == LimbRole::unknown && limb.joints >= kJointsOfAnArm && limb.masses != 1) {
      ++counts.arms;
    }
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
  counts.surfaces = number[LimbRole::surface];
  counts.furniture =
      std::count_if(robot.joints.begin(), robot.joints.end(), [](const Joint& joint) {
        return joint.type != JointType::fixed && is_furniture(joint.name);
      });
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

/// Why nothing holds a robot that flies or swims: its fins, or a word in the names of its links.
std::optional<std::string> why_nothing_holds(const Robot& robot, long surfaces) {
  if (surfaces >= 2) return "it moves by fins, wings or thrusters";
  const auto quote = [](const std::string& word) {
    return fmt::format("the file has the word \"{}\" in its names", word);
  };
  for (const Link& link : robot.links) {
    if (const auto word = word_of_flight(link.name)) return quote(*word);
  }
  const auto word = word_of_flight(robot.name);
  return word ? std::optional(quote(*word)) : std::nullopt;
}

std::string kind_with_fingers(const Robot& robot, const std::string& prefix, long fingers) {
  const long driven = std::count_if(robot.joints.begin(), robot.joints.end(), [](const Joint& j) {
    return j.type != JointType::fixed && !j.mimic;
  });
  if (!prefix.empty()) return is_hand(prefix) ? "a hand" : "a gripper";
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
  const std::string carried =
      fmt::format("an arm or a stand holds it by the root link \"{}\"", root);
  if (end_name(found.prefix).kind == EndKind::foot && has.legs < 2) {
    take("a foot", false, fmt::format("a leg holds it by the root link \"{}\"", root));
  } else if (has.legs >= 2) {
    take(kind_with_legs(has.legs, has.arms), true,
         fmt::format("it stands on {} legs that nothing holds to the ground", has.legs));
  } else if (has.propellers >= 2) {
    take(has.arms > 0 ? "a flying robot with an arm" : "a drone", true, "it flies by propellers");
  } else if (const auto reason = why_nothing_holds(robot, has.surfaces)) {
    take(has.arms > 0 ? "a flying or swimming robot with an arm" : "a flying or swimming robot",
         true, *reason);
  } else if (has.furniture >= 2) {
    take("a piece of furniture", false, "it has drawers or doors");
  } else if (has.wheels >= 2) {
    take(has.arms > 0 ? "a mobile manipulator" : "a wheeled base", true,
         "it rolls on wheels; where it stands still while an arm works, fixed is enough");
  } else if (has.fingers > 0 && has.arms == 0) {
    take(kind_with_fingers(robot, found.prefix, has.fingers), false, carried);
  } else if (end_name(root).kind == EndKind::foot && has.arms > 0) {
    take("a robot that stands on its root link", false,
         fmt::format("it stands on the root link \"{}\"", root));
  } else if (found.limbs.empty()) {
    take("a single body", false, "nothing says that it floats");
  } else {
    take(has.arms == 0   ? (has.legs == 1 ? "a leg" : "a mechanism")
         : has.arms == 1 ? "an arm"
                         : fmt::format("a robot of {} arms", has.arms),
         false,
         fmt::format("the file has no legs, wheels or propellers, and the root link \"{}\" is "
                     "taken as held by the ground",
                     root));
  }
}

}  // namespace treeline
