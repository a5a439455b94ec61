// Fingers of a published hand turn a ball, as a program.
#include "command_line/run_experiment.hpp"
#include "turn_ball.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "Fingers of a published hand turn a ball and lead it around. Their tips roll on it, press\n"
      "it, and never slip. Exit status 3 if they do."};
  OutputPaths paths;
  std::string hand = "allegro";
  command.add_choice("--hand", hand, {"allegro", "shadow"}, "allegro: three fingers; shadow: five");
  std::string table;
  add_outputs(command, paths, "write the run here, 100 lines a second");
  add_page_table(command, table);
  return run_experiment(command, argc, argv, [&paths, &hand, &table] {
    const BallRun run = hand == "allegro" ? turn_ball_by_allegro(plan_of_allegro())
                                          : turn_ball_by_shadow(plan_of_shadow());
    auto files = files_of(paths, run.table, ball_figure(run));
    if (!table.empty()) {  // of both hands
      files.push_back({table, ball_page_table({turn_ball_by_allegro(plan_of_allegro()),
                                               turn_ball_by_shadow(plan_of_shadow())})});
    }
    return Findings{ball_summary(run), files, ball_claim_holds(run)};
  });
}
