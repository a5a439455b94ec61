#pragma once

/// The functions of closed loops that are called by themselves, for `double` and `Digits50`,
/// compiled once in the library `treeline_interpreter_instances`. Include this instead of
/// `loops.hpp` and `close_loops.hpp` and link that library.

#include "interpreter/close_loops.hpp"
#include "interpreter/instances.hpp"

namespace treeline::interpreter {

// clang-format off
#define TREELINE_LOOP_INSTANCES(EXTERN, T)                                                         \
  EXTERN template Matrix<T> loop_jacobian<T>(const Model<T>&, const Loops<T>&, VectorArg<T>);      \
  EXTERN template Vector<T> loop_errors<T>(const Model<T>&, const Loops<T>&, VectorArg<T>)
/// By dual numbers, which take the longest to compile; nothing needs it in `double`.
#define TREELINE_LOOP_BIAS_INSTANCE(EXTERN, T)                                                     \
  EXTERN template Vector<T> loop_bias<T>(                                                          \
      const Model<T>&, const Loops<T>&, VectorArg<T>, VectorArg<T>)
#define TREELINE_CLOSING_INSTANCES(EXTERN, T)                                                      \
  EXTERN template Vector<T> move_coordinates<T>(                                                   \
      const Model<T>&, const Vector<T>&, const Vector<T>&, const T&);                              \
  EXTERN template std::optional<Vector<T>> close_loops<T>(                                         \
      const Model<T>&, const Loops<T>&, Vector<T>, const std::vector<int>&, const T&)
// clang-format on

TREELINE_LOOP_INSTANCES(extern, double);
TREELINE_LOOP_INSTANCES(extern, Digits50);
TREELINE_LOOP_BIAS_INSTANCE(extern, Digits50);
TREELINE_CLOSING_INSTANCES(extern, double);

}  // namespace treeline::interpreter
