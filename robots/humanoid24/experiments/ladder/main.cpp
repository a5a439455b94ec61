// Two humanoids carry a ladder with commanded internal forces, by the code of a scene with both of
// them (Chang 7.1). Exit status: 0 the bounds are kept, 1 a file cannot be written, 2 usage, 3 a
// bound is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "carry_ladder.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "Two humanoids carry a ladder, squeezing its rails as commanded, at 1 kHz. Exit status 3 if "
      "a bound is broken."};
  experiments::LadderPlan plan;
  std::string csv, svg;
  app.add_option("--substeps", plan.substeps, "integration steps per cycle")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  app.add_option("--csv", csv, "write every cycle to this file");
  app.add_option("--svg", svg, "draw the figure into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto outcome = experiments::carry_ladder(plan);
  fmt::print("two humanoids carry a ladder at {:.0f} Hz\n{}", plan.rate,
             experiments::summary(outcome));
  std::string error;
  if (!csv.empty()) error = servo::write_text(csv, servo::csv_text(outcome.table));
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::figure(outcome)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "carry_ladder: {}\n", error);
    return 1;
  }
  return experiments::within_bounds(outcome) ? 0 : 3;
}
