#pragma once

#include <map>
#include <string>
#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "passes/choose.hpp"
#include "passes/passes.hpp"

namespace treeline {

/// Options for working out the routes to a function.
struct RouteOptions {
  int lanes = 1;                    ///< see `Scene::lanes`
  Sines sin_cos = Sines::computed;  ///< see `Scene::sin_cos`
  /// Routes that cost more than the cheapest one by this factor, as traced, are pruned. Passes save
  /// only a few per cent, and lanes up to a quarter.
  double prune_above = 1.3;
  OperationCosts costs = {};  ///< by which routes are compared
};

/// Options for a scene: its lanes, sines, and the costs of its target. A batch has no lanes.
RouteOptions route_options(const Scene& scene, bool batch = false);

/// Value of `RouteOptions::prune_above` with which no route is pruned.
inline constexpr double kAllRoutes = 1e9;

/// The routes to a function. The operations of those that may win are reduced but not yet ordered.
struct Routes {
  std::vector<Program> candidates;
  std::vector<Cost> pruned;                             ///< pruned routes as traced, cheapest first
  std::map<std::string, std::vector<PassReport>> logs;  ///< of each candidate, by its key
};

/// Traces every route and reduces the operations of those that may win. The best ones are also
/// tried with isomorphic limbs in lanes, if the mechanism has such limbs.
Routes run_routes(const Mechanism& mechanism, Function function, const RouteOptions& options);

}  // namespace treeline
