#include "choice/run_routes.hpp"

#include <algorithm>
#include <limits>
#include <utility>

#include "choice/only_by_name.hpp"
#include "description/follow_target.hpp"
#include "mechanism/find_limbs.hpp"
#include "passes/passes.hpp"
#include "recursion/routes/trace_function.hpp"
#include "target/target.hpp"

namespace treeline {
namespace {

bool is_cheaper(const Cost& a, const Cost& b) {
  return a.weighted < b.weighted;
}

class RouteRunner {
 public:
  RouteRunner(Function function, const RouteOptions& options)
      : function_(function), options_(options) {}

  /// Routes that the passes and lanes will not make the cheapest go to `pruned`, as traced.
  void append_plain(const Mechanism& mechanism, Routes& routes) const {
    std::vector<Program> programs = trace_function(mechanism, function_, options_.lanes);
    std::vector<Cost> costs;
    for (const Program& program : programs) {
      costs.push_back(cost_of(program, options_.costs));
    }
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (!is_only_by_name(programs[i])) least = std::min(least, costs[i].weighted);
    }
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (costs[i].weighted <= options_.prune_above * least) {
        routes.candidates.push_back(finish(std::move(programs[i]), routes));
      } else {
        routes.pruned.push_back(costs[i]);
      }
    }
    std::sort(routes.pruned.begin(), routes.pruned.end(), is_cheaper);
  }

  /// Adds variants of the best candidates that compute alike limbs in lanes.
  void append_with_limbs(const Mechanism& with_limbs, Routes& routes) const {
    constexpr double kNear = 1.05;
    std::map<std::string, double> costs;
    double least = std::numeric_limits<double>::infinity();
    for (const Program& candidate : routes.candidates) {
      const Cost cost = cost_of(candidate, options_.costs);
      costs[key_of(cost.route)] = cost.weighted;
      if (is_only_by_name(candidate)) continue;
      least = std::min(least, cost.weighted);
    }
    for (Program& program : trace_function(with_limbs, function_, options_.lanes)) {
      const auto plain = costs.find(key_of(program.route));
      if (plain != costs.end() && plain->second <= kNear * least) {
        program.route.limbs = true;
        routes.candidates.push_back(finish(std::move(program), routes));
      }
    }
  }

 private:
  Program finish(Program program, Routes& routes) const {
    std::vector<PassReport>& log = routes.logs[key_of(program.route)];
    return change_lines(std::move(program), [&](Program lines) {
      if (options_.sin_cos == Sines::given) lines = take_sines(canonicalize(lines));
      return reduce_operations(std::move(lines), log);
    });
  }

  Function function_;
  RouteOptions options_;
};

}  // namespace

RouteOptions route_options(const Scene& scene, bool batch) {
  RouteOptions options;
  options.lanes = batch ? 1 : scene.lanes;
  options.sin_cos = scene.sin_cos;
  options.costs = operation_costs(*find_target(scene.target), bytes_of(scene.real));
  return options;
}

Routes run_routes(const Mechanism& mechanism, Function function, const RouteOptions& options) {
  const RouteRunner runner(function, options);
  Routes routes;
  runner.append_plain(mechanism, routes);
  Mechanism with_limbs = mechanism;
  with_limbs.limbs = find_limbs(mechanism, options.lanes);
  if (!with_limbs.limbs.empty()) {
    runner.append_with_limbs(with_limbs, routes);
  }
  return routes;
}

}  // namespace treeline
