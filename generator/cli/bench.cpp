#include "bench/bench.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <memory>
#include <optional>

#include "bench/cold_report.hpp"
#include "bench/draw_svg.hpp"
#include "bench/suite.hpp"
#include "cli/commands.hpp"
#include "cli/read_inputs.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/progress_line.hpp"
#include "terminal/write_output.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

constexpr const char* kHowToReadBench =
    "Each way to a function's numbers is timed, and compared with the interpreter in 50 digits:\n"
    "  ns          of a state: median of interleaved rounds, warm, back to back over 64 states\n"
    "  ratio       of that to the code that the scene asks for, the first line\n"
    "  norm        largest error of any entry of a result over its largest entry\n"
    "  comp        largest error of any entry over that entry\n"
    "  50 %, 99 %, worst  of all states; they lie within the joints' limits, at ordinary speeds,\n"
    "              and are drawn from numbers that float has, so that float answers the same;\n"
    "              where rows are held, states of double keep them, and qdd alone is compared\n"
    "  *           nothing else is as fast and as accurate (worst, norm-wise); never where the "
    "caller\n"
    "              has to take the sines, or to have eight states at once\n"
    "Below stands how the fastest of the rejected routes compares with the first line.\n"
    "Variants differ from the first line in what they are called by, and in nothing else: C, "
    "eight\n"
    "states a call (batch), lanes, float, the algorithm (route), inertias as in the URDF (full),\n"
    "accuracy, where sines and cosines come from, whether products and sums may be fused. Behind "
    "a\n"
    "semicolon stand variants whose code is the same. Lambda by Eigen's factorisations starts "
    "from\n"
    "the emitted Lambda^-1 in double. The interpreter's time has its allocations in it.\n"
    "Peers are other libraries, in double: KDL, DART, Pinocchio, MuJoCo, dynibo, and what CasADi\n"
    "records of Pinocchio, where their modules lie beside this program (built with\n"
    "-DTREELINE_PEERS=ON). Recorded code is compiled by $CC, else cc, with -O3 -march=native, and\n"
    "left out where that takes more than a minute. The time of peers has what brings joints into\n"
    "their order in it, not what brings matrices back. A peer that computes something else is\n"
    "told, not timed.\n"
    "With --cold, what `optimize: speed` and `size` make of each function of one "
    "state:\n"
    "  bytes       of code, with the sines that it calls, and constants\n"
    "  from cache  a call alone, after much else ran on this core: code and data are in the cache\n"
    "              that cores share\n"
    "  from memory  the same, code and data are in no cache\n"
    "  flag        -Os where it is compiled so\n"
    "With --suite, the emitted code as C++, as C and of eight states a call (batch) beside the\n"
    "fastest peer that loads a robot, and the fastest that makes code for it (recorded), of each\n"
    "robot of a list:\n"
    "  places      time where the code lies worst in memory over that where it lies best\n"
    "  times       how many times as long as the C++ the peer takes\n"
    "  error       largest norm-wise error of any state, then of each peer\n"
    "Measure on a machine that does nothing else. The compiler is $CXX, else c++, else g++.\n\n"
    "Examples:\n"
    "  treeline bench puma560.urdf scene.yaml --svg puma560.svg\n"
    "  treeline bench puma560.urdf scene.yaml --functions control_torque --json > bench.jsonl\n"
    "  treeline bench humanoid.urdf scene.yaml --cold\n"
    "  treeline bench --suite robots.txt --svg suite.svg";

constexpr int kQuickStates = 40;
constexpr int kQuickRounds = 7;
constexpr int kQuickColdRounds = 9;
constexpr int kSuitePlaces = 5;

struct BenchCommand {
  InputOptions inputs;
  BenchOptions bench;
  std::string svg;
  std::vector<std::string> peers;
  std::vector<std::string> variants;
  std::optional<int> places;
  std::string suite;
  bool quick = false;
  bool cold = false;
  bool json = false;
};

