#pragma once

#include <string>
#include <vector>

#include "program/ending.hpp"
#include "recursion/routes/trace.hpp"

namespace treeline {

/// The routes to a function that is about the robot or its operational points, at least one; none
/// for other functions.
std::vector<Route> robot_routes(const RouteQuery& query);

/// The routes to a function that is about the centre of mass, at least one.
std::vector<Route> posture_routes(const RouteQuery& query);

/// The routes to derivatives of inverse or forward dynamics, at least one. Results are nv x nv,
/// row-major: entry (i, j) is the change of result i per unit of velocity, acceleration, force or
/// displacement j. A displacement is a tangent: for a floating joint a twist of the child in its
/// own axes (linear over angular), for every other joint a change of its coordinate.
std::vector<Route> derivative_routes(const RouteQuery& query);

/// The routes to a function that is about contacts or links, at least one.
std::vector<Route> contact_routes(const RouteQuery& query);

/// Key of the routes that eliminate what constraints determine.
inline constexpr const char* kEliminatedKey = "eliminated";

/// Why there is no such route to the function, and what to do; empty if there is.
std::string why_not_eliminated(const Mechanism& mechanism, Function function);

/// The routes to a function that is about constraints, at least one.
std::vector<Route> constraint_routes(const RouteQuery& query);

/// The routes to a function that is about held objects, at least one.
std::vector<Route> object_routes(const RouteQuery& query);

// Routes to functions of the task that solve with Lambda^-1, see `robot_routes`.

/// To Lambda^-1, or to Lambda if `invert`.
std::vector<Route> lambda_routes(const Tree<Expression>& tree, bool invert, TaskLaws& laws);

std::vector<Route> control_routes(const Mechanism& mechanism, const Tree<Expression>& tree,
                                  TaskLaws& laws);

/// To the dynamically consistent inverse Jbar, or to the projector 1 - Jbar J if `project`: by the
/// factors of M, which mimic joints permit.
std::vector<Route> consistent_inverse_routes(const Tree<Expression>& tree, bool project,
                                             TaskLaws& laws);

/// To the forces of gravity in the task rows, or to those of velocities.
std::vector<Route> operational_force_routes(const Tree<Expression>& tree, bool of_gravity,
                                            TaskLaws& laws);

// Routes to derivatives of energy and of the motion of points, see `robot_routes`.

std::vector<Route> kinetic_energy_derivative_routes();
std::vector<Route> point_velocity_derivative_routes();
std::vector<Route> point_acceleration_derivative_routes();

/// Whether functions of the tree may be computed in one common frame, see
/// `runtime/emitted/common_frame.h`: joints have one freedom of their own each and are numbered
/// depth first, a base may float, and inertias are constants.
bool suits_common_frame(const Tree<Expression>& tree);

/// M by lines for the links' places and a routine for the rest. Joints' rotations are not deferred
/// in the trace.
Ending end_with_mass_matrix(const Trace& trace);

/// Derivatives of joint forces, likewise. No forces act at points.
Ending end_with_force_derivatives(const Trace& trace);

/// Derivatives of accelerations, likewise.
Ending end_with_acceleration_derivatives(const Trace& trace);

}  // namespace treeline
