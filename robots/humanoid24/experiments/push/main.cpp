// Pushes on a humanoid that stands within its limits, as a program.
#include "command_line/run_experiment.hpp"
#include "push.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "The humanoid stands on two feet that can tip, shifts its weight, reaches far, and is "
      "pushed\n"
      "at its chest from behind, from before and from the side. Torques and forces stay within\n"
      "their limits, and it recovers. By the unlimited law it falls. Exit status 3 if it does "
      "not."};
  OutputPaths paths;
  add_outputs(command, paths, "write the run within limits here", "draw both runs into this file");
  return run_experiment(command, argc, argv, [&paths] {
    const auto limited = run_push(true);
    const auto unlimited = run_push(false);
    return Findings{push_summary(limited, unlimited),
                    files_of(paths, limited.table, push_figure(limited, unlimited)),
                    push_claim_holds(limited, unlimited)};
  });
}
