// Chang chapter 8 on the humanoid, as a program: its left fist hits a wall.
#include "command_line/run_experiment.hpp"
#include "hit_wall.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CLI::App app{
      "The humanoid's left fist hits a wall, rebounds and presses against it. Exit "
      "status 3 if a claim is broken."};
  std::string plan_file = TREELINE_HUMANOID24_DIR "/touch_floor.yaml";
  OutputPaths paths;
  WallSettings settings;
  app.add_option("--plan", plan_file, "where the start and the posture's stiffness are read")
      ->capture_default_str();
  app.add_option("--restitution", settings.restitution, "of the fist on the wall")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--friction", settings.friction, "coefficient between fist and wall")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  add_outputs(app, paths);
  return run_experiment(app, argc, argv, [&] {
    Plan plan;
    std::string error;
    if (!read_plan(plan_file, plan, error)) return bad_input(error);
    const auto run = run_hit_wall(plan, settings);
    return Findings{hit_wall_summary(run, settings),
                    files_of(paths, run.table, hit_wall_figure(run)),
                    hit_wall_claims_hold(run, settings)};
  });
}
