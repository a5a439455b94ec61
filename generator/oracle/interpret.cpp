#include "oracle/interpret.hpp"

#include <stdexcept>
#include <string>

#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"
#include "oracle/interpret_constraints.hpp"
#include "oracle/interpret_contacts.hpp"
#include "oracle/interpret_objects.hpp"

namespace treeline {
namespace {

using interpreter::Vector;

template <class Scalar>
std::vector<Scalar> poses(const Subject<Scalar>& subject, const Vector<Scalar>& q) {
  std::vector<Scalar> positions;
  std::vector<Scalar> rotations;
  for (const auto& pose :
       interpreter::forward_kinematics<Scalar>(subject.model, subject.points, q)) {
    append(pose.position, positions);
    append(pose.rotation, rotations);
  }
  positions.insert(positions.end(), rotations.begin(), rotations.end());
  return positions;
}

template <class Scalar>
std::vector<Scalar> derivatives(const interpreter::DynamicsDerivatives<Scalar>& of) {
  std::vector<Scalar> entries;
  append(of.by_displacement, entries);
  append(of.by_velocity, entries);
  append(of.by_drive, entries);
  return entries;
}

/// Those of links that move against their parents: masses, then centres.
template <class Scalar>
std::vector<Scalar> subtrees(const interpreter::Model<Scalar>& model, const Vector<Scalar>& q) {
  std::vector<Scalar> masses;
  std::vector<Scalar> centers;
  const auto all = interpreter::subtrees<Scalar>(model, q);
  for (int i = 0; i < model.size(); ++i) {
    if (model.body(i).kind == interpreter::JointKind::fixed) continue;
    masses.push_back(all[static_cast<std::size_t>(i)].mass);
    append(all[static_cast<std::size_t>(i)].center, centers);
  }
  masses.insert(masses.end(), centers.begin(), centers.end());
  return masses;
}

/// The numbers of a state in the interpreter's types.
template <class Scalar>
struct Numbers {
  explicit Numbers(const State& state)
      : q(vector_of<Scalar>(state.q)),
        qd(vector_of<Scalar>(state.qd)),
        qdd(vector_of<Scalar>(state.qdd)),
        tau(vector_of<Scalar>(state.tau)),
        xdd_cmd(vector_of<Scalar>(state.xdd_cmd)),
        f_ext(vector_of<Scalar>(state.f_ext)),
        step(vector_of<Scalar>(values_of(state, Quantity::step))) {}

