#pragma once

#include <array>
#include <cstddef>

#include "functions/quantity.hpp"

namespace treeline {

/// The functions that can be generated. All that is known of one before any algorithm is its row in
/// `kFunctions`; a scene asks for it by its name there.
enum class Function {
  forward_kinematics,
  jacobian,
  bias_acceleration,
  inverse_dynamics,
  gravity,
  nonlinear_effects,
  mass_matrix,
  forward_dynamics,
  lambda_inverse,
  lambda,
  control_torque,
  object_state,
  object_control_torque,
  object_forward_dynamics,
  contact_motion,
  contact_inverse_inertia,
  effective_mass,
  impulse_response,
  constrained_forward_dynamics,
  supported_control_torque,
  constraint_jacobian,
  constraint_errors,
  link_inverse_inertias,
  center_of_mass,
  center_of_mass_jacobian,
  inverse_dynamics_derivatives,
  forward_dynamics_derivatives,
  coriolis_matrix,
  kinetic_energy,
  kinetic_energy_derivatives,
  potential_energy,
  inverse_dynamics_regressor,
  energy_regressor,
  centroidal_momentum_matrix,
  centroidal_momentum,
  centroidal_bias,
  center_of_mass_bias_acceleration,
  centroidal_momentum_derivatives,
  centroidal_momentum_rate_derivatives,
  subtree_masses_and_centers,
  point_velocity,
  point_acceleration,
  point_velocity_derivatives,
  point_acceleration_derivatives,
  dynamically_consistent_inverse,
  null_space_projector,
  operational_bias_force,
  operational_gravity,
  damped_control_torque,
};

/// Subject of a function. Operational points, objects and contacts must be in the scene.
enum class FunctionGroup {
  robot,           ///< joints and the robot as a whole
  points,          ///< operational points
  objects,         ///< objects in the hands
  contacts,        ///< points where impulses act
  constraints,     ///< rows that constraints hold, and joints without a motor
  links,           ///< every link
  center_of_mass,  ///< some link must have mass
  derivatives,     ///< of forward and inverse dynamics
};

/// Condition under which a scene gets a function.
enum class Emitted {
  by_default,   ///< all that have what it is about and name no functions
  on_request,   ///< scenes that name it
  with_damping  ///< scenes with the key `damped`; it is composed of others and never named
};

/// Matrix that a function solves with: its errors grow with the condition of that matrix. M is
/// positive definite everywhere, Lambda^-1 singular in some configurations, Lambda^-1 + Delta in
/// none. Each of them needs the inverse of M.
enum class Solve { none, mass_matrix, lambda_inverse, damped };

/// The functions whose operations are counted to choose the frames that links are computed in for a
/// function: itself where it is one recursion, forward dynamics where inertias and motions both
/// count; of two choices the one in which the function itself is cheaper. None: frames are as the
/// mechanism has them. Derivatives would be slow to trace for every choice, and what that saved of
/// their operations cost them lanes (measured).
struct FrameCost {
  std::array<Function, 2> functions{};
  std::size_t count = 0;
  bool of_files = false;  ///< not even moved from where the URDF has them, but for z on the axis

  [[nodiscard]] constexpr const Function* begin() const { return functions.data(); }
  [[nodiscard]] constexpr const Function* end() const { return functions.data() + count; }
};
constexpr FrameCost frames_by(Function function) {
  return {{function, function}, 1};
}
constexpr FrameCost frames_by(Function first, Function second) {
  return {{first, second}, 2};
}
inline constexpr FrameCost kFramesAsBuilt{};
/// Frame cost of results that are wanted in the frames of the URDF's links.
inline constexpr FrameCost kFramesOfFiles{{}, 0, true};

/// Whether columns of the matrix of accelerations may be handed from link to link where frames are
/// chosen by the cost of this function, see `MovingLink::carries_column`.
enum class Columns { computed, carried };

/// Arguments in the order of the contract. Those of no size, as f_ext in a scene without external
/// forces, are left out of it.
struct FunctionInputs {
  std::array<Quantity, 16> quantities{};
  std::size_t count = 0;

  [[nodiscard]] constexpr const Quantity* begin() const { return quantities.data(); }
  [[nodiscard]] constexpr const Quantity* end() const { return quantities.data() + count; }
};

template <class... Listed>
constexpr FunctionInputs inputs(Listed... listed) {
  return {{listed...}, sizeof...(listed)};
}

/// Inputs of a function that depends on inertia but not on weight. Properties that change while a
/// robot runs are arguments only in scenes that list them under `inputs`.
template <class... Listed>
constexpr FunctionInputs inertial_inputs(Listed... listed) {
  return inputs(listed..., Quantity::payload, Quantity::parameters, Quantity::base_parameters);
}
/// Inputs of a function that depends on weight.
template <class... Listed>
constexpr FunctionInputs weighed_inputs(Listed... listed) {
  return inputs(listed..., Quantity::gravity, Quantity::payload, Quantity::parameters,
                Quantity::base_parameters);
}
/// Inputs of a function that depends on the masses of single links.
template <class... Listed>
constexpr FunctionInputs inputs_of_links(Listed... listed) {
  return inputs(listed..., Quantity::payload, Quantity::parameters);
}
constexpr FunctionInputs with(Quantity quantity, FunctionInputs listed) {
  listed.quantities[listed.count++] = quantity;
  return listed;
}
/// Inputs of a function that also depends on the origins of operational points.
constexpr FunctionInputs with_tool_origin(const FunctionInputs& listed) {
  return with(Quantity::tool, listed);
}
/// Inputs of a function that also depends on the axes and origins of operational points.
constexpr FunctionInputs with_tool(const FunctionInputs& listed) {
  return with(Quantity::tool_orientation, with_tool_origin(listed));
}
/// Inputs of a function that also depends on the origins of contacts.
constexpr FunctionInputs with_contact(const FunctionInputs& listed) {
  return with(Quantity::contact, listed);
}
/// Inputs of a function that holds constraints.
constexpr FunctionInputs with_activity(const FunctionInputs& listed) {
  return with(Quantity::active, listed);
}

/// Inputs of a function that does the tasks of operational points.
constexpr FunctionInputs with_tasks(const FunctionInputs& listed) {
  return with(Quantity::active_tasks, with_tool(listed));
}

/// All that is known of a function before any algorithm.
struct FunctionInfo {
  Function function;
  const char* name;  ///< in scenes and in emitted code
  FunctionGroup group;
  Emitted emitted;
  Solve solve;
  FrameCost frames;
  Columns columns;
  FunctionInputs inputs;
  const char* equation;  ///< as contracts tell it
};

}  // namespace treeline
