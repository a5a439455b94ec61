// Chang appendix A in one command: the PUMA 560 through its elbow lock and wrist lock with the
// strategy, without it, and with damped least squares. Exit status: 0 the claims hold, 1 a file
// cannot be written, 2 usage, 3 a claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "lock_run.hpp"

namespace {

using namespace treeline;  // NOLINT: a program, not a header

std::string write_files(const std::string& folder, const char* name, experiments::Lock lock,
                        const std::vector<experiments::LockRun>& runs) {
  const char* suffixes[] = {"none", "damped", "singular"};
  std::string error;
  for (std::size_t i = 0; i < runs.size() && error.empty(); ++i) {
    error = servo::write_text(fmt::format("{}/{}_{}.csv", folder, name, suffixes[i]),
                              servo::csv_text(runs[i].table));
  }
  if (error.empty()) {
    error = servo::write_text(fmt::format("{}/{}.svg", folder, name),
                              servo::svg_text(experiments::lock_figure(lock, runs)));
  }
  return error;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app{"PUMA 560: entering, passing and leaving singularities."};
  std::string folder;
  app.add_option("--output", folder, "existing folder for CSV and SVG files");
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  bool holds = true;
  for (const auto lock : {experiments::Lock::elbow, experiments::Lock::wrist}) {
    std::vector<experiments::LockRun> runs;
    for (const auto strategy : experiments::kStrategies) {
      runs.push_back(experiments::run_lock(lock, strategy));
    }
    fmt::print("{}", experiments::lock_summary(lock, runs));
    holds = experiments::lock_claim_holds(lock, runs) && holds;
    const char* name = lock == experiments::Lock::elbow ? "elbow_lock" : "wrist_lock";
    const std::string error = folder.empty() ? "" : write_files(folder, name, lock, runs);
    if (!error.empty()) {
      fmt::print(stderr, "puma560_singularity: {}\n", error);
      return 1;
    }
  }
  return holds ? 0 : 3;
}
