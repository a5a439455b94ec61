#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "functions/function.hpp"
#include "program/ending.hpp"
#include "recursion/methods/control_torque.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/tree/declare_inputs.hpp"
#include "recursion/tree/deferred_rotations.hpp"
#include "recursion/tree/object_tree.hpp"

namespace treeline {

/// Data for a route while a function is traced: the tree, its transforms for the inputs q, and all
/// inputs.
struct Trace {
  const Mechanism* mechanism = nullptr;  ///< as the scene has it
  Tree<Expression> tree;                 ///< of the mechanism as the function sees it
  std::vector<TreeObject<Expression>> objects;
  std::vector<JointTransform<Expression>> X;
  TracedInputs in;
  PivotRule rule = {};  ///< how rows yield

  [[nodiscard]] const std::vector<Expression>& q() const { return in[Quantity::q]; }
  [[nodiscard]] const std::vector<Expression>& qd() const { return in[Quantity::qd]; }
  /// Accelerations: those of the joints, or those that are wanted beside a task.
  [[nodiscard]] const std::vector<Expression>& qdd() const {
    const auto& beside = in[Quantity::qdd_0];
    return beside.empty() ? in[Quantity::qdd] : beside;
  }
  [[nodiscard]] const std::vector<Expression>& tau() const { return in[Quantity::tau]; }
  [[nodiscard]] std::size_t rows() const {
    return static_cast<std::size_t>(mechanism->task_rows());
  }
  [[nodiscard]] std::vector<Wrench<Expression>> applied() const {
    const auto& f_ext = in[Quantity::f_ext];
    return f_ext.empty() ? std::vector<Wrench<Expression>>{}
                         : applied_wrenches<Expression>(tree, X, f_ext);
  }
  /// "joint forces, N m"
  [[nodiscard]] std::string with_unit(const std::string& meaning, Quantity quantity) const {
    return meaning + ", " + unit_of(quantity, *mechanism);
  }
  [[nodiscard]] std::vector<WorldPose<Expression>> poses() const { return world_poses(tree, X); }
};

/// A trace in the open graph that knows the robot as it is in the files, but no inputs.
inline Trace begin_trace(const Mechanism& mechanism) {
  Trace trace;
  trace.mechanism = &mechanism;
  trace.tree = constant_tree<Expression>(mechanism);
  return trace;
}

/// Finds the transforms of all joints for the inputs. Where rotations are deferred, inertias turn
/// with joints.
inline void find_transforms(Trace& trace, bool deferred = true) {
  trace.X = joint_transforms<Expression>(trace.tree, trace.q());
  if (deferred) defer_rotations(trace.tree, trace.X);
  follow_points(trace.tree, trace.objects);
}

/// One way to compute a function.
struct Route {
  RouteId id;
  std::function<std::vector<Result>(const Trace&)> body;
  std::shared_ptr<const TaskLaw> law = nullptr;  ///< of rows that yield
  std::string singular =
      {};  ///< what happens at singular states, for users; empty: as the law says
  /// The order in which results are to be computed; empty: any.
  std::function<std::vector<ResultPlace>(const Mechanism& mechanism, std::size_t results)> order =
      {};
  /// In place of `body`: a routine that is called, with results of the straight lines before it.
  std::function<Ending(const Trace&)> ending = {};
  bool keeps_inertias = false;  ///< constants: no rotation is deferred
};

/// The function and the tree whose routes are asked for. They depend on its structure alone.
struct RouteQuery {
  Function function;
  const Mechanism& mechanism;  ///< as the scene has it
  const Mechanism& seen;       ///< as the function sees it: with constraints as points
  const Tree<Expression>& tree;
  int lanes = 1;  ///< how many numbers the emitted code may compute together
};

}  // namespace treeline
