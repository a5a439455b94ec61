// The task of Chang section 7.5 (fig. 7.9, 7.10) with generated control and generated forward
// dynamics of the closed chain: both hands put a box on the floor along a cubic spline and squeeze
// it with a commanded force; the desired posture is the initial one. Exit status: 0 the bounds are
// kept, 1 bad input or a fault, 2 usage, 3 a bound is broken.
#include "put_box.hpp"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "box_outcome.hpp"
#include "humanoid24_box.hpp"
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
  std::string csv;
  std::string svg;
  experiments::RunSettings run;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("--plan", options.plan, "start, target, squeeze and gains (YAML)")
      ->capture_default_str();
  app.add_option("--urdf", options.urdf, "where joint limits are read")->capture_default_str();
  app.add_option("--substeps", options.run.substeps, "integration steps per cycle")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--csv", options.csv, "write every cycle to this file");
  app.add_option("--svg", options.svg, "draw the figure into this file");
}

/// Writes the files that are requested. Returns the error in words, or an empty text.
std::string write_files(const Options& options, const experiments::BoxPlan& plan,
                        const experiments::BoxOutcome& outcome) {
  std::string error;
  if (!options.csv.empty()) {
    error = servo::write_text(options.csv, servo::csv_text(outcome.table));
  }
  if (error.empty() && !options.svg.empty()) {
    error = servo::write_text(options.svg, servo::svg_text(experiments::box_figure(outcome, plan)));
  }
  return error;
}

int report(const Options& options, const experiments::BoxPlan& plan,
           const experiments::BoxOutcome& outcome) {
  fmt::print(
      "humanoid24 puts a box on the floor (Chang section 7.5): {:.1f} s spline at {:.0f} Hz\n{}",
      plan.run.duration, plan.run.rate, experiments::box_summary(outcome, plan));
  const std::string error = write_files(options, plan, outcome);
  if (!error.empty()) {
    fmt::print(stderr, "put_box: {}\n", error);
    return 1;
  }
  if (outcome.fault) {
    const auto joint = static_cast<std::size_t>(outcome.fault.index);
    const bool named = outcome.fault.index >= 0 && joint < plan.run.joints.size();
    fmt::print(stderr, "put_box: stopped: {}\n",
               servo::describe(outcome.fault, named ? plan.run.joints[joint] : ""));
    return 1;
  }
  return experiments::box_within_bounds(experiments::largest_box_errors(outcome, plan)) ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Both hands put a box on the floor, squeezing it, posture advised, at a fixed rate. "
      "Exit status 3 if a bound is broken."};
  Options options;
  declare(app, options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  experiments::BoxPlan plan;
  experiments::JointLimits limits;
  std::string error;
  if (!experiments::read_box_plan(options.plan, plan, error) ||
      !experiments::read_limits(options.urdf, plan.run.joints, limits, error)) {
    fmt::print(stderr, "put_box: {}\n", error);
    return 1;
  }
  if (plan.run.joints.size() != static_cast<std::size_t>(Humanoid24WithBox::kVelocities)) {
    fmt::print(stderr, "put_box: {} lists {} joints, the robot has {}\n", options.plan,
               plan.run.joints.size(), Humanoid24WithBox::kVelocities);
    return 1;
  }
  servo::SimulatedClock clock;
  return report(options, plan,
                experiments::put_box<Humanoid24WithBox>(plan, options.run, limits, clock));
}
