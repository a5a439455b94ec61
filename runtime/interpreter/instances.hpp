#pragma once

/// The interpreter for `float`, `double` and `Digits50`, compiled once in the library
/// `treeline_interpreter_instances`. Include this instead of `interpreter.hpp` and link that
/// library.

#include "interpreter/digits50.hpp"
#include "interpreter/interpreter.hpp"

namespace treeline::interpreter {

// clang-format off
#define TREELINE_INTERPRETER_DYNAMICS(EXTERN, T)                                                   \
  EXTERN template Vector<T> position_derivative<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);   \
  EXTERN template Kinematics<T> kinematics<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);        \
  EXTERN template PerBody<Vector6<T>> accelerations<T>(                                            \
      const Model<T>&, const Kinematics<T>&, VectorArg<T>, const Vector3<T>&);                     \
  EXTERN template Vector<T> inverse_dynamics<T>(                                                   \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>);      \
  EXTERN template Vector<T> inverse_dynamics<T>(                                                   \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector<T> nonlinear_effects<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);     \
  EXTERN template Vector<T> gravity<T>(const Model<T>&, VectorArg<T>);                             \
  EXTERN template Matrix<T> mass_matrix<T>(const Model<T>&, VectorArg<T>);                         \
  EXTERN template Vector<T> forward_dynamics_by_mass_matrix<T>(                                    \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>);      \
  EXTERN template Vector<T> forward_dynamics<T>(                                                   \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>);      \
  EXTERN template Vector<T> forward_dynamics<T>(                                                   \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template DynamicsDerivatives<T> inverse_dynamics_derivatives<T>(                          \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>);      \
  EXTERN template DynamicsDerivatives<T> forward_dynamics_derivatives<T>(                          \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>);      \
  EXTERN template Matrix<T> friction_slopes<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);       \
  EXTERN template ImplicitDrives<T> implicit_drives<T>(const Model<T>&, VectorArg<T>,              \
                                                       VectorArg<T>, const T&);                    \
  EXTERN template Vector<T> forward_dynamics_with_implicit_drives<T>(                              \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>,       \
      const T&);                                                                                   \
  EXTERN template Matrix<T> coriolis_matrix<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);       \
  EXTERN template T kinetic_energy<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);                \
  EXTERN template T potential_energy<T>(const Model<T>&, VectorArg<T>);                            \
  EXTERN template Vector3<T> center_of_mass<T>(const Model<T>&, VectorArg<T>);                     \
  EXTERN template Matrix<T> center_of_mass_jacobian<T>(const Model<T>&, VectorArg<T>);             \
  EXTERN template Matrix<T> centroidal_momentum_matrix<T>(const Model<T>&, VectorArg<T>);          \
  EXTERN template Vector6<T> centroidal_momentum<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);  \
  EXTERN template Vector6<T> centroidal_bias<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);      \
  EXTERN template Vector6<T> centroidal_momentum_rate<T>(                                          \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector3<T> center_of_mass_bias_acceleration<T>(                                  \
      const Model<T>&, VectorArg<T>, VectorArg<T>);                                                \
  EXTERN template DynamicsDerivatives<T> centroidal_momentum_derivatives<T>(                       \
      const Model<T>&, VectorArg<T>, VectorArg<T>);                                                \
  EXTERN template DynamicsDerivatives<T> centroidal_momentum_rate_derivatives<T>(                  \
      const Model<T>&, VectorArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template DynamicsDerivatives<T> kinetic_energy_derivatives<T>(                            \
      const Model<T>&, VectorArg<T>, VectorArg<T>);                                                \
  EXTERN template std::vector<Subtree<T>> subtrees<T>(const Model<T>&, VectorArg<T>)

#define TREELINE_INTERPRETER_OPERATIONAL_SPACE(EXTERN, T)                                          \
  EXTERN template std::vector<PointPose<T>> forward_kinematics<T>(                                 \
      const Model<T>&, PointsArg<T>, VectorArg<T>);                                                \
  EXTERN template Matrix<T> jacobian<T>(const Model<T>&, PointsArg<T>, VectorArg<T>);              \
  EXTERN template Vector<T> point_accelerations<T>(                                                \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>, VectorArg<T>);                    \
  EXTERN template Vector<T> bias_acceleration<T>(                                                  \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector<T> point_velocity<T>(                                                     \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector<T> point_acceleration<T>(                                                 \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>, VectorArg<T>);                    \
  EXTERN template DynamicsDerivatives<T> point_velocity_derivatives<T>(                            \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template DynamicsDerivatives<T> point_acceleration_derivatives<T>(                        \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>, VectorArg<T>);                    \
  EXTERN template Matrix<T> dynamically_consistent_inverse<T>(                                     \
      const Model<T>&, PointsArg<T>, VectorArg<T>, const TaskLaw<T>&);                             \
  EXTERN template Matrix<T> null_space_projector<T>(                                               \
      const Model<T>&, PointsArg<T>, VectorArg<T>, const TaskLaw<T>&);                             \
  EXTERN template Vector<T> operational_bias_force<T>(                                             \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>, const TaskLaw<T>&);               \
  EXTERN template Vector<T> operational_gravity<T>(                                                \
      const Model<T>&, PointsArg<T>, VectorArg<T>, const TaskLaw<T>&);                             \
  EXTERN template Matrix<T> lambda_inverse<T>(const Model<T>&, PointsArg<T>, VectorArg<T>);        \
  EXTERN template Matrix<T> lambda<T>(const Model<T>&, PointsArg<T>, VectorArg<T>);                \
  EXTERN template Matrix<T> law_rows<T>(                                                           \
      const Model<T>&, PointsArg<T>, VectorArg<T>, const TaskLaw<T>&);                             \
  EXTERN template Matrix<T> lambda<T>(                                                             \
      const Model<T>&, PointsArg<T>, VectorArg<T>, const TaskLaw<T>&);                             \
  EXTERN template Vector<T> task_force<T>(const Model<T>&, PointsArg<T>, VectorArg<T>,             \
      VectorArg<T>, VectorArg<T>, VectorArg<T>);                                                   \
  EXTERN template Vector<T> control_torque<T>(const Model<T>&, PointsArg<T>, VectorArg<T>,         \
      VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>);                       \
  EXTERN template Vector<T> control_torque<T>(const Model<T>&, PointsArg<T>, VectorArg<T>,         \
      VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>, const TaskLaw<T>&);    \
  EXTERN template Vector<T> control_torque<T>(const Model<T>&, PointsArg<T>, VectorArg<T>,         \
      VectorArg<T>, VectorArg<T>, VectorArg<T>);                                                   \
  EXTERN template ExplicitOperationalSpace<T> explicit_operational_space<T>(                       \
      const Model<T>&, PointsArg<T>, VectorArg<T>);                                                \
  EXTERN template Vector<T> explicit_control_torque<T>(const ExplicitOperationalSpace<T>&,         \
      VectorArg<T>, VectorArg<T>, VectorArg<T>, VectorArg<T>);                                     \
  EXTERN template DampedTorque<T> damped_control_torque<T>(const Model<T>&, PointsArg<T>,          \
      VectorArg<T>, VectorArg<T>, VectorArg<T>, VectorArg<T>, const Damping<T>&, PointsArg<T>,     \
      VectorArg<T>);                                                                               \
  EXTERN template Vector<T> prioritized_control_torque<T>(const Model<T>&, PointsArg<T>,           \
      VectorArg<T>, VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>,          \
      const std::vector<T>&)

#define TREELINE_INTERPRETER_CONTACTS_AND_OBJECTS(EXTERN, T)                                       \
  EXTERN template PerBody<Matrix6<T>> link_inverse_inertias<T>(const Model<T>&, VectorArg<T>);     \
  EXTERN template ContactMotion<T> contact_motion<T>(                                              \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector<T> effective_masses<T>(                                                   \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector<T> mobilities_along<T>(                                                   \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector<T> effective_masses<T>(                                                   \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>, const TaskLaw<T>&);               \
  EXTERN template ImpulseResponse<T> impulse_response<T>(                                          \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Matrix<T> contact_inverse_inertia<T>(                                            \
      const Model<T>&, PointsArg<T>, VectorArg<T>);                                                \
  EXTERN template std::vector<std::vector<HeldPose<T>>> held_poses<T>(                             \
      const ClosedChain<T>&, PerRobotArg<T>, PerRobotArg<T>);                                      \
  EXTERN template PerRobot<T> object_control_torque<T>(const ClosedChain<T>&, PerRobotArg<T>,      \
      PerRobotArg<T>, PerRobotArg<T>, VectorArg<T>, VectorArg<T>, const TaskLaw<T>&);              \
  EXTERN template ClosedChainMotion<T> object_forward_dynamics<T>(const ClosedChain<T>&,           \
      PerRobotArg<T>, PerRobotArg<T>, PerRobotArg<T>,                                              \
      const Stabilisation<std::type_identity_t<T>>&);                                              \
  EXTERN template ClosedChainMotion<T> object_forward_dynamics<T>(const ClosedChain<T>&,           \
      PerRobotArg<T>, PerRobotArg<T>, PerRobotArg<T>,                                              \
      const Stabilisation<std::type_identity_t<T>>&, const TaskLaw<T>&);                           \
  EXTERN template ConstrainedMotion<T> constrained_forward_dynamics<T>(                            \
      const Model<T>&, PointsArg<T>, const ConstrainedState<std::type_identity_t<T>>&);            \
  EXTERN template ConstrainedMotion<T> constrained_forward_dynamics<T>(const Model<T>&,            \
      PointsArg<T>, const ConstrainedState<std::type_identity_t<T>>&, const TaskLaw<T>&);          \
  EXTERN template Vector<T> detail::solve_consistent<T>(const Matrix<T>&, const Vector<T>&);       \
  EXTERN template SupportedTorque<T> supported_control_torque<T>(                                  \
      const Model<T>&, const SupportedTask<T>&, VectorArg<T>, VectorArg<T>);                       \
  EXTERN template SupportedTorque<T> supported_control_torque<T>(const Model<T>&,                  \
      const SupportedTask<T>&, VectorArg<T>, VectorArg<T>, const SupportLaw<T>&)
// clang-format on

#define TREELINE_INTERPRETER_INSTANCES(EXTERN, T)    \
  TREELINE_INTERPRETER_DYNAMICS(EXTERN, T);          \
  TREELINE_INTERPRETER_OPERATIONAL_SPACE(EXTERN, T); \
  TREELINE_INTERPRETER_CONTACTS_AND_OBJECTS(EXTERN, T)

TREELINE_INTERPRETER_INSTANCES(extern, float);
TREELINE_INTERPRETER_INSTANCES(extern, double);
TREELINE_INTERPRETER_INSTANCES(extern, Digits50);

}  // namespace treeline::interpreter
