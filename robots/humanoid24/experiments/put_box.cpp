// The task of Chang section 7.5 (fig. 7.9, 7.10) with generated control and generated forward
// dynamics of the closed chain: both hands put a box on the floor along a cubic spline and squeeze
// it with a commanded force; the desired posture is the initial one.
#include "put_box.hpp"

#include <fmt/core.h>

#include "box_outcome.hpp"
#include "command_line/run_experiment.hpp"
#include "humanoid24_box.hpp"
#include "joint_panel.hpp"
#include "plan.hpp"

namespace {

using namespace treeline;  // NOLINT: a program, not a header

struct Generated {
  static constexpr int kCoordinates = humanoid24_box::kCoordinates;
  static constexpr int kVelocities = humanoid24_box::kVelocities;
  static constexpr auto& mass_matrix = humanoid24_box::mass_matrix;
  static constexpr auto& object_state = humanoid24_box::object_state;
  static constexpr auto& object_control_torque = humanoid24_box::object_control_torque;
  static constexpr auto& object_forward_dynamics = humanoid24_box::object_forward_dynamics;
};
using Humanoid24WithBox = experiments::RobotWithObject<Generated>;

struct Options {
  std::string plan = TREELINE_HUMANOID24_DIR "/put_box.yaml";
  std::string urdf = TREELINE_HUMANOID24_DIR "/humanoid24.urdf";
  experiments::OutputPaths paths;
  std::string table;
  experiments::RunSettings run;
};

void declare(experiments::CommandLine& command, Options& options) {
  command.add_text("--plan", options.plan, "start, target, squeeze and gains (YAML)");
  command.add_text("--urdf", options.urdf, "where joint limits are read");
  experiments::add_substeps(command, options.run.substeps);
  experiments::add_outputs(command, options.paths);
  experiments::add_page_table(command, options.table);
}

/// The table of the page.
std::string page_table(const experiments::BoxOutcome& outcome, const experiments::BoxPlan& plan,
                       const experiments::JointLimits& limits) {
  const auto errors = experiments::largest_box_errors(outcome, plan);
  const auto joints =
      experiments::describe_joints(outcome.table, plan.run, limits, experiments::kBoxColumns);
  return fmt::format(
      "| over the whole motion and after it, 1 kHz | |\n|---|---|\n"
      "| box, worst error | {:.1e} m, {:.0e} rad |\n"
      "| squeeze, worst error (after a cycle under one torque) | {:.0f} mN, other internal moments "
      "{:.1f} mN m |\n"
      "| nearest joint limit | {} |\n"
      "| fastest joint; at the end | {}; {:.4f} rad/s |\n"
      "| greatest torques | {} |\n",
      errors.position, errors.rotation, 1e3 * errors.internal_force, 1e3 * errors.internal_moment,
      joints.nearest_limit, joints.fastest, errors.final_speed, joints.torques);
}

experiments::Findings run(const Options& options) {
  experiments::BoxPlan plan;
  experiments::JointLimits limits;
  std::string error;
  if (!experiments::read_box_plan(options.plan, plan, error) ||
      !experiments::count_joints(options.plan, plan.run, Humanoid24WithBox::kVelocities, error) ||
      !experiments::read_limits(options.urdf, plan.run.joints, limits, error)) {
    return experiments::bad_input(error);
  }
  servo::SimulatedClock clock;
  const auto outcome = experiments::put_box<Humanoid24WithBox>(plan, options.run, limits, clock);
  const std::string title = fmt::format(
      "humanoid24 puts a box on the floor (Chang section 7.5): {:.1f} s spline at {:.0f} Hz\n",
      plan.run.duration, plan.run.rate);
  const auto errors = experiments::largest_box_errors(outcome, plan);
  auto files =
      experiments::files_of(options.paths, outcome.table, experiments::box_figure(outcome, plan));
  files.push_back({options.table, page_table(outcome, plan, limits)});
  return {title + experiments::box_summary(outcome, plan), files,
          experiments::box_within_bounds(errors) && experiments::box_rests(errors),
          experiments::stopped(outcome.fault, plan.run)};
}

}  // namespace

int main(int argc, char** argv) {
  experiments::CommandLine command{
      "Both hands put a box on the floor, squeezing it, posture advised, at a fixed rate. "
      "Exit status 3 if a bound is broken."};
  Options options;
  declare(command, options);
  return experiments::run_experiment(command, argc, argv, [&options] { return run(options); });
}
