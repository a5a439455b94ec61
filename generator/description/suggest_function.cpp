#include "description/suggest_function.hpp"

#include <fmt/format.h>

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

}  // namespace treeline
