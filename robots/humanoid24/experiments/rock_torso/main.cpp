// The humanoid holds both hands and rocks its torso in their null space (Chang fig. 2.1, 2.3).
// Exit status: 0 the claim holds, 1 bad input, a fault, or a file cannot be written, 2 usage, 3 the
// claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "rock_torso.hpp"

namespace {

using namespace treeline;  // NOLINT: a program, not a header

int report(const experiments::RockPlan& plan, const experiments::Plan& pose,
           const experiments::Outcome& outcome, const std::string& csv, const std::string& svg) {
  fmt::print("humanoid24 rocks its torso, both hands held, at {:.0f} Hz\n{}", plan.rate,
             experiments::rock_summary(outcome, plan, pose));
  std::string error;
  if (outcome.fault) {
    const auto joint = static_cast<std::size_t>(outcome.fault.index);
    error = "stopped: " +
            servo::describe(outcome.fault, joint < pose.joints.size() ? pose.joints[joint] : "");
  }
  if (error.empty() && !csv.empty()) {
    error = servo::write_text(csv, servo::csv_text(outcome.table));
  }
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::rock_figure(outcome, pose)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "rock_torso: {}\n", error);
    return 1;
  }
  return experiments::rocks_without_hands(outcome, plan, pose) ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Both hands hold their poses while the torso rocks, advised at 30 Hz. Exit status 3 if a "
      "hand notices or the torso does not follow."};
  std::string plan_file = TREELINE_HUMANOID24_DIR "/touch_floor.yaml";
  std::string urdf = TREELINE_HUMANOID24_DIR "/humanoid24.urdf";
  std::string csv;
  std::string svg;
  experiments::RockPlan plan;
  app.add_option("--plan", plan_file, "where the start and the hands' gains are read (YAML)")
      ->capture_default_str();
  app.add_option("--urdf", urdf, "where joint limits are read")->capture_default_str();
  app.add_option("--rate", plan.rate, "Hz")->check(CLI::Range(1.0, 1e5))->capture_default_str();
  app.add_option("--csv", csv, "write every cycle to this file");
  app.add_option("--svg", svg, "draw the figure into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  experiments::Plan pose;
  experiments::JointLimits limits;
  std::string error;
  if (!experiments::read_plan(plan_file, pose, error) ||
      !experiments::read_limits(urdf, pose.joints, limits, error)) {
    fmt::print(stderr, "rock_torso: {}\n", error);
    return 1;
  }
  if (pose.joints.size() != 24) {
    fmt::print(stderr, "rock_torso: {} lists {} joints, the robot has 24\n", plan_file,
               pose.joints.size());
    return 1;
  }
  return report(plan, pose, experiments::rock_torso(plan, pose, limits), csv, svg);
}
