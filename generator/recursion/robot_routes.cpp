#include "recursion/robot_routes.hpp"

#include <fmt/format.h>

#include <utility>

#include "recursion/coriolis_matrix.hpp"
#include "recursion/describe_choice.hpp"
#include "recursion/energy_regressor.hpp"
#include "recursion/forward_dynamics.hpp"
#include "recursion/kinetic_energy.hpp"
#include "recursion/motion_derivative_routes.hpp"
#include "recursion/operational_quantities.hpp"
#include "recursion/point_motion.hpp"
#include "recursion/potential_energy.hpp"
#include "recursion/resolved_by_pivots.hpp"
#include "recursion/trace_parts.hpp"

namespace treeline {
namespace {

using Expressions = std::vector<Expression>;
using TracedTree = Tree<Expression>;
using Outputs = std::vector<Result>;

Outputs vector_output(const char* name, const std::string& meaning, Expressions values) {
  return {vector_result(name, meaning, std::move(values))};
}
Outputs matrix_output(const char* name, const std::string& meaning,
                      const DenseMatrix<Expression>& matrix) {
  return {matrix_result(name, meaning, matrix)};
}

Outputs point_poses(const RobotTrace& trace) {
  const auto poses = trace.poses();
  Expressions positions;
  Expressions rotations;
  for (const TreePoint<Expression>& point : trace.tree.operational_points) {
    const WorldPose<Expression> pose = point_pose(poses, point);
    positions.insert(positions.end(), {pose.p.x, pose.p.y, pose.p.z});
    for (const auto& row : {pose.R.row_x, pose.R.row_y, pose.R.row_z}) {
      rotations.insert(rotations.end(), {row.x, row.y, row.z});
    }
  }
  const int count = static_cast<int>(trace.tree.operational_points.size());
  return {{{"position", 3 * count, 1, "positions in the world, m, one point after the other"},
           positions},
          {{"rotation", 9 * count, 1,
            "rotation matrices, row-major, point's axes to world, one point after the other"},
           rotations}};
}

std::vector<RobotRoute> jacobian_routes(const TracedTree& tree) {
  std::vector<RobotRoute> routes{
      {{"inward", "rows carried inward from each point"}, [](const RobotTrace& trace) {
         const auto poses = trace.poses();
         const auto tasks = task_points(trace.tree, {}, poses);
         return matrix_output("J", "Jacobian",
                              jacobian_inward(trace.tree, trace.X, tasks, trace.rows, poses));
       }}};
  if (permits(tree, {}, LambdaRoute::factors_world)) {
    routes.push_back({{"poses", "from the poses of all links"}, [](const RobotTrace& trace) {
                        return matrix_output(
                            "J", "Jacobian",
                            jacobian_world(trace.tree, trace.poses(), {}, trace.rows));
                      }});
  }
  return routes;
}

Expressions net_forces(const RobotTrace& trace) {
  const auto h = inverse_dynamics<Expression>(trace.tree, trace.X, {trace.qd, {}}, trace.applied());
  Expressions net = trace.tau;
  for (std::size_t i = 0; i < net.size(); ++i) {
    net[i] = net[i] - h[i];
  }
  return net;
}

std::vector<RobotRoute> forward_dynamics_routes(const TracedTree& tree) {
  std::vector<RobotRoute> routes{
      {{"ltdl", "M = L^T D L by composite bodies, sparse solve (RBDA section 6.5)"},
       [](const RobotTrace& trace) {
         const auto factor = factor_ltdl(mass_matrix(trace.tree, trace.X));
         return vector_output("qdd", trace.with_unit("joint accelerations", Quantity::qdd),
                              solve(factor, net_forces(trace)));
       }}};
  if (!tree.has_mimics) {
    routes.push_back({{"aba", "articulated bodies, Chang table 4.2"}, [](const RobotTrace& trace) {
                        return vector_output(
                            "qdd", trace.with_unit("joint accelerations", Quantity::qdd),
                            solve_articulated(trace.tree, trace.X, articulate(trace.tree, trace.X),
                                              net_forces(trace)));
                      }});
  }
  return routes;
}

std::vector<RobotRoute> lambda_routes(const TracedTree& tree, bool invert, TaskLaws& laws) {
  std::vector<RobotRoute> routes;
  const auto law =
      invert ? laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {}) : nullptr;
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    routes.push_back({route_id(choice, tree),
                      [choice, invert](const RobotTrace& trace) {
                        const auto Lambda_inv =
                            lambda_inverse_as_asked(trace.tree, trace.X, choice, trace.rows);
                        return invert
                                   ? matrix_output("Lambda", "operational-space inertia",
                                                   inverse(factor_ldlt(Lambda_inv, trace.rule)))
                                   : matrix_output("Lambda_inv",
                                                   "inverse operational-space inertia", Lambda_inv);
                      },
                      law});
  }
  return routes;
}

