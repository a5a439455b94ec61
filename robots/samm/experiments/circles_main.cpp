// Chang fig. 6.6 to 6.11, as a program: SAMM's tool moves in a circle, with the base at rest and
// with the base on a circle of its own, with ideal drives and with friction and backlash. Exit
// status: 0 the claims hold, 1 a file cannot be written, 2 usage, 3 a claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "circles.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "SAMM draws a circle with its tool at 1 kHz: base at rest, then base on a circle of its own\n"
      "in the tool's null space; each with ideal drives, friction, backlash, and both (worn).\n"
      "Prints the errors beside the thesis's 4 %; exit status 3 if a claim is broken."};
  std::string folder;
  app.add_option("--output", folder, "existing folder for RUN.csv and RUN.svg of each run")
      ->check(CLI::ExistingDirectory);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto runs = experiments::run_all_circles();
  fmt::print("{}", experiments::circles_summary(runs));
  for (const auto& run : runs) {
    if (folder.empty()) {
      break;
    }
    const std::string name = folder + "/" + experiments::file_name(run);
    std::string error = servo::write_text(name + ".csv", servo::csv_text(run.table));
    if (error.empty()) {
      error = servo::write_text(name + ".svg", servo::svg_text(experiments::circles_figure(run)));
    }
    if (!error.empty()) {
      fmt::print(stderr, "samm_circles: {}\n", error);
      return 1;
    }
  }
  const std::string broken = experiments::broken_circle_claims(runs);
  fmt::print(stderr, "{}", broken);
  return broken.empty() ? 0 : 3;
}
