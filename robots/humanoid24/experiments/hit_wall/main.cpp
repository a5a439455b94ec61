// Chang chapter 8 on the humanoid: its left fist hits a wall. Exit status: 0 the claims hold, 1 bad
// input or a file cannot be written, 2 usage, 3 a claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "hit_wall.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "The humanoid's left fist hits a wall, rebounds and presses against it. Exit "
      "status 3 if a claim is broken."};
  std::string plan_file = TREELINE_HUMANOID24_DIR "/touch_floor.yaml";
  std::string csv;
  std::string svg;
  experiments::WallSettings settings;
  app.add_option("--plan", plan_file, "where the start and the posture's stiffness are read")
      ->capture_default_str();
  app.add_option("--restitution", settings.restitution, "of the fist on the wall")
      ->check(CLI::Range(0.0, 1.0))
      ->capture_default_str();
  app.add_option("--friction", settings.friction, "coefficient between fist and wall")
      ->check(CLI::Range(0.0, 10.0))
      ->capture_default_str();
  app.add_option("--csv", csv, "write every cycle to this file");
  app.add_option("--svg", svg, "draw the figure into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  experiments::Plan plan;
  std::string error;
  if (!experiments::read_plan(plan_file, plan, error)) {
    fmt::print(stderr, "hit_wall: {}\n", error);
    return 1;
  }
  const auto run = experiments::run_hit_wall(plan, settings);
  fmt::print("{}", experiments::hit_wall_summary(run, settings));
  if (!csv.empty()) {
    error = servo::write_text(csv, servo::csv_text(run.table));
  }
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::hit_wall_figure(run)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "hit_wall: {}\n", error);
    return 1;
  }
  return experiments::hit_wall_claims_hold(run, settings) ? 0 : 3;
}
