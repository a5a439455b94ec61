#include <cstdio>

#include "generation/measure_savings.hpp"
#include "scenes_of_robots.hpp"

// Prints one table for all scenes of a folder of robots: savings_report FOLDER.

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: savings_report FOLDER\n");
    return 2;
  }
  treeline::Diagnostics diagnostics;
  std::vector<treeline::Savings> all;
  for (const auto& [robot, scene] : treeline::growth::scenes_of_robots(argv[1], diagnostics)) {
    all.push_back(treeline::measure_savings(robot, scene));
  }
  std::printf("%s", treeline::print_table(all).c_str());
  for (const treeline::Diagnostic& diagnostic : diagnostics.list()) {
    std::fprintf(stderr, "%s\n", to_string(diagnostic).c_str());
  }
  return diagnostics.has_errors() ? 1 : 0;
}