  Vector<Scalar> q, qd, qdd, tau, xdd_cmd, f_ext, step;
};

template <class Scalar>
Vector<Scalar> forward_dynamics(const Subject<Scalar>& subject, const Numbers<Scalar>& at) {
  if (at.step.size() == 0) {
    return interpreter::forward_dynamics<Scalar>(subject.model, at.q, at.qd, at.tau,
                                                 subject.external, at.f_ext);
  }
  return interpreter::forward_dynamics_with_implicit_drives<Scalar>(
      subject.model, at.q, at.qd, at.tau, subject.external, at.f_ext, at.step(0));
}

/// Results of functions of joints and of the whole robot.
template <class Scalar>
std::vector<Scalar> of_robot(Function function, const Subject<Scalar>& subject,
                             const Numbers<Scalar>& at) {
  const auto& model = subject.model;
  const auto& external = subject.external;
  switch (function) {
    case Function::inverse_dynamics:
      return entries_of(
          interpreter::inverse_dynamics<Scalar>(model, at.q, at.qd, at.qdd, external, at.f_ext));
    case Function::gravity:
      return entries_of(interpreter::gravity<Scalar>(model, at.q));
    case Function::nonlinear_effects:
      return entries_of(interpreter::nonlinear_effects<Scalar>(model, at.q, at.qd));
    case Function::mass_matrix:
      return entries_of(interpreter::mass_matrix<Scalar>(model, at.q));
    case Function::forward_dynamics:
      return entries_of(forward_dynamics(subject, at));
    case Function::coriolis_matrix:
      return entries_of(interpreter::coriolis_matrix<Scalar>(model, at.q, at.qd));
    case Function::kinetic_energy:
      return {interpreter::kinetic_energy<Scalar>(model, at.q, at.qd)};
    case Function::kinetic_energy_derivatives:
      return derivatives(interpreter::kinetic_energy_derivatives<Scalar>(model, at.q, at.qd));
    case Function::potential_energy:
      return {interpreter::potential_energy<Scalar>(model, at.q)};
    case Function::inverse_dynamics_regressor:
      return entries_of(interpreter::inverse_dynamics_regressor<Scalar>(model, subject.regressor,
                                                                        at.q, at.qd, at.qdd));
    case Function::energy_regressor:
      return entries_of(
          interpreter::energy_regressor<Scalar>(model, subject.regressor, at.q, at.qd));
    case Function::center_of_mass:
      return entries_of(interpreter::center_of_mass<Scalar>(model, at.q));
    case Function::center_of_mass_jacobian:
      return entries_of(interpreter::center_of_mass_jacobian<Scalar>(model, at.q));
    case Function::centroidal_momentum_matrix:
      return entries_of(interpreter::centroidal_momentum_matrix<Scalar>(model, at.q));
    case Function::centroidal_momentum:
      return entries_of(interpreter::centroidal_momentum<Scalar>(model, at.q, at.qd));
    case Function::centroidal_bias:
      return entries_of(interpreter::centroidal_bias<Scalar>(model, at.q, at.qd));
    case Function::center_of_mass_bias_acceleration:
      return entries_of(interpreter::center_of_mass_bias_acceleration<Scalar>(model, at.q, at.qd));
    case Function::centroidal_momentum_derivatives:
      return derivatives(interpreter::centroidal_momentum_derivatives<Scalar>(model, at.q, at.qd));
    case Function::centroidal_momentum_rate_derivatives:
      return derivatives(
          interpreter::centroidal_momentum_rate_derivatives<Scalar>(model, at.q, at.qd, at.qdd));
    case Function::subtree_masses_and_centers:
      return subtrees(model, at.q);
    case Function::inverse_dynamics_derivatives:
      return derivatives(interpreter::inverse_dynamics_derivatives<Scalar>(
          model, at.q, at.qd, at.qdd, external, at.f_ext));
    case Function::forward_dynamics_derivatives:
      return derivatives(interpreter::forward_dynamics_derivatives<Scalar>(
          model, at.q, at.qd, at.tau, external, at.f_ext));
    case Function::forward_kinematics:
    case Function::jacobian:
    case Function::bias_acceleration:
    case Function::lambda_inverse:
    case Function::lambda:
    case Function::control_torque:
    case Function::point_velocity:
    case Function::point_acceleration:
    case Function::point_velocity_derivatives:
    case Function::point_acceleration_derivatives:
    case Function::dynamically_consistent_inverse:
    case Function::null_space_projector:
    case Function::operational_bias_force:
    case Function::operational_gravity:
    case Function::object_state:
    case Function::object_control_torque:
    case Function::object_forward_dynamics:
    case Function::contact_motion:
    case Function::contact_inverse_inertia:
    case Function::effective_mass:
    case Function::impulse_response:
    case Function::constrained_forward_dynamics:
    case Function::supported_control_torque:
    case Function::constraint_jacobian:
    case Function::constraint_errors:
    case Function::link_inverse_inertias:
    case Function::damped_control_torque:
      break;
  }
  throw std::logic_error(std::string(function_name(function)) + " is not of the robot as a whole");
}

template <class Scalar>
Vector<Scalar> control_torque(const Subject<Scalar>& subject, const Numbers<Scalar>& at,
                              const interpreter::TaskLaw<Scalar>& law) {
  if (law.borders.empty()) {
    return interpreter::control_torque<Scalar>(subject.model, subject.points, at.q, at.qd, at.qdd,
                                               at.xdd_cmd, subject.external, at.f_ext);
  }
  return interpreter::control_torque<Scalar>(subject.model, subject.points, at.q, at.qd, at.qdd,
                                             at.xdd_cmd, subject.external, at.f_ext, law);
}

template <class Scalar>
std::vector<Scalar> damped_control_torque(const Subject<Scalar>& subject,
                                          const Numbers<Scalar>& at) {
  const auto damped = interpreter::damped_control_torque<Scalar>(
      subject.model, subject.points, at.q, at.qd, at.qdd, at.xdd_cmd, subject.damping,
      subject.external, at.f_ext);
  std::vector<Scalar> entries = entries_of(damped.tau);
  entries.push_back(damped.ease);
  return entries;
}

/// Results of functions of operational points.
template <class Scalar>
std::vector<Scalar> of_points(Function function, const Subject<Scalar>& subject,
                              const Numbers<Scalar>& at, const interpreter::TaskLaw<Scalar>& law) {
  const auto& model = subject.model;
  const auto& points = subject.points;
  switch (function) {
    case Function::forward_kinematics:
      return poses(subject, at.q);
    case Function::jacobian:
      return entries_of(interpreter::jacobian<Scalar>(model, points, at.q));
    case Function::bias_acceleration:
      return entries_of(interpreter::bias_acceleration<Scalar>(model, points, at.q, at.qd));
    case Function::lambda_inverse:
      return entries_of(interpreter::lambda_inverse<Scalar>(model, points, at.q));
    case Function::lambda:
      return entries_of(law.borders.empty()
                            ? interpreter::lambda<Scalar>(model, points, at.q)
                            : interpreter::lambda<Scalar>(model, points, at.q, law));
    case Function::point_velocity:
      return entries_of(interpreter::point_velocity<Scalar>(model, points, at.q, at.qd));
    case Function::point_acceleration:
      return entries_of(
          interpreter::point_acceleration<Scalar>(model, points, at.q, at.qd, at.qdd));
    case Function::point_velocity_derivatives:
      return derivatives(
          interpreter::point_velocity_derivatives<Scalar>(model, points, at.q, at.qd));
    case Function::point_acceleration_derivatives:
      return derivatives(
          interpreter::point_acceleration_derivatives<Scalar>(model, points, at.q, at.qd, at.qdd));
    case Function::dynamically_consistent_inverse:
      return entries_of(
          interpreter::dynamically_consistent_inverse<Scalar>(model, points, at.q, law));
    case Function::null_space_projector:
      return entries_of(interpreter::null_space_projector<Scalar>(model, points, at.q, law));
    case Function::operational_bias_force:
      return entries_of(
          interpreter::operational_bias_force<Scalar>(model, points, at.q, at.qd, law));
    case Function::operational_gravity:
      return entries_of(interpreter::operational_gravity<Scalar>(model, points, at.q, law));
    case Function::control_torque:
      return entries_of(control_torque(subject, at, law));
    case Function::damped_control_torque:
      return damped_control_torque(subject, at);
    default:
      throw std::logic_error(std::string(function_name(function)) + " is not about points");
  }
}

}  // namespace

template <class Scalar>
std::vector<Scalar> interpret(Function function, const Subject<Scalar>& subject, const State& state,
                              const interpreter::TaskLaw<Scalar>& law) {
  switch (info_of(function).group) {
    case FunctionGroup::objects:
      return interpret_objects(function, subject, state, law);
    case FunctionGroup::contacts:
    case FunctionGroup::links:
      return interpret_contacts(function, subject, state, law);
    case FunctionGroup::constraints:
      return interpret_constraints(function, subject, state, law);
    case FunctionGroup::points:
      return of_points(function, subject, Numbers<Scalar>(state), law);
    case FunctionGroup::robot:
    case FunctionGroup::center_of_mass:
    case FunctionGroup::derivatives:
      break;
  }
  return of_robot(function, subject, Numbers<Scalar>(state));
}

template std::vector<float> interpret(Function, const Subject<float>&, const State&,
                                      const interpreter::TaskLaw<float>&);
template std::vector<double> interpret(Function, const Subject<double>&, const State&,
                                       const interpreter::TaskLaw<double>&);
template std::vector<interpreter::Digits50> interpret(
    Function, const Subject<interpreter::Digits50>&, const State&,
    const interpreter::TaskLaw<interpreter::Digits50>&);

}  // namespace treeline
