#pragma once

#include <map>
#include <string>
#include <vector>

#include "description/scene.hpp"
#include "mechanism/mechanism.hpp"
#include "passes/choose.hpp"
#include "passes/run_passes.hpp"

namespace treeline {

/// How the routes to a function are to be worked out.
struct RouteOptions {
  int lanes = 1;                    ///< see `Scene::lanes`
  Sines sin_cos = Sines::computed;  ///< see `Scene::sin_cos`
  /// A route that costs so many times the cheapest as traced is hopeless: the passes take away a
  /// few per cent, lanes up to a quarter.
  double hopeless = 1.3;
};

/// For `RouteOptions::hopeless`: no route is.
inline constexpr double kAllRoutes = 1e9;

/// The routes to a function, those that may win with their operations reduced, not yet in order.
struct Routes {
  std::vector<Program> candidates;
  std::vector<Cost> hopeless;                           ///< the others as traced, cheapest first
  std::map<std::string, std::vector<PassReport>> logs;  ///< of each candidate, by its key
};

/// Traces every route and reduces operations; those of the best ones again with alike limbs in
/// lanes, where the mechanism has any.
Routes run_routes(const Mechanism& mechanism, Function function, const RouteOptions& options);

}  // namespace treeline
