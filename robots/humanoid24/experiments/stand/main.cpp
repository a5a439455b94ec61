// Standing on two feet, as a program. Exit status: 0 the claim holds, 1 a file cannot be written, 2
// usage, 3 the claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "stand.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "The humanoid stands on two feet and shifts its weight by leaning, while its left hand "
      "keeps\n"
      "its place. The base floats and has no motor. Exit status 3 if it has a torque, the hand or "
      "a\n"
      "foot moves, or the ground cannot have the forces that were chosen."};
  std::string csv;
  std::string svg;
  app.add_option("--csv", csv, "write the run here");
  app.add_option("--svg", svg, "draw the run into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto run = experiments::run_stand();
  fmt::print("{}", experiments::stand_summary(run));
  std::string error;
  if (!csv.empty()) error = servo::write_text(csv, servo::csv_text(run.table));
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::stand_figure(run)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "stand: {}\n", error);
    return 1;
  }
  return experiments::stand_claim_holds(run) ? 0 : 3;
}
