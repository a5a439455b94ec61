#include <fstream>

#include "bench/bench_report.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"

namespace treeline {
namespace {

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  std::string model;
  std::string family;
  for (std::string line; std::getline(file, line) && !line.empty();) {
    const auto value = [&] { return line.substr(std::min(line.find(':') + 2, line.size())); };
    if (line.starts_with("model name")) model = value();
    if (line.starts_with("cpu family")) family = value();
  }
  if (model.empty()) return "unknown processor";
  return family.empty() ? model : model + ", family " + family;
}

/// Returns the first line of `g++ --version` for a command like `g++ -std=c++17 -O3`.
std::string compiler_name(const std::string& command) {
  Command asked;
  for (const std::string& word : split_words(command)) {
    if (word.starts_with("-std=")) break;
    asked.push_back(word);
  }
  if (asked.empty()) return "unknown compiler";
  asked.emplace_back("--version");
  const TemporaryFolder work;
  const std::string output = run_commands({asked}, 1, work.path()).front().output;
  return output.substr(0, output.find('\n'));
}

std::string own_compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "g++ " __VERSION__;
#else
  return "unknown compiler";
#endif
}

}  // namespace

BenchMachine describe_machine(const std::string& command) {
  return {processor_name(), compiler_name(command), command, own_compiler()};
}

}  // namespace treeline
