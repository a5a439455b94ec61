// Standing on two feet, as a program.
#include "command_line/run_experiment.hpp"
#include "stand.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "The humanoid stands on two feet and shifts its weight by leaning, while its left hand "
      "keeps\n"
      "its place. The base floats and has no motor. Exit status 3 if it has a torque, the hand or "
      "a\n"
      "foot moves, or the ground cannot have the forces that were chosen."};
  OutputPaths paths;
  add_outputs(command, paths, "write the run here", "draw the run into this file");
  return run_experiment(command, argc, argv, [&paths] {
    const auto run = run_stand();
    return Findings{stand_summary(run), files_of(paths, run.table, stand_figure(run)),
                    stand_claim_holds(run)};
  });
}
