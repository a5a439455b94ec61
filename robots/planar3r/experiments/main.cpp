// Chang fig. 2.4 and 2.5, as a program. Exit status: 0 the claim holds, 1 a file cannot be written,
// 2 usage, 3 the claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "null_space.hpp"

int main(int argc, char** argv) {
  using namespace treeline;  // NOLINT: a program, not a header
  CLI::App app{
      "3R planar arm: null-space motion with two generalised inverses. Exit "
      "status 3 if the claim is broken."};
  std::string csv;
  std::string svg;
  app.add_option("--csv", csv,
                 "write the run with the dynamically consistent inverse here, and the "
                 "other to FILE.pseudo");
  app.add_option("--svg", svg, "draw both figures into this file");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  const auto pseudo = experiments::run_null_space(experiments::Inverse::pseudo);
  const auto consistent = experiments::run_null_space(experiments::Inverse::dynamic_consistent);
  fmt::print("{}", experiments::null_space_summary(pseudo, consistent));
  std::string error;
  if (!csv.empty()) {
    error = servo::write_text(csv, servo::csv_text(consistent.table));
    if (error.empty()) {
      error = servo::write_text(csv + ".pseudo", servo::csv_text(pseudo.table));
    }
  }
  if (error.empty() && !svg.empty()) {
    error =
        servo::write_text(svg, servo::svg_text(experiments::null_space_figure(pseudo, consistent)));
  }
  if (!error.empty()) {
    fmt::print(stderr, "planar3r_null_space: {}\n", error);
    return 1;
  }
  return experiments::null_space_claim_holds(pseudo, consistent) ? 0 : 3;
}
