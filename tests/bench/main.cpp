// Times generated code beside the interpreter and the peers. Options: those of Google Benchmark
// (`--benchmark_filter=humanoid24/control_torque`, `--benchmark_repetitions=`), and
//   --json=FILE  one JSON object a line for each function of each implementation
//   --least      tables of the least times instead of the medians
// Tables go to stdout.
#include <fmt/format.h>

#include <fstream>
#include <string_view>

#include "agreement.hpp"
#include "measure.hpp"
#include "peers.hpp"
#include "report.hpp"

namespace treeline::bench {
namespace {

/// Implementations whose numbers differ from the first's, announced on stderr.
bool report_differences(const Measured& measured) {
  bool agree = true;
  const auto states = random_states(measured.robot, 20, 7);
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

int run(const std::string& json_path, bool least) {
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
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  const Machine machine = describe_machine();
  fmt::print("{}", print_tables(robots, collector.times, machine, least));
  if (!json_path.empty()) {
    std::ofstream(json_path) << print_json_lines(robots, collector.times, machine);
  }
  return 0;
}

}  // namespace
}  // namespace treeline::bench

int main(int count, char** given) {
  // What is given comes later and wins.
  std::string interleave = "--benchmark_enable_random_interleaving=true";
  std::string repetitions = "--benchmark_repetitions=9";
  std::string time = "--benchmark_min_time=0.004";
  std::vector<char*> arguments{given[0], interleave.data(), repetitions.data(), time.data()};
  std::string json_path;
  bool least = false;
  constexpr std::string_view kJson = "--json=";
  for (int i = 1; i < count; ++i) {
    const std::string_view argument = given[i];
    if (argument.starts_with(kJson)) {
      json_path = argument.substr(kJson.size());
    } else if (argument == "--least") {
      least = true;
    } else {
      arguments.push_back(given[i]);
    }
  }
  int left = static_cast<int>(arguments.size());
  benchmark::Initialize(&left, arguments.data());
  if (benchmark::ReportUnrecognizedArguments(left, arguments.data())) return 2;
  return treeline::bench::run(json_path, least);
}
