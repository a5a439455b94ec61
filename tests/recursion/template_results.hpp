#pragma once

#include <string>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/function_results.hpp"
#include "recursion/methods/center_of_mass.hpp"
#include "recursion/methods/control_torque.hpp"
#include "recursion/methods/coriolis_matrix.hpp"
#include "recursion/methods/forward_dynamics.hpp"
#include "recursion/methods/kinetic_energy.hpp"
#include "recursion/methods/potential_energy.hpp"
#include "recursion/methods/resolved_acceleration.hpp"
#include "recursion/tree/deferred_rotations.hpp"

/// The recursions without a graph, in any `Scalar`. In 50 digits the constants of the mechanism are
/// not rounded, so results that are equal in theory agree in 40 digits.
namespace treeline::tests {

template <class Scalar>
struct RouteResults {
  std::string route;
  Results<Scalar> results;
};

template <class Scalar>
class TemplateRun {
 public:
  TemplateRun(const Mechanism& mechanism, const Inputs<Scalar>& in,
              const ModelInputs<Scalar>& model = {})
      : in_(in),
        tree_(tree_of<Scalar>(mechanism, model)),
        rows_(static_cast<std::size_t>(mechanism.task_rows())),
        X_(transforms_with_deferred_rotations(tree_, in_.q)),
        poses_(world_poses(tree_, X_)) {
    if (!in_.f_ext.empty()) applied_ = applied_wrenches<Scalar>(tree_, X_, in_.f_ext);
  }

  [[nodiscard]] Vector3<Scalar> center() const { return center_of_mass(tree_, X_); }

  /// Results of the function by every route that applies to the tree.
  [[nodiscard]] std::vector<RouteResults<Scalar>> results(Function function) const {
    switch (function) {
      case Function::forward_kinematics:
        return {{"", point_poses()}};
      case Function::jacobian:
        return jacobians();
      case Function::bias_acceleration:
        return {
            {"", {bias_acceleration<Scalar>(tree_, X_, task_points(tree_, {}, poses_), in_.qd)}}};
      case Function::inverse_dynamics:
        return {{"", {newton_euler({in_.qd, in_.qdd}, applied_)}}};
      case Function::gravity:
        return {{"", {newton_euler({}, {})}}};
      case Function::nonlinear_effects:
        return {{"", {newton_euler({in_.qd, {}}, {})}}};
      case Function::mass_matrix:
        return {{"", {mass_matrix(tree_, X_).values()}}};
      case Function::coriolis_matrix:
        return {{"", {coriolis_matrix<Scalar>(tree_, X_, in_.qd).values()}}};
      case Function::kinetic_energy:
        return {{"", {{kinetic_energy<Scalar>(tree_, X_, in_.qd)}}}};
      case Function::potential_energy:
        return {{"", {{potential_energy(tree_, X_)}}}};
      case Function::forward_dynamics:
        return forward_dynamics();
      case Function::lambda_inverse:
      case Function::lambda:
        return lambdas(function == Function::lambda);
      case Function::control_torque:
        return control_torques();
      default:  // about contacts, objects and posture: tested in files of their own
        break;
    }
    return {};
  }

 private:
  static std::vector<JointTransform<Scalar>> transforms_with_deferred_rotations(
      Tree<Scalar>& tree, const std::vector<Scalar>& q) {
    auto X = joint_transforms<Scalar>(tree, q);
    defer_rotations(tree, X);
    return X;
  }

  using Wrenches = std::vector<Wrench<Scalar>>;

  [[nodiscard]] std::vector<Scalar> newton_euler(const JointRates<Scalar>& rates,
                                                 const Wrenches& applied) const {
    return inverse_dynamics<Scalar>(tree_, X_, rates, applied);
  }

  [[nodiscard]] Results<Scalar> point_poses() const {
    Results<Scalar> results(2);
    for (const TreePoint<Scalar>& point : tree_.operational_points) {
      const WorldPose<Scalar> pose = pose_of(tree_, X_, poses_, point);
      results[0].insert(results[0].end(), {pose.p.x, pose.p.y, pose.p.z});
      for (const auto& row : {pose.R.row_x, pose.R.row_y, pose.R.row_z}) {
        results[1].insert(results[1].end(), {row.x, row.y, row.z});
      }
    }
    return results;
  }

  [[nodiscard]] std::vector<RouteResults<Scalar>> jacobians() const {
    std::vector<RouteResults<Scalar>> runs{
        {"inward",
         {jacobian_inward(tree_, X_, task_points(tree_, {}, poses_), rows_, poses_).values()}}};
    if (permits(tree_, {}, LambdaRoute::factors_world)) {
      runs.push_back({"world", {jacobian_world(tree_, poses_, {}, rows_).values()}});
    }
    return runs;
  }

  [[nodiscard]] std::vector<RouteResults<Scalar>> forward_dynamics() const {
    std::vector<Scalar> net = in_.tau;
    const auto h = newton_euler({in_.qd, {}}, applied_);
    for (std::size_t i = 0; i < net.size(); ++i) net[i] = net[i] - h[i];
    std::vector<RouteResults<Scalar>> runs{
        {"factors", {solve(factor_ltdl(mass_matrix(tree_, X_)), net)}}};
    if (find_clusters(tree_)) {
      runs.push_back({tree_.has_mimics ? "articulated, with followers" : "articulated",
                      {solve_articulated(tree_, X_, articulate(tree_, X_), net)}});
    }
    return runs;
  }

  static std::string name_of(const LambdaChoice& choice) {
    const TaskBasis& basis = choice.basis;
    return "route " + std::to_string(static_cast<int>(choice.route)) +
           (basis.in_link_axes ? ", link axes" : "") +
           (basis.at_link_origin ? ", link origin" : "") + ", axes of link " +
           std::to_string(basis.axes_link);
  }

  [[nodiscard]] std::vector<RouteResults<Scalar>> lambdas(bool invert) const {
    std::vector<RouteResults<Scalar>> runs;
    for (const LambdaChoice& choice : lambda_choices(tree_)) {
      const auto Lambda_inv = lambda_inverse_as_asked(tree_, X_, choice, rows_);
      runs.push_back({name_of(choice),
                      {invert ? inverse(factor_ldlt(Lambda_inv)).values() : Lambda_inv.values()}});
    }
    return runs;
  }

  [[nodiscard]] std::vector<RouteResults<Scalar>> control_torques() const {
    std::vector<RouteResults<Scalar>> runs;
    for (const LambdaChoice& choice : control_choices(tree_)) {
      runs.push_back({name_of(choice),
                      {control_torque<Scalar>(tree_, X_, {{in_.qd, in_.qdd}, in_.xdd_cmd, applied_},
                                              choice, rows_)}});
    }
    if (permits_resolved_acceleration(tree_)) {
      for (const int link : axes_links(tree_)) {
        runs.push_back({"resolved acceleration, axes of link " + std::to_string(link),
                        {control_torque_by_resolved_acceleration<Scalar>(
                            tree_, X_, {{in_.qd, in_.qdd}, in_.xdd_cmd, applied_}, link)}});
      }
    }
    return runs;
  }

  Inputs<Scalar> in_;
  Tree<Scalar> tree_;
  std::size_t rows_;
  std::vector<JointTransform<Scalar>> X_;
  std::vector<WorldPose<Scalar>> poses_;
  Wrenches applied_;
};

}  // namespace treeline::tests
