#include "recursion/routes/trace_contacts.hpp"

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>

#include "recursion/methods/contacts.hpp"
#include "recursion/methods/link_inverse_inertias.hpp"
#include "recursion/methods/task_law.hpp"
#include "recursion/routes/describe_choice.hpp"
#include "recursion/routes/trace_parts.hpp"
#include "recursion/tree/deferred_rotations.hpp"

namespace treeline {
namespace {

using Expressions = std::vector<Expression>;
using TracedTree = Tree<Expression>;

struct ContactTrace {
  TracedTree tree;
  Expressions q, other;  ///< `other`: the function's second input
  std::vector<JointTransform<Expression>> X;
  std::vector<WorldPose<Expression>> poses;
  PivotRule rule = {};

  [[nodiscard]] std::size_t contacts() const { return tree.contacts.size(); }
};

struct ContactRoute {
  RouteId id;
  std::function<std::vector<Result>(const ContactTrace&)> body;
  std::shared_ptr<const TaskLaw> law = nullptr;
};

/// The tree with its contacts as the points that rows of Lambda^-1 are about.
TracedTree tree_of_contact_tasks(TracedTree tree) {
  tree.operational_points = tree.contacts;
  return tree;
}

std::vector<ContactRoute> inverse_inertia_routes(const TracedTree& tree) {
  std::vector<ContactRoute> routes;
  const TracedTree tasks = tree_of_contact_tasks(tree);
  for (const LambdaChoice& choice : lambda_choices(tasks)) {
    routes.push_back(
        {route_id(choice, tasks), [choice](const ContactTrace& trace) {
           const auto Lambda_inv = lambda_inverse_as_asked(tree_of_contact_tasks(trace.tree),
                                                           trace.X, choice, 3 * trace.contacts());
           const int size = static_cast<int>(Lambda_inv.rows());
           return std::vector<Result>{
               {{"Lambda_c_inv", size, size, "inverse inertia over all contacts, 1/kg, world axes"},
                Lambda_inv.values()}};
         }});
  }
  return routes;
}

std::vector<Result> masses(const DenseMatrix<Expression>& Lambda_inv, const PivotRule& rule) {
  return {vector_result("mass", "effective masses, kg where the normal is a unit vector",
                        masses_along(Lambda_inv, rule))};
}

/// Couplings between contacts are traced and never used: what is not asked for is not emitted.
std::vector<ContactRoute> mass_routes(const Mechanism& mechanism, const TracedTree& tree) {
  const auto law = TaskLaws(mechanism).find(TaskLaw::Kind::normals, LawPoints::contacts, {});
  std::vector<ContactRoute> routes{
      {{"ltdl-inward", "M = L^T D L, J carried inward along each normal"},
       [](const ContactTrace& trace) {
         const auto tasks = normal_tasks<Expression>(trace.tree, trace.poses, trace.other);
         return masses(lambda_inverse_by_factors(trace.tree, trace.X,
                                                 jacobian_inward(trace.tree, trace.X, tasks,
                                                                 trace.contacts(), trace.poses)),
                       trace.rule);
       },
       law}};
  if (tree.has_mimics) return routes;
  routes.push_back({{"unit-forces", "a unit force along each normal propagated inward"},
                    [](const ContactTrace& t) {
                      const auto tasks = normal_tasks<Expression>(t.tree, t.poses, t.other);
                      return masses(lambda_inverse_by_unit_forces(t.tree, t.X, tasks, t.contacts()),
                                    t.rule);
                    },
                    law});
  routes.push_back({{"link-inertias", "inverse inertias of the links, Chang eq. 8.2"},
                    [](const ContactTrace& t) {
                      const auto tasks = normal_tasks<Expression>(t.tree, t.poses, t.other);
                      return masses(lambda_inverse_by_branching(t.tree, t.X, tasks), t.rule);
                    },
                    law});
  return routes;
}

std::vector<Result> velocity_changes(Expressions dqd) {
  return {vector_result("dqd", "changes of the joint velocities", std::move(dqd))};
}

std::vector<ContactRoute> impulse_routes(const TracedTree& tree) {
  std::vector<ContactRoute> routes{
      {{"ltdl", "M = L^T D L by composite bodies, sparse solve (RBDA section 6.5)"},
       [](const ContactTrace& trace) {
         return velocity_changes(impulse_response_by_factors(
             trace.tree, trace.X,
             impulses_on_links<Expression>(trace.tree, trace.poses, trace.other)));
       }}};
  if (!tree.has_mimics) {
    routes.push_back({{"impulse-propagation", "impulse propagation, Chang table 8.2"},
                      [](const ContactTrace& trace) {
                        return velocity_changes(impulse_response(
                            trace.tree, trace.X,
                            impulses_on_links<Expression>(trace.tree, trace.poses, trace.other)));
                      }});
  }
  return routes;
}

std::vector<ContactRoute> link_routes(const TracedTree& tree) {
  const auto result = [](Expressions entries) {
    return std::vector<Result>{vector_result(
        "Omega", "6x6 row-major for each link, at its frame and in its axes", std::move(entries))};
  };
  if (tree.has_mimics) {
    return {{{"ltdl-inward", "M = L^T D L, J carried inward link by link"},
             [result](const ContactTrace& trace) {
               return result(link_inverse_inertias_by_factors(trace.tree, trace.X, trace.poses));
             }}};
  }
  return {{{"force-propagation", "force propagation, Chang table 5.2, over all links"},
           [result](const ContactTrace& t) { return result(link_inverse_inertias(t.tree, t.X)); }}};
}

std::vector<ContactRoute> routes_of(Function function, const Mechanism& mechanism,
                                    const TracedTree& tree) {
  switch (function) {
    case Function::contact_motion:
      return {{{"outward", "outward recursion"}, [](const ContactTrace& trace) {
                 auto motion =
                     contact_motion<Expression>(trace.tree, trace.X, trace.poses, trace.other);
                 return std::vector<Result>{
                     vector_result("position", "in the world, m, one contact after the other",
                                   std::move(motion.position)),
                     vector_result("velocity", "world axes, m/s, one contact after the other",
                                   std::move(motion.velocity))};
               }}};
    case Function::contact_inverse_inertia:
      return inverse_inertia_routes(tree);
    case Function::effective_mass:
      return mass_routes(mechanism, tree);
    case Function::impulse_response:
      return impulse_routes(tree);
    case Function::link_inverse_inertias:
      return link_routes(tree);
    default:
      throw std::logic_error(std::string(function_name(function)) + " is not about contacts");
  }
}

Program trace(const Mechanism& mechanism, Function function, const ContactRoute& route, int lanes) {
  Program program;
  program.name = function_name(function);
  program.equation = info_of(function).equation;
  program.route = route.id;
  program.graph = Graph::for_trace(lanes);
  const Graph::Scope scope(program.graph);
  ContactTrace traced;
  traced.tree = constant_tree<Expression>(mechanism);
  const TracedInputs inputs(mechanism, function, program);
  apply_inputs(mechanism, inputs, traced.tree);
  traced.q = inputs[Quantity::q];
  for (const Quantity quantity : info_of(function).inputs) {
    if (quantity != Quantity::q && !is_of_model(quantity)) traced.other = inputs[quantity];
  }
  traced.X = joint_transforms<Expression>(traced.tree, traced.q);
  defer_rotations(traced.tree, traced.X);
  traced.poses = world_poses(traced.tree, traced.X);
  if (route.law) {
    traced.rule = route.law->rule;
    program.singular = describe(*route.law);
  } else if (mechanism.singular == SingularTasks::exact && function == Function::effective_mass) {
    program.singular = kBareSolve;
  }
  program.law = route.law;
  program.results = route.body(traced);
  return program;
}

}  // namespace

std::vector<Program> trace_contact_function(const Mechanism& mechanism, Function function,
                                            int lanes) {
  Program scratch;
  std::vector<ContactRoute> routes;
  {
    const Graph::Scope scope(scratch.graph);
    routes = routes_of(function, mechanism, structure_of(mechanism, function, scratch));
  }
  std::vector<Program> programs;
  for (const ContactRoute& route : routes)
    programs.push_back(trace(mechanism, function, route, lanes));
  return programs;
}

}  // namespace treeline
