#include "bench/bench_report.hpp"
#include "compilation/run_commands.hpp"
#include "compilation/temporary_folder.hpp"
#include "timing/describe_processor.hpp"

namespace treeline {
namespace {

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
  return {describe_processor(), compiler_name(command), command, own_compiler()};
}

}  // namespace treeline
