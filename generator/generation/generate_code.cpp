#include "generation/generate_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "description/check_scene.hpp"
#include "generation/describe_scene.hpp"
#include "mechanism/build_mechanism.hpp"
#include "passes/settle.hpp"
#include "passes/take_sines.hpp"
#include "recursion/trace_function.hpp"

namespace treeline {
namespace {

EmissionContext::ChoiceRow choice_row(const GeneratedFunction& generated) {
  EmissionContext::ChoiceRow row;
  row.function = function_name(generated.function);
  row.chosen = {generated.chosen.method, generated.chosen.count.flops()};
  for (const Cost& cost : generated.rejected) {
    row.rejected.push_back({cost.method, cost.count.flops()});
  }
  return row;
}

/// What the scene's silence saves: each function that it could have asked for and did not.
std::vector<EmissionContext::SkippedRow> skipped_rows(const Mechanism& mechanism,
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
    rows.push_back(
        {fmt::format("function {}", function_name(function)),
         generate_function(mechanism, function, scene.lanes, scene.sin_cos).chosen.count.flops()});
  }
  return rows;
}

EmissionContext context_of(const Robot& robot, const Scene& scene, const Provenance& provenance,
                           const Generation& generation) {
  EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  context.command = fmt::format("treeline generate {} {} --output {}{}", provenance.urdf_name,
                                provenance.scene_name, scene.name, provenance.options);
  context.inputs = {{provenance.urdf_name, provenance.urdf_text},
                    {provenance.scene_name, provenance.scene_text}};
  for (const GeneratedFunction& generated : generation.functions) {
    context.choices.push_back(choice_row(generated));
  }
  context.skipped = skipped_rows(generation.mechanism, scene);
  return context;
}

}  // namespace

GeneratedFunction generate_function(const Mechanism& mechanism, Function function, int lanes,
                                    Sines sin_cos) {
  std::vector<Candidate> candidates;
  std::map<std::string, std::vector<PassReport>> logs;  // by method
  for (Program& program : trace_function(mechanism, function, lanes)) {
    const std::string method = program.source;
    if (sin_cos == Sines::given) program = take_sines(settle(program));
    candidates.push_back({method, run_passes(std::move(program), logs[method])});
  }
  Choice choice = *choose(std::move(candidates));  // there is at least one route
  GeneratedFunction generated;
  generated.function = function;
  generated.chosen = std::move(choice.chosen);
  generated.rejected = std::move(choice.rejected);
  generated.program = std::move(choice.program);
  generated.passes = std::move(logs[generated.chosen.method]);
  return generated;
}

std::string source_stem(const GeneratedFunction& generated) {
  return (generated.batch > 0 ? "batch_" : "") + generated.program.name;
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
  std::vector<Program> programs;
  for (const Function function : scene.functions) {
    generation.functions.push_back(
        generate_function(generation.mechanism, function, scene.lanes, scene.sin_cos));
    programs.push_back(generation.functions.back().program);
  }
  std::vector<Program> batch;
  if (scene.batch > 0) {
    for (const GeneratedFunction& generated : generation.functions) {
      generation.batch.push_back(
          generate_function(generation.mechanism, generated.function, 1, scene.sin_cos));
      generation.batch.back().batch = scene.batch;
      batch.push_back(generation.batch.back().program);
    }
  }
  const EmissionContext context = context_of(robot, scene, provenance, generation);
  generation.files = emit(context, programs, diagnostics, batch);
  if (diagnostics.has_errors()) {
    return std::nullopt;
  }
  return generation;
}

}  // namespace treeline
