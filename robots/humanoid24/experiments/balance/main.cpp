// Balance as posture, as a program.
#include "balance.hpp"
#include "command_line/run_experiment.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "The humanoid's left hand reaches forward and down at 1 kHz: with the centre of mass kept "
      "over\n"
      "the feet in the hand's null space, and without. Exit status 3 if it leaves them or the "
      "hand\n"
      "notices."};
  std::string plan_file = TREELINE_HUMANOID24_DIR "/touch_floor.yaml";
  std::string urdf = TREELINE_HUMANOID24_DIR "/humanoid24.urdf";
  OutputPaths paths;
  command.add_text("--plan", plan_file, "where the start and all gains are read (YAML)");
  command.add_text("--urdf", urdf, "where joint limits are read");
  add_outputs(command, paths, "write the balanced run here, the other to FILE.without",
              "draw both runs into this file");
  return run_experiment(command, argc, argv, [&] {
    Plan plan;
    JointLimits limits;
    std::string error;
    if (!read_plan(plan_file, plan, error) || !count_joints(plan_file, plan, 24, error) ||
        !read_limits(urdf, plan.joints, limits, error)) {
      return bad_input(error);
    }
    const auto balancing = run_balance(plan, limits, true);
    const auto without = run_balance(plan, limits, false);
    return Findings{balance_summary(balancing, without),
                    files_of_both(paths, balancing.table, ".without", without.table,
                                  balance_figure(balancing, without, plan)),
                    balance_claim_holds(balancing, without)};
  });
}
