// Identification of a simulated PUMA 560, as a program. Exit status: 0 the claim holds, 1 a file
// cannot be written, 2 usage, 3 the claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "identify.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "Finds the base parameters, rotors and friction of a simulated PUMA 560 from noisy torques "
      "of\n"
      "an exciting motion, with their standard deviations, and predicts the torques of another\n"
      "motion. Exit status 3 if they are off by more than the noise explains."};
  std::string csv;
  std::string svg;
  app.add_option("--csv", csv, "write the torques of the other motion here");
  app.add_option("--svg", svg, "draw them into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto result = experiments::identify();
  fmt::print("{}", experiments::identify_summary(result));
  std::string error;
  if (!csv.empty()) error = servo::write_text(csv, servo::csv_text(result.held_out));
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::identify_figure(result)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "puma560_identification: {}\n", error);
    return 1;
  }
  return experiments::identify_claim_holds(result) ? 0 : 3;
}
