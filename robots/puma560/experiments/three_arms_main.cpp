// Three PUMA 560 carry one beam with commanded internal forces, by the code of a scene with all of
// them (Chang 7.2).
#include <fmt/core.h>

#include "command_line/run_experiment.hpp"
#include "three_arms.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "Three arms carry one beam, pulling it apart as commanded, at 1 kHz. Exit status 3 if "
      "a bound is broken."};
  ThreeArmsPlan plan;
  OutputPaths paths;
  std::string table;
  add_substeps(command, plan.substeps);
  add_outputs(command, paths);
  add_page_table(command, table);
  return run_experiment(command, argc, argv, [&] {
    const auto outcome = carry_with_three_arms(plan);
    const std::string title = fmt::format("three PUMA 560 carry a beam at {:.0f} Hz\n", plan.rate);
    auto files = files_of(paths, outcome.table, figure(outcome));
    files.push_back({table, page_table(outcome)});
    return Findings{title + summary(outcome), files, within_bounds(outcome)};
  });
}
