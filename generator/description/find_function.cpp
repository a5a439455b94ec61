#include "description/find_function.hpp"

#include <fmt/format.h>

#include <array>
#include <span>
#include <utility>

#include "description/suggest_name.hpp"

namespace treeline {
namespace {

/// What goes by other names elsewhere.
constexpr std::array kElsewhere = std::to_array<std::pair<std::string_view, const char*>>({
    {"aba", "\"forward_dynamics\" is computed so where that is cheapest"},
    {"bias_forces", "\"nonlinear_effects\" is b + g"},
    {"com", "did you mean \"center_of_mass\"?"},
    {"com_jacobian", "did you mean \"center_of_mass_jacobian\"?"},
    {"coriolis", "\"nonlinear_effects\" is b + g, \"gravity\" is g; their difference is C qd"},
    {"coriolis_matrix",
     "\"nonlinear_effects\" is b + g, \"gravity\" is g; their difference is C qd, and C itself is "
     "not generated"},
    {"crba", "did you mean \"mass_matrix\"?"},
    {"inertia_matrix", "did you mean \"mass_matrix\"?"},
    {"osim", "\"lambda_inverse\" is J M^-1 J^T, \"lambda\" its inverse"},
    {"rnea", "did you mean \"inverse_dynamics\"?"},
});

/// Those that a scene gets only when it asks.
std::vector<std::string> names_of_unasked() {
  std::vector<std::string> names;
  for (const Function function : every_function()) {
    if (is_about_posture(function) || is_derivative(function) ||
        function == Function::link_inverse_inertias) {
      names.emplace_back(function_name(function));
    }
  }
  return names;
}

}  // namespace

std::vector<Function> every_function() {
  std::vector<Function> every;
  const auto append = [&](std::span<const Function> functions) {
    for (const Function function : functions) every.push_back(function);
  };
  append(kAllFunctions);
  append(kContactFunctions);
  append(kObjectFunctions);
  append(kPostureFunctions);
  append(kDerivativeFunctions);
  return every;
}

std::optional<Function> find_function(std::string_view name) {
  for (const Function function : every_function()) {
    if (name == function_name(function)) return function;
  }
  return std::nullopt;
}

std::string suggest_function(std::string_view name) {
  if (name == "all") {
    return fmt::format(
        "leave out functions for all that the scene permits; these come only when they are "
        "listed:\n"
        "{}",
        list_names(names_of_unasked()));
  }
  for (const auto& [elsewhere, meaning] : kElsewhere) {
    if (name == elsewhere) return meaning;
  }
  std::vector<std::string> known;
  for (const Function function : every_function()) known.emplace_back(function_name(function));
  return suggest_name(name, known, "the functions are");
}

}  // namespace treeline
