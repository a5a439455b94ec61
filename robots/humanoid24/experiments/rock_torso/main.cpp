// The humanoid holds both hands and rocks its torso in their null space (Chang fig. 2.1, 2.3).
#include <fmt/core.h>

#include "command_line/run_experiment.hpp"
#include "rock_torso.hpp"

namespace {

using namespace treeline::experiments;  // NOLINT: a program, not a header

Findings findings_of(const RockPlan& plan, const Plan& pose, const Outcome& outcome,
                     const OutputPaths& paths) {
  Findings findings;
  findings.summary = fmt::format("humanoid24 rocks its torso, both hands held, at {:.0f} Hz\n{}",
                                 plan.rate, rock_summary(outcome, plan, pose));
  findings.error = stopped(outcome.fault, pose);
  findings.claims_hold = rocks_without_hands(outcome, plan, pose);
  if (findings.error.empty()) {
    findings.files = files_of(paths, outcome.table, rock_figure(outcome, pose));
  }
  return findings;
}

}  // namespace

int main(int argc, char** argv) {
  CommandLine command{
      "Both hands hold their poses while the torso rocks, advised at 30 Hz. Exit status 3 if a "
      "hand notices or the torso does not follow."};
  std::string plan_file = TREELINE_HUMANOID24_DIR "/touch_floor.yaml";
  std::string urdf = TREELINE_HUMANOID24_DIR "/humanoid24.urdf";
  OutputPaths paths;
  RockPlan plan;
  command.add_text("--plan", plan_file, "where the start and the hands' gains are read (YAML)");
  command.add_text("--urdf", urdf, "where joint limits are read");
  command.add_number("--rate", plan.rate, {1.0, 1e5}, "Hz");
  add_outputs(command, paths);
  return run_experiment(command, argc, argv, [&] {
    Plan pose;
    JointLimits limits;
    std::string error;
    if (!read_plan(plan_file, pose, error) ||
        !count_joints(plan_file, pose, kRockingJoints, error) ||
        !read_limits(urdf, pose.joints, limits, error)) {
      return bad_input(error);
    }
    return findings_of(plan, pose, rock_torso(plan, pose, limits), paths);
  });
}
