#include "description/suggestions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "functions/function.hpp"
#include "text/suggest_name.hpp"

namespace treeline {
namespace {

constexpr const char* kInverseKinematics =
    "no function finds joint angles; steps of \"forward_kinematics\" and \"jacobian\" do, and "
    "\"control_torque\" needs none";

/// Names of other libraries for our functions.
constexpr std::array kElsewhere = std::to_array<std::pair<std::string_view, const char*>>({
    {"aba", "\"forward_dynamics\" is computed so where that is cheapest"},
    {"bias_forces", "\"nonlinear_effects\" is b + g"},
    {"ccrba", "did you mean \"centroidal_momentum_matrix\"?"},
    {"cmm", "did you mean \"centroidal_momentum_matrix\"?"},
    {"com", "did you mean \"center_of_mass\"?"},
    {"com_jacobian", "did you mean \"center_of_mass_jacobian\"?"},
    {"coriolis",
     "\"coriolis_matrix\" is C; \"nonlinear_effects\" is b + g, \"gravity\" is g; their difference "
     "is b = C qd"},
    {"crba", "did you mean \"mass_matrix\"?"},
    {"derivatives",
     "derivatives are \"inverse_dynamics_derivatives\" and \"forward_dynamics_derivatives\""},
    {"energy", "\"kinetic_energy\" and \"potential_energy\" are computed apart"},
    {"fk", "did you mean \"forward_kinematics\"?"},
    {"id", "did you mean \"inverse_dynamics\"?"},
    {"ik", kInverseKinematics},
    {"inertia_matrix", "did you mean \"mass_matrix\"?"},
    {"inverse_kinematics", kInverseKinematics},
    {"joint_torque_regressor", "did you mean \"inverse_dynamics_regressor\"?"},
    {"jbar", "did you mean \"dynamically_consistent_inverse\"?"},
    {"mu", "did you mean \"operational_bias_force\"?"},
    {"nle", "did you mean \"nonlinear_effects\"?"},
    {"nullspace_projector", "did you mean \"null_space_projector\"?"},
    {"osc", "did you mean \"control_torque\"?"},
    {"osim", "\"lambda_inverse\" is J M^-1 J^T, \"lambda\" its inverse"},
    {"regressor", "did you mean \"inverse_dynamics_regressor\"?"},
    {"rnea", "did you mean \"inverse_dynamics\"?"},
    {"twist", "did you mean \"point_velocity\"?"},
});

std::vector<std::string> names_of(std::span<const Function> functions) {
  std::vector<std::string> names;
  for (const Function function : functions) names.emplace_back(function_name(function));
  return names;
}

}  // namespace

std::string suggest_function(std::string_view name) {
  if (name == "all") {
    return fmt::format(
        "leave out functions for all that the scene permits; these come only when they are "
        "listed:\n"
        "{}",
        list_names(names_of(kRequestedFunctions)));
  }
  for (const auto& [elsewhere, meaning] : kElsewhere) {
    if (name == elsewhere) return meaning;
  }
  return suggest_name(name, names_of(kSceneFunctions), "the functions are");
}

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