/// As many joints as rows: by cofactors, or by pivots that may yield.
void append_resolved_routes(const Mechanism& mechanism, const TracedTree& tree, TaskLaws& laws,
                            std::vector<RobotRoute>& routes) {
  if (!permits_resolved_acceleration(tree)) {
    return;
  }
  const auto inputs = [](const RobotTrace& trace) -> ControlInputs<Expression> {
    return {{trace.qd, trace.qdd}, trace.xdd_cmd, trace.applied()};
  };
  if (mechanism.singular == SingularTasks::exact) {
    for (const int link : axes_links(tree)) {
      routes.push_back({{"resolved", "resolved acceleration, spherical wrist", axes_key(link),
                         fmt::format("J in {}", axes_name(link, tree))},
                        [link, inputs](const RobotTrace& trace) {
                          return vector_output("tau",
                                               trace.with_unit("joint forces", Quantity::tau),
                                               control_torque_by_resolved_acceleration<Expression>(
                                                   trace.tree, trace.X, inputs(trace), link));
                        }});
    }
    return;
  }
  for (int link = 0; link < 3; ++link) {
    const auto law = laws.resolved(link);
    if (!law) continue;
    routes.push_back({{"resolved-pivots", "resolved acceleration, spherical wrist, by pivots",
                       fmt::format("{}+{}", axes_key(link), axes_key(law->angular_axes_link)),
                       fmt::format("J in {} and {}", axes_name(link, tree),
                                   axes_name(law->angular_axes_link, tree))},
                      [law, inputs](const RobotTrace& trace) {
                        return vector_output("tau", trace.with_unit("joint forces", Quantity::tau),
                                             control_torque_by_pivots<Expression>(
                                                 trace.tree, trace.X, inputs(trace), *law));
                      },
                      law});
  }
}

std::vector<RobotRoute> control_routes(const Mechanism& mechanism, const TracedTree& tree,
                                       TaskLaws& laws) {
  std::vector<RobotRoute> routes;
  const auto kind =
      has_priorities(tree) ? TaskLaw::Kind::priorities : TaskLaw::Kind::inverse_inertia;
  for (const LambdaChoice& choice : control_choices(tree)) {
    // Table 5.1 gives Lambda itself, behind a floating joint, where nothing can be lost.
    const bool solves = choice.route != LambdaRoute::inertia_propagation || has_priorities(tree);
    routes.push_back(
        {has_priorities(tree)
             ? on_top_of(route_id(choice, tree), "fused-by-priority",
                         "Chang table 6.1, fused, LDL^T in order of priority")
             : on_top_of(route_id(choice, tree), "fused", "Chang table 6.1, fused"),
         [choice](const RobotTrace& trace) {
           return vector_output(
               "tau", trace.with_unit("joint forces", Quantity::tau),
               control_torque<Expression>(trace.tree, trace.X,
                                          {{trace.qd, trace.qdd}, trace.xdd_cmd, trace.applied()},
                                          choice, trace.rows, trace.rule));
         },
         solves ? laws.find(kind, LawPoints::operational, control_basis(tree, choice)) : nullptr});
  }
  append_resolved_routes(mechanism, tree, laws, routes);
  return routes;
}

std::vector<RobotRoute> newton_euler_route(const char* name) {
  return {{{"rnea", "recursive Newton-Euler, Chang table 4.1"}, [name](const RobotTrace& trace) {
             return vector_output(name, trace.with_unit("joint forces", Quantity::tau),
                                  inverse_dynamics<Expression>(
                                      trace.tree, trace.X, {trace.qd, trace.qdd}, trace.applied()));
           }}};
}

std::vector<RobotRoute> coriolis_routes() {
  return {{{"composite-bodies", "composite bodies, Echeandia & Wensing 2021"},
           [](const RobotTrace& trace) {
             return matrix_output("C", "Coriolis matrix",
                                  coriolis_matrix<Expression>(trace.tree, trace.X, trace.qd));
           }}};
}

