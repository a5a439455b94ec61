// Joint-limit avoidance in the null space, as a program. Exit status: 0 the claim holds, 1 a file
// cannot be written, 2 usage, 3 the claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "avoid_limits.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "SAMM's tool turns in place at 1 kHz, farther than the arm alone can: with joint limits\n"
      "avoided by the posture, so that the base goes round, and without. Exit status 3 if a limit\n"
      "is reached or the tool notices."};
  std::string csv;
  std::string svg;
  app.add_option("--csv", csv,
                 "write the run that avoids the limits here, the other to FILE.without");
  app.add_option("--svg", svg, "draw both runs into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto avoiding = experiments::run_avoid_limits(true);
  const auto without = experiments::run_avoid_limits(false);
  fmt::print("{}", experiments::avoid_summary(avoiding, without));
  std::string error;
  if (!csv.empty()) {
    error = servo::write_text(csv, servo::csv_text(avoiding.table));
    if (error.empty()) {
      error = servo::write_text(csv + ".without", servo::csv_text(without.table));
    }
  }
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::avoid_figure(avoiding, without)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "samm_avoid_limits: {}\n", error);
    return 1;
  }
  return experiments::avoid_claim_holds(avoiding, without) ? 0 : 3;
}
