// Chang appendix A, as a program: the PUMA 560 goes through its elbow, head and wrist lock with the
// strategy, without it, and with damped least squares. Exit status: 0 the claims hold, 1 a file
// cannot be written, 2 usage, 3 a claim is broken.
#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <cstdio>

#include "lock_run.hpp"

namespace {

using namespace treeline;  // NOLINT: a program, not a header

const char* file_name(experiments::Lock lock) {
  switch (lock) {
    case experiments::Lock::elbow:
      return "elbow_lock";
    case experiments::Lock::head:
      return "head_lock";
    case experiments::Lock::wrist:
      return "wrist_lock";
  }
  return "";
}

std::string write_files(const std::string& folder, experiments::Lock lock,
                        const std::vector<experiments::LockRun>& runs) {
  const char* name = file_name(lock);
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
  CLI::App app{
      "PUMA 560 at 1 kHz entering, passing and leaving its elbow, head and wrist lock: with the\n"
      "strategy, without it, and with damped least squares. Prints torques, speeds and errors;\n"
      "exit status 3 if a claim is broken."};
  std::string folder;
  app.add_option("--output", folder, "existing folder for LOCK_STRATEGY.csv and LOCK.svg")
      ->check(CLI::ExistingDirectory);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  bool holds = true;
  for (const auto lock : experiments::kLocks) {
    std::vector<experiments::LockRun> runs;
    for (const auto strategy : experiments::kStrategies) {
      runs.push_back(experiments::run_lock(lock, strategy));
    }
    fmt::print("{}", experiments::lock_summary(lock, runs));
    holds = experiments::lock_claim_holds(lock, runs) && holds;
    const std::string error = folder.empty() ? "" : write_files(folder, lock, runs);
    if (!error.empty()) {
      fmt::print(stderr, "puma560_singularity: {}\n", error);
      return 1;
    }
  }
  return holds ? 0 : 3;
}
