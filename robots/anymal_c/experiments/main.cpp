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
  std::string table;
  add_outputs(command, paths, "write the run here, 100 lines a second");
  add_page_table(command, table);
  return run_experiment(command, argc, argv, [&paths, &table] {
    const TrotPlan plan;
    const TrotRun run = run_trot(plan);
    auto files = files_of(paths, run.table, trot_figure(run));
    files.push_back({table, trot_page_table(run)});
    return Findings{trot_summary(plan, run), files, trot_claim_holds(plan, run)};
  });
}
