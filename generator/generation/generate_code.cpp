#include "generation/generate_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "description/check_scene.hpp"
#include "generation/describe_scene.hpp"
#include "generation/function_mechanisms.hpp"
#include "mechanism/build_mechanism.hpp"
#include "mechanism/find_limbs.hpp"
#include "passes/settle.hpp"
#include "passes/take_sines.hpp"
#include "recursion/trace_function.hpp"

namespace treeline {
namespace {

/// A method's name without the coordinates that it is worked out in.
std::string route_of(const std::string& method) {
  std::size_t end = method.size();
  for (const char* coordinates : {", in the axes", ", in link axes", ", J in the axes"}) {
    end = std::min(end, method.find(coordinates));
  }
  return method.substr(0, end);
}

/// Of each route, in whatever coordinates and lanes it costs least. Those rejected are sorted by
/// cost.
EmissionContext::ChoiceRow choice_row(const GeneratedFunction& generated) {
  EmissionContext::ChoiceRow row;
  row.function = function_name(generated.function);
  row.chosen = {generated.chosen.method, generated.chosen.count.flops()};
  std::set<std::string> routes{route_of(generated.chosen.method)};
  for (const Cost& cost : generated.rejected) {
    if (!routes.insert(route_of(cost.method)).second) continue;
    row.rejected.push_back({cost.method, cost.count.flops()});
  }
  return row;
}

/// What the scene's silence saves: each function that it could have asked for and did not,
/// counted as plain code.
std::vector<EmissionContext::SkippedRow> skipped_rows(FunctionMechanisms& mechanisms,
                                                      const Scene& scene) {
  std::vector<EmissionContext::SkippedRow> rows;
  std::vector<Function> functions(kAllFunctions.begin(), kAllFunctions.end());
  if (!scene.objects.empty()) {
    functions.insert(functions.end(), kObjectFunctions.begin(), kObjectFunctions.end());
  }
  for (const Function function : functions) {
    const bool asked = std::find(scene.functions.begin(), scene.functions.end(), function) !=
                       scene.functions.end();
    if (asked || (needs_points(function) && scene.operational_points.empty())) {
      continue;
    }
    rows.push_back({fmt::format("function {}", function_name(function)),
                    generate_function(mechanisms.of(function), function, 1, scene.sin_cos)
                        .chosen.count.flops()});
  }
  return rows;
}

EmissionContext context_of(const Robot& robot, const Scene& scene, const Provenance& provenance,
                           const Generation& generation, FunctionMechanisms& mechanisms) {
  EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  context.command = fmt::format("treeline generate {} {} --output {}{}", provenance.urdf_name,
                                provenance.scene_name, scene.name, provenance.options);
  context.inputs = {{provenance.urdf_name, provenance.urdf_text},
                    {provenance.scene_name, provenance.scene_text}};
  for (const GeneratedFunction& generated : generation.functions) {
    context.choices.push_back(choice_row(generated));
  }
  context.skipped = skipped_rows(mechanisms, scene);
  return context;
}

using PassLogs = std::map<std::string, std::vector<PassReport>>;

/// Traces the routes of a function and runs the passes on those that may win.
class RouteRunner {
 public:
  RouteRunner(Function function, int lanes, Sines sin_cos)
      : function_(function), lanes_(lanes), sin_cos_(sin_cos) {}

  /// Routes that the passes and lanes will not make the cheapest go to `hopeless`, as traced.
  std::vector<Candidate> run(const Mechanism& mechanism, std::vector<Cost>& hopeless,
                             PassLogs& logs) const {
    constexpr double kHopeless = 1.3;  // the passes take away a few per cent, lanes up to a quarter
    std::vector<Program> programs = trace_function(mechanism, function_, lanes_);
    std::vector<Cost> costs;
    for (const Program& program : programs) {
      costs.push_back(cost_of(program));
    }
    const double least = std::min_element(costs.begin(), costs.end(), is_cheaper)->weighted;
    std::vector<Candidate> candidates;
    for (std::size_t i = 0; i < programs.size(); ++i) {
      if (costs[i].weighted <= kHopeless * least) {
        candidates.push_back(finish(std::move(programs[i]), logs));
      } else {
        hopeless.push_back(costs[i]);
      }
    }
    std::sort(hopeless.begin(), hopeless.end(), is_cheaper);
    return candidates;
  }

