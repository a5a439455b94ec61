#pragma once

/// The functions of closed loops that are called by themselves, compiled once in the library
/// `treeline_interpreter_instances`. Include this instead of `loops.hpp`,
/// `eliminated_forward_dynamics.hpp` and `close_loops.hpp` and link that library.

#include "interpreter/close_loops.hpp"
#include "interpreter/eliminated_forward_dynamics.hpp"
#include "interpreter/instances.hpp"

namespace treeline::interpreter {

// clang-format off
#define TREELINE_LOOP_INSTANCES(EXTERN, T)                                                         \
  EXTERN template Matrix<T> loop_jacobian<T>(const Model<T>&, const Loops<T>&, VectorArg<T>);      \
  EXTERN template Vector<T> loop_errors<T>(const Model<T>&, const Loops<T>&, VectorArg<T>);        \
  EXTERN template Vector<T> loop_bias<T>(                                                          \
      const Model<T>&, const Loops<T>&, VectorArg<T>, VectorArg<T>);                               \
  EXTERN template ConstrainedMotion<T> eliminated_forward_dynamics<T>(const Model<T>&,             \
      const ConstrainedState<std::type_identity_t<T>>&, const TaskLaw<T>&);                        \
  EXTERN template SupportedTorque<T> eliminated_control_torque<T>(const Model<T>&,                 \
      const SupportedTask<T>&, VectorArg<T>, VectorArg<T>, const TaskLaw<T>&)
#define TREELINE_CLOSING_INSTANCES(EXTERN, T)                                                      \
  EXTERN template Vector<T> move_coordinates<T>(                                                   \
      const Model<T>&, const Vector<T>&, const Vector<T>&, const T&);                              \
  EXTERN template std::optional<Vector<T>> close_loops<T>(                                         \
      const Model<T>&, const Loops<T>&, Vector<T>, const std::vector<int>&, const T&)
// clang-format on

TREELINE_LOOP_INSTANCES(extern, float);
TREELINE_LOOP_INSTANCES(extern, double);
TREELINE_LOOP_INSTANCES(extern, Digits50);
TREELINE_CLOSING_INSTANCES(extern, double);

}  // namespace treeline::interpreter
