#include "board/check_on_board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "board/cross_compile.hpp"
#include "board/judge_calls.hpp"
#include "board/measure_objects.hpp"
#include "board/run_board.hpp"
#include "board/step_on_board.hpp"
#include "check/find_sources.hpp"
#include "check/judge_step.hpp"
#include "compilation/choose_flags.hpp"
#include "compilation/print_step_entry.hpp"
#include "compilation/temporary_folder.hpp"
#include "emission/print_identity.hpp"
#include "oracle/reference_maker.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Functions that run on the board, and their indices in `all_callable`. Functions for several
/// states in one call stay on the host.
struct BoardSelection {
  std::vector<GeneratedFunction> functions;
  std::vector<std::size_t> indices;
  std::vector<std::string> left_out;
};

BoardSelection select_functions(const Generation& generation) {
  BoardSelection selection;
  std::size_t i = 0;
  for (GeneratedFunction& generated : all_callable(generation)) {
    if (generated.batch > 0) {
      selection.left_out.push_back(source_stem(generated));
    } else {
      selection.functions.push_back(std::move(generated));
      selection.indices.push_back(i);
    }
    ++i;
  }
  return selection;
}

/// Bits are those of the expression graph, as the host computes it. Only bounds need 50 digits.
std::vector<StateReference> refer(const Robot& robot, const Scene& scene,
                                  const Generation& generation, const ReferenceOptions& options,
                                  bool contracted) {
  if (contracted) return make_references(robot, scene, generation, options);
  const ReferenceMaker maker(robot, scene, generation, options.seed);
  std::vector<StateReference> references;
  for (int i = 0; i < options.states; ++i) {
    references.push_back(maker.estimate(options.first + i));
  }
  return references;
}

std::vector<State> states_of(const std::vector<StateReference>& references) {
  std::vector<State> states;
  for (const StateReference& reference : references) states.push_back(reference.state);
  return states;
}

BoardReport begin_board_report(const Robot& robot, const Scene& scene, const Target& target,
                               const CheckOptions& options) {
  BoardReport report;
  report.name = scene.name;
  report.robot = robot.name;
  report.target = &target;
  report.single_precision = scene.real == Real::float32;
  report.contracted = asks_contraction(options.compile.flags);
  report.states = options.references.states;
  report.first_state = options.references.first;
  report.seed = options.references.seed;
  report.folder = options.folder.string();
  return report;
}

/// Inputs of a run beside the robot.
struct BoardJob {
  const Robot& robot;
  const Scene& scene;
  const Generation& generation;
  const Target& target;
  const Tools& tools;
  const CheckOptions& options;
  fs::path sources, work;
};

/// Compiles, measures, runs and judges. Fills in what the report lacks.
bool run_job(const BoardJob& job, const BoardSelection& selection,
             const std::vector<StateReference>& references, BoardReport& report,
             Diagnostics& diagnostics) {
  const Real real = job.scene.real;
  const auto& functions = selection.functions;
  std::optional<StepTape> tape;
  std::string step_entry;
  CompileOptions stepping = job.options.compile;
  if (job.generation.controller) {
    tape = record_steps(job.robot, job.scene, job.generation, job.options, job.sources, job.work,
                        diagnostics);
    if (!tape) return false;
    stepping = with_controller(job.scene, job.generation, stepping);
    step_entry = print_step_entry(
        job.scene.name, find_controller_header(job.scene.name, job.generation.files), "double");
  }
  const StepTape* const steps = tape ? &*tape : nullptr;
  if (!write_harness(functions, states_of(references), job.scene, job.target, steps, step_entry,
                     job.work, diagnostics)) {
    return false;
  }
  CompileOptions compile = stepping;
  compile.language = job.scene.language;
  compile.optimize = job.scene.optimize;
  compile.target = job.scene.target;
  compile.flags = add_extra_passes(compile.flags);  // compilers for boards are GCC
  const auto objects =
      cross_compile(job.sources, functions, job.target, job.tools, compile, job.work, diagnostics);
  if (!objects) return false;
  const auto program = link_program(*objects, job.target, job.tools, diagnostics);
  if (!program) return false;
  report.command = objects->command;
  report.long_command = objects->long_command;
  report.small_command = objects->small_command;
  report.compile_seconds = objects->seconds;
  report.functions = measure_objects(*objects, job.scene.name, functions, job.target, job.tools);
  const auto start = Clock::now();
  const auto calls = run_board(*program, functions, references.size(), real, steps, job.tools,
                               job.work, diagnostics);
  report.run_seconds = seconds_since(start);
  for (std::size_t i = 0; calls && i < functions.size(); ++i) {
    judge_calls(selection.indices[i], functions[i], calls->functions[i], references, real,
                report.contracted, report.functions[i]);
  }
  if (calls && tape) {
    BoardFunction step =
        measure_step(*objects, job.scene.name, functions.size(), job.target, job.tools);
    judge_steps(*tape, calls->steps, step);
    report.functions.push_back(std::move(step));
  }
  return calls.has_value();
}

}  // namespace

bool BoardReport::passed() const {
  return stale.empty() && std::all_of(functions.begin(), functions.end(),
                                      [&](const BoardFunction& f) { return f.passed(contracted); });
}

std::optional<BoardReport> check_on_board(const Robot& robot, const Scene& scene,
                                          const Generation& generation, const CheckOptions& options,
                                          Diagnostics& diagnostics) {
  const Target& target = *find_target(scene.target);
  const auto work = make_temporary_folder(diagnostics);
  if (!work) return std::nullopt;
  const auto tools = find_tools(target, work->path(), diagnostics);
  if (!tools) return std::nullopt;
  const auto sources = find_sources(scene, generation, options, work->path(), diagnostics);
  if (!sources) return std::nullopt;
  BoardReport report = begin_board_report(robot, scene, target, options);
  report.compiler = tools->compiler_version;
  report.simulator = fmt::format("{}", fmt::join(tools->simulator, " "));
  report.digest = digest_of_files(generation.files);
  if (!options.folder.empty()) report.stale = compare_files(options.folder, generation.files);
  BoardSelection selection = select_functions(generation);
  report.not_run = std::move(selection.left_out);
  const auto references = refer(robot, scene, generation, options.references, report.contracted);
  const fs::path place = work->path() / "board";
  fs::create_directory(place);
  const BoardJob job{robot, scene, generation, target, *tools, options, *sources, place};
  if (!run_job(job, selection, references, report, diagnostics)) return std::nullopt;
  return report;
}

}  // namespace treeline
