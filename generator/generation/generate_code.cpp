#include "generation/generate_code.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <memory>
#include <mutex>
#include <set>
#include <utility>

#include "emission/backend.hpp"
#include "emission/describe_contract.hpp"
#include "generation/add_controller.hpp"
#include "generation/add_ground.hpp"
#include "generation/base_parameter_domain.hpp"
#include "generation/bound_damped.hpp"
#include "generation/choose_loops.hpp"
#include "generation/compose_damped.hpp"
#include "generation/count_inputs.hpp"
#include "generation/describe_limits.hpp"
#include "generation/describe_scene.hpp"
#include "generation/for_each_index.hpp"
#include "generation/function_mechanisms.hpp"
#include "generation/only_by_name.hpp"
#include "generation/quote_for_shell.hpp"
#include "generation/run_routes.hpp"
#include "recursion/routes/constraint_routes.hpp"
#include "recursion/routes/run_ending.hpp"
#include "recursion/routes/trace_loops.hpp"

namespace treeline {
namespace {

/// Lists the routes of a function, each in the coordinates and lanes in which it costs least.
/// Rejected ones are sorted by cost.
EmissionContext::ChoiceRow choice_row(const GeneratedFunction& generated) {
  EmissionContext::ChoiceRow row;
  row.function = source_stem(generated);
  const auto method = [](const Cost& cost, int lanes) -> EmissionContext::Method {
    return {key_of(cost.route), describe(cost.route), cost.count.flops(), cost.weighted, lanes};
  };
  row.chosen = method(generated.chosen, generated.other_lanes);
  std::set<std::string> algorithms{generated.chosen.route.algorithm};
  for (const Cost& cost : generated.rejected) {
    if (algorithms.insert(cost.route.algorithm).second) row.rejected.push_back(method(cost, 0));
  }
  return row;
}

/// Half an ulp of one.
double rounding_unit(const Scene& scene) {
  return scene.real == Real::float32 ? 0x1p-24 : 0x1p-53;
}

/// Adds the text of the contract about rounding errors, and the ranges of inputs that it assumes.
void add_rounding(const Scene& scene, const Generation& generation, EmissionContext& context) {
  for (const auto* functions : {&generation.functions, &generation.batch}) {
    for (const GeneratedFunction& generated : *functions) {
      const Program& program = generated.program;
      context.rounding[source_stem(generated)] =
          describe(generated.rounding, program, rounding_unit(scene));
    }
  }
  if (generation.damped) {
    context.rounding[function_name(Function::damped_control_torque)] =
        describe_damped_rounding(generation.functions, scene, generation.domain);
  }
  context.domain = describe_domain(generation);
}

/// Command that regenerates the folder, if run where the files and the folder lie side by side.
std::string command_of(const Scene& scene, const Provenance& provenance) {
  std::string files;
  for (const std::string& name : {provenance.urdf_name, provenance.scene_name}) {
    if (!name.empty()) files += " " + quote_for_shell(name);
  }
  return fmt::format("treeline generate{} --output {}{}", files, scene.name, provenance.options);
}

EmissionContext context_of(const Robot& robot, const Scene& scene, const Provenance& provenance,
                           const Generation& generation) {
  EmissionContext context = describe_scene(robot, scene, generation.mechanism);
  context.command = command_of(scene, provenance);
  for (auto& [name, text] : list_inputs(provenance)) {
    context.inputs.push_back({std::move(name), std::move(text)});
  }
  for (const auto* functions : {&generation.functions, &generation.batch}) {
    for (const auto& generated : *functions) context.choices.push_back(choice_row(generated));
  }
  add_rounding(scene, generation, context);
  if (scene.has_limits()) {
    context.limits = describe_limits(robot, scene, generation.mechanism, generation.functions);
  }
  return context;
}

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
  generated.program = change_lines(std::move(choice.program), [&](const Program& lines) {
    return put_in_order(lines, generated.passes);
  });
  return generated;
}

std::string list_routes(const Mechanism& mechanism, Function function, RouteOptions options) {
  options.prune_above = kAllRoutes;
  std::string text;
  for (const Program& candidate : run_routes(mechanism, function, options).candidates) {
    text += fmt::format("{}`{}`", text.empty() ? "" : ", ", key_of(candidate.route));
  }
  return text;
}

/// Remedy for a route that does not exist, with the reason that keeps this robot from it, if
/// known.
std::string describe_remedy(const Mechanism& mechanism, Function function, const std::string& route,
                            const RouteOptions& options) {
  const std::string others = list_routes(mechanism, function, options);
  const std::string obstacle =
      route.starts_with(kEliminatedKey) ? why_not_eliminated(mechanism, function) : "";
  return obstacle.empty() ? fmt::format("Choose one of {}.", others)
                          : fmt::format("{} Or choose one of {}.", obstacle, others);
}

/// The function by the route that is chosen for it, else by the one of least cost.
std::optional<GeneratedFunction> generate_by_choice(const Mechanism& mechanism, Function function,
                                                    RouteOptions options,
                                                    const std::map<Function, RouteChoice>& choices,
                                                    Diagnostics& diagnostics) {
  const auto choice = choices.find(function);
  if (choice == choices.end()) return generate_function(mechanism, function, options);
  const int scene_lanes = options.lanes;
  if (choice->second.lanes > 0) options.lanes = choice->second.lanes;
  auto generated = generate_chosen(mechanism, function, choice->second.route, options);
  if (!generated) {
    diagnostics.add({Severity::error, "", 0, function_name(function),
                     fmt::format("the route that is chosen, `{}` in {} lanes, is none of this "
                                 "robot's and scene's",
                                 choice->second.route, options.lanes),
                     describe_remedy(mechanism, function, choice->second.route, options)});
    return std::nullopt;
  }
  generated->other_lanes = options.lanes == scene_lanes ? 0 : options.lanes;
  return generated;
}

/// A function to generate, for one state or a batch, and what came of it.
struct Job {
  Function function;
  bool batch = false;
  const Mechanism* mechanism = nullptr;
  const Mechanism* whole = nullptr;  ///< for loops over links, whose table all functions share
  std::optional<GeneratedFunction> generated = std::nullopt;
  Diagnostics diagnostics = {};
};

bool may_loop(const Scene& scene, const Choices& choices) {
  return scene.optimize == Optimize::size ||
         std::any_of(choices.plain.begin(), choices.plain.end(),
                     [](const auto& choice) { return choice.second.route == kLoopsKey; });
}

std::vector<Job> list_jobs(FunctionMechanisms& mechanisms, const Scene& scene,
                           const Choices& choices) {
  const Mechanism* const whole = may_loop(scene, choices) ? &mechanisms.whole() : nullptr;
  std::vector<Job> jobs;
  for (const Function function : scene.functions) {
    const Mechanism& mechanism = mechanisms.of(function);
    jobs.push_back({function, false, &mechanism, whole});
    if (scene.batch > 0) jobs.push_back({function, true, &mechanism});
  }
  return jobs;
}

/// The function in whichever form is chosen: as straight lines, or as loops over links.
void generate_in_form(const Scene& scene, const Choices& choices, Job& job) {
  std::map<Function, RouteChoice> routes = job.batch ? choices.batch : choices.plain;
  const auto choice = routes.find(job.function);
  const bool chosen = choice != routes.end();
  const bool loops = chosen && !job.batch && choice->second.route == kLoopsKey;
  if (loops) routes.erase(choice);
  job.generated = generate_by_choice(*job.mechanism, job.function, route_options(scene, job.batch),
                                     routes, job.diagnostics);
  if (!job.generated || job.batch) return;
  if (loops || (!chosen && scene.optimize == Optimize::size)) {
    choose_loops(*job.whole, scene, loops, *job.generated, job.diagnostics);
  }
}

void do_job(const Scene& scene, const Choices& choices, const Domain& domain, Job& job) {
  generate_in_form(scene, choices, job);
  if (!job.generated || job.diagnostics.has_errors()) return;
  if (job.batch) job.generated->batch = scene.batch;
  job.generated->rounding =
      bound_rounding(job.generated->program, domain, rounding_unit(scene), solve_of(job.function));
}

/// Functions and batches of `generation`; false when a choice cannot be made. They do not depend on
/// each other, so several are generated at a time.
bool generate_functions(FunctionMechanisms& mechanisms, const Scene& scene, const Choices& choices,
                        const TellFunction& tell, Generation& generation,
                        Diagnostics& diagnostics) {
  std::vector<Job> jobs = list_jobs(mechanisms, scene, choices);
  std::mutex telling;
  std::size_t begun = 0;
  for_each_index(jobs.size(), [&](std::size_t i) {
    if (tell) {
      const std::lock_guard lock(telling);
      tell(fmt::format("{} ({} of {})", function_name(jobs[i].function), ++begun, jobs.size()));
    }
    do_job(scene, choices, generation.domain, jobs[i]);
  });
  for (Job& job : jobs) {
    for (const Diagnostic& each : job.diagnostics.list()) diagnostics.add(each);
    if (!job.generated || job.diagnostics.has_errors()) return false;
    (job.batch ? generation.batch : generation.functions).push_back(std::move(*job.generated));
  }
  return true;
}

}  // namespace

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

