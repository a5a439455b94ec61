// Chang chapter 8 on the humanoid, as a program: its left fist hits a wall.
#include "command_line/run_experiment.hpp"
#include "hit_wall.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "The humanoid's left fist hits a wall, rebounds and presses against it. Exit "
      "status 3 if a claim is broken."};
  std::string plan_file = TREELINE_HUMANOID24_DIR "/hit_wall.yaml";
  OutputPaths paths;
  WallSettings settings;
  command.add_text("--plan", plan_file, "where the start and the posture's springs are read");
  command.add_number("--restitution", settings.restitution, {0.0, 1.0}, "of the fist on the wall");
  command.add_number("--friction", settings.friction, {0.0, 10.0},
                     "coefficient between fist and wall");
  add_outputs(command, paths);
  return run_experiment(command, argc, argv, [&] {
    Plan plan;
    std::string error;
    if (!read_plan(plan_file, plan, error, "")) return bad_input(error);
    const auto run = run_hit_wall(plan, settings);
    return Findings{hit_wall_summary(run, settings),
                    files_of(paths, run.table, hit_wall_figure(run)),
                    hit_wall_claims_hold(run, settings)};
  });
}
