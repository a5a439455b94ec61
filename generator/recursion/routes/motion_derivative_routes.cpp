#include "recursion/routes/motion_derivative_routes.hpp"

#include "recursion/methods/kinetic_energy_derivatives.hpp"
#include "recursion/methods/point_motion_derivatives.hpp"
#include "recursion/routes/result_parts.hpp"

namespace treeline {

std::vector<Route> kinetic_energy_derivative_routes() {
  return {{{"carried-momentum", "momentum of what each joint carries"}, [](const Trace& trace) {
             const auto d =
                 kinetic_energy_derivatives<Expression>(trace.tree, trace.X, {trace.qd(), {}});
             return std::vector<Result>{
                 vector_result("dT_dq", by_displacements(*trace.mechanism), d.dq),
                 vector_result("dT_dqd", "by qd: M qd", d.dqd)};
           }}};
}

std::vector<Route> point_velocity_derivative_routes() {
  return {
      {{"inward", "inward from each point, as carriers see it"}, [](const Trace& trace) {
         const auto d = point_motion_derivatives<Expression>(trace.tree, trace.X, {trace.qd(), {}});
         return std::vector<Result>{
             matrix_result("dv_dq", by_displacements(*trace.mechanism), d.dv_dq),
             matrix_result("dv_dqd", "by qd: six rows of J a point", d.J)};
       }}};
}

std::vector<Route> point_acceleration_derivative_routes() {
  return {{{"inward", "inward from each point, as carriers see it"}, [](const Trace& trace) {
             const auto d = point_motion_derivatives<Expression>(trace.tree, trace.X,
                                                                 {trace.qd(), trace.qdd()});
             return std::vector<Result>{
                 matrix_result("da_dq", by_displacements(*trace.mechanism), d.da_dq),
                 matrix_result("da_dqd", "by qd", d.da_dqd),
                 matrix_result("da_dqdd", "by qdd: six rows of J a point", d.J)};
           }}};
}

}  // namespace treeline
