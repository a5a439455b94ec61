#include "check/interpret.hpp"

#include <stdexcept>
#include <string>

#include "check/entries.hpp"
#include "check/interpret_contacts.hpp"
#include "check/interpret_objects.hpp"
#include "interpreter/instances.hpp"

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

}  // namespace

template <class Scalar>
std::vector<Scalar> interpret(Function function, const Subject<Scalar>& subject,
                              const State& state) {
  const auto& model = subject.model;
  const auto& points = subject.points;
  const auto& external = subject.external;
  const auto q = vector_of<Scalar>(state.q);
  const auto qd = vector_of<Scalar>(state.qd);
  const auto qdd = vector_of<Scalar>(state.qdd);
  const auto tau = vector_of<Scalar>(state.tau);
  const auto xdd_cmd = vector_of<Scalar>(state.xdd_cmd);
  const auto f_ext = vector_of<Scalar>(state.f_ext);
  switch (function) {
    case Function::forward_kinematics:
      return poses(subject, q);
    case Function::jacobian:
      return entries_of(interpreter::jacobian<Scalar>(model, points, q));
    case Function::bias_acceleration:
      return entries_of(interpreter::bias_acceleration<Scalar>(model, points, q, qd));
    case Function::inverse_dynamics:
      return entries_of(interpreter::inverse_dynamics<Scalar>(model, q, qd, qdd, external, f_ext));
    case Function::gravity:
      return entries_of(interpreter::gravity<Scalar>(model, q));
    case Function::nonlinear_effects:
      return entries_of(interpreter::nonlinear_effects<Scalar>(model, q, qd));
    case Function::mass_matrix:
      return entries_of(interpreter::mass_matrix<Scalar>(model, q));
    case Function::forward_dynamics:
      return entries_of(interpreter::forward_dynamics<Scalar>(model, q, qd, tau, external, f_ext));
    case Function::lambda_inverse:
      return entries_of(interpreter::lambda_inverse<Scalar>(model, points, q));
    case Function::lambda:
      return entries_of(interpreter::lambda<Scalar>(model, points, q));
    case Function::control_torque:
      return entries_of(
          interpreter::control_torque<Scalar>(model, points, q, qd, qdd, xdd_cmd, external, f_ext));
    case Function::center_of_mass:
      return entries_of(interpreter::center_of_mass<Scalar>(model, q));
    case Function::center_of_mass_jacobian:
      return entries_of(interpreter::center_of_mass_jacobian<Scalar>(model, q));
    case Function::inverse_dynamics_derivatives:
      return derivatives(
          interpreter::inverse_dynamics_derivatives<Scalar>(model, q, qd, qdd, external, f_ext));
    case Function::forward_dynamics_derivatives:
      return derivatives(
          interpreter::forward_dynamics_derivatives<Scalar>(model, q, qd, tau, external, f_ext));
    case Function::damped_control_torque: {
      const auto damped = interpreter::damped_control_torque<Scalar>(
          model, points, q, qd, qdd, xdd_cmd, subject.damping, external, f_ext);
      std::vector<Scalar> entries = entries_of(damped.tau);
      entries.push_back(damped.ease);
      return entries;
    }
    case Function::object_state:
    case Function::object_control_torque:
    case Function::object_forward_dynamics:
      return interpret_objects(function, subject, state);
    case Function::contact_motion:
    case Function::contact_inverse_inertia:
    case Function::effective_mass:
    case Function::impulse_response:
    case Function::link_inverse_inertias:
      return interpret_contacts(function, subject, state);
  }
  throw std::logic_error(std::string("the interpreter has no ") + function_name(function));
}

template std::vector<float> interpret(Function, const Subject<float>&, const State&);
template std::vector<double> interpret(Function, const Subject<double>&, const State&);
template std::vector<interpreter::Digits50> interpret(Function,
                                                      const Subject<interpreter::Digits50>&,
                                                      const State&);

}  // namespace treeline
