#include "choice/generated_function.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "choice/only_by_name.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline {
namespace {

/// Whether `name` is the route's key, or the words by which earlier manifests name it.
bool is_called(const RouteId& route, const std::string& name) {
  return key_of(route) == name || describe(route) == name;
}

/// Moves the candidate of that name out of `routes`; nothing when there is none.
std::optional<Choice> take_chosen(const std::string& name, const OperationCosts& costs,
                                  Routes& routes) {
  const auto at = std::find_if(routes.candidates.begin(), routes.candidates.end(),
                               [&](const Program& each) { return is_called(each.route, name); });
  if (at == routes.candidates.end()) return std::nullopt;
  std::vector<Program> one{std::move(*at)};
  routes.candidates.erase(at);
  Choice choice = *choose(std::move(one), costs);
  if (!routes.candidates.empty()) {
    Choice others = *choose(std::move(routes.candidates), costs);
    choice.rejected = std::move(others.rejected);
    choice.rejected.insert(choice.rejected.begin(), std::move(others.chosen));
  }
  return choice;
}

/// The cheapest of those that need not be named. Those that must be are rejected, behind the
/// others.
Choice choose_unnamed(std::vector<Program> candidates, const OperationCosts& costs) {
  const auto first =
      std::stable_partition(candidates.begin(), candidates.end(),
                            [](const Program& each) { return !is_only_by_name(each); });
  std::vector<Program> named(std::make_move_iterator(first),
                             std::make_move_iterator(candidates.end()));
  candidates.erase(first, candidates.end());
  // There is at least one route that need not be named.
  Choice choice = *choose(std::move(candidates), costs);
  if (named.empty()) return choice;
  Choice last = *choose(std::move(named), costs);
  choice.rejected.push_back(std::move(last.chosen));
  choice.rejected.insert(choice.rejected.end(), last.rejected.begin(), last.rejected.end());
  return choice;
}

GeneratedFunction generated_from(Function function, Choice choice, Routes& routes) {
  GeneratedFunction generated;
  generated.function = function;
  generated.chosen = std::move(choice.chosen);
  generated.rejected = std::move(choice.rejected);
  generated.rejected.insert(generated.rejected.end(), routes.pruned.begin(), routes.pruned.end());
  generated.passes = std::move(routes.logs[key_of(generated.chosen.route)]);
  generated.program = std::move(choice.program);
  order_lines(generated);
  return generated;
}

}  // namespace

void order_lines(GeneratedFunction& generated) {
  generated.program = change_lines(std::move(generated.program), [&](const Program& lines) {
    return put_in_order(lines, generated.passes);
  });
}

GeneratedFunction generate_function(const Mechanism& mechanism, Function function,
                                    const RouteOptions& options) {
  Routes routes = run_routes(mechanism, function, options);
  Choice choice = choose_unnamed(std::move(routes.candidates), options.costs);
  return generated_from(function, std::move(choice), routes);
}

std::optional<GeneratedFunction> generate_chosen(const Mechanism& mechanism, Function function,
                                                 const std::string& route, RouteOptions options) {
  Routes routes = run_routes(mechanism, function, options);
  auto choice = take_chosen(route, options.costs, routes);
  if (!choice) {
    options.prune_above = kAllRoutes;
    routes = run_routes(mechanism, function, options);
    choice = take_chosen(route, options.costs, routes);
  }
  if (!choice) return std::nullopt;
  return generated_from(function, std::move(*choice), routes);
}

GeneratedFunction generated_from(Function function, Program candidate,
                                 const OperationCosts& costs) {
  GeneratedFunction generated;
  generated.function = function;
  generated.chosen = cost_of(candidate, costs);
  generated.program = std::move(candidate);
  return generated;
}

std::string source_stem(Function function, int batch) {
  return fmt::format("{}{}", batch > 0 ? "batch_" : "", function_name(function));
}

std::string source_stem(const GeneratedFunction& generated) {
  return source_stem(generated.function, generated.batch);
}

bool is_composed(const GeneratedFunction& generated) {
  return generated.function == Function::damped_control_torque;
}

std::size_t count_written(const GeneratedFunction& generated) {
  return generated.program.results.size() - (is_composed(generated) ? 1 : 0);
}

}  // namespace treeline
