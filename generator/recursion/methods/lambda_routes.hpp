#pragma once

#include <algorithm>
#include <initializer_list>
#include <vector>

#include "recursion/methods/force_propagation.hpp"
#include "recursion/methods/inertia_propagation.hpp"
#include "recursion/methods/lambda_inverse.hpp"
#include "recursion/methods/link_poses.hpp"
#include "recursion/methods/prioritized_task_force.hpp"
#include "recursion/methods/shift_lambda_inverse.hpp"
#include "recursion/methods/turn_lambda_inverse.hpp"

namespace treeline {

/// Algorithms for Lambda^-1.
enum class LambdaRoute {
  unit_forces,          ///< PV-OSIM
  factors_inward,       ///< M = L^T D L, J carried inward
  factors_world,        ///< M = L^T D L, J from poses
  branching,            ///< Chang tables 5.2, 5.3
  inertia_propagation,  ///< Chang table 5.1
};

/// Whether `route` solves with the factors of M, not by recursions of articulated bodies.
constexpr bool uses_factors(LambdaRoute route) {
  return route == LambdaRoute::factors_inward || route == LambdaRoute::factors_world;
}

/// An algorithm for Lambda^-1 and the coordinates in which it computes.
struct LambdaChoice {
  TaskBasis basis;
  LambdaRoute route = LambdaRoute::unit_forces;
};

/// Whether a route applies to what shares coordinates in the tree. Unit forces pass clusters of
/// joints; the other recursions of articulated bodies do not.
template <class Scalar>
bool permits_followers(const Tree<Scalar>& tree, LambdaRoute route) {
  if (!tree.has_mimics || uses_factors(route)) return true;
  return route == LambdaRoute::unit_forces && find_clusters(tree).has_value();
}

/// Whether `route` applies to the tree. Forces on the centre of mass are propagated row by row from
/// all links, its Jacobian is carried inward. Jacobians from poses apply to the axes from which the
/// poses are seen, the world's or a link's.
template <class Scalar>
bool permits(const Tree<Scalar>& tree, TaskBasis basis, LambdaRoute route) {
  if (!permits(tree, basis) || !permits_followers(tree, route)) return false;
  if (has_center_of_mass(tree)) {
    return route == LambdaRoute::unit_forces || route == LambdaRoute::factors_inward;
  }
  if (route == LambdaRoute::inertia_propagation) {
    return permits_inertia_propagation(tree);
  }
  const bool all_world =
      std::all_of(tree.operational_points.begin(), tree.operational_points.end(),
                  [](const TreePoint<Scalar>& point) { return point.axes == Axes::world; });
  return route != LambdaRoute::factors_world || basis.axes_link >= 0 ||
         (all_world && !basis.in_link_axes);
}

/// Lambda^-1 in the coordinates of `choice`. `poses` are seen from its `axes_link`.
template <class Scalar>
DenseMatrix<Scalar> lambda_inverse(const Tree<Scalar>& tree,
                                   const std::vector<JointTransform<Scalar>>& X,
                                   const std::vector<WorldPose<Scalar>>& poses,
                                   const LambdaChoice& choice, std::size_t rows) {
  if (choice.route == LambdaRoute::factors_world) {
    return lambda_inverse_by_factors(tree, X, jacobian_world(tree, poses, choice.basis, rows));
  }
  const auto tasks = task_points(tree, choice.basis, poses);
  switch (choice.route) {
    case LambdaRoute::factors_inward:
      return lambda_inverse_by_factors(tree, X, jacobian_inward(tree, X, tasks, rows, poses));
    case LambdaRoute::branching:
      return lambda_inverse_by_branching(tree, X, tasks);
    case LambdaRoute::inertia_propagation:
      return lambda_inverse_by_inertia_propagation(tree, X, tasks, rows);
    default:
      return lambda_inverse_by_unit_forces(tree, X, tasks, rows);
  }
}

/// Lambda^-1 at the points and in the axes of the scene, computed in the coordinates of `choice`,
/// which must not be each link's own.
template <class Scalar>
DenseMatrix<Scalar> lambda_inverse_as_asked(const Tree<Scalar>& tree,
                                            const std::vector<JointTransform<Scalar>>& X,
                                            const LambdaChoice& choice, std::size_t rows) {
  const TaskBasis& basis = choice.basis;
  const auto poses = poses_seen_from(tree, X, basis.axes_link);
  auto Lambda_inv = lambda_inverse(tree, X, poses, choice, rows);
  if (basis.at_link_origin) {
    shift_to_points(tree, basis, poses, Lambda_inv);
  }
  if (basis.axes_link >= 0) {
    turn_to_asked_axes(tree, X, basis.axes_link, Lambda_inv);
  }
  return Lambda_inv;
}

/// Links whose axes are worth trying for a point: the first two and the last three of those that
/// carry it, which have won for every robot tried. None if there are points on several links,
/// because rotating their couplings costs more than such axes save.
template <class Scalar>
std::vector<int> axes_links(const Tree<Scalar>& tree) {
  const auto& points = tree.operational_points;
  const bool together = std::all_of(points.begin(), points.end(), [&](const auto& point) {
    return point.link == points.front().link;
  });
  std::vector<int> links;
  for (int i = together && !points.empty() ? points.front().link : -1; i >= 0;
       i = tree.links[static_cast<std::size_t>(i)].parent) {
    const bool turns = tree.links[static_cast<std::size_t>(i)].turns_axes();
    if (turns || i == points.front().link) {  // otherwise as good as the axes of the link below
      links.push_back(i);
    }
  }
  if (links.size() > 5) {
    links.erase(links.begin() + 3, links.end() - 2);
  }
  return links;
}

namespace detail {

/// Appends choices with `basis` at the points and at link origins, for those of `routes` that the
/// tree permits.
template <class Scalar>
void append_choices(const Tree<Scalar>& tree, TaskBasis basis,
                    std::initializer_list<LambdaRoute> routes, std::vector<LambdaChoice>& choices) {
  for (const LambdaRoute route : routes) {
    for (const bool at_link_origin : {false, true}) {
      basis.at_link_origin = at_link_origin;
      if (permits(tree, basis, route)) {
        choices.push_back({basis, route});
      }
    }
  }
}

}  // namespace detail

/// All ways to compute Lambda^-1 in the axes of the scene.
template <class Scalar>
std::vector<LambdaChoice> lambda_choices(const Tree<Scalar>& tree) {
  using enum LambdaRoute;
  std::vector<LambdaChoice> choices;
  detail::append_choices(
      tree, {}, {unit_forces, factors_inward, factors_world, branching, inertia_propagation},
      choices);
  for (const int link : axes_links(tree)) {
    if (permits_turning(tree, link)) {
      detail::append_choices(tree, {false, false, link}, {factors_inward, factors_world}, choices);
      if (link == tree.operational_points.front().link) {
        detail::append_choices(tree, {false, false, link},
                               {unit_forces, branching, inertia_propagation}, choices);
      }
    }
  }
  return choices;
}

/// All ways to compute Lambda^-1 for a control torque, which may use other axes than those of the
/// scene. What is solved at links' origins is solved in their axes. Priorities require the rows of
/// the scene.
template <class Scalar>
std::vector<LambdaChoice> control_choices(const Tree<Scalar>& tree) {
  using enum LambdaRoute;
  if (has_priorities(tree)) {
    return lambda_choices(tree);
  }
  std::vector<LambdaChoice> choices;
  detail::append_choices(tree, {}, {unit_forces, factors_inward, factors_world}, choices);
  std::erase_if(choices, [](const LambdaChoice& choice) { return choice.basis.at_link_origin; });
  detail::append_choices(tree, {true, false}, {unit_forces, factors_inward}, choices);
  for (const LambdaRoute route : {branching, inertia_propagation}) {
    const TaskBasis basis{true, true};  // at the points it cost more for every robot tried
    const bool several = tree.operational_points.size() > 1;
    if (permits(tree, basis, route) && !(several && route == inertia_propagation)) {
      choices.push_back({basis, route});
    }
  }
  for (const int link : axes_links(tree)) {
    detail::append_choices(tree, {false, false, link}, {factors_inward, factors_world}, choices);
  }
  return choices;
}

}  // namespace treeline
