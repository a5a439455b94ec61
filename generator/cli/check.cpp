#include "check/check.hpp"

#include <fmt/format.h>

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>

#include "board/check_on_board.hpp"
#include "check/add_selftest.hpp"
#include "cli/commands.hpp"
#include "cli/generate_from_files.hpp"
#include "target/executes.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/progress_line.hpp"
#include "terminal/write_output.hpp"

namespace treeline {
namespace {

constexpr const char* kHowToReadCheck =
    "Each function is called at every state and compared with the interpreter in 50 digits:\n"
    "  median, 99 %, worst  error in ulp (2^-52, of float 2^-23) of the scale: the equation with\n"
    "              the magnitude of each term in place of the term, so that nothing cancels\n"
    "  interp      the interpreter's own worst error, computed in the same Real\n"
    "  equation    where the equation has a derivative: what it is off, of its largest term,\n"
    "              if lower functions are differentiated in 50 digits, at 20 states\n"
    "  bound       allowed: 8 ulp + 16 x the interpreter's worst; where a matrix is solved with,\n"
    "              the latter per condition of that matrix (scaled to a unit diagonal), times it;\n"
    "              what is made with M^-1 multiplies the condition of M by its own;\n"
    "              and for each angle that is computed as q + offset its magnitude in rad.\n"
    "              damped_control_torque solves with Lambda^-1 + Delta: what is large beside the\n"
    "              limits of effective mass counts, a singularity does not\n"
    "  of bound    the largest share of its bound that any state's error takes\n"
    "  rounding    what the header states of rounding errors, in the result's unit; with a tilde\n"
    "              to first order; of rounding: the largest share of it, or of the first-order\n"
    "              bound of the very state, that was seen\n"
    "  singular    states where that matrix is singular in Real; only bits are compared there\n"
    "  bits        equal: without contraction of products and sums, all results are those of the\n"
    "              expression graph to the bit\n"
    "  code, stack bytes of the function with its sines and cosines, of damped_control_torque\n"
    "              without the functions that it calls; cc: seconds to compile it; of more than\n"
    "              12000 operations with -O0, which is larger, unless --flags says how, or\n"
    "              `optimize` of the scene asks for small code: then as it is delivered\n"
    "State classes: neutral, random (within limits), large (angles of many turns), fast, tiny,\n"
    "aligned (joints at or next to quarter turns, where arms are singular), limits (joints at "
    "their\n"
    "limits). A state is a matter of its index, the seed and the robot; --first INDEX --states 1 "
    "--json prints it.\n"
    "For --target x86-64-v3 or v4 the code is compiled for it where this machine executes that.\n"
    "The compiler is $CXX, else c++, else g++; of C code $CC, else that of C beside $CXX, else "
    "cc,\n"
    "else gcc. Exit: 0 passed, 1 bad input, 3 a function is beyond its bound, differs in a bit or\n"
    "could not be checked, or a file of --generated is stale.\n\n"
    "Examples:\n"
    "  treeline check puma560.urdf\n"
    "  treeline check puma560.urdf scene.yaml\n"
    "  treeline check puma560.urdf scene.yaml --flags '-O3 -march=native'\n"
    "  treeline check puma560.urdf scene.yaml --generated generated/puma560\n"
    "  treeline check puma560.urdf scene.yaml --real float --target cortex-m4f\n"
    "  treeline check puma560.urdf scene.yaml --real float --target cortex-m4f --states 20\n"
    "    --runner ./run_on_my_board --memory 0x08000000,0x20000000,0x20000";

constexpr const char* kHowToReadTargets =
    "With --target NAME, unless NAME is generic or of x86, the code is compiled for that "
    "processor\n"
    "with GCC and runs on a board that QEMU imitates; each result is compared with this "
    "machine's:\n"
    "  text, const bytes of code, and of constants outside of it\n"
    "  stack       bytes as the compiler measured them, summed over the deepest path of calls,\n"
    "              without the compiler's own library; seen: those that a call wrote to, with it\n"
    "  instructions  that a call executes, least and most over all states if they differ\n"
    "  cycles, about  an estimate: instructions times the mean of the costs printed below the "
    "table\n"
    "  bits        equal: those of this machine; with flags that fuse products and sums the "
    "largest\n"
    "              error in ulp of the scale instead\n"
    "  library     functions of the compiler's own that emulate operations\n"
    "With --runner COMMAND a board of yours takes the place of QEMU: COMMAND ELF lets it run the\n"
    "program and prints what it sends, by semihosting or, with --port, as that writes it. Cycles\n"
    "are then counted by DWT's CYCCNT, mcycle or the port; instructions where the board can.\n\n";

struct CheckCommand {
  InputOptions inputs;
  CheckOptions check;
  BoardOptions board;
  std::string port;
  std::string folder;
  bool json = false;
  bool has_flags = false;  ///< whether --flags is given
};

/// Counts where somebody sees it.
Progress count_progress(const char* what) {
  if (!is_watched()) return {};
  return [what](int done, int total) {
    show_progress(done == total ? "" : fmt::format("  {} {}/{}", what, done, total));
  };
}

/// Whether the code shall run on a board instead of this machine.
bool is_for_board(const CheckCommand& options) {
  const Target* const target = find_target(options.inputs.target);
  return target != nullptr && target->board.kind != BoardKind::none;
}

/// The code that `generate` would write.
std::optional<GeneratedInputs> make_code(const CheckCommand& options, Diagnostics& diagnostics) {
  auto made = generate_from_files(options.inputs, Failing::kept, diagnostics);
  if (!made) return made;
  // Functions that fail have no states of a self-test: what comes shows them.
  if (!made->failed.empty()) made->inputs.scene.selftest = 0;
  if (!add_selftest(made->inputs.robot, made->inputs.scene, made->generation, diagnostics)) {
    return std::nullopt;
  }
  warn_beforehand(options.inputs, *made);
  return made;
}

std::optional<BoardReport> make_board_report(const CheckCommand& options,
                                             Diagnostics& diagnostics) {
  const auto made = make_code(options, diagnostics);
  if (!made) return std::nullopt;
  return check_on_board(made->inputs.robot, made->inputs.scene, made->generation, options.check,
                        options.board, diagnostics);
}

/// Compiles for the scene's processor where it is one of x86 and this machine is one, too.
void select_processor(const Target& target, CompileOptions& compile, Diagnostics& diagnostics) {
  if (!is_particular(target) || target.board.kind != BoardKind::none) return;
  if (executes(target)) {
    for (std::string* flags : {&compile.flags, &compile.long_flags}) {
      *flags += std::string(" ") + target.flags;
    }
    return;
  }
  diagnostics.add({Severity::warning, "", 0, "",
                   fmt::format("this machine does not execute code for {}", target.name),
                   "The code is checked without its flags, in vectors of this machine."});
}

std::optional<CheckReport> make_report(CheckCommand options, Diagnostics& diagnostics) {
  const auto made = make_code(options, diagnostics);
  if (!made) return std::nullopt;
  const Scene& scene = made->inputs.scene;
  if (!options.has_flags) {
    select_processor(*find_target(scene.target), options.check.compile, diagnostics);
  }
  return check(made->inputs.robot, scene, made->generation, options.check, diagnostics);
}

/// Prints a report of either kind, if there is one.
template <class Report>
int print_report(const CheckCommand& options, const std::optional<Report>& report,
                 const Diagnostics& diagnostics) {
  print_diagnostics(diagnostics, options.inputs.warnings);
  if (!report) return kBadInput;
  const ExitCode exit_code = report->passed() ? kOk : kMismatch;
  return options.json ? write_output(print_json(*report), OutputForm::json, exit_code)
                      : write_output(print_text(*report), OutputForm::text, exit_code);
}

int run(CheckCommand options) {
  Diagnostics diagnostics;
  options.check.folder = options.folder;
  options.board.port = options.port;
  options.check.compile.progress = count_progress("compiled");
  options.check.references.progress = count_progress("states");
  if (!options.board.runner.empty() && !is_for_board(options)) {
    diagnostics.add({Severity::error, "", 0, "--runner",
                     "the code is to run on this machine, not on a board",
                     "Name the board's processor, such as --target cortex-m4f."});
    print_diagnostics(diagnostics, options.inputs.warnings);
    return kBadInput;
  }
  if (is_for_board(options)) {
    const auto report = make_board_report(options, diagnostics);
    return print_report(options, report, diagnostics);
  }
  const auto report = make_report(options, diagnostics);
  return print_report(options, report, diagnostics);
}

/// Options of a board that stands in the place of QEMU's.
void add_own_board(CLI::App& command, CheckCommand& options) {
  auto* runner = command.add_option(
      "--runner", options.board.runner,
      "For --target, in place of QEMU: program and arguments, before that of the ELF file, that "
      "let a board run it and print what the board sends");
  command
      .add_option("--port", options.port,
                  "C or C++ source of that board: treeline_board_begin, _write, _cycles")
      ->check(CLI::ExistingFile)
      ->needs(runner);
  command
      .add_option("--memory", options.board.memory,
                  "Of that board: where code and data begin, and bytes of data, such as "
                  "0x08000000,0x20000000,0x20000")
      ->needs(runner);
}

}  // namespace

void add_check(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<CheckCommand>();
  CLI::App* command =
      app.add_subcommand("check", "Compile generated code and compare it with 50 digits");
  add_input_options(*command, options->inputs);
  command->add_option("--generated", options->folder,
                      "Compile this folder instead of what is generated now, and name stale files");
  ReferenceOptions& references = options->check.references;
  auto* states = command
                     ->add_option("--states", references.states,
                                  "How many states; for a board of --target 300 unless you say")
                     ->capture_default_str()
                     ->check(whole_between(1, 1000000));
  command->add_option("--first", references.first, "Index of the first state")
      ->capture_default_str()
      ->check(whole_between(0, 1000000000));
  command->add_option("--seed", references.seed, "Other states")
      ->capture_default_str()
      ->check(whole_between(0, std::numeric_limits<std::int64_t>::max()));
  auto* flags = command->add_option("--flags", options->check.compile.flags, "For the compiler")
                    ->capture_default_str();
  add_own_board(*command, *options);
  command->add_option("--name", options->inputs.name,
                      "Namespace or prefix, and header, instead of the scene's");
  add_language_option(*command, options->inputs);
  command->add_option("--choices", options->inputs.choices,
                      "Algorithms and lanes as this manifest.json records them, not by cost");
  command->add_flag("--json", options->json, "Everything as JSON, with the states it names");
  command->footer(std::string(kHowToReadTargets) + kHowToReadCheck);
  command->callback([options, flags, states, &exit_code] {
    constexpr int kStatesOnBoard = 300;
    if (states->empty() && is_for_board(*options)) {
      options->check.references.states = kStatesOnBoard;
    }
    // Bits are the same at any level, and compiling long functions takes most of the time.
    options->has_flags = !flags->empty();
    if (!options->has_flags) {
      options->check.compile.long_flags =
          fmt::format("{} -ffp-contract=off", is_for_board(*options) ? "-O1" : "-O0");
    }
    exit_code = run(*options);
  });
}

}  // namespace treeline
