#include <array>
#include <utility>

#include "functions/function_table.hpp"
#include "recursion/methods/contacts.hpp"
#include "recursion/methods/link_inverse_inertias.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/describe_choice.hpp"
#include "recursion/routes/result_parts.hpp"
#include "recursion/routes/routes_of_groups.hpp"

namespace treeline {
namespace {

using Expressions = std::vector<Expression>;
using TracedTree = Tree<Expression>;

/// The tree with its contacts as the points that rows of Lambda^-1 are about.
TracedTree tree_of_contact_tasks(TracedTree tree) {
  tree.operational_points = tree.contacts;
  return tree;
}

std::vector<Route> inverse_inertia_routes(const TracedTree& tree) {
  std::vector<Route> routes;
  const TracedTree tasks = tree_of_contact_tasks(tree);
  for (const LambdaChoice& choice : lambda_choices(tasks)) {
    routes.push_back(
        {route_id(choice, tasks), [choice](const Trace& trace) {
           const auto Lambda_inv = lambda_inverse_as_asked(
               tree_of_contact_tasks(trace.tree), trace.X, choice, 3 * trace.tree.contacts.size());
           const int size = static_cast<int>(Lambda_inv.rows());
           return std::vector<Result>{
               {{"Lambda_c_inv", size, size, "inverse inertia over all contacts, 1/kg, world axes"},
                Lambda_inv.values()}};
         }});
  }
  return routes;
}

std::vector<Result> masses(const DenseMatrix<Expression>& Lambda_inv, const PivotRule& law) {
  return {vector_result("mass", "effective masses, kg where the normal is a unit vector",
                        masses_along(Lambda_inv, law.borders))};
}

/// Couplings between contacts are traced and never used: what is not asked for is not emitted.
std::vector<Route> mass_routes(const Mechanism& mechanism, const TracedTree& tree) {
  const auto law = TaskLaws(mechanism).find(TaskLaw::Kind::normals, LawPoints::contacts, {});
  std::vector<Route> routes{
      {{"ltdl-inward", "M = L^T D L, J carried inward along each normal"},
       [](const Trace& trace) {
         const auto poses = trace.poses();
         const auto tasks =
             normal_tasks<Expression>(trace.tree, poses, trace.in[Quantity::normals]);
         return masses(
             lambda_inverse_by_factors(
                 trace.tree, trace.X,
                 jacobian_inward(trace.tree, trace.X, tasks, trace.tree.contacts.size(), poses)),
             trace.rule);
       },
       law}};
  if (!find_clusters(tree)) return routes;
  routes.push_back(
      {{"unit-forces", "a unit force along each normal propagated inward"},
       [](const Trace& t) {
         const auto tasks = normal_tasks<Expression>(t.tree, t.poses(), t.in[Quantity::normals]);
         return masses(lambda_inverse_by_unit_forces(t.tree, t.X, tasks, t.tree.contacts.size()),
                       t.rule);
       },
       law});
  if (tree.has_mimics) return routes;
  routes.push_back({{"link-inertias", "inverse inertias of the links, Chang eq. 8.2"},
                    [](const Trace& t) {
                      const auto tasks =
                          normal_tasks<Expression>(t.tree, t.poses(), t.in[Quantity::normals]);
                      return masses(lambda_inverse_by_branching(t.tree, t.X, tasks), t.rule);
                    },
                    law});
  return routes;
}

std::vector<Result> velocity_changes(Expressions dqd) {
  return {vector_result("dqd", "changes of the joint velocities", std::move(dqd))};
}

std::vector<Route> impulse_routes(const TracedTree& tree) {
  std::vector<Route> routes{
      {{"ltdl", "M = L^T D L by composite bodies, sparse solve (RBDA section 6.5)"},
       [](const Trace& trace) {
         return velocity_changes(impulse_response_by_factors(
             trace.tree, trace.X,
             impulses_on_links<Expression>(trace.tree, trace.poses(),
                                           trace.in[Quantity::impulse])));
       }}};
  if (find_clusters(tree)) {
    routes.push_back(
        {{"impulse-propagation", "impulse propagation, Chang table 8.2"}, [](const Trace& trace) {
           return velocity_changes(
               impulse_response(trace.tree, trace.X,
                                impulses_on_links<Expression>(trace.tree, trace.poses(),
                                                              trace.in[Quantity::impulse])));
         }});
  }
  return routes;
}

std::vector<Route> link_routes(const TracedTree& tree) {
  const auto result = [](Expressions entries) {
    return std::vector<Result>{vector_result(
        "Omega", "6x6 row-major for each link, at its frame and in its axes", std::move(entries))};
  };
  std::vector<Route> routes{
      {{"ltdl-inward", "M = L^T D L, J carried inward link by link"}, [result](const Trace& trace) {
         return result(link_inverse_inertias_by_factors(trace.tree, trace.X, trace.poses()));
       }}};
  if (tree.has_mimics) return routes;
  routes.push_back(
      {{"force-propagation", "force propagation, Chang table 5.2, over all links"},
       [result](const Trace& t) { return result(link_inverse_inertias(t.tree, t.X)); }});
  return routes;
}

std::vector<Result> trace_motion(const Trace& trace) {
  auto motion = contact_motion<Expression>(trace.tree, trace.X, trace.poses(), trace.qd());
  return {vector_result("position", "in the world, m, one contact after the other",
                        std::move(motion.position)),
          vector_result("velocity", "world axes, m/s, one contact after the other",
                        std::move(motion.velocity))};
}

struct ContactRow {
  Function function;
  std::vector<Route> (*routes)(const RouteQuery& query);
};

constexpr auto kContacts = std::to_array<ContactRow>({
    {Function::contact_motion,
     [](const RouteQuery&) -> std::vector<Route> {
       return {{{"outward", "outward recursion"}, trace_motion}};
     }},
    {Function::contact_inverse_inertia,
     [](const RouteQuery& query) { return inverse_inertia_routes(query.tree); }},
    {Function::effective_mass,
     [](const RouteQuery& query) { return mass_routes(query.mechanism, query.tree); }},
    {Function::impulse_response,
     [](const RouteQuery& query) { return impulse_routes(query.tree); }},
    {Function::link_inverse_inertias,
     [](const RouteQuery& query) { return link_routes(query.tree); }},
});
static_assert(covers<is_about<FunctionGroup::contacts, FunctionGroup::links>>(kContacts));

}  // namespace

std::vector<Route> contact_routes(const RouteQuery& query) {
  return find_row(kContacts, query.function)->routes(query);
}

}  // namespace treeline