std::vector<RobotRoute> kinetic_energy_routes() {
  return {{{"outward", "outward recursion"}, [](const RobotTrace& trace) {
             return vector_output("energy", "kinetic energy, J",
                                  {kinetic_energy<Expression>(trace.tree, trace.X, trace.qd)});
           }}};
}

std::vector<RobotRoute> potential_energy_routes() {
  return {
      {{"composite-moments", "first moments of the composite bodies"}, [](const RobotTrace& trace) {
         return vector_output("energy", "potential energy, J",
                              {potential_energy(trace.tree, trace.X)});
       }}};
}

std::vector<RobotRoute> inverse_dynamics_regressor_routes() {
  return {{{"unit-motions", "forces of unit parameters along the unit motions of the joints"},
           [](const RobotTrace& trace) {
             return matrix_output(
                 "Y", "regressor of the joint forces",
                 inverse_dynamics_regressor<Expression>(trace.tree, trace.X, {trace.qd, trace.qdd},
                                                        regressor_columns(*trace.mechanism)));
           }}};
}

std::vector<RobotRoute> energy_regressor_routes() {
  return {{{"outward", "energies of unit parameters"}, [](const RobotTrace& trace) {
             return matrix_output(
                 "E", "regressor of kinetic over potential energy",
                 energy_regressor<Expression>(trace.tree, trace.X, trace.qd,
                                              regressor_columns(*trace.mechanism)));
           }}};
}

std::vector<RobotRoute> pose_routes() {
  return {{{"outward", "outward recursion"}, point_poses}};
}

std::vector<RobotRoute> point_velocity_routes() {
  return {{{"outward", "outward recursion"}, [](const RobotTrace& trace) {
             return vector_output("velocity",
                                  "velocity over angular velocity, world axes, m/s, rad/s, one "
                                  "point after the other",
                                  point_velocities<Expression>(trace.tree, trace.X, trace.qd));
           }}};
}

std::vector<RobotRoute> point_acceleration_routes() {
  return {{{"outward", "outward recursion, Chang eq. 6.11"}, [](const RobotTrace& trace) {
             return vector_output(
                 "acceleration",
                 "acceleration over angular acceleration, world axes, m/s^2, rad/s^2, one point "
                 "after the other",
                 point_accelerations<Expression>(trace.tree, trace.X, {trace.qd, trace.qdd}));
           }}};
}

DenseMatrix<Expression> jacobian_by(LambdaRoute route, const RobotTrace& trace) {
  const auto poses = trace.poses();
  return route == LambdaRoute::factors_world
             ? jacobian_world(trace.tree, poses, {}, trace.rows)
             : jacobian_inward(trace.tree, trace.X, task_points(trace.tree, {}, poses), trace.rows,
                               poses);
}

/// Of Jbar, and with it of the projector: by the factors of M, which mimic joints permit.
std::vector<RobotRoute> consistent_inverse_routes(const TracedTree& tree, bool project,
                                                  TaskLaws& laws) {
  const auto law = laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {});
  std::vector<RobotRoute> routes;
  for (const LambdaRoute route : {LambdaRoute::factors_inward, LambdaRoute::factors_world}) {
    if (!permits(tree, {}, route)) continue;
    routes.push_back(
        {route_id(LambdaChoice{{}, route}, tree),
         [route, project](const RobotTrace& trace) {
           const auto J = jacobian_by(route, trace);
           const auto Jbar = dynamically_consistent_inverse(trace.tree, trace.X, J, trace.rule);
           return project ? matrix_output("N", "null-space projector 1 - Jbar J",
                                          null_space_projector(Jbar, J))
                          : matrix_output("Jbar", "dynamically consistent inverse of J", Jbar);
         },
         law});
  }
  return routes;
}

