// Balance as posture, as a program. Exit status: 0 the claim holds, 1 bad input or a file cannot be
// written, 2 usage, 3 the claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "balance.hpp"

namespace treeline::experiments {
namespace {

/// Writes the files that are requested. Returns what could not be written; empty if all could.
std::string write_files(const std::string& csv, const std::string& svg, const BalanceRun& balancing,
                        const BalanceRun& without, const Plan& plan) {
  std::string error;
  if (!csv.empty()) {
    error = servo::write_text(csv, servo::csv_text(balancing.table));
    if (error.empty()) {
      error = servo::write_text(csv + ".without", servo::csv_text(without.table));
    }
  }
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(balance_figure(balancing, without, plan)));
  }
  return error;
}

}  // namespace
}  // namespace treeline::experiments

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "The humanoid's left hand reaches forward and down at 1 kHz: with the centre of mass kept "
      "over\n"
      "the feet in the hand's null space, and without. Exit status 3 if it leaves them or the "
      "hand\n"
      "notices."};
  std::string plan_file = TREELINE_HUMANOID24_DIR "/touch_floor.yaml";
  std::string urdf = TREELINE_HUMANOID24_DIR "/humanoid24.urdf";
  std::string csv;
  std::string svg;
  app.add_option("--plan", plan_file, "where the start and all gains are read (YAML)")
      ->capture_default_str();
  app.add_option("--urdf", urdf, "where joint limits are read")->capture_default_str();
  app.add_option("--csv", csv, "write the balanced run here, the other to FILE.without");
  app.add_option("--svg", svg, "draw both runs into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  experiments::Plan plan;
  experiments::JointLimits limits;
  std::string error;
  if (!experiments::read_plan(plan_file, plan, error) ||
      !experiments::read_limits(urdf, plan.joints, limits, error)) {
    fmt::print(stderr, "balance: {}\n", error);
    return 1;
  }
  if (plan.joints.size() != 24) {
    fmt::print(stderr, "balance: {} lists {} joints, the robot has 24\n", plan_file,
               plan.joints.size());
    return 1;
  }
  const auto balancing = experiments::run_balance(plan, limits, true);
  const auto without = experiments::run_balance(plan, limits, false);
  fmt::print("{}", experiments::balance_summary(balancing, without));
  error = experiments::write_files(csv, svg, balancing, without, plan);
  if (!error.empty()) {
    fmt::print(stderr, "balance: {}\n", error);
    return 1;
  }
  return experiments::balance_claim_holds(balancing, without) ? 0 : 3;
}