/// Says what is being done, where somebody sees it.
std::function<void(const std::string&, int, int)> tell_progress() {
  if (!is_watched()) return {};
  return [](const std::string& what, int done, int total) {
    show_progress(done == total ? "" : fmt::format("  {} {}/{}", what, done, total));
  };
}

/// Tells which peers were not measured or disagree: somebody who sees no table may miss them.
void tell_of_peers(const BenchReport& report, Diagnostics& diagnostics) {
  const auto tell = [&](Severity severity, const std::string& fault) {
    diagnostics.add({severity, "", 0, "", fault, ""});
  };
  if (!report.no_peers.empty()) tell(Severity::note, "no peers measured: " + report.no_peers);
  if (!report.absent_peers.empty()) {
    tell(Severity::note,
         fmt::format("not measured: {}; {}", fmt::join(report.absent_peers, ", "), kBringPeers));
  }
  for (const BenchFunction& function : report.functions) {
    for (const BenchRow& row : function.disagreeing) {
      tell(Severity::warning,
           fmt::format("{} of {} disagrees, by {:.1e} at the median, and is left out",
                       function_name(function.function), row.variant.name, row.norm.median));
    }
  }
}

/// Variants and peers are compared as C++, and no figure of one language stands for another.
void refuse_language(Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, "", 0, "language", "bench times C++ only",
                   "Leave `language` out of the scene that you measure."});
}

template <class Report>
int print_report(const std::optional<Report>& report, const BenchCommand& options,
                 const Diagnostics& diagnostics) {
  print_diagnostics(diagnostics, options.inputs.warnings);
  if (!report) return kBadInput;
  const ExitCode exit_code = diagnostics.has_errors() ? kBadInput : kOk;
  return options.json ? write_output(print_json_lines(*report), OutputForm::json, exit_code)
                      : write_output(print_table(*report), OutputForm::text, exit_code);
}

/// Writes the picture where one is asked for, and the report.
template <class Report>
int deliver(const std::optional<Report>& report, const BenchCommand& options,
            Diagnostics& diagnostics) {
  if (report && !options.svg.empty()) {
    (void)write_output_file(options.svg, draw_svg(*report), diagnostics);
  }
  return print_report(report, options, diagnostics);
}

std::optional<ColdReport> run_cold(const RobotAndScene& inputs, const BenchCommand& options,
                                   Diagnostics& diagnostics) {
  ColdBenchOptions cold;
  cold.flags = options.bench.flags;
  cold.seed = options.bench.seed;
  cold.progress = tell_progress();
  if (options.quick) {
    cold.rounds = kQuickColdRounds;
    cold.warm.rounds = kQuickRounds;
  }
  return run_cold_bench(inputs.robot, inputs.scene, cold, diagnostics);
}

/// Completes the options by what the command line says.
void prepare_warm(BenchCommand& options, Diagnostics& diagnostics) {
  for (const std::string& name : options.variants) {
    if (const auto group = find_group(name)) options.bench.groups.push_back(*group);
  }
  options.bench.peers = find_peers(options.peers, diagnostics);
  options.bench.progress = tell_progress();
  if (options.quick) {
    options.bench.states = kQuickStates;
    options.bench.timing.rounds = kQuickRounds;
  }
}

std::optional<BenchReport> run_warm(const RobotAndScene& inputs, const BenchCommand& options,
                                    Diagnostics& diagnostics) {
  if (diagnostics.has_errors()) return std::nullopt;
  auto report = run_bench(inputs.robot, inputs.scene, options.bench, diagnostics);
  if (report) tell_of_peers(*report, diagnostics);
  return report;
}

