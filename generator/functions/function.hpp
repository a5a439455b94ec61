#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "functions/function_rows.hpp"

namespace treeline {

constexpr const FunctionInfo& info_of(Function function) {
  return kFunctions[static_cast<std::size_t>(function)];
}
constexpr const char* function_name(Function function) {
  return info_of(function).name;
}
constexpr Solve solve_of(Function function) {
  return info_of(function).solve;
}

constexpr bool needs_points(Function function) {
  return info_of(function).group == FunctionGroup::points ||
         function == Function::supported_control_torque;
}
constexpr bool needs_objects(Function function) {
  return info_of(function).group == FunctionGroup::objects;
}
constexpr bool needs_contacts(Function function) {
  return info_of(function).group == FunctionGroup::contacts;
}
constexpr bool needs_constraints(Function function) {
  return info_of(function).group == FunctionGroup::constraints;
}
constexpr bool needs_mass(Function function) {
  return info_of(function).group == FunctionGroup::center_of_mass;
}
constexpr bool inverts_mass_matrix(Function function) {
  return solve_of(function) != Solve::none;
}
constexpr bool takes(Function function, Quantity quantity) {
  const FunctionInputs& inputs = info_of(function).inputs;
  return std::find(inputs.begin(), inputs.end(), quantity) != inputs.end();
}
constexpr bool takes_external_forces(Function function) {
  return takes(function, Quantity::f_ext);
}
/// Whether the result has Lambda in it, of which rows of the task yield near singularities.
constexpr bool has_lambda(Function function) {
  return needs_points(function) && solve_of(function) == Solve::lambda_inverse;
}
/// Whether it depends on the robot's mass or on where its centre of mass is: on a fixed base, on
/// more than the base parameters.
constexpr bool depends_on_mass(Function function) {
  return needs_mass(function) || function == Function::potential_energy;
}
/// Whether its columns are those of inertial parameters, which the scene's key `regressor` lists.
constexpr bool is_regressor(Function function) {
  return function == Function::inverse_dynamics_regressor || function == Function::energy_regressor;
}
constexpr bool is_derivative(Function function) {
  return info_of(function).group == FunctionGroup::derivatives;
}

/// The functions whose rows satisfy a predicate, as an array in the order of the rows.
template <bool (*predicate)(const FunctionInfo&)>
constexpr auto select_functions() {
  constexpr auto count =
      static_cast<std::size_t>(std::count_if(kFunctions.begin(), kFunctions.end(), predicate));
  std::array<Function, count> functions{};
  std::size_t filled = 0;
  for (const FunctionInfo& row : kFunctions) {
    if (predicate(row)) functions[filled++] = row.function;
  }
  return functions;
}
template <FunctionGroup... groups>
constexpr bool is_about(const FunctionInfo& row) {
  return ((row.group == groups) || ...);
}
template <Emitted emitted>
constexpr bool is_emitted(const FunctionInfo& row) {
  return row.emitted == emitted;
}
constexpr bool is_nameable(const FunctionInfo& row) {
  return !is_emitted<Emitted::with_damping>(row);
}
constexpr bool is_default_of_points(const FunctionInfo& row) {
  return is_emitted<Emitted::by_default>(row) &&
         is_about<FunctionGroup::robot, FunctionGroup::points>(row);
}

/// All that a scene may ask for.
inline constexpr auto kSceneFunctions = select_functions<is_nameable>();
/// Functions that a scene with operational points has if it names no functions.
inline constexpr auto kDefaultFunctions = select_functions<is_default_of_points>();
/// Functions that a scene has only when it asks for them.
inline constexpr auto kRequestedFunctions = select_functions<is_emitted<Emitted::on_request>>();
/// Functions about objects. A scene may ask for them only when it lists objects.
inline constexpr auto kObjectFunctions = select_functions<is_about<FunctionGroup::objects>>();
/// Functions about contacts, for which a scene may ask only when it lists contacts, and the inverse
/// inertias of all links, which it has only when it asks for them.
inline constexpr auto kContactFunctions =
    select_functions<is_about<FunctionGroup::contacts, FunctionGroup::links>>();
/// Functions for posture and balance laws. A scene has them only when it asks for them.
inline constexpr auto kPostureFunctions =
    select_functions<is_about<FunctionGroup::center_of_mass>>();
/// Functions for optimisers: long code, which a scene has only when it asks for it.
inline constexpr auto kDerivativeFunctions =
    select_functions<is_about<FunctionGroup::derivatives>>();
/// Functions of which `damped_control_torque` is composed.
inline constexpr std::array kDampedFunctions = {Function::jacobian, Function::bias_acceleration,
                                                Function::inverse_dynamics,
                                                Function::lambda_inverse};

/// The function of that name that a scene may ask for; nothing when there is none.
std::optional<Function> find_function(std::string_view name);

/// The symbol of the matrix that is solved with; empty where there is none.
const char* matrix_symbol(Solve solve);

/// Symbols of the matrices that are inverted, with M before one that is made by inverting M.
std::string matrix_symbols(Solve solve);

}  // namespace treeline
