#include "choice/choose_functions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <mutex>
#include <set>
#include <utility>

#include "choice/base_parameter_domain.hpp"
#include "choice/choose_loops.hpp"
#include "choice/evaluate_damped.hpp"
#include "choice/for_each_index.hpp"
#include "recursion/routes/routes_of_groups.hpp"
#include "recursion/routes/trace_function.hpp"

namespace treeline {
namespace {

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
  job.generated->rounding = bound_rounding(job.generated->program, domain,
                                           rounding_unit(scene.real), solve_of(job.function));
}

/// Functions and batches of `chosen`; false when a choice cannot be made. They do not depend on
/// each other, so several are generated at a time.
bool generate_functions(FunctionMechanisms& mechanisms, const Scene& scene, const Choices& choices,
                        const TellFunction& tell, ChosenFunctions& chosen,
                        Diagnostics& diagnostics) {
  std::vector<Job> jobs = list_jobs(mechanisms, scene, choices);
  std::mutex telling;
  std::size_t begun = 0;
  for_each_index(jobs.size(), [&](std::size_t i) {
    if (tell) {
      const std::lock_guard lock(telling);
      tell(fmt::format("{} ({} of {})", function_name(jobs[i].function), ++begun, jobs.size()));
    }
    do_job(scene, choices, chosen.domain, jobs[i]);
  });
  for (Job& job : jobs) {
    for (const Diagnostic& each : job.diagnostics.list()) diagnostics.add(each);
    if (!job.generated || job.diagnostics.has_errors()) return false;
    (job.batch ? chosen.batch : chosen.functions).push_back(std::move(*job.generated));
  }
  return true;
}

}  // namespace

std::optional<ChosenFunctions> choose_functions(const Robot& robot, const Scene& scene,
                                                FunctionMechanisms& mechanisms,
                                                const Choices& choices, const TellFunction& tell,
                                                Diagnostics& diagnostics) {
  ChosenFunctions chosen;
  chosen.mechanism = mechanisms.whole();
  chosen.choices = choices;
  chosen.domain = make_domain(robot, scene, chosen.mechanism);
  add_base_parameters(chosen.mechanism, chosen.domain);
  if (!generate_functions(mechanisms, scene, choices, tell, chosen, diagnostics)) {
    return std::nullopt;
  }
  if (scene.damped) chosen.damped = compose_damped(chosen.functions);
  return chosen;
}

std::optional<ChosenFunctions> choose_functions(const Robot& robot, const Scene& scene,
                                                const Choices& choices, Diagnostics& diagnostics) {
  FunctionMechanisms mechanisms(robot, scene);
  return choose_functions(robot, scene, mechanisms, choices, {}, diagnostics);
}

double rounding_unit(Real real) {
  return real == Real::float32 ? 0x1p-24 : 0x1p-53;
}

std::vector<Program> programs_of(const std::vector<GeneratedFunction>& functions) {
  std::vector<Program> programs;
  for (const GeneratedFunction& generated : functions) programs.push_back(generated.program);
  return programs;
}

std::vector<GeneratedFunction> all_functions(const ChosenFunctions& chosen) {
  std::vector<GeneratedFunction> all = chosen.functions;
  all.insert(all.end(), chosen.batch.begin(), chosen.batch.end());
  return all;
}

std::vector<GeneratedFunction> all_callable(const ChosenFunctions& chosen) {
  std::vector<GeneratedFunction> all = all_functions(chosen);
  if (chosen.damped) all.push_back(*chosen.damped);
  return all;
}

std::string describe_domain(const ChosenFunctions& chosen) {
  std::set<std::string> arguments;
  for (const GeneratedFunction& generated : all_functions(chosen)) {
    if (generated.rounding.kind == RoundingBound::Kind::none) continue;
    for (const Argument& argument : generated.program.arguments) arguments.insert(argument.name);
  }
  return describe(chosen.domain, {arguments.begin(), arguments.end()});
}

}  // namespace treeline
