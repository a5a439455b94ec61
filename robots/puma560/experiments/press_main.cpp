// Force control with a moving selection frame, as a program: the PUMA 560 presses on a rocking
// plate. Exit status: 0 the claim holds, 1 a file cannot be written, 2 usage, 3 the claim is
// broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "press_surface.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "PUMA 560 presses on a springy plate that rocks and heaves, and slides on it in a circle, "
      "at\n"
      "1 kHz: with the selection frame moving with the plate, and with a fixed one. Exit status 3\n"
      "if force or circle are off by more than claimed."};
  std::string csv;
  std::string svg;
  app.add_option("--csv", csv, "write the run with the moving frame here, the other to FILE.fixed");
  app.add_option("--svg", svg, "draw both runs into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto moving = experiments::run_press(experiments::Frame::moving);
  const auto fixed = experiments::run_press(experiments::Frame::fixed);
  fmt::print("{}", experiments::press_summary(moving, fixed));
  std::string error;
  if (!csv.empty()) {
    error = servo::write_text(csv, servo::csv_text(moving.table));
    if (error.empty()) {
      error = servo::write_text(csv + ".fixed", servo::csv_text(fixed.table));
    }
  }
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::press_figure(moving, fixed)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "puma560_press: {}\n", error);
    return 1;
  }
  return experiments::press_claim_holds(moving, fixed) ? 0 : 3;
}
