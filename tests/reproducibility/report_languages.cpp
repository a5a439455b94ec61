// report_languages ROBOTS DATA: compares C with C++ to the bit for every scene of ROBOTS, in double
// and float, and for every robot of DATA/golden and DATA/published, each with GCC and Clang. Prints
// a line for each. Exit status: 0 all bits are equal, 1 something fails, 2 usage, 3 some bits
// differ.
#include <fmt/core.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "reproducibility/compare_languages.hpp"

namespace {

using namespace treeline;         // NOLINT: a program, not a header
using namespace treeline::tests;  // NOLINT
namespace fs = std::filesystem;

constexpr int kStates = 500;

/// A robot to compare; without a scene, functions of the joints alone.
struct Case {
  std::string urdf, scene;
};

std::vector<Case> find_cases(const fs::path& robots, const fs::path& data) {
  std::vector<Case> cases;
  for (const auto& folder : fs::directory_iterator(robots)) {
    const fs::path urdf = folder.path() / (folder.path().filename().string() + ".urdf");
    if (!fs::exists(urdf)) continue;
    for (const auto& file : fs::directory_iterator(folder)) {
      const bool is_scene = file.path().filename().string().starts_with("scene") &&
                            file.path().extension() == ".yaml";
      if (is_scene) cases.push_back({urdf.string(), file.path().string()});
    }
  }
  for (const char* folder : {"golden", "published"}) {
    for (const auto& file : fs::directory_iterator(data / folder)) {
      if (file.path().extension() == ".urdf") cases.push_back({file.path().string(), ""});
    }
  }
  std::sort(cases.begin(), cases.end(),
            [](const Case& a, const Case& b) { return a.urdf + a.scene < b.urdf + b.scene; });
  return cases;
}

/// Prints one line and returns the number of results that differ.
int compare_case(const Case& each, Real real, const Compilers& compilers) {
  const auto rows = compare_languages_of(each.urdf, each.scene, {}, real, 1, compilers, kStates);
  int results = 0, differ = 0;
  for (const LanguageRow& row : rows) {
    results += row.states;
    differ += row.bits_differ;
  }
  fmt::print("{:<24} {:<24} {:<6} {:<14} {:>9} {:>8} {:>7}\n", fs::path(each.urdf).stem().string(),
             fs::path(each.scene).stem().string(), real == Real::float32 ? "float" : "double",
             compilers.first + " " + compilers.second, rows.size(), results, differ);
  std::fflush(stdout);
  return differ;
}

int run(const fs::path& robots, const fs::path& data) {
  fmt::print("{:<24} {:<24} {:<6} {:<14} {:>9} {:>8} {:>7}\n", "robot", "scene", "real",
             "compilers", "functions", "results", "differ");
  int differ = 0;
  for (const Case& each : find_cases(robots, data)) {
    for (const Compilers& compilers : {Compilers{"g++", "gcc"}, Compilers{"clang++", "clang"}}) {
      differ += compare_case(each, Real::float64, compilers);
      if (!each.scene.empty()) differ += compare_case(each, Real::float32, compilers);
    }
  }
  return differ == 0 ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: report_languages ROBOTS DATA\n");
    return 2;
  }
  try {
    return run(argv[1], argv[2]);
  } catch (const std::exception& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
  }
}
