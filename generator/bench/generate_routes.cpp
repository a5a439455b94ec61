#include <algorithm>
#include <set>
#include <utility>

#include "bench/plan_builds.hpp"
#include "generation/run_routes.hpp"

namespace treeline {

std::vector<GeneratedFunction> generate_routes(const Mechanism& mechanism, Function function,
                                               int lanes, Sines sin_cos) {
  Routes routes = run_routes(mechanism, function, {lanes, sin_cos, kAllRoutes});
  std::vector<GeneratedFunction> all;
  for (Program& candidate : routes.candidates) {
    all.push_back(generated_from(function, std::move(candidate)));
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    return a.chosen.weighted < b.chosen.weighted;
  });
  std::set<std::string> seen;
  std::erase_if(all, [&](const GeneratedFunction& each) {
    return !seen.insert(each.chosen.route.algorithm).second;
  });
  for (GeneratedFunction& each : all) each.program = put_in_order(each.program, each.passes);
  return all;
}

}  // namespace treeline