std::vector<RobotRoute> operational_force_routes(const TracedTree& tree, bool of_gravity,
                                                 TaskLaws& laws) {
  const auto law = laws.find(TaskLaw::Kind::inverse_inertia, LawPoints::operational, {});
  std::vector<RobotRoute> routes;
  for (const LambdaChoice& choice : lambda_choices(tree)) {
    routes.push_back(
        {on_top_of(route_id(choice, tree), "released",
                   "from the acceleration of the released task"),
         [choice, of_gravity](const RobotTrace& trace) {
           return of_gravity ? vector_output("p", "forces of gravity in the task rows, N, N m",
                                             operational_gravity(trace.tree, trace.X, choice,
                                                                 trace.rows, trace.rule))
                             : vector_output("mu", "forces of velocities in the task rows, N, N m",
                                             operational_bias_force<Expression>(
                                                 trace.tree, trace.X, choice, trace.rows,
                                                 trace.rule, trace.qd));
         },
         law});
  }
  return routes;
}

std::vector<RobotRoute> bias_routes() {
  return {{{"outward", "outward recursion, Chang eq. 6.11"}, [](const RobotTrace& trace) {
             const auto tasks = task_points(trace.tree, {}, trace.poses());
             return vector_output(
                 "bias", "accelerations of the task rows at qdd = 0, m/s^2, rad/s^2",
                 bias_acceleration<Expression>(trace.tree, trace.X, tasks, trace.qd));
           }}};
}

std::vector<RobotRoute> mass_matrix_routes() {
  return {{{"crba", "composite rigid bodies, RBDA table 6.2"}, [](const RobotTrace& trace) {
             return matrix_output("M", "joint-space inertia", mass_matrix(trace.tree, trace.X));
           }}};
}

}  // namespace

std::vector<RobotRoute> robot_routes(Function function, const Mechanism& mechanism,
                                     const TracedTree& tree) {
  TaskLaws laws(mechanism);
  switch (function) {
    case Function::forward_kinematics:
      return pose_routes();
    case Function::jacobian:
      return jacobian_routes(tree);
    case Function::bias_acceleration:
      return bias_routes();
    case Function::inverse_dynamics:
      return newton_euler_route("tau");
    case Function::gravity:
      return newton_euler_route("g");
    case Function::nonlinear_effects:
      return newton_euler_route("h");
    case Function::mass_matrix:
      return mass_matrix_routes();
    case Function::forward_dynamics:
      return forward_dynamics_routes(tree);
    case Function::coriolis_matrix:
      return coriolis_routes();
    case Function::kinetic_energy:
      return kinetic_energy_routes();
    case Function::kinetic_energy_derivatives:
      return kinetic_energy_derivative_routes();
    case Function::potential_energy:
      return potential_energy_routes();
    case Function::inverse_dynamics_regressor:
      return inverse_dynamics_regressor_routes();
    case Function::energy_regressor:
      return energy_regressor_routes();
    case Function::lambda_inverse:
      return lambda_routes(tree, false, laws);
    case Function::lambda:
      return lambda_routes(tree, true, laws);
    case Function::control_torque:
      return control_routes(mechanism, tree, laws);
    case Function::point_velocity:
      return point_velocity_routes();
    case Function::point_acceleration:
      return point_acceleration_routes();
    case Function::point_velocity_derivatives:
      return point_velocity_derivative_routes();
    case Function::point_acceleration_derivatives:
      return point_acceleration_derivative_routes();
    case Function::dynamically_consistent_inverse:
      return consistent_inverse_routes(tree, false, laws);
    case Function::null_space_projector:
      return consistent_inverse_routes(tree, true, laws);
    case Function::operational_bias_force:
      return operational_force_routes(tree, false, laws);
    case Function::operational_gravity:
      return operational_force_routes(tree, true, laws);
    case Function::object_state:
    case Function::object_control_torque:
    case Function::object_forward_dynamics:
    case Function::contact_motion:
    case Function::contact_inverse_inertia:
    case Function::effective_mass:
    case Function::impulse_response:
    case Function::constrained_forward_dynamics:
    case Function::supported_control_torque:
    case Function::constraint_jacobian:
    case Function::constraint_errors:
    case Function::link_inverse_inertias:
    case Function::center_of_mass:
    case Function::center_of_mass_jacobian:
    case Function::centroidal_momentum_matrix:
    case Function::centroidal_momentum:
    case Function::centroidal_bias:
    case Function::center_of_mass_bias_acceleration:
    case Function::centroidal_momentum_derivatives:
    case Function::centroidal_momentum_rate_derivatives:
    case Function::subtree_masses_and_centers:
    case Function::inverse_dynamics_derivatives:
    case Function::forward_dynamics_derivatives:
    case Function::damped_control_torque:
      break;  // traced elsewhere
  }
  return {};
}

}  // namespace treeline
