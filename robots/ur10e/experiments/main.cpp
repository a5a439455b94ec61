// The UR10e goes through singularities, as a program: table 6.1 without changes, damped least
// squares, and damped by directions. Exit status: 0 the claims hold, 1 a file cannot be written, 2
// usage, 3 a claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "singular_run.hpp"

namespace {

using namespace treeline;  // NOLINT: a program, not a header

std::string write_files(const std::string& folder, ur10e_experiments::Line line,
                        const std::vector<ur10e_experiments::SingularRun>& runs) {
  const char* suffixes[] = {"exact", "least_squares", "damped"};
  const std::string name = ur10e_experiments::file_name_of(line);
  std::string error;
  for (std::size_t i = 0; i < runs.size() && error.empty(); ++i) {
    error = servo::write_text(fmt::format("{}/{}_{}.csv", folder, name, suffixes[i]),
                              servo::csv_text(runs[i].table));
  }
  if (error.empty()) {
    error = servo::write_text(fmt::format("{}/{}.svg", folder, name),
                              servo::svg_text(ur10e_experiments::figure(line, runs)));
  }
  return error;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{
      "UR10e: torque and speed on the way through singularities. Exit status 3 if a "
      "claim is broken."};
  std::string folder;
  app.add_option("--output", folder, "existing folder for CSV and SVG files");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  bool holds = true;
  for (const auto line : ur10e_experiments::kLines) {
    std::vector<ur10e_experiments::SingularRun> runs;
    for (const auto law : ur10e_experiments::kLaws) {
      runs.push_back(ur10e_experiments::run_line(line, law));
    }
    fmt::print("{}", ur10e_experiments::summary(line, runs));
    holds = ur10e_experiments::claim_holds(line, runs) && holds;
    const std::string error = folder.empty() ? "" : write_files(folder, line, runs);
    if (!error.empty()) {
      fmt::print(stderr, "ur10e_singularity: {}\n", error);
      return 1;
    }
  }
  return holds ? 0 : 3;
}
