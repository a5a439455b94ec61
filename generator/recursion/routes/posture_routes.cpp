#include <array>
#include <utility>

#include "functions/function_table.hpp"
#include "recursion/methods/centroidal_derivatives.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"

namespace treeline {
namespace {

using Outputs = std::vector<Result>;

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

const RouteId kCompositeMoments{"composite-moments", "first moments of the composite bodies"};
const RouteId kCompositeBodies{"composite-bodies", "composite bodies about the centre of mass"};
const RouteId kMotionSums{"outward-inward", "motions outward, their sum inward"};
const RouteId kCompositeChanges{"composite-changes",
                                "changes of what each joint carries, about the centre of mass"};

struct PostureRow {
  Function function;
  const RouteId& id;
  Outputs (*results)(const Trace& trace);
};

constexpr auto kPosture = std::to_array<PostureRow>({
    {Function::center_of_mass, kCompositeMoments,
     [](const Trace& t) {
       return vector_of("com", "centre of mass in the world, m", center_of_mass(t.tree, t.X));
     }},
    {Function::center_of_mass_jacobian, kCompositeMoments,
     [](const Trace& t) -> Outputs {
       return {matrix_result("J_com", "Jacobian of the centre of mass, world axes",
                             center_of_mass_jacobian(t.tree, t.X))};
     }},
    {Function::centroidal_momentum_matrix, kCompositeBodies,
     [](const Trace& t) -> Outputs {
       return {matrix_result("A_G", "momentum over angular momentum, world axes",
                             centroidal_momentum_matrix(t.tree, t.X))};
     }},
    {Function::centroidal_momentum, kMotionSums,
     [](const Trace& t) {
       return vector_of("h_G", "momentum, N s, over angular momentum, N m s, world axes",
                        centroidal_momentum<Expression>(t.tree, t.X, t.qd()));
     }},
    {Function::centroidal_bias, kMotionSums,
     [](const Trace& t) {
       return vector_of("bias", "force, N, over moment about the centre of mass, N m, world axes",
                        centroidal_bias<Expression>(t.tree, t.X, t.qd()));
     }},
    {Function::center_of_mass_bias_acceleration, kMotionSums,
     [](const Trace& t) {
       return vector_of("bias", "acceleration of the centre of mass at qdd = 0, m/s^2, world axes",
                        center_of_mass_bias_acceleration<Expression>(t.tree, t.X, t.qd()));
     }},
    {Function::centroidal_momentum_derivatives, kCompositeChanges, momentum_derivatives},
    {Function::centroidal_momentum_rate_derivatives, kCompositeChanges, momentum_rate_derivatives},
    {Function::subtree_masses_and_centers, kCompositeMoments, subtrees},
});
static_assert(covers<is_about<FunctionGroup::center_of_mass>>(kPosture));

}  // namespace

std::vector<Route> posture_routes(const RouteQuery& query) {
  const PostureRow* const row = find_row(kPosture, query.function);
  return {{row->id, row->results}};
}

}  // namespace treeline