  /// The same for the best of `candidates`, alike limbs in lanes.
  void append_with_limbs(const Mechanism& with_limbs, std::vector<Candidate>& candidates,
                         PassLogs& logs) const {
    constexpr double kNear = 1.05;
    std::map<std::string, double> costs;
    double least = std::numeric_limits<double>::infinity();
    for (const Candidate& candidate : candidates) {
      costs[candidate.method] = cost_of(candidate.program).weighted;
      least = std::min(least, costs[candidate.method]);
    }
    for (Program& program : trace_function(with_limbs, function_, lanes_)) {
      const auto plain = costs.find(program.source);
      if (plain != costs.end() && plain->second <= kNear * least) {
        program.source += ", alike limbs in lanes";
        candidates.push_back(finish(std::move(program), logs));
      }
    }
  }

 private:
  static bool is_cheaper(const Cost& a, const Cost& b) { return a.weighted < b.weighted; }

  static Cost cost_of(const Program& program) {
    const OperationCount count = count_operations(program);
    return {program.source, count, cost(program, count)};
  }

  Candidate finish(Program program, PassLogs& logs) const {
    const std::string method = program.source;
    if (sin_cos_ == Sines::given) {
      program = take_sines(settle(program));
    }
    return {method, run_passes(std::move(program), logs[method])};
  }

  Function function_;
  int lanes_;
  Sines sin_cos_;
};

}  // namespace

GeneratedFunction generate_function(const Mechanism& mechanism, Function function, int lanes,
                                    Sines sin_cos) {
  const RouteRunner runner(function, lanes, sin_cos);
  std::map<std::string, std::vector<PassReport>> logs;  // by method
  std::vector<Cost> hopeless;
  std::vector<Candidate> candidates = runner.run(mechanism, hopeless, logs);
  Mechanism with_limbs = mechanism;
  with_limbs.limbs = find_limbs(mechanism, lanes);
  if (!with_limbs.limbs.empty()) {
    runner.append_with_limbs(with_limbs, candidates, logs);
  }
  Choice choice = *choose(std::move(candidates));  // there is at least one route
  GeneratedFunction generated;
  generated.function = function;
  generated.chosen = std::move(choice.chosen);
  generated.rejected = std::move(choice.rejected);
  generated.rejected.insert(generated.rejected.end(), hopeless.begin(), hopeless.end());
  generated.program = std::move(choice.program);
  generated.passes = std::move(logs[generated.chosen.method]);
  return generated;
}

std::string source_stem(const GeneratedFunction& generated) {
  return fmt::format("{}{}", generated.batch > 0 ? "batch_" : "", generated.program.name);
}

std::vector<GeneratedFunction> all_functions(const Generation& generation) {
  std::vector<GeneratedFunction> all = generation.functions;
  all.insert(all.end(), generation.batch.begin(), generation.batch.end());
  return all;
}

std::optional<Generation> generate_code(const Robot& robot, const Scene& scene,
                                        const Provenance& provenance, Diagnostics& diagnostics) {
  Generation generation;
  generation.mechanism = reduced_mechanism(robot, scene);
  FunctionMechanisms mechanisms(robot, scene);
  std::vector<Program> programs;
  for (const Function function : scene.functions) {
    generation.functions.push_back(
        generate_function(mechanisms.of(function), function, scene.lanes, scene.sin_cos));
    programs.push_back(generation.functions.back().program);
  }
  std::vector<Program> batch;
  if (scene.batch > 0) {
    for (const GeneratedFunction& generated : generation.functions) {
      generation.batch.push_back(generate_function(mechanisms.of(generated.function),
                                                   generated.function, 1, scene.sin_cos));
      generation.batch.back().batch = scene.batch;
      batch.push_back(generation.batch.back().program);
    }
  }
  const EmissionContext context = context_of(robot, scene, provenance, generation, mechanisms);
  generation.files = emit(context, programs, diagnostics, batch);
  if (diagnostics.has_errors()) {
    return std::nullopt;
  }
  return generation;
}

}  // namespace treeline
