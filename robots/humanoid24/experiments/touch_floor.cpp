// The task of Chang section 6.3 (fig. 6.3, 6.4) with generated controller and generated forward
// dynamics: the left hand goes to the floor along a cubic spline, the right hand holds its pose,
// and the desired posture is the initial one.
#include "touch_floor.hpp"

#include <fmt/core.h>

#include <cstdio>
#include <optional>

#include "command_line/run_experiment.hpp"
#include "humanoid24_functions.hpp"
#include "joint_panel.hpp"
#include "outcome.hpp"
#include "plan.hpp"
#include "servo/realtime.hpp"

namespace {

using namespace treeline;  // NOLINT: a program, not a header

struct Options {
  std::string plan = TREELINE_HUMANOID24_DIR "/touch_floor.yaml";
  std::string urdf = TREELINE_HUMANOID24_DIR "/humanoid24.urdf";
  experiments::OutputPaths paths;
  std::string table;
  std::optional<double> rate;
  std::optional<double> duration;
  std::optional<double> spring;
  bool realtime = false;
  experiments::RunSettings run;
};

void declare(experiments::CommandLine& command, Options& options) {
  command.add_text("--plan", options.plan, "start, target and gains (YAML)");
  command.add_text("--urdf", options.urdf, "where joint limits are read");
  command.add_number("--rate", options.rate, {1.0, 1e5}, "Hz, instead of the plan's");
  command.add_number("--duration", options.duration, {0.1, 1e3},
                     "s of the spline, instead of the plan's");
  experiments::add_substeps(command, options.run.substeps);
  command.add_number("--spring", options.spring, {0.01, 1e4},
                     "N m/rad, of every joint, instead of the plan's");
  command.add_flag("--realtime", options.realtime, "keep to the machine's clock");
  experiments::add_outputs(command, options.paths);
  experiments::add_page_table(command, options.table);
}

experiments::Outcome touch_floor(const Options& options, const experiments::Plan& plan,
                                 const experiments::JointLimits& limits) {
  if (!options.realtime) {
    servo::SimulatedClock clock;
    return experiments::touch_floor<experiments::Humanoid24>(plan, options.run, limits, clock);
  }
  const std::string refused = servo::request_realtime();
  if (!refused.empty()) {
    fmt::print(stderr, "touch_floor: {}\n", refused);
  }
  servo::SteadyClock clock;
  return experiments::touch_floor<experiments::Humanoid24>(plan, options.run, limits, clock);
}

/// The table of the page: the plan's rate beside the thesis's.
std::string page_table(const experiments::Outcome& outcome, const Options& options,
                       experiments::Plan plan, const experiments::JointLimits& limits) {
  const auto joints =
      experiments::describe_joints(outcome.table, plan, limits, experiments::kFixedColumns);
  plan.rate = 300.0;
  const auto slow = touch_floor(options, plan, limits);
  const auto slow_joints =
      experiments::describe_joints(slow.table, plan, limits, experiments::kFixedColumns);
  const auto errors = experiments::largest_errors(outcome.table);
  const auto slow_errors = experiments::largest_errors(slow.table);
  const auto row = [](const char* what, const std::string& first, const std::string& second) {
    return fmt::format("| {} | {} | {} |\n", what, first, second);
  };
  const auto metres = [](double x) { return fmt::format("{:.1e} m", x); };
  return row("over the whole motion and after it", "1 kHz", "300 Hz, as in the thesis") +
         "|---|---|---|\n" +
         row("left hand, worst error", metres(errors.left_position),
             metres(slow_errors.left_position)) +
         row("right hand, worst drift", metres(errors.right_position),
             metres(slow_errors.right_position)) +
         row("nearest joint limit", joints.nearest_limit, slow_joints.nearest_limit) +
         row("fastest joint", joints.fastest, slow_joints.fastest) +
         row("greatest torques", joints.torques, slow_joints.torques);
}

experiments::Findings run(const Options& options) {
  experiments::Plan plan;
  experiments::JointLimits limits;
  std::string error;
  if (!experiments::read_plan(options.plan, plan, error) ||
      !experiments::count_joints(options.plan, plan, experiments::Humanoid24::kVelocities, error) ||
      !experiments::read_limits(options.urdf, plan.joints, limits, error)) {
    return experiments::bad_input(error);
  }
  plan.spring = options.spring.value_or(plan.spring);
  if (!(plan.spring > 0.0)) return experiments::bad_input(options.plan + " has no springs");
  plan.rate = options.rate.value_or(plan.rate);
  plan.duration = options.duration.value_or(plan.duration);
  const auto outcome = touch_floor(options, plan, limits);
  const std::string title = fmt::format(
      "humanoid24 touches the floor (Chang section 6.3): {:.1f} s spline at {:.0f} Hz\n",
      plan.duration, plan.rate);
  auto files =
      experiments::files_of(options.paths, outcome.table, experiments::figure(outcome, plan));
  files.push_back(
      {options.table, options.table.empty() ? "" : page_table(outcome, options, plan, limits)});
  return {title + experiments::summary(outcome, plan, options.realtime), files,
          experiments::within_bounds(outcome), experiments::stopped(outcome.fault, plan)};
}

}  // namespace

int main(int argc, char** argv) {
  experiments::CommandLine command{
      "Left hand to the floor, right hand held, posture advised, at a fixed rate. Exit "
      "status 3 if a bound is broken."};
  Options options;
  declare(command, options);
  return experiments::run_experiment(command, argc, argv, [&options] { return run(options); });
}
