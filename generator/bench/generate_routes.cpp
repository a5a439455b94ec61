#include <algorithm>
#include <set>
#include <utility>

#include "bench/plan_builds.hpp"
#include "choice/only_by_name.hpp"

namespace treeline {

std::vector<GeneratedFunction> generate_routes(const Mechanism& mechanism, Function function,
                                               RouteOptions options) {
  options.prune_above = kAllRoutes;
  std::vector<GeneratedFunction> all;
  for (Program& candidate : run_routes(mechanism, function, options).candidates) {
    all.push_back(generated_from(function, std::move(candidate), options.costs));
  }
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) {
    const std::pair first{is_only_by_name(a.program), a.chosen.weighted};
    return first < std::pair{is_only_by_name(b.program), b.chosen.weighted};
  });
  std::set<std::string> seen;
  std::erase_if(all, [&](const GeneratedFunction& each) {
    return !seen.insert(each.chosen.route.algorithm).second;
  });
  for (GeneratedFunction& each : all) order_lines(each);
  return all;
}

}  // namespace treeline
