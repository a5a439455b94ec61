#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "functions/function.hpp"
#include "program/program.hpp"
#include "recursion/methods/control_torque.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/tree/declare_inputs.hpp"

namespace treeline {

/// What a trace has at hand: the tree, its transforms for the inputs q, and the other inputs.
struct RobotTrace {
  Tree<Expression> tree;
  const Mechanism* mechanism = nullptr;
  std::size_t rows = 0;
  std::vector<Expression> q, qd, qdd, tau, xdd_cmd, f_ext;
  std::vector<JointTransform<Expression>> X;
  PivotRule rule;

  [[nodiscard]] std::vector<Wrench<Expression>> applied() const {
    return f_ext.empty() ? std::vector<Wrench<Expression>>{}
                         : applied_wrenches<Expression>(tree, X, f_ext);
  }
  /// "joint forces, N m"
  [[nodiscard]] std::string with_unit(const std::string& meaning, Quantity quantity) const {
    return meaning + ", " + unit_of(quantity, *mechanism);
  }
  [[nodiscard]] std::vector<WorldPose<Expression>> poses() const { return world_poses(tree, X); }
};

/// One way to compute a function.
struct RobotRoute {
  RouteId id;
  std::function<std::vector<Result>(const RobotTrace&)> body;
  std::shared_ptr<const TaskLaw> law = nullptr;  ///< of rows that yield
};

/// The routes to a function that is about the robot or its operational points, at least one; none
/// for other functions. Which there are depends on the structure of the tree alone.
std::vector<RobotRoute> robot_routes(Function function, const Mechanism& mechanism,
                                     const Tree<Expression>& tree);

}  // namespace treeline
