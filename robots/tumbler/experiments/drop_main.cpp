// The tumbler falls onto the ground and bounces. Exit status: 0 the claims hold, 1 bad input or a
// file cannot be written, 2 usage, 3 a claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>

#include "drop.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "A falling tree of nine links bounces: without loss, with it, and with friction. "
      "Exit status 3 if a claim is broken."};
  std::string csv;
  std::string svg;
  double duration = 2.5;
  app.add_option("--duration", duration, "s of each run")
      ->check(CLI::Range(0.1, 60.0))
      ->capture_default_str();
  app.add_option("--csv", csv, "write the run with friction here");
  app.add_option("--svg", svg, "draw all runs into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::string error;
  const auto model = experiments::load_floating(TREELINE_TUMBLER_URDF, error);
  if (!model) {
    fmt::print(stderr, "drop_tumbler: {}\n", error);
    return 1;
  }
  const auto runs = experiments::run_drops(*model, duration);
  for (const auto& run : runs) {
    fmt::print("{}", experiments::drop_summary(run));
  }
  if (!csv.empty()) {
    error = servo::write_text(csv, servo::csv_text(runs.back().table));
  }
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::drop_figure(runs)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "drop_tumbler: {}\n", error);
    return 1;
  }
  return std::all_of(runs.begin(), runs.end(), experiments::drop_claims_hold) ? 0 : 3;
}