std::vector<Program> programs_of(const std::vector<GeneratedFunction>& functions) {
  std::vector<Program> programs;
  for (const GeneratedFunction& generated : functions) programs.push_back(generated.program);
  return programs;
}

std::string source_stem(Function function, int batch) {
  return fmt::format("{}{}", batch > 0 ? "batch_" : "", function_name(function));
}

std::string source_stem(const GeneratedFunction& generated) {
  return source_stem(generated.function, generated.batch);
}

std::vector<Provenance::File> list_inputs(const Provenance& provenance) {
  const Provenance::File scene{provenance.scene_name, provenance.scene_text};
  if (provenance.robots.empty()) return {{provenance.urdf_name, provenance.urdf_text}, scene};
  std::vector<Provenance::File> files{scene};
  files.insert(files.end(), provenance.robots.begin(), provenance.robots.end());
  return files;
}

bool is_composed(const GeneratedFunction& generated) {
  return generated.function == Function::damped_control_torque;
}

std::size_t count_written(const GeneratedFunction& generated) {
  return generated.program.results.size() - (is_composed(generated) ? 1 : 0);
}

std::vector<GeneratedFunction> all_functions(const Generation& generation) {
  std::vector<GeneratedFunction> all = generation.functions;
  all.insert(all.end(), generation.batch.begin(), generation.batch.end());
  return all;
}

