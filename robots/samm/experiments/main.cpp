// Two PUMAs on SAMM bases carry one object with commanded internal forces (Chang 7.2.2), by the
// code of a scene with both robots.
#include <fmt/core.h>

#include "carry_object.hpp"
#include "command_line/run_experiment.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "Two mobile manipulators carry one object, squeezing it as commanded, at 1 kHz. Exit "
      "status 3 if a bound is broken."};
  CarryPlan plan;
  OutputPaths paths;
  add_substeps(command, plan.substeps);
  add_outputs(command, paths);
  return run_experiment(command, argc, argv, [&] {
    const auto outcome = carry_object(plan);
    const std::string title =
        fmt::format("two SAMMs carry an object: {:.0f} s at {:.0f} Hz\n", plan.duration, plan.rate);
    return Findings{title + summary(outcome), files_of(paths, outcome.table, figure(outcome)),
                    within_bounds(outcome)};
  });
}
