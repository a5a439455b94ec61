#include "oracle/interpret.hpp"

#include <array>

#include "functions/function_table.hpp"
#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"

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

/// Masses, then centres, of the subtrees of links that move against their parents.
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

/// Inputs of the interpreter: the subject, the numbers of its state in the interpreter's types, and
/// the law of rows that are relaxed.
template <class Scalar>
struct Inputs {
  Inputs(const Subject<Scalar>& described, const State& state,
         const interpreter::TaskLaw<Scalar>& relaxing)
      : subject(described),
        model(described.model),
        points(described.points),
        external(described.external),
        law(relaxing),
        q(vector_of<Scalar>(state.q)),
        qd(vector_of<Scalar>(state.qd)),
        qdd(vector_of<Scalar>(state.qdd)),
        tau(vector_of<Scalar>(state.tau)),
        xdd_cmd(vector_of<Scalar>(state.xdd_cmd)),
        f_ext(vector_of<Scalar>(state.f_ext)),
        step(vector_of<Scalar>(values_of(state, Quantity::step))) {}

  const Subject<Scalar>& subject;
  const interpreter::Model<Scalar>& model;
  const interpreter::Points<Scalar>& points;
  const interpreter::Points<Scalar>& external;
  const interpreter::TaskLaw<Scalar>& law;
  Vector<Scalar> q, qd, qdd, tau, xdd_cmd, f_ext, step;
};

/// How a function is interpreted: all of its results, one after the other.
template <class Scalar>
struct Interpretation {
  Function function;
  std::vector<Scalar> (*results)(const Inputs<Scalar>& in);
};

template <class Scalar>
Vector<Scalar> forward_dynamics(const Inputs<Scalar>& in) {
  if (in.step.size() == 0) {
    return interpreter::forward_dynamics<Scalar>(in.model, in.q, in.qd, in.tau, in.external,
                                                 in.f_ext);
  }
  return interpreter::forward_dynamics_with_implicit_drives<Scalar>(
      in.model, in.q, in.qd, in.tau, in.external, in.f_ext, in.step(0));
}

/// Functions of joints and of the whole robot.
template <class Scalar>
constexpr auto kOfRobot = std::to_array<Interpretation<Scalar>>({
{Function::inverse_dynamics, [](const Inputs<Scalar>& in) { return entries_of(
          interpreter::inverse_dynamics<Scalar>(in.model, in.q, in.qd, in.qdd, in.external, in.f_ext)); }},
{Function::gravity, [](const Inputs<Scalar>& in) { return entries_of(interpreter::gravity<Scalar>(in.model, in.q)); }},
{Function::nonlinear_effects, [](const Inputs<Scalar>& in) { return entries_of(interpreter::nonlinear_effects<Scalar>(in.model, in.q, in.qd)); }},
{Function::mass_matrix, [](const Inputs<Scalar>& in) { return entries_of(interpreter::mass_matrix<Scalar>(in.model, in.q)); }},
{Function::forward_dynamics, [](const Inputs<Scalar>& in) { return entries_of(forward_dynamics(in)); }},
{Function::coriolis_matrix, [](const Inputs<Scalar>& in) { return entries_of(interpreter::coriolis_matrix<Scalar>(in.model, in.q, in.qd)); }},
{Function::kinetic_energy, [](const Inputs<Scalar>& in) { return std::vector<Scalar>{interpreter::kinetic_energy<Scalar>(in.model, in.q, in.qd)}; }},
{Function::kinetic_energy_derivatives, [](const Inputs<Scalar>& in) { return derivatives(interpreter::kinetic_energy_derivatives<Scalar>(in.model, in.q, in.qd)); }},
{Function::potential_energy, [](const Inputs<Scalar>& in) { return std::vector<Scalar>{interpreter::potential_energy<Scalar>(in.model, in.q)}; }},
{Function::inverse_dynamics_regressor, [](const Inputs<Scalar>& in) { return entries_of(interpreter::inverse_dynamics_regressor<Scalar>(in.model, in.subject.regressor,
                                                                        in.q, in.qd, in.qdd)); }},
{Function::energy_regressor, [](const Inputs<Scalar>& in) { return entries_of(
          interpreter::energy_regressor<Scalar>(in.model, in.subject.regressor, in.q, in.qd)); }},
{Function::center_of_mass, [](const Inputs<Scalar>& in) { return entries_of(interpreter::center_of_mass<Scalar>(in.model, in.q)); }},
{Function::center_of_mass_jacobian, [](const Inputs<Scalar>& in) { return entries_of(interpreter::center_of_mass_jacobian<Scalar>(in.model, in.q)); }},
{Function::centroidal_momentum_matrix, [](const Inputs<Scalar>& in) { return entries_of(interpreter::centroidal_momentum_matrix<Scalar>(in.model, in.q)); }},
{Function::centroidal_momentum, [](const Inputs<Scalar>& in) { return entries_of(interpreter::centroidal_momentum<Scalar>(in.model, in.q, in.qd)); }},
{Function::centroidal_bias, [](const Inputs<Scalar>& in) { return entries_of(interpreter::centroidal_bias<Scalar>(in.model, in.q, in.qd)); }},
{Function::center_of_mass_bias_acceleration, [](const Inputs<Scalar>& in) { return entries_of(interpreter::center_of_mass_bias_acceleration<Scalar>(in.model, in.q, in.qd)); }},
{Function::centroidal_momentum_derivatives, [](const Inputs<Scalar>& in) { return derivatives(interpreter::centroidal_momentum_derivatives<Scalar>(in.model, in.q, in.qd)); }},
{Function::centroidal_momentum_rate_derivatives, [](const Inputs<Scalar>& in) { return derivatives(
          interpreter::centroidal_momentum_rate_derivatives<Scalar>(in.model, in.q, in.qd, in.qdd)); }},
{Function::subtree_masses_and_centers, [](const Inputs<Scalar>& in) { return subtrees(in.model, in.q); }},
{Function::inverse_dynamics_derivatives, [](const Inputs<Scalar>& in) { return derivatives(interpreter::inverse_dynamics_derivatives<Scalar>(
          in.model, in.q, in.qd, in.qdd, in.external, in.f_ext)); }},
{Function::forward_dynamics_derivatives, [](const Inputs<Scalar>& in) { return derivatives(interpreter::forward_dynamics_derivatives<Scalar>(
          in.model, in.q, in.qd, in.tau, in.external, in.f_ext)); }},
});

