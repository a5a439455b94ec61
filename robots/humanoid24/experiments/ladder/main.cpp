// Two humanoids carry a ladder with commanded internal forces, by the code of a scene with both of
// them (Chang 7.1).
#include <fmt/core.h>

#include "carry_ladder.hpp"
#include "command_line/run_experiment.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "Two humanoids carry a ladder, squeezing its rails as commanded, at 1 kHz. Exit status 3 if "
      "a bound is broken."};
  LadderPlan plan;
  OutputPaths paths;
  std::string table;
  add_substeps(command, plan.substeps);
  add_outputs(command, paths);
  add_page_table(command, table);
  return run_experiment(command, argc, argv, [&] {
    const auto outcome = carry_ladder(plan);
    const std::string title = fmt::format("two humanoids carry a ladder at {:.0f} Hz\n", plan.rate);
    auto files = files_of(paths, outcome.table, figure(outcome));
    files.push_back({table, page_table(outcome)});
    return Findings{title + summary(outcome), files, within_bounds(outcome)};
  });
}
