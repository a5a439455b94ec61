#include <array>

#include "functions/function_table.hpp"
#include "recursion/methods/coriolis_matrix.hpp"
#include "recursion/methods/energy_regressor.hpp"
#include "recursion/methods/forward_dynamics.hpp"
#include "recursion/methods/kinetic_energy.hpp"
#include "recursion/methods/point_motion.hpp"
#include "recursion/methods/potential_energy.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"

namespace treeline {
namespace {

std::vector<Result> point_poses(const Trace& trace) {
  const auto poses = trace.poses();
  std::vector<Expression> positions;
  std::vector<Expression> rotations;
  for (const TreePoint<Expression>& point : trace.tree.operational_points) {
    const WorldPose<Expression> pose = pose_of(trace.tree, trace.X, poses, point);
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

std::vector<Route> jacobian_routes(const Tree<Expression>& tree) {
  std::vector<Route> routes{
      {{"inward", "rows carried inward from each point"}, [](const Trace& trace) {
         const auto poses = trace.poses();
         const auto tasks = task_points(trace.tree, {}, poses);
         return matrix_output("J", "Jacobian",
                              jacobian_inward(trace.tree, trace.X, tasks, trace.rows(), poses));
       }}};
  if (permits(tree, {}, LambdaRoute::factors_world)) {
    routes.push_back({{"poses", "from the poses of all links"}, [](const Trace& trace) {
                        return matrix_output(
                            "J", "Jacobian",
                            jacobian_world(trace.tree, trace.poses(), {}, trace.rows()));
                      }});
  }
  return routes;
}

std::vector<Expression> net_forces(const Trace& trace) {
  const auto h =
      inverse_dynamics<Expression>(trace.tree, trace.X, {trace.qd(), {}}, trace.applied());
  std::vector<Expression> net = trace.tau();
  for (std::size_t i = 0; i < net.size(); ++i) {
    net[i] = net[i] - h[i];
  }
  return net;
}

std::vector<Route> forward_dynamics_routes(const Tree<Expression>& tree) {
  std::vector<Route> routes{
      {{"ltdl", "M = L^T D L by composite bodies, sparse solve (RBDA section 6.5)"},
       [](const Trace& trace) {
         const auto factor = factor_ltdl(mass_matrix(trace.tree, trace.X));
         return vector_output("qdd", trace.with_unit("joint accelerations", Quantity::qdd),
                              solve(factor, net_forces(trace)));
       }}};
  if (find_clusters(tree)) {
    routes.push_back(
        {{"aba", tree.has_mimics ? "articulated bodies, followers one joint with their "
                                   "leader (Chang table 4.2)"
                                 : "articulated bodies, Chang table 4.2"},
         [](const Trace& trace) {
           return vector_output(
               "qdd", trace.with_unit("joint accelerations", Quantity::qdd),
               solve_articulated(trace.tree, trace.X, articulate(trace.tree, trace.X),
                                 net_forces(trace)));
         }});
  }
  return routes;
}

std::vector<Route> newton_euler_route(const char* name) {
  return {{{"rnea", "recursive Newton-Euler, Chang table 4.1"}, [name](const Trace& trace) {
             return vector_output(
                 name, trace.with_unit("joint forces", Quantity::tau),
                 inverse_dynamics<Expression>(trace.tree, trace.X, {trace.qd(), trace.qdd()},
                                              trace.applied()));
           }}};
}

std::vector<Route> coriolis_routes() {
  return {
      {{"composite-bodies", "composite bodies, Echeandia & Wensing 2021"}, [](const Trace& trace) {
         return matrix_output("C", "Coriolis matrix",
                              coriolis_matrix<Expression>(trace.tree, trace.X, trace.qd()));
       }}};
}

std::vector<Route> kinetic_energy_routes() {
  return {{{"outward", "outward recursion"}, [](const Trace& trace) {
             return vector_output("energy", "kinetic energy, J",
                                  {kinetic_energy<Expression>(trace.tree, trace.X, trace.qd())});
           }}};
}

std::vector<Route> potential_energy_routes() {
  return {{{"composite-moments", "first moments of the composite bodies"}, [](const Trace& trace) {
             return vector_output("energy", "potential energy, J",
                                  {potential_energy(trace.tree, trace.X)});
           }}};
}

std::vector<Route> inverse_dynamics_regressor_routes() {
  return {{{"unit-motions", "forces of unit parameters along the unit motions of the joints"},
           [](const Trace& trace) {
             return matrix_output("Y", "regressor of the joint forces",
                                  inverse_dynamics_regressor<Expression>(
                                      trace.tree, trace.X, {trace.qd(), trace.qdd()},
                                      regressor_columns(*trace.mechanism)));
           }}};
}

std::vector<Route> energy_regressor_routes() {
  return {{{"outward", "energies of unit parameters"}, [](const Trace& trace) {
             return matrix_output(
                 "E", "regressor of kinetic over potential energy",
                 energy_regressor<Expression>(trace.tree, trace.X, trace.qd(),
                                              regressor_columns(*trace.mechanism)));
           }}};
}

std::vector<Route> pose_routes() {
  return {{{"outward", "outward recursion"}, point_poses}};
}

std::vector<Route> point_velocity_routes() {
  return {{{"outward", "outward recursion"}, [](const Trace& trace) {
             return vector_output("velocity",
                                  "velocity over angular velocity, world axes, m/s, rad/s, one "
                                  "point after the other",
                                  point_velocities<Expression>(trace.tree, trace.X, trace.qd()));
           }}};
}

std::vector<Route> point_acceleration_routes() {
  return {{{"outward", "outward recursion, Chang eq. 6.11"}, [](const Trace& trace) {
             return vector_output(
                 "acceleration",
                 "acceleration over angular acceleration, world axes, m/s^2, rad/s^2, one point "
                 "after the other",
                 point_accelerations<Expression>(trace.tree, trace.X, {trace.qd(), trace.qdd()}));
           }}};
}

std::vector<Route> bias_routes() {
  return {{{"outward", "outward recursion, Chang eq. 6.11"}, [](const Trace& trace) {
             const auto tasks = task_points(trace.tree, {}, trace.poses());
             return vector_output(
                 "bias", "accelerations of the task rows at qdd = 0, m/s^2, rad/s^2",
                 bias_acceleration<Expression>(trace.tree, trace.X, tasks, trace.qd()));
           }}};
}

/// The mechanism whose routes are asked for, with its tree and its task laws.
struct Traced {
  const Mechanism& mechanism;
  const Tree<Expression>& tree;
  TaskLaws& laws;
  int lanes = 1;  ///< how many numbers the emitted code may compute together
};

std::vector<Route> mass_matrix_routes(const Traced& of) {
  std::vector<Route> routes{
      {{"crba", "composite rigid bodies, RBDA table 6.2"}, [](const Trace& trace) {
         return matrix_output("M", "joint-space inertia", mass_matrix(trace.tree, trace.X));
       }}};
  if (of.lanes > 1 && suits_common_frame(of.tree)) {
    Route route{{"common-frame", "composite rigid bodies in the base's frame, joints side by side"},
                {}};
    route.ending = end_with_mass_matrix;
    route.keeps_inertias = true;
    routes.push_back(std::move(route));
  }
  return routes;
}

struct RoutesOf {
  Function function;
  std::vector<Route> (*routes)(const Traced& of);
};

constexpr auto kRoutes = std::to_array<RoutesOf>({
    {Function::forward_kinematics, [](const Traced&) { return pose_routes(); }},
    {Function::jacobian, [](const Traced& of) { return jacobian_routes(of.tree); }},
    {Function::bias_acceleration, [](const Traced&) { return bias_routes(); }},
    {Function::inverse_dynamics, [](const Traced&) { return newton_euler_route("tau"); }},
    {Function::gravity, [](const Traced&) { return newton_euler_route("g"); }},
    {Function::nonlinear_effects, [](const Traced&) { return newton_euler_route("h"); }},
    {Function::mass_matrix, [](const Traced& of) { return mass_matrix_routes(of); }},
    {Function::forward_dynamics, [](const Traced& of) { return forward_dynamics_routes(of.tree); }},
    {Function::coriolis_matrix, [](const Traced&) { return coriolis_routes(); }},
    {Function::kinetic_energy, [](const Traced&) { return kinetic_energy_routes(); }},
    {Function::kinetic_energy_derivatives,
     [](const Traced&) { return kinetic_energy_derivative_routes(); }},
    {Function::potential_energy, [](const Traced&) { return potential_energy_routes(); }},
    {Function::inverse_dynamics_regressor,
     [](const Traced&) { return inverse_dynamics_regressor_routes(); }},
    {Function::energy_regressor, [](const Traced&) { return energy_regressor_routes(); }},
    {Function::lambda_inverse,
     [](const Traced& of) { return lambda_routes(of.tree, false, of.laws); }},
    {Function::lambda, [](const Traced& of) { return lambda_routes(of.tree, true, of.laws); }},
    {Function::control_torque,
     [](const Traced& of) { return control_routes(of.mechanism, of.tree, of.laws); }},
    {Function::point_velocity, [](const Traced&) { return point_velocity_routes(); }},
    {Function::point_acceleration, [](const Traced&) { return point_acceleration_routes(); }},
    {Function::point_velocity_derivatives,
     [](const Traced&) { return point_velocity_derivative_routes(); }},
    {Function::point_acceleration_derivatives,
     [](const Traced&) { return point_acceleration_derivative_routes(); }},
    {Function::dynamically_consistent_inverse,
     [](const Traced& of) { return consistent_inverse_routes(of.tree, false, of.laws); }},
    {Function::null_space_projector,
     [](const Traced& of) { return consistent_inverse_routes(of.tree, true, of.laws); }},
    {Function::operational_bias_force,
     [](const Traced& of) { return operational_force_routes(of.tree, false, of.laws); }},
    {Function::operational_gravity,
     [](const Traced& of) { return operational_force_routes(of.tree, true, of.laws); }},
});

/// Whether a function of the robot or its points has routes: one composed of others has none.
constexpr bool has_routes(const FunctionInfo& row) {
  return is_nameable(row) && is_about<FunctionGroup::robot, FunctionGroup::points>(row);
}
static_assert(covers<has_routes>(kRoutes));

}  // namespace

std::vector<Route> robot_routes(const RouteQuery& query) {
  const RoutesOf* const row = find_row(kRoutes, query.function);
  if (row == nullptr) return {};
  TaskLaws laws(query.mechanism);
  return row->routes({query.mechanism, query.tree, laws, query.lanes});
}

}  // namespace treeline
