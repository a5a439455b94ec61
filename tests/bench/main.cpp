// Times generated code, the interpreter and the peers. Options are those of Google Benchmark
// (`--benchmark_filter=humanoid24/control_torque`, `--benchmark_repetitions=`), and
//   --json=FILE    one JSON object per line for each function of each implementation
//   --plot=FILE    an SVG
//   --counts=FILE  instructions from count_instructions.sh, for the table
//   --times=FILE   adds the times of earlier runs in the file, and these to the file
//   --least        least times instead of medians
// The table is printed on stdout.
#include <fmt/format.h>

#include <fstream>
#include <string_view>

#include "agreement.hpp"
#include "counts.hpp"
#include "measure.hpp"
#include "peers.hpp"
#include "report.hpp"

namespace treeline::bench {
namespace {

/// Prints implementations whose results differ from the first one's on stderr. Returns whether
/// there are any.
bool report_differences(const Measured& measured) {
  bool agree = true;
  const auto states = random_states(measured.robot, 16, 7);
  for (const auto& each : differences(measured.robot, measured.subjects, states)) {
    if (each.worst <= kAgreement) continue;
    agree = false;
    fmt::print(stderr, "DIFFERS: {} {} of {}: {:.1e} relative\n", measured.robot.robot,
               name_of(each.function), each.implementation, each.worst);
  }
  return agree;
}

std::vector<Measured> read_robots() {
  std::vector<Measured> robots;
  for (const auto& name : robot_names()) {
    if (auto robot = read_case(name)) {
      auto subjects = all_subjects(*robot);
      robots.push_back({std::move(*robot), std::move(subjects)});
    }
  }
  return robots;
}

struct Options {
  std::string json, plot, counts, times;
  bool least = false;
};

int run(const Options& options) {
  const auto robots = read_robots();
  bool agree = robots.size() == robot_names().size();
  for (const Measured& measured : robots) {
    agree = report_differences(measured) && agree;
    register_benchmarks(measured.robot, measured.subjects);
  }
  if (!agree) {
    fmt::print(stderr, "Nothing was timed: the implementations do not compute the same.\n");
    return 1;
  }
  const Machine machine = describe_machine();
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  if (!options.times.empty()) add_times(options.times, collector.times);
  const auto rows =
      collect_rows(robots, collector.times, read_counts(options.counts), machine.limits);
  fmt::print("{}", print_table(rows, machine, options.least));
  if (!options.json.empty()) std::ofstream(options.json) << print_json_lines(rows, machine);
  if (!options.plot.empty()) {
    std::ofstream(options.plot) << draw_plot(rows, machine, options.least);
  }
  return 0;
}

bool take_value(std::string_view argument, std::string_view key, std::string& value) {
  if (!argument.starts_with(key)) return false;
  value = argument.substr(key.size());
  return true;
}

/// Reads the argument if it is one of ours. All others belong to Google Benchmark.
bool take(std::string_view argument, Options& options) {
  if (argument == "--least") return options.least = true;
  return take_value(argument, "--json=", options.json) ||
         take_value(argument, "--plot=", options.plot) ||
         take_value(argument, "--times=", options.times) ||
         take_value(argument, "--counts=", options.counts);
}

}  // namespace
}  // namespace treeline::bench

int main(int count, char** given) {
  // Arguments given by the user come later and override these.
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::string repetitions = "--benchmark_repetitions=9";
  std::string time = "--benchmark_min_time=0.004";
  std::vector<char*> arguments{given[0], interleave.data(), repetitions.data(), time.data()};
  treeline::bench::Options options;
  for (int i = 1; i < count; ++i) {
    if (!treeline::bench::take(given[i], options)) arguments.push_back(given[i]);
  }
  int left = static_cast<int>(arguments.size());
  benchmark::Initialize(&left, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(left, arguments.data())) return 2;
  return treeline::bench::run(options);
}
