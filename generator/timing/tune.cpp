#include "timing/tune.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "choice/function_mechanisms.hpp"
#include "choice/only_by_name.hpp"
#include "choice/run_routes.hpp"

namespace treeline {
namespace {

/// Numbers of lanes to try, the scene's first. A batch has its states as lanes.
std::vector<int> lanes_to_try(const Scene& scene, bool batch) {
  if (batch) return {1};
  std::vector<int> lanes{scene.lanes};
  for (const int more : {1, 2, 4, 8}) {
    if (more != scene.lanes) lanes.push_back(more);
  }
  return lanes;
}

/// Identifies the code of a program: the order of its nodes and the packs.
std::string fingerprint(const Program& program) {
  std::string text;
  const auto append = [&text](const auto& number) {
    text.append(reinterpret_cast<const char*>(&number), sizeof number);
  };
  for (const Node& node : program.graph.nodes()) {
    append(node.op);
    append(node.a);
    append(node.b);
    append(node.value);
  }
  for (const LanePack& pack : program.packs) {
    append(pack.size());
    for (const std::uint32_t lane : pack) append(lane);
  }
  return text;
}

bool is_cheaper(const GeneratedFunction& a, const GeneratedFunction& b) {
  return a.chosen.weighted < b.chosen.weighted;
}

std::optional<TunedFunction> tune_function(std::vector<GeneratedFunction> candidates,
                                           const Measure& measure, const TuneOptions& options,
                                           Diagnostics& diagnostics) {
  if (options.progress) options.progress(source_stem(candidates.front()), candidates.size());
  const auto measured = measure(candidates, diagnostics);
  if (!measured) return std::nullopt;
  TunedFunction tuned{candidates.front().function, candidates.front().batch, {}, 0};
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const GeneratedFunction& candidate = candidates[i];
    tuned.trials.push_back(
        {{key_of(candidate.chosen.route), tuned.batch > 0 ? 0 : candidate.other_lanes},
         candidate.chosen.count,
         (*measured)[i]});
    const double least = tuned.trials[tuned.fastest].measured.ratio;
    const Timing& own = tuned.trials.back().measured;
    if (own.ratio < least && 1 - own.ratio > std::max(options.margin, 2 * own.noise)) {
      tuned.fastest = i;
    }
  }
  return tuned;
}

}  // namespace

std::vector<GeneratedFunction> list_candidates(FunctionMechanisms& mechanisms, Function function,
                                               const Scene& scene, bool batch, double reach) {
  const Mechanism& mechanism = mechanisms.of(function);
  std::vector<GeneratedFunction> all;
  for (const int lanes : lanes_to_try(scene, batch)) {
    RouteOptions options = route_options(scene);
    options.lanes = lanes;
    Routes routes = run_routes(mechanism, function, options);
    const std::size_t first = all.size();
    for (Program& candidate : routes.candidates) {
      if (is_only_by_name(candidate)) continue;
      GeneratedFunction& made =
          all.emplace_back(generated_from(function, std::move(candidate), options.costs));
      made.other_lanes = lanes;
      made.batch = batch ? scene.batch : 0;
    }
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    std::stable_sort(begin, all.end(), is_cheaper);
  }
  const double least = std::min_element(all.begin(), all.end(), is_cheaper)->chosen.weighted;
  std::set<std::string> seen;
  std::erase_if(all, [&, first = true](const GeneratedFunction& each) mutable {
    const bool keep = std::exchange(first, false) || each.chosen.weighted <= (1 + reach) * least;
    return !keep || !seen.insert(fingerprint(each.program)).second;
  });
  for (GeneratedFunction& each : all) order_lines(each);
  return all;
}

std::optional<Tuning> tune(const Robot& robot, const Scene& scene, const Measure& measure,
                           const TuneOptions& options, Diagnostics& diagnostics) {
  if (scene.optimize == Optimize::size) {
    diagnostics.add({Severity::error, "", 0, "optimize",
                     "`size` chooses by bytes, and tuning by time", "Leave one of them out."});
    return std::nullopt;
  }
  FunctionMechanisms mechanisms(robot, scene);
  Tuning tuning;
  for (const Function function : scene.functions) {
    for (const bool batch : {false, true}) {
      if (batch && scene.batch == 0) continue;
      auto tuned = tune_function(list_candidates(mechanisms, function, scene, batch, options.reach),
                                 measure, options, diagnostics);
      if (!tuned) return std::nullopt;
      tuning.functions.push_back(std::move(*tuned));
    }
  }
  return tuning;
}

Choices choices_of(const Tuning& tuning) {
  Choices choices;
  choices.measured = tuning.measured;
  for (const TunedFunction& tuned : tuning.functions) {
    auto& kind = tuned.batch > 0 ? choices.batch : choices.plain;
    kind[tuned.function] = tuned.trials[tuned.fastest].choice;
  }
  return choices;
}

}  // namespace treeline
