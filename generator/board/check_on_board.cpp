#include "board/check_on_board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "board/cross_compile.hpp"
#include "board/measure_objects.hpp"
#include "board/run_board.hpp"
#include "check/check.hpp"
#include "check/judges.hpp"
#include "compilation/compile_folder.hpp"
#include "compilation/print_step_entry.hpp"
#include "compilation/temporary_folder.hpp"
#include "emission/print_files.hpp"
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
  const BoardOptions& board;
  fs::path sources, work;
};

/// Sources that the program has beside the functions, and how all are compiled.
CompileOptions list_board_sources(const BoardJob& job) {
  CompileOptions compile = with_controller(job.scene, job.generation, job.options.compile);
  if (job.scene.selftest > 0) compile.stems.emplace_back(kSelftestStem);
  compile.language = job.scene.language;
  compile.optimize = job.scene.optimize;
  compile.flags = add_extra_passes(compile.flags);  // compilers for boards are GCC
  return compile;
}

/// A self-test that returns another number than 0 counts as a state of other bits.
void judge_selftest(const SelftestCall& call, BoardFunction& selftest) {
  selftest.states = 1;
  selftest.stack_seen = call.stack_seen;
  selftest.least = selftest.most = call.instructions;
  selftest.least_cycles = selftest.most_cycles = call.cycles;
  selftest.cycles *= static_cast<double>(call.instructions);
  selftest.returned = static_cast<int>(call.result);
  selftest.bits_differ = call.result == 0 ? 0 : 1;
}

/// Drops what this board does not count.
void drop_uncounted(const BoardReport& report, BoardFunction& function) {
  if (!report.counts_cycles) function.least_cycles = function.most_cycles = 0;
  if (report.counts_instructions) return;
  function.least = function.most = 0;
  function.cycles = 0;
  function.modes.clear();
}

/// Adds what was measured of the calls to what was measured of the objects.
void judge_run(const BoardJob& job, const BoardSelection& selection,
               const std::vector<StateReference>& references, const BoardObjects& objects,
               const BoardCase& board_case, const BoardRun& run, BoardReport& report) {
  const std::size_t functions = selection.functions.size();
  for (std::size_t i = 0; i < functions; ++i) {
    judge_calls(selection.indices[i], selection.functions[i], run.functions[i], references,
                job.scene.real, report.contracted, report.functions[i]);
  }
  const std::size_t end_of_step = objects.stems.size() - (board_case.selftest ? 1 : 0);
  const auto measure = [&](const char* suffix, std::size_t first, std::size_t last) {
    return measure_unit(objects, job.scene.name + suffix, first, last, job.target, job.tools);
  };
  if (board_case.tape != nullptr) {
    report.functions.push_back(measure("_step", functions, end_of_step));
    judge_steps(*board_case.tape, run.steps, report.functions.back());
  }
  if (board_case.selftest) {
    report.functions.push_back(measure("_selftest", end_of_step, objects.stems.size()));
    judge_selftest(run.selftest, report.functions.back());
  }
  report.counts_instructions = run.counts_instructions;
  report.counts_cycles = !job.board.runner.empty() &&
                         std::all_of(report.functions.begin(), report.functions.end(),
                                     [](const auto& each) { return each.most_cycles > 0; });
  for (BoardFunction& function : report.functions) drop_uncounted(report, function);
}

/// Compiles, measures, runs and judges. Fills in what the report lacks.
bool run_job(const BoardJob& job, const BoardSelection& selection,
             const std::vector<StateReference>& references, BoardReport& report,
             Diagnostics& diagnostics) {
  const auto& functions = selection.functions;
  BoardCase board_case{job.scene.name,
                       job.scene.language,
                       job.scene.real,
                       functions,
                       states_of(references),
                       nullptr,
                       {},
                       job.scene.selftest > 0};
  std::optional<StepTape> tape;
  if (job.generation.controller) {
    tape = record_steps(job.robot, job.scene, job.generation, job.options, job.sources, job.work,
                        diagnostics);
    if (!tape) return false;
    board_case.tape = &*tape;
    board_case.step_entry = print_step_entry(
        job.scene.name, find_controller_header(job.scene.name, job.generation.files), "double");
  }
  const auto id = write_harness(board_case, job.target, job.work, diagnostics);
  if (!id) return false;
  const auto objects = cross_compile(job.sources, functions, job.target, job.tools,
                                     list_board_sources(job), job.board, job.work, diagnostics);
  if (!objects) return false;
  const auto program = link_program(*objects, job.target, job.tools, job.board, diagnostics);
  if (!program) return false;
  report.command = objects->command;
  report.long_command = objects->long_command;
  report.small_command = objects->small_command;
  report.compile_seconds = objects->seconds;
  report.functions = measure_objects(*objects, job.scene.name, functions, job.target, job.tools);
  const auto start = Clock::now();
  const auto run = run_board(*program, *id, board_case, job.tools, job.board.runner.empty(),
                             job.work, diagnostics);
  report.run_seconds = seconds_since(start);
  if (run) judge_run(job, selection, references, *objects, board_case, *run, report);
  return run.has_value();
}

}  // namespace

bool BoardReport::passed() const {
  return stale.empty() && std::all_of(functions.begin(), functions.end(),
                                      [&](const BoardFunction& f) { return f.passed(contracted); });
}

std::optional<BoardReport> check_on_board(const Robot& robot, const Scene& scene,
                                          const Generation& generation, const CheckOptions& options,
                                          const BoardOptions& board, Diagnostics& diagnostics) {
  const Target& target = *find_target(scene.target);
  const auto work = make_temporary_folder(diagnostics);
  if (!work) return std::nullopt;
  const auto tools = find_tools(target, board.runner, work->path(), diagnostics);
  if (!tools) return std::nullopt;
  const auto sources = find_sources(scene, generation, options, work->path(), diagnostics);
  if (!sources) return std::nullopt;
  BoardReport report = begin_board_report(robot, scene, target, options);
  report.compiler = tools->compiler_version;
  report.runner = fmt::format("{}", fmt::join(tools->runner, " "));
  report.digest = digest_of_files(generation.files);
  if (!options.folder.empty()) report.stale = compare_files(options.folder, generation.files);
  BoardSelection selection = select_functions(generation);
  report.not_run = std::move(selection.left_out);
  if (scene.ground_step) {
    diagnostics.add({Severity::note, scene.file, 0, "ground/step",
                     scene.name + "_ground_step is not looked at on the board",
                     "`treeline check` without --target compiles it."});
  }
  const auto references = refer(robot, scene, generation, options.references, report.contracted);
  const fs::path place = work->path() / "board";
  fs::create_directory(place);
  const BoardJob job{robot, scene, generation, target, *tools, options, board, *sources, place};
  if (!run_job(job, selection, references, report, diagnostics)) return std::nullopt;
  return report;
}

}  // namespace treeline