/// The reports of all robots of the suite; nothing where one of them has a fault.
std::optional<std::vector<BenchReport>> measure_suite(const BenchCommand& options,
                                                      Diagnostics& diagnostics) {
  const auto robots = read_suite(options.suite, diagnostics);
  if (!robots) return std::nullopt;
  std::vector<BenchReport> reports;
  for (const SuiteRobot& robot : *robots) {
    InputOptions files = options.inputs;
    files.urdf = robot.urdf;
    files.scene = robot.scene;
    files.name = package_name_from(std::filesystem::path(robot.urdf).stem().string());
    const auto inputs = read_inputs(files, diagnostics);
    if (!inputs) return std::nullopt;
    auto report = run_warm(*inputs, options, diagnostics);
    if (!report) return std::nullopt;
    reports.push_back(std::move(*report));
  }
  return reports;
}

int run_suite(BenchCommand options) {
  Diagnostics diagnostics;
  if (options.variants.empty()) {
    options.bench.groups = {VariantGroup::language, VariantGroup::batch, VariantGroup::peer};
  }
  options.bench.places = options.places.value_or(kSuitePlaces);
  prepare_warm(options, diagnostics);
  return deliver(measure_suite(options, diagnostics), options, diagnostics);
}

int run(BenchCommand options) {
  if (!options.suite.empty()) return run_suite(std::move(options));
  Diagnostics diagnostics;
  const auto inputs = read_inputs(options.inputs, diagnostics);
  if (inputs && inputs->scene.language != Language::cpp) refuse_language(diagnostics);
  if (inputs) (void)may_write(options.svg, list_paths(inputs->files), diagnostics);
  options.bench.places = options.places.value_or(1);
  if (!options.cold) prepare_warm(options, diagnostics);
  const bool ready = inputs && !diagnostics.has_errors();
  if (options.cold) {
    return print_report(ready ? run_cold(*inputs, options, diagnostics) : std::nullopt, options,
                        diagnostics);
  }
  return deliver(ready ? run_warm(*inputs, options, diagnostics) : std::nullopt, options,
                 diagnostics);
}

}  // namespace

void add_bench(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<BenchCommand>();
  CLI::App* command =
      app.add_subcommand("bench", "Run time and error of every way to a function's numbers");
  add_input_options(*command, options->inputs);
  CLI::Option* urdf = command->get_option("urdf")->required(false);
  CLI::Option* states = command->add_option("--states", options->bench.states, "How many states")
                            ->capture_default_str()
                            ->check(whole_between(1, 100000));
  command->add_option("--seed", options->bench.seed, "Other states")
      ->capture_default_str()
      ->check(whole_between(0, std::numeric_limits<std::int64_t>::max()));
  command->add_option("--flags", options->bench.flags, "For the compiler")->capture_default_str();
  command
      ->add_flag("--quick", options->quick,
                 fmt::format("{} states, {} rounds", kQuickStates, kQuickRounds))
      ->excludes(states);
  command->add_flag("--json", options->json, "The machine and each variant as a line of JSON");
  CLI::Option* svg =
      command->add_option("--svg", options->svg, "Writes time against error, a panel a function")
          ->check(no_input_file());
  CLI::Option* peer =
      command->add_option("--peer", options->peers, "Module of another peer, any number");
  command
      ->add_option("--variants", options->variants,
                   "Kinds of variants beside the emitted code, separated by commas; all")
      ->delimiter(',')
      ->allow_extra_args(false)
      ->check(one_of(group_names()));
  command
      ->add_option("--places", options->places,
                   fmt::format("How many times code is loaded, each elsewhere in memory, and "
                               "timed; 1, with --suite {}",
                               kSuitePlaces))
      ->check(whole_between(1, 100));
  CLI::Option* suite = command->add_option(
      "--suite", options->suite, "List of robots and scenes, a line each, beside the best peer");
  suite->excludes(urdf);
  command
      ->add_flag("--cold", options->cold,
                 "Bytes, and time out of cold caches, by `optimize`, in place of error")
      ->excludes(peer)
      ->excludes(suite)
      ->excludes(states)
      ->excludes(svg);
  command->footer(kHowToReadBench);
  command->callback([options, urdf, suite, &exit_code] {
    if (urdf->count() + suite->count() == 0) throw CLI::RequiredError("urdf");
    exit_code = run(*options);
  });
}

}  // namespace treeline
