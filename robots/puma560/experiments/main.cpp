// Chang appendix A, as a program: the PUMA 560 goes through its elbow, head and wrist lock with the
// strategy, without it, and with damped least squares.
#include "command_line/run_experiment.hpp"
#include "lock_run.hpp"

namespace {

using treeline::experiments::Lock;

const char* file_name(Lock lock) {
  switch (lock) {
    case Lock::elbow:
      return "elbow_lock";
    case Lock::head:
      return "head_lock";
    case Lock::wrist:
      return "wrist_lock";
  }
  return "";
}

}  // namespace

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "PUMA 560 at 1 kHz entering, passing and leaving its elbow, head and wrist lock: with the\n"
      "strategy, without it, and with damped least squares. Prints torques, speeds and errors;\n"
      "exit status 3 if a claim is broken."};
  std::string folder;
  std::string table;
  add_output_folder(command, folder, "LOCK_STRATEGY.csv and LOCK.svg");
  add_page_table(command, table);
  return run_experiment(command, argc, argv, [&folder, &table] {
    std::string rows = kLockTableHead;
    constexpr const char* kEndings[] = {"_none.csv", "_damped.csv", "_singular.csv"};
    Findings findings{"", {}, true};
    for (const auto lock : kLocks) {
      std::vector<LockRun> runs;
      for (const auto strategy : kStrategies) runs.push_back(run_lock(lock, strategy));
      add_runs(findings, folder, file_name(lock), kEndings, runs, lock_figure(lock, runs));
      findings.summary += lock_summary(lock, runs);
      rows += lock_rows(lock, runs);
      findings.claims_hold = lock_claim_holds(lock, runs) && findings.claims_hold;
    }
    findings.files.push_back({table, rows});
    return findings;
  });
}
