// Joint-limit avoidance in the null space, as a program.
#include "avoid_limits.hpp"
#include "command_line/run_experiment.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "SAMM's tool turns in place at 1 kHz, farther than the arm alone can: with joint limits\n"
      "avoided by the posture, so that the base goes round, and without. Exit status 3 if a limit\n"
      "is reached or the tool notices."};
  OutputPaths paths;
  add_outputs(command, paths,
              "write the run that avoids the limits here, the other to FILE.without",
              "draw both runs into this file");
  return run_experiment(command, argc, argv, [&paths] {
    const auto avoiding = run_avoid_limits(true);
    const auto without = run_avoid_limits(false);
    return Findings{avoid_summary(avoiding, without),
                    files_of_both(paths, avoiding.table, ".without", without.table,
                                  avoid_figure(avoiding, without)),
                    avoid_claim_holds(avoiding, without)};
  });
}
