#include "description/suggest_key.hpp"

#include <algorithm>
#include <string>

#include "text/suggest_name.hpp"

namespace treeline {
namespace {

constexpr const char* kPoint =
    "operational_points: [{name: tool, link: LINK}] names points to control";
constexpr const char* kPayload =
    "inputs: {payload: LINK} makes a body at this link an argument of the functions";
constexpr const char* kFriction =
    "joint_friction: viscous or coulomb counts what the robot's file states, or a map from joint "
    "to numbers";
constexpr const char* kRotors =
    "armature: file counts rotors that the robot's file states, or a map from joint to inertia";
constexpr const char* kGains =
    "controller: {laws: joint_impedance, joint_frequency: 20} has gains; functions have none";
constexpr const char* kLimits =
    "the robot's file states them; torque_limits and controller: {laws: ..., limits: ...} use them";
constexpr const char* kBody =
    "the URDF's <inertial> states it; inputs: {parameters: [LINK]} makes it an argument";
constexpr const char* kPrefetch =
    "leave it out: a function that is called once while the program waits is in the caches";

/// What other programs, people and releases before this one call what a key of the scene says.
struct OtherWord {
  std::string_view word;
  const char* key;  ///< where this one is known
  const char* advice;
};
constexpr OtherWord kWords[] = {
    {"damping", "joint_friction", kFriction},
    {"ee", "operational_points", kPoint},
    {"ee_link", "operational_points", kPoint},
    {"end_effector", "operational_points", kPoint},
    {"end_effectors", "operational_points", kPoint},
    {"friction", "joint_friction", kFriction},
    {"gains", "controller", kGains},
    {"inertia", "inputs", kBody},
    {"joint_limits", "torque_limits", kLimits},
    {"kd", "controller", kGains},
    {"kp", "controller", kGains},
    {"limits", "torque_limits", kLimits},
    {"load", "inputs", kPayload},
    {"mass", "inputs", kBody},
    {"motor_inertia", "armature", kRotors},
    {"payload", "inputs", kPayload},
    {"prefetch", "functions", kPrefetch},
    {"rotor_inertia", "armature", kRotors},
    {"stiffness", "joint_springs", "joint_springs: {JOINT: {stiffness: ..., rest: ...}} holds it"},
    {"tcp", "operational_points", kPoint},
    {"tip", "operational_points", kPoint},
    {"tool", "operational_points", kPoint},
    {"tool_frame", "operational_points", kPoint},
    {"urdf", "robots",
     "the URDF is named on the command line; robots: lists several robots in one scene"},
    {"viscous_friction", "joint_friction", kFriction},
};

}  // namespace

std::string suggest_key(std::string_view key, const std::vector<std::string>& known) {
  for (const OtherWord& each : kWords) {
    if (key == each.word && std::find(known.begin(), known.end(), each.key) != known.end()) {
      return each.advice;
    }
  }
  return suggest_name(key, known, "the keys here are");
}

}  // namespace treeline
