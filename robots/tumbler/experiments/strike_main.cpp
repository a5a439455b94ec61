// The tumbler is struck at each of its links. Exit status: 0 the claims hold, 1 bad input or a file
// cannot be written, 2 usage, 3 a claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "strike.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "A free tree of nine links is struck at each of them in turn. Exit status 3 if a "
      "claim is broken."};
  std::string csv;
  std::string svg;
  double impulse = 1;
  app.add_option("--impulse", impulse, "N s, of each blow")->capture_default_str();
  app.add_option("--csv", csv, "write a line for each link here");
  app.add_option("--svg", svg, "draw the flights into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::string error;
  const auto model = experiments::load_floating(TREELINE_TUMBLER_URDF, error);
  if (!model) {
    fmt::print(stderr, "strike_tumbler: {}\n", error);
    return 1;
  }
  const auto run = experiments::run_strikes(*model, impulse, 1);
  fmt::print("{}", experiments::strike_summary(run));
  if (!csv.empty()) {
    error = servo::write_text(csv, experiments::strike_csv(run));
  }
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::strike_figure(run)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "strike_tumbler: {}\n", error);
    return 1;
  }
  return experiments::strike_claims_hold(run) ? 0 : 3;
}