template <class Scalar>
Vector<Scalar> control_torque(const Inputs<Scalar>& in) {
  if (in.law.borders.empty()) {
    return interpreter::control_torque<Scalar>(in.model, in.points, in.q, in.qd, in.qdd, in.xdd_cmd,
                                               in.external, in.f_ext);
  }
  return interpreter::control_torque<Scalar>(in.model, in.points, in.q, in.qd, in.qdd, in.xdd_cmd,
                                             in.external, in.f_ext, in.law);
}

template <class Scalar>
std::vector<Scalar> damped_control_torque(const Inputs<Scalar>& in) {
  const auto damped = interpreter::damped_control_torque<Scalar>(
      in.model, in.points, in.q, in.qd, in.qdd, in.xdd_cmd, in.subject.damping, in.external,
      in.f_ext);
  std::vector<Scalar> entries = entries_of(damped.tau);
  entries.push_back(damped.least_eigenvalue);
  return entries;
}

/// Functions of operational points.
template <class Scalar>
constexpr auto kOfPoints = std::to_array<Interpretation<Scalar>>({
    {Function::forward_kinematics,
     [](const Inputs<Scalar>& in) { return poses(in.subject, in.q); }},
    {Function::jacobian,
     [](const Inputs<Scalar>& in) {
       return entries_of(interpreter::jacobian<Scalar>(in.model, in.points, in.q));
     }},
    {Function::bias_acceleration,
     [](const Inputs<Scalar>& in) {
       return entries_of(interpreter::bias_acceleration<Scalar>(in.model, in.points, in.q, in.qd));
     }},
    {Function::lambda_inverse,
     [](const Inputs<Scalar>& in) {
       return entries_of(interpreter::lambda_inverse<Scalar>(in.model, in.points, in.q));
     }},
    {Function::lambda,
     [](const Inputs<Scalar>& in) {
       return entries_of(in.law.borders.empty()
                             ? interpreter::lambda<Scalar>(in.model, in.points, in.q)
                             : interpreter::lambda<Scalar>(in.model, in.points, in.q, in.law));
     }},
    {Function::point_velocity,
     [](const Inputs<Scalar>& in) {
       return entries_of(interpreter::point_velocity<Scalar>(in.model, in.points, in.q, in.qd));
     }},
    {Function::point_acceleration,
     [](const Inputs<Scalar>& in) {
       return entries_of(
           interpreter::point_acceleration<Scalar>(in.model, in.points, in.q, in.qd, in.qdd));
     }},
    {Function::point_velocity_derivatives,
     [](const Inputs<Scalar>& in) {
       return derivatives(
           interpreter::point_velocity_derivatives<Scalar>(in.model, in.points, in.q, in.qd));
     }},
    {Function::point_acceleration_derivatives,
     [](const Inputs<Scalar>& in) {
       return derivatives(interpreter::point_acceleration_derivatives<Scalar>(in.model, in.points,
                                                                              in.q, in.qd, in.qdd));
     }},
    {Function::dynamically_consistent_inverse,
     [](const Inputs<Scalar>& in) {
       return entries_of(
           interpreter::dynamically_consistent_inverse<Scalar>(in.model, in.points, in.q, in.law));
     }},
    {Function::null_space_projector,
     [](const Inputs<Scalar>& in) {
       return entries_of(
           interpreter::null_space_projector<Scalar>(in.model, in.points, in.q, in.law));
     }},
    {Function::operational_bias_force,
     [](const Inputs<Scalar>& in) {
       return entries_of(
           interpreter::operational_bias_force<Scalar>(in.model, in.points, in.q, in.qd, in.law));
     }},
    {Function::operational_gravity,
     [](const Inputs<Scalar>& in) {
       return entries_of(
           interpreter::operational_gravity<Scalar>(in.model, in.points, in.q, in.law));
     }},
    {Function::control_torque,
     [](const Inputs<Scalar>& in) { return entries_of(control_torque(in)); }},
    {Function::damped_control_torque,
     [](const Inputs<Scalar>& in) { return damped_control_torque(in); }},
});

static_assert(covers<is_about<FunctionGroup::robot, FunctionGroup::center_of_mass,
                              FunctionGroup::derivatives>>(kOfRobot<double>));
static_assert(covers<is_about<FunctionGroup::points>>(kOfPoints<double>));

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
      return find_row(kOfPoints<Scalar>, function)->results({subject, state, law});
    case FunctionGroup::robot:
    case FunctionGroup::center_of_mass:
    case FunctionGroup::derivatives:
      break;
  }
  return find_row(kOfRobot<Scalar>, function)->results({subject, state, law});
}

template std::vector<float> interpret(Function, const Subject<float>&, const State&,
                                      const interpreter::TaskLaw<float>&);
template std::vector<double> interpret(Function, const Subject<double>&, const State&,
                                       const interpreter::TaskLaw<double>&);
template std::vector<interpreter::Digits50> interpret(
    Function, const Subject<interpreter::Digits50>&, const State&,
    const interpreter::TaskLaw<interpreter::Digits50>&);

}  // namespace treeline
