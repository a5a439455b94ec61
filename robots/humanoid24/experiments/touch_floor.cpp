// The task of Chang section 6.3 (fig. 6.3, 6.4) with generated controller and generated forward
// dynamics: the left hand goes to the floor along a cubic spline, the right hand holds its pose,
// and the desired posture is the initial one.
#include "touch_floor.hpp"

#include <fmt/core.h>

#include <cstdio>

#include "command_line/run_experiment.hpp"
#include "humanoid24_functions.hpp"
#include "outcome.hpp"
#include "plan.hpp"
#include "servo/realtime.hpp"

namespace {

using namespace treeline;  // NOLINT: a program, not a header

struct Options {
  std::string plan = TREELINE_HUMANOID24_DIR "/touch_floor.yaml";
  std::string urdf = TREELINE_HUMANOID24_DIR "/humanoid24.urdf";
  experiments::OutputPaths paths;
  double rate = 0.0;
  double duration = 0.0;
  double spring = 0.0;
  bool realtime = false;
  experiments::RunSettings run;
};

void declare(CLI::App& app, Options& options) {
  app.add_option("--plan", options.plan, "start, target and gains (YAML)")->capture_default_str();
  app.add_option("--urdf", options.urdf, "where joint limits are read")->capture_default_str();
  app.add_option("--rate", options.rate, "Hz, instead of the plan's")->check(CLI::Range(1.0, 1e5));
  app.add_option("--duration", options.duration, "s of the spline, instead of the plan's")
      ->check(CLI::Range(0.1, 1e3));
  experiments::add_substeps(app, options.run.substeps);
  app.add_option("--spring", options.spring, "N m/rad, of every joint, instead of the plan's")
      ->check(CLI::Range(0.01, 1e4));
  app.add_flag("--realtime", options.realtime, "keep to the machine's clock");
  experiments::add_outputs(app, options.paths);
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

experiments::Findings run(const Options& options) {
  experiments::Plan plan;
  experiments::JointLimits limits;
  std::string error;
  if (!experiments::read_plan(options.plan, plan, error) ||
      !experiments::count_joints(options.plan, plan, experiments::Humanoid24::kVelocities, error) ||
      !experiments::read_limits(options.urdf, plan.joints, limits, error)) {
    return experiments::bad_input(error);
  }
  plan.spring = options.spring > 0.0 ? options.spring : plan.spring;
  if (!(plan.spring > 0.0)) return experiments::bad_input(options.plan + " has no springs");
  plan.rate = options.rate > 0.0 ? options.rate : plan.rate;
  plan.duration = options.duration > 0.0 ? options.duration : plan.duration;
  const auto outcome = touch_floor(options, plan, limits);
  const std::string title = fmt::format(
      "humanoid24 touches the floor (Chang section 6.3): {:.1f} s spline at {:.0f} Hz\n",
      plan.duration, plan.rate);
  return {title + experiments::summary(outcome, plan, options.realtime),
          experiments::files_of(options.paths, outcome.table, experiments::figure(outcome, plan)),
          experiments::within_bounds(outcome), experiments::stopped(outcome.fault, plan)};
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "Left hand to the floor, right hand held, posture advised, at a fixed rate. Exit "
      "status 3 if a bound is broken."};
  Options options;
  declare(app, options);
  return experiments::run_experiment(app, argc, argv, [&options] { return run(options); });
}
