// ANYmal C stands, trots in place and walks ten metres, as a program.
#include "command_line/run_experiment.hpp"
#include "trot.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "The quadruped ANYmal C stands, trots in place, walks ten metres on diagonal pairs of feet,\n"
      "and stands again, on a ground that only pushes. Torques and forces stay within their "
      "limits\n"
      "in every cycle. Exit status 3 if it does not."};
  OutputPaths paths;
  add_outputs(command, paths, "write the run here, 100 lines a second");
  return run_experiment(command, argc, argv, [&paths] {
    const TrotPlan plan;
    const TrotRun run = run_trot(plan);
    return Findings{trot_summary(plan, run), files_of(paths, run.table, trot_figure(run)),
                    trot_claim_holds(plan, run)};
  });
}
