#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <string_view>

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

/// What a function is about. Operational points, objects and contacts must be in the scene.
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

/// Which scenes get a function.
enum class Emitted {
  by_default,   ///< all that have what it is about and name no functions
  on_request,   ///< those that name it
  with_damping  ///< those with the key `damped`; it is composed of others and never named
};

/// Which matrix a function solves with: its errors grow with the condition of that matrix. M is
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
/// Of what is wanted in the frames of the URDF's links.
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

/// The same of a function that depends on inertia but not on weight. What changes a robot while it
/// runs is an argument only in scenes that list it under `inputs`.
template <class... Listed>
constexpr FunctionInputs inertial_inputs(Listed... listed) {
  return inputs(listed..., Quantity::payload, Quantity::parameters, Quantity::base_parameters);
}
/// The same of a function that depends on weight.
template <class... Listed>
constexpr FunctionInputs weighed_inputs(Listed... listed) {
  return inputs(listed..., Quantity::gravity, Quantity::payload, Quantity::parameters,
                Quantity::base_parameters);
}
/// The same of a function that depends on the masses of single links.
template <class... Listed>
constexpr FunctionInputs inputs_of_links(Listed... listed) {
  return inputs(listed..., Quantity::payload, Quantity::parameters);
}
constexpr FunctionInputs with(Quantity quantity, FunctionInputs listed) {
  listed.quantities[listed.count++] = quantity;
  return listed;
}
/// The same of a function that depends on where the origins of operational points are.
constexpr FunctionInputs with_tool_origin(const FunctionInputs& listed) {
  return with(Quantity::tool, listed);
}
/// The same of a function that depends on their axes, too.
constexpr FunctionInputs with_tool(const FunctionInputs& listed) {
  return with(Quantity::tool_orientation, with_tool_origin(listed));
}
/// The same of a function that depends on where contacts are.
constexpr FunctionInputs with_contact(const FunctionInputs& listed) {
  return with(Quantity::contact, listed);
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

/// Every function, in the order of the enumeration.
inline constexpr auto kFunctions = std::to_array<FunctionInfo>({
    {Function::forward_kinematics, "forward_kinematics", FunctionGroup::points, Emitted::by_default,
     Solve::none, frames_by(Function::forward_kinematics), Columns::computed,
     with_tool(inputs(Quantity::q)), "x_world = R x_point + p, for every operational point"},
    {Function::jacobian, "jacobian", FunctionGroup::points, Emitted::by_default, Solve::none,
     frames_by(Function::jacobian), Columns::computed, with_tool(inputs(Quantity::q)),
     "xd = J qd, rows stacked over operational points"},
    {Function::bias_acceleration, "bias_acceleration", FunctionGroup::points, Emitted::by_default,
     Solve::none, frames_by(Function::bias_acceleration), Columns::carried,
     with_tool(inputs(Quantity::q, Quantity::qd)), "xdd = J qdd + Jd qd: the term Jd qd"},
    {Function::inverse_dynamics, "inverse_dynamics", FunctionGroup::robot, Emitted::by_default,
     Solve::none, frames_by(Function::inverse_dynamics), Columns::carried,
     weighed_inputs(Quantity::q, Quantity::qd, Quantity::qdd, Quantity::f_ext),
     "tau = M qdd + b + g - J_ext^T f_ext"},
    {Function::gravity, "gravity", FunctionGroup::robot, Emitted::by_default, Solve::none,
     frames_by(Function::gravity), Columns::computed, weighed_inputs(Quantity::q),
     "g: the joint forces that hold the robot at rest"},
    {Function::nonlinear_effects, "nonlinear_effects", FunctionGroup::robot, Emitted::by_default,
     Solve::none, frames_by(Function::nonlinear_effects), Columns::carried,
     weighed_inputs(Quantity::q, Quantity::qd), "h = b + g: the joint forces at qdd = 0"},
    {Function::mass_matrix, "mass_matrix", FunctionGroup::robot, Emitted::by_default, Solve::none,
     frames_by(Function::mass_matrix), Columns::computed, inertial_inputs(Quantity::q),
     "tau = M qdd + b + g: the matrix M"},
    {Function::forward_dynamics, "forward_dynamics", FunctionGroup::robot, Emitted::by_default,
     Solve::mass_matrix, frames_by(Function::forward_dynamics), Columns::carried,
     weighed_inputs(Quantity::q, Quantity::qd, Quantity::tau, Quantity::f_ext, Quantity::step),
     "qdd = M^-1 (tau - b - g + J_ext^T f_ext)"},
    {Function::lambda_inverse, "lambda_inverse", FunctionGroup::points, Emitted::by_default,
     Solve::mass_matrix, frames_by(Function::forward_dynamics), Columns::computed,
     with_tool(inertial_inputs(Quantity::q)), "Lambda^-1 = J M^-1 J^T"},
    {Function::lambda, "lambda", FunctionGroup::points, Emitted::by_default, Solve::lambda_inverse,
     frames_by(Function::forward_dynamics), Columns::computed,
     with_tool(inertial_inputs(Quantity::q)), "Lambda = (J M^-1 J^T)^-1"},
    {Function::control_torque, "control_torque", FunctionGroup::points, Emitted::by_default,
     Solve::lambda_inverse, frames_by(Function::forward_dynamics), Columns::computed,
     with_tool(weighed_inputs(Quantity::q, Quantity::qd, Quantity::qdd_0, Quantity::xdd_cmd,
                              Quantity::f_ext)),
     "tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, "
     "F = Lambda (xdd_cmd - Jd qd - J qdd_0)"},
    {Function::object_state, "object_state", FunctionGroup::objects, Emitted::by_default,
     Solve::none, frames_by(Function::object_state), Columns::carried,
     inputs(Quantity::q, Quantity::qd),
     "x_world = R x_object + p, as the first grasp has the object"},
    {Function::object_control_torque, "object_control_torque", FunctionGroup::objects,
     Emitted::by_default, Solve::lambda_inverse, frames_by(Function::forward_dynamics),
     Columns::computed,
     weighed_inputs(Quantity::q, Quantity::qd, Quantity::qdd_0, Quantity::xdd_object,
                    Quantity::internal),
     "tau = J^T f + M qdd_0 + b + g, f = Lambda (C xdd - Jd qd - J qdd_0) + "
     "W^-1 [Lambda_obj xdd + mu_obj + p_obj; internal]"},
    {Function::object_forward_dynamics, "object_forward_dynamics", FunctionGroup::objects,
     Emitted::by_default, Solve::lambda_inverse, frames_by(Function::forward_dynamics),
     Columns::computed,
     weighed_inputs(Quantity::q, Quantity::qd, Quantity::tau, Quantity::stabilisation),
     "M qdd + b + g = tau - J^T f, Lambda_obj xdd + mu_obj + p_obj = C^T f, "
     "J qdd + Jd qd = C xdd - stabilisation[0] drift_rate - stabilisation[1] drift"},
    {Function::contact_motion, "contact_motion", FunctionGroup::contacts, Emitted::by_default,
     Solve::none, frames_by(Function::contact_motion), Columns::carried,
     with_contact(inputs(Quantity::q, Quantity::qd)),
     "positions of the contacts and their derivatives"},
    {Function::contact_inverse_inertia, "contact_inverse_inertia", FunctionGroup::contacts,
     Emitted::by_default, Solve::mass_matrix, frames_by(Function::forward_dynamics),
     Columns::computed, with_contact(inertial_inputs(Quantity::q)),
     "dv = Lambda_c^-1 y: velocities of the contacts by impulses there"},
    {Function::effective_mass, "effective_mass", FunctionGroup::contacts, Emitted::by_default,
     Solve::mass_matrix, frames_by(Function::forward_dynamics), Columns::computed,
     with_contact(inertial_inputs(Quantity::q, Quantity::normals)),
     "m = 1 / (n^T Lambda_c^-1 n), for every contact by itself"},
    {Function::impulse_response, "impulse_response", FunctionGroup::contacts, Emitted::by_default,
     Solve::mass_matrix, frames_by(Function::forward_dynamics), Columns::computed,
     with_contact(inertial_inputs(Quantity::q, Quantity::impulse)), "dqd = M^-1 J_c^T y"},
    {Function::constrained_forward_dynamics, "constrained_forward_dynamics",
     FunctionGroup::constraints, Emitted::by_default, Solve::lambda_inverse,
     frames_by(Function::forward_dynamics), Columns::computed,
     weighed_inputs(Quantity::q, Quantity::qd, Quantity::tau, Quantity::stabilisation,
                    Quantity::drift, Quantity::f_ext, Quantity::step),
     "M qdd + b + g = tau + J_s^T f + J_ext^T f_ext, "
     "J_s qdd + Jd_s qd = -stabilisation[0] J_s qd - stabilisation[1] drift"},
    {Function::supported_control_torque, "supported_control_torque", FunctionGroup::constraints,
     Emitted::by_default, Solve::lambda_inverse, frames_by(Function::forward_dynamics),
     Columns::computed,
     with_tool(weighed_inputs(Quantity::q, Quantity::qd, Quantity::qdd_0, Quantity::xdd_cmd,
                              Quantity::f_wanted, Quantity::f_ext)),
     "M qdd + b + g = tau + J_s^T f + J_ext^T f_ext, J_s qdd + Jd_s qd = 0, "
     "J qdd + Jd qd = xdd_cmd, tau = 0 at passive joints, qdd nearest to qdd_0"},
    {Function::constraint_jacobian, "constraint_jacobian", FunctionGroup::constraints,
     Emitted::on_request, Solve::none, kFramesAsBuilt, Columns::computed, inputs(Quantity::q),
     "J_s: rows that constraints hold have the velocities J_s qd, which are zero"},
    {Function::constraint_errors, "constraint_errors", FunctionGroup::constraints,
     Emitted::on_request, Solve::none, kFramesAsBuilt, Columns::computed, inputs(Quantity::q),
     "how far loops and couplings are from closed, by row: displacements, sines of turns, sums of "
     "coordinates; their derivatives are rows of J_s where they are closed"},
    {Function::link_inverse_inertias, "link_inverse_inertias", FunctionGroup::links,
     Emitted::on_request, Solve::mass_matrix, kFramesAsBuilt, Columns::computed,
     inertial_inputs(Quantity::q),
     "Lambda_i^-1 = J_i M^-1 J_i^T, for every link that moves against its parent"},
    {Function::center_of_mass, "center_of_mass", FunctionGroup::center_of_mass, Emitted::on_request,
     Solve::none, frames_by(Function::center_of_mass), Columns::computed,
     inertial_inputs(Quantity::q), "centre of mass: sum of m_i c_i over the mass of all links"},
    {Function::center_of_mass_jacobian, "center_of_mass_jacobian", FunctionGroup::center_of_mass,
     Emitted::on_request, Solve::none, frames_by(Function::center_of_mass_jacobian),
     Columns::computed, inertial_inputs(Quantity::q), "velocity of the centre of mass = J_com qd"},
    {Function::inverse_dynamics_derivatives, "inverse_dynamics_derivatives",
     FunctionGroup::derivatives, Emitted::on_request, Solve::none,
     frames_by(Function::forward_dynamics, Function::mass_matrix), Columns::computed,
     weighed_inputs(Quantity::q, Quantity::qd, Quantity::qdd, Quantity::f_ext),
     "derivatives of tau = M qdd + b + g - J_ext^T f_ext, f_ext held"},
    {Function::forward_dynamics_derivatives, "forward_dynamics_derivatives",
     FunctionGroup::derivatives, Emitted::on_request, Solve::mass_matrix,
     frames_by(Function::forward_dynamics, Function::mass_matrix), Columns::computed,
     weighed_inputs(Quantity::q, Quantity::qd, Quantity::tau, Quantity::f_ext),
     "derivatives of qdd = M^-1 (tau - b - g + J_ext^T f_ext), f_ext held"},
    {Function::coriolis_matrix, "coriolis_matrix", FunctionGroup::robot, Emitted::on_request,
     Solve::none, frames_by(Function::coriolis_matrix), Columns::computed,
     inertial_inputs(Quantity::q, Quantity::qd),
     "C qd = b, dM/dt - 2 C skew-symmetric: the matrix C"},
    {Function::kinetic_energy, "kinetic_energy", FunctionGroup::robot, Emitted::on_request,
     Solve::none, frames_by(Function::kinetic_energy), Columns::computed,
     inertial_inputs(Quantity::q, Quantity::qd), "T = qd^T M qd / 2"},
    {Function::kinetic_energy_derivatives, "kinetic_energy_derivatives", FunctionGroup::robot,
     Emitted::on_request, Solve::none, frames_by(Function::kinetic_energy), Columns::computed,
     inertial_inputs(Quantity::q, Quantity::qd), "derivatives of T = qd^T M qd / 2"},
    {Function::potential_energy, "potential_energy", FunctionGroup::robot, Emitted::on_request,
     Solve::none, frames_by(Function::potential_energy), Columns::computed,
     weighed_inputs(Quantity::q), "U = -sum of m_i gravity . c_i, zero at the world's origin"},
    {Function::inverse_dynamics_regressor, "inverse_dynamics_regressor", FunctionGroup::robot,
     Emitted::on_request, Solve::none, kFramesOfFiles, Columns::computed,
     inputs(Quantity::q, Quantity::qd, Quantity::qdd, Quantity::gravity),
     "M qdd + b + g = Y p: the matrix Y, for the parameters p listed above"},
    {Function::energy_regressor, "energy_regressor", FunctionGroup::robot, Emitted::on_request,
     Solve::none, kFramesOfFiles, Columns::computed,
     inputs(Quantity::q, Quantity::qd, Quantity::gravity),
     "[T; U] = E p: the matrix E, for the parameters p listed above"},
    {Function::centroidal_momentum_matrix, "centroidal_momentum_matrix",
     FunctionGroup::center_of_mass, Emitted::on_request, Solve::none,
     frames_by(Function::centroidal_momentum_matrix), Columns::computed,
     inertial_inputs(Quantity::q),
     "h_G = A_G qd: the matrix A_G; h_G is momentum over angular momentum about the centre of "
     "mass"},
    {Function::centroidal_momentum, "centroidal_momentum", FunctionGroup::center_of_mass,
     Emitted::on_request, Solve::none, frames_by(Function::centroidal_momentum), Columns::computed,
     inertial_inputs(Quantity::q, Quantity::qd),
     "h_G = A_G qd: momentum over angular momentum about the centre of mass"},
    {Function::centroidal_bias, "centroidal_bias", FunctionGroup::center_of_mass,
     Emitted::on_request, Solve::none, frames_by(Function::centroidal_bias), Columns::carried,
     inertial_inputs(Quantity::q, Quantity::qd),
     "dh_G/dt = A_G qdd + dA_G/dt qd: the term dA_G/dt qd"},
    {Function::center_of_mass_bias_acceleration, "center_of_mass_bias_acceleration",
     FunctionGroup::center_of_mass, Emitted::on_request, Solve::none,
     frames_by(Function::center_of_mass_bias_acceleration), Columns::carried,
     inertial_inputs(Quantity::q, Quantity::qd),
     "acceleration of the centre of mass = J_com qdd + dJ_com/dt qd: the term dJ_com/dt qd"},
    {Function::centroidal_momentum_derivatives, "centroidal_momentum_derivatives",
     FunctionGroup::center_of_mass, Emitted::on_request, Solve::none,
     frames_by(Function::centroidal_momentum_matrix), Columns::computed,
     inertial_inputs(Quantity::q, Quantity::qd), "derivatives of h_G = A_G qd"},
    {Function::centroidal_momentum_rate_derivatives, "centroidal_momentum_rate_derivatives",
     FunctionGroup::center_of_mass, Emitted::on_request, Solve::none,
     frames_by(Function::centroidal_momentum_matrix), Columns::computed,
     inertial_inputs(Quantity::q, Quantity::qd, Quantity::qdd),
     "derivatives of dh_G/dt = A_G qdd + dA_G/dt qd"},
    {Function::subtree_masses_and_centers, "subtree_masses_and_centers",
     FunctionGroup::center_of_mass, Emitted::on_request, Solve::none,
     frames_by(Function::subtree_masses_and_centers), Columns::computed,
     inputs_of_links(Quantity::q), "mass and centre of mass of everything that each joint carries"},
    {Function::point_velocity, "point_velocity", FunctionGroup::points, Emitted::on_request,
     Solve::none, frames_by(Function::point_velocity), Columns::computed,
     with_tool_origin(inputs(Quantity::q, Quantity::qd)),
     "[v; w] of every operational point, all six rows"},
    {Function::point_acceleration, "point_acceleration", FunctionGroup::points, Emitted::on_request,
     Solve::none, frames_by(Function::point_acceleration), Columns::carried,
     with_tool_origin(inputs(Quantity::q, Quantity::qd, Quantity::qdd)),
     "[dv/dt; dw/dt] of every operational point, all six rows, without gravity"},
    {Function::point_velocity_derivatives, "point_velocity_derivatives", FunctionGroup::points,
     Emitted::on_request, Solve::none, frames_by(Function::point_velocity), Columns::computed,
     with_tool_origin(inputs(Quantity::q, Quantity::qd)),
     "derivatives of [v; w] of every operational point, all six rows"},
    {Function::point_acceleration_derivatives, "point_acceleration_derivatives",
     FunctionGroup::points, Emitted::on_request, Solve::none, frames_by(Function::point_velocity),
     Columns::computed, with_tool_origin(inputs(Quantity::q, Quantity::qd, Quantity::qdd)),
     "derivatives of [dv/dt; dw/dt] of every operational point, all six rows"},
    {Function::dynamically_consistent_inverse, "dynamically_consistent_inverse",
     FunctionGroup::points, Emitted::on_request, Solve::lambda_inverse,
     frames_by(Function::forward_dynamics), Columns::computed,
     with_tool(inertial_inputs(Quantity::q)), "Jbar = M^-1 J^T Lambda, J Jbar = 1"},
    {Function::null_space_projector, "null_space_projector", FunctionGroup::points,
     Emitted::on_request, Solve::lambda_inverse, frames_by(Function::forward_dynamics),
     Columns::computed, with_tool(inertial_inputs(Quantity::q)),
     "N = 1 - Jbar J: J N = 0; N^T tau_0 does not accelerate the task"},
    {Function::operational_bias_force, "operational_bias_force", FunctionGroup::points,
     Emitted::on_request, Solve::lambda_inverse, frames_by(Function::forward_dynamics),
     Columns::computed, with_tool(inertial_inputs(Quantity::q, Quantity::qd)),
     "F = Lambda xdd + mu + p: the term mu = Jbar^T b - Lambda Jd qd"},
    {Function::operational_gravity, "operational_gravity", FunctionGroup::points,
     Emitted::on_request, Solve::lambda_inverse, frames_by(Function::forward_dynamics),
     Columns::computed, with_tool(weighed_inputs(Quantity::q)),
     "F = Lambda xdd + mu + p: the term p = Jbar^T g"},
    {Function::damped_control_torque, "damped_control_torque", FunctionGroup::points,
     Emitted::with_damping, Solve::damped, kFramesAsBuilt, Columns::computed,
     with_tool(weighed_inputs(Quantity::q, Quantity::qd, Quantity::qdd_0, Quantity::xdd_cmd,
                              Quantity::f_ext)),
     "tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, "
     "F = (Lambda^-1 + Delta)^-1 (xdd_cmd - Jd qd - J qdd_0)"},
});

static_assert(kFunctions.size() == static_cast<std::size_t>(Function::damped_control_torque) + 1,
              "every function has a row");
static_assert(
    [] {
      for (std::size_t i = 0; i < kFunctions.size(); ++i) {
        if (kFunctions[i].function != static_cast<Function>(i)) return false;
        for (std::size_t j = 0; j < i; ++j) {
          if (std::string_view(kFunctions[i].name) == kFunctions[j].name) return false;
        }
      }
      return true;
    }(),
    "rows are in the order of the enumeration, and no two names are the same");

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
/// Those that a scene with operational points has if it says nothing else.
inline constexpr auto kDefaultFunctions = select_functions<is_default_of_points>();
/// Those that a scene has only when it asks.
inline constexpr auto kRequestedFunctions = select_functions<is_emitted<Emitted::on_request>>();
/// Those about objects, which a scene may ask for only when it lists some.
inline constexpr auto kObjectFunctions = select_functions<is_about<FunctionGroup::objects>>();
/// Those about contacts, which a scene may ask for only when it lists some, and the inverse
/// inertias of all links, which it gets only when it asks.
inline constexpr auto kContactFunctions =
    select_functions<is_about<FunctionGroup::contacts, FunctionGroup::links>>();
/// Those that posture and balance laws need, which a scene gets only when it asks.
inline constexpr auto kPostureFunctions =
    select_functions<is_about<FunctionGroup::center_of_mass>>();
/// Those that optimisers need: long code, which a scene gets only when it asks.
inline constexpr auto kDerivativeFunctions =
    select_functions<is_about<FunctionGroup::derivatives>>();
/// Those that `damped_control_torque` is composed of.
inline constexpr std::array kDampedFunctions = {Function::jacobian, Function::bias_acceleration,
                                                Function::inverse_dynamics,
                                                Function::lambda_inverse};

}  // namespace treeline
