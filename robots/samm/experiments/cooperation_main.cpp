// Two mobile manipulators carry one object: centralised, decentralised and hybrid control compared
// (Chang 7.3.1). Exit status: 0 the claims hold, 1 a file cannot be written, 2 usage, 3 a claim is
// broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "cooperation.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "Two mobile manipulators carry one object by three laws: one computer for both, each robot "
      "by "
      "itself, and each by itself with forces exchanged. Exit status 3 if a claim is broken."};
  std::string csv, svg;
  app.add_option("--csv", csv, "write the errors of all runs to this file");
  app.add_option("--svg", svg, "draw the figure into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto comparison = experiments::compare_laws({});
  const std::string text = experiments::summary(comparison);
  fmt::print("{}", text);
  std::string error;
  if (!csv.empty()) error = servo::write_text(csv, experiments::csv_text(comparison));
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::figure(comparison)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "samm_cooperation: {}\n", error);
    return 1;
  }
  return experiments::claims_hold(comparison) ? 0 : 3;
}
