#include <fmt/format.h>

#include <algorithm>

#include "description/robot_queries.hpp"
#include "generation/append_notes.hpp"

namespace treeline {
namespace {

constexpr const char* kFrictionNote =
    "b contains friction, joint by joint: d qd + f s(qd / w), where s is within 1.3e-5 of tanh up "
    "to "
    "2600 w and above 0.995 up to 5461 w; coriolis_matrix has no friction";
constexpr const char* kSpringNote =
    "g contains springs, joint by joint: k (q - rest); potential_energy has theirs";

bool slides(const Robot& robot, const std::string& joint) {
  return info_of(find_joint(robot, joint)->type).slides();
}

std::string friction_text(const SceneFriction& own, bool slides) {
  const char* const rate = slides ? "N s/m" : "N m s/rad";
  std::string text;
  if (own.damping > 0) text += fmt::format("d = {:.6g} {}", own.damping, rate);
  if (own.friction > 0) {
    text += fmt::format("{}f = {:.6g} {}, w = {:.6g} {}", text.empty() ? "" : ", ", own.friction,
                        slides ? "N" : "N m", own.width, slides ? "m/s" : "rad/s");
  }
  return text;
}

}  // namespace

void append_drive_notes(const Robot& robot, const Scene& scene, std::vector<std::string>& notes) {
  for (const auto& [joint, inertia] : scene.armature) {
    notes.push_back(fmt::format("a rotor adds {:.6g} {} to joint {}", inertia,
                                slides(robot, joint) ? "kg" : "kg m^2", joint));
  }
  for (const auto& [joint, rotor] : scene.rotors) {
    notes.push_back(fmt::format(
        "the rotor of joint {} is a body of {:.6g} kg m^2 about its axis, which turns {:.6g} times "
        "as fast as the joint{}",
        joint, rotor.inertia, rotor.ratio,
        rotor.link.empty() ? "" : fmt::format(", on link {}", rotor.link)));
  }
  if (!scene.joint_friction.empty()) notes.emplace_back(kFrictionNote);
  for (const auto& [joint, own] : scene.joint_friction) {
    notes.push_back(
        fmt::format("friction of joint {}: {}", joint, friction_text(own, slides(robot, joint))));
  }
  if (!scene.joint_springs.empty()) notes.emplace_back(kSpringNote);
  for (const auto& [joint, own] : scene.joint_springs) {
    const bool along = slides(robot, joint);
    notes.push_back(fmt::format("spring of joint {}: k = {:.6g} {}, rest = {:.6g} {}", joint,
                                own.stiffness, along ? "N/m" : "N m/rad", own.rest,
                                along ? "m" : "rad"));
  }
}

}  // namespace treeline
