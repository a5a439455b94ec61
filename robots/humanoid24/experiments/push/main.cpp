// Pushes on a humanoid that stands within its limits, as a program. Exit status: 0 the claim holds,
// 1 a file cannot be written, 2 usage, 3 the claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "push.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "The humanoid stands on two feet that can tip, shifts its weight, reaches far, and is "
      "pushed\n"
      "at its chest from behind, from before and from the side. Torques and forces stay within\n"
      "their limits, and it recovers. By the unlimited law it falls. Exit status 3 if it does "
      "not."};
  std::string csv;
  std::string svg;
  app.add_option("--csv", csv, "write the run within limits here");
  app.add_option("--svg", svg, "draw both runs into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto limited = experiments::run_push(true);
  const auto unlimited = experiments::run_push(false);
  fmt::print("{}", experiments::push_summary(limited, unlimited));
  std::string error;
  if (!csv.empty()) error = servo::write_text(csv, servo::csv_text(limited.table));
  if (error.empty() && !svg.empty()) {
    error = servo::write_text(svg, servo::svg_text(experiments::push_figure(limited, unlimited)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "push_humanoid: {}\n", error);
    return 1;
  }
  return experiments::push_claim_holds(limited, unlimited) ? 0 : 3;
}
