// Two PUMAs on SAMM bases carry one object with commanded internal forces (Chang 7.2.2), by the
// code of a scene with both robots. Exit status: 0 the bounds are kept, 1 a file cannot be written,
// 2 usage, 3 a bound is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "carry_object.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "Two mobile manipulators carry one object, squeezing it as commanded, at 1 kHz. Exit "
      "status 3 if a bound is broken."};
  experiments::CarryPlan plan;
  std::string csv;
  std::string svg;
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
  const auto outcome = experiments::carry_object(plan);
  fmt::print("two SAMMs carry an object: {:.0f} s at {:.0f} Hz\n{}", plan.duration, plan.rate,
             experiments::summary(outcome));
  std::string error;
  if (!csv.empty()) {
    error = servo::write_text(csv, servo::csv_text(outcome.table));
  }
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::figure(outcome)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "carry_object: {}\n", error);
    return 1;
  }
  return experiments::within_bounds(outcome) ? 0 : 3;
}
