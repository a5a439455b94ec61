// The digits that difficult robots and states cost each algorithm. One command runs all experiments
// and writes a table and a plot of each. Exit status: 0 all claims hold, 1 a file cannot be
// written, 2 usage, 3 a claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "experiments.hpp"

namespace {

using namespace treeline;          // NOLINT: a program, not a header
using namespace treeline::stress;  // NOLINT

std::string write_files(const std::string& folder, const Finding& finding) {
  const std::string stem = folder + "/" + finding.name;
  const std::string error = report::write_text(stem + ".csv", report::csv_text(table_of(finding)));
  return error.empty() ? report::write_text(stem + ".svg", report::svg_text(plot_of(finding)))
                       : error;
}

void print(const Finding& finding) {
  fmt::print("{}: {}\n", finding.name, finding.title);
  for (const std::string& line : finding.said) fmt::print("  {}\n", line);
  for (const std::string& line : finding.broken) fmt::print("  BROKEN: {}\n", line);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"What hard robots and states cost each algorithm."};
  std::string folder;
  std::vector<std::string> names;
  Effort effort{false, TREELINE_ROBOTS_DIR};
  app.add_option("experiments", names, "which; none: all");
  app.add_option("--output", folder, "existing folder for CSV and SVG files");
  app.add_flag("--quick", effort.quick, "as in the suite");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  std::vector<Experiment> all = sweep_experiments();
  for (const auto& more : {table_experiments(), motion_experiments(), loop_experiments()}) {
    all.insert(all.end(), more.begin(), more.end());
  }
  bool holds = true;
  for (const Experiment& experiment : all) {
    if (!names.empty() && std::find(names.begin(), names.end(), experiment.name) == names.end()) {
      continue;
    }
    const Finding finding = experiment.run(effort);
    print(finding);
    holds = holds && finding.broken.empty();
    const std::string error = folder.empty() ? "" : write_files(folder, finding);
    if (!error.empty()) {
      fmt::print(stderr, "stress: {}\n", error);
      return 1;
    }
  }
  return holds ? 0 : 3;
}
