#include "recursion/routes/posture_routes.hpp"

#include <stdexcept>
#include <string>
#include <utility>

#include "recursion/methods/centroidal_derivatives.hpp"
#include "recursion/routes/result_parts.hpp"

namespace treeline {
namespace {

using Outputs = std::vector<Result>;

RouteId posture_route(Function function) {
  switch (function) {
    case Function::centroidal_momentum_matrix:
      return {"composite-bodies", "composite bodies about the centre of mass"};
    case Function::centroidal_momentum_derivatives:
    case Function::centroidal_momentum_rate_derivatives:
      return {"composite-changes", "changes of what each joint carries, about the centre of mass"};
    case Function::centroidal_momentum:
    case Function::centroidal_bias:
    case Function::center_of_mass_bias_acceleration:
      return {"outward-inward", "motions outward, their sum inward"};
    default:
      return {"composite-moments", "first moments of the composite bodies"};
  }
}

Outputs vector_of(const char* name, const char* meaning, const Vector3<Expression>& v) {
  return {vector_result(name, meaning, {v.x, v.y, v.z})};
}

Outputs vector_of(const char* name, const char* meaning, const Wrench<Expression>& w) {
  return {vector_result(name, meaning, {w.f.x, w.f.y, w.f.z, w.n.x, w.n.y, w.n.z})};
}

Outputs subtrees(const Trace& trace) {
  std::vector<Expression> masses;
  std::vector<Expression> centers;
  for (const auto& [mass, center] : subtree_matter(trace.tree, trace.X)) {
    masses.push_back(mass);
    centers.insert(centers.end(), {center.x, center.y, center.z});
  }
  return {vector_result("mass", "kg, of each link with everything beyond it", std::move(masses)),
          vector_result("center",
                        "their centres of mass in the world, m, one link after the other; of no "
                        "mass the link's origin",
                        std::move(centers))};
}

Outputs momentum_derivatives(const Trace& trace) {
  return {matrix_result(
              "dh_dq", by_displacements(*trace.mechanism),
              centroidal_momentum_by_displacements<Expression>(trace.tree, trace.X, trace.qd())),
          matrix_result("dh_dqd", "by qd: A_G", centroidal_momentum_matrix(trace.tree, trace.X))};
}

Outputs momentum_rate_derivatives(const Trace& trace) {
  const auto d =
      centroidal_rate_derivatives<Expression>(trace.tree, trace.X, {trace.qd(), trace.qdd()});
  return {
      matrix_result("dhd_dq", by_displacements(*trace.mechanism), d.dq),
      matrix_result("dhd_dqd", "by qd", d.dqd),
      matrix_result("dhd_dqdd", "by qdd: A_G", centroidal_momentum_matrix(trace.tree, trace.X))};
}

Outputs posture_results(Function function, const Trace& trace) {
  const auto& tree = trace.tree;
  const auto& X = trace.X;
  const auto& qd = trace.qd();
  switch (function) {
    case Function::center_of_mass:
      return vector_of("com", "centre of mass in the world, m", center_of_mass(tree, X));
    case Function::center_of_mass_jacobian:
      return {matrix_result("J_com", "Jacobian of the centre of mass, world axes",
                            center_of_mass_jacobian(tree, X))};
    case Function::centroidal_momentum_matrix:
      return {matrix_result("A_G", "momentum over angular momentum, world axes",
                            centroidal_momentum_matrix(tree, X))};
    case Function::centroidal_momentum:
      return vector_of("h_G", "momentum, N s, over angular momentum, N m s, world axes",
                       centroidal_momentum<Expression>(tree, X, qd));
    case Function::centroidal_bias:
      return vector_of("bias", "force, N, over moment about the centre of mass, N m, world axes",
                       centroidal_bias<Expression>(tree, X, qd));
    case Function::center_of_mass_bias_acceleration:
      return vector_of("bias", "acceleration of the centre of mass at qdd = 0, m/s^2, world axes",
                       center_of_mass_bias_acceleration<Expression>(tree, X, qd));
    case Function::centroidal_momentum_derivatives:
      return momentum_derivatives(trace);
    case Function::centroidal_momentum_rate_derivatives:
      return momentum_rate_derivatives(trace);
    case Function::subtree_masses_and_centers:
      return subtrees(trace);
    default:
      throw std::logic_error(std::string(function_name(function)) +
                             " is not about the centre of mass");
  }
}

}  // namespace

std::vector<Route> posture_routes(const RouteQuery& query) {
  return {{posture_route(query.function), [function = query.function](const Trace& trace) {
             return posture_results(function, trace);
           }}};
}

}  // namespace treeline
