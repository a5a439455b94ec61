#pragma once

/// The interpreter for `double` and `Digits50`, compiled once in the library
/// `treeline_interpreter_instances`: include this instead of `interpreter.hpp` and link that.

#include "interpreter/digits50.hpp"
#include "interpreter/interpreter.hpp"

namespace treeline::interpreter {

// clang-format off
#define TREELINE_INTERPRETER_INSTANCES(EXTERN, T)                                                  \
  EXTERN template Vector<T> position_derivative<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);   \
  EXTERN template Kinematics<T> kinematics<T>(const Model<T>&, VectorArg<T>, VectorArg<T>);        \
  EXTERN template PerBody<Vector6<T>> accelerations<T>(                                            \
      const Model<T>&, const Kinematics<T>&, VectorArg<T>, const Vector3<T>&);                     \
  EXTERN template std::vector<PointPose<T>> forward_kinematics<T>(                                 \
      const Model<T>&, PointsArg<T>, VectorArg<T>);                                                \
  EXTERN template Matrix<T> jacobian<T>(const Model<T>&, PointsArg<T>, VectorArg<T>);              \
  EXTERN template Vector<T> point_accelerations<T>(                                                \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>, VectorArg<T>);                    \
  EXTERN template Vector<T> bias_acceleration<T>(                                                  \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
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
  EXTERN template Matrix<T> lambda_inverse<T>(const Model<T>&, PointsArg<T>, VectorArg<T>);        \
  EXTERN template Matrix<T> lambda<T>(const Model<T>&, PointsArg<T>, VectorArg<T>);                \
  EXTERN template Vector<T> task_force<T>(const Model<T>&, PointsArg<T>, VectorArg<T>,             \
      VectorArg<T>, VectorArg<T>, VectorArg<T>);                                                   \
  EXTERN template Vector<T> control_torque<T>(const Model<T>&, PointsArg<T>, VectorArg<T>,         \
      VectorArg<T>, VectorArg<T>, VectorArg<T>, PointsArg<T>, VectorArg<T>);                       \
  EXTERN template Vector<T> control_torque<T>(const Model<T>&, PointsArg<T>, VectorArg<T>,         \
      VectorArg<T>, VectorArg<T>, VectorArg<T>);                                                   \
  EXTERN template ExplicitOperationalSpace<T> explicit_operational_space<T>(                       \
      const Model<T>&, PointsArg<T>, VectorArg<T>);                                                \
  EXTERN template PerBody<Matrix6<T>> link_inverse_inertias<T>(const Model<T>&, VectorArg<T>);      \
  EXTERN template PerBody<Matrix6<T>> link_inertias<T>(                                            \
      const Model<T>&, VectorArg<T>, const std::type_identity_t<T>&);                              \
  EXTERN template ContactMotion<T> contact_motion<T>(                                              \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector<T> effective_masses<T>(                                                   \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template ImpulseResponse<T> impulse_response<T>(                                          \
      const Model<T>&, PointsArg<T>, VectorArg<T>, VectorArg<T>);                                  \
  EXTERN template Vector<T> explicit_control_torque<T>(const ExplicitOperationalSpace<T>&,         \
      VectorArg<T>, VectorArg<T>, VectorArg<T>, VectorArg<T>)
// clang-format on

#ifndef TREELINE_INTERPRETER_DEFINES_INSTANCES
TREELINE_INTERPRETER_INSTANCES(extern, double);
TREELINE_INTERPRETER_INSTANCES(extern, Digits50);
#endif

}  // namespace treeline::interpreter