std::vector<GeneratedFunction> all_callable(const Generation& generation) {
  std::vector<GeneratedFunction> all = all_functions(generation);
  if (generation.damped) all.push_back(*generation.damped);
  return all;
}

std::string describe_domain(const Generation& generation) {
  std::set<std::string> arguments;
  for (const GeneratedFunction& generated : all_functions(generation)) {
    if (generated.rounding.kind == RoundingBound::Kind::none) continue;
    for (const Argument& argument : generated.program.arguments) arguments.insert(argument.name);
  }
  return describe(generation.domain, {arguments.begin(), arguments.end()});
}

std::optional<Generation> generate_code(const Robot& robot, const Scene& scene,
                                        const Provenance& provenance, Diagnostics& diagnostics,
                                        const Choices& choices, const TellFunction& tell) {
  Generation generation;
  FunctionMechanisms mechanisms(robot, scene);
  generation.mechanism = mechanisms.whole();
  backend_of(scene.language)
      .refuse(describe_scene(robot, scene, generation.mechanism), diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  generation.domain = make_domain(robot, scene, generation.mechanism);
  add_base_parameters(generation.mechanism, generation.domain);
  if (!generate_functions(mechanisms, scene, choices, tell, generation, diagnostics)) {
    return std::nullopt;
  }
  check_normals(scene, generation.mechanism, generation.functions, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  if (scene.damped) generation.damped = compose_damped(generation.functions);
  EmissionContext context = context_of(robot, scene, provenance, generation);
  context.measured = choices.measured;
  context.input_costs = count_inputs(robot, scene, generation.functions);
  if (scene.controller) {
    if (tell) tell("the controller");
    add_controller(robot, scene, context, generation);
  }
  if (scene.ground_step) {
    if (tell) tell("the step on the ground");
    add_ground(robot, scene, context, diagnostics);
    if (diagnostics.has_errors()) return std::nullopt;
  }
  const std::vector<Program> programs = programs_of(generation.functions);
  const std::vector<Program> batch = programs_of(generation.batch);
  generation.files = emit(context, programs, diagnostics, batch);
  if (diagnostics.has_errors()) return std::nullopt;
  generation.conventions = describe_conventions(context);
  generation.sources = list_sources({context, programs, batch});
  generation.context = std::make_shared<const EmissionContext>(std::move(context));
  return generation;
}

}  // namespace treeline
