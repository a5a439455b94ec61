// The UR10e goes through singularities, as a program: table 6.1 without changes, damped least
// squares, and damped by directions.
#include "command_line/run_experiment.hpp"
#include "singular_run.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;        // NOLINT: a program, not a header
  using namespace treeline::ur10e_experiments;  // NOLINT
  CommandLine command{
      "UR10e: torque and speed on the way through singularities. Exit status 3 if a "
      "claim is broken."};
  std::string folder;
  std::string table;
  add_output_folder(command, folder, "LINE_LAW.csv and LINE.svg");
  add_page_table(command, table);
  return run_experiment(command, argc, argv, [&folder, &table] {
    std::string rows = kTableHead;
    constexpr const char* kEndings[] = {"_exact.csv", "_least_squares.csv", "_damped.csv"};
    Findings findings{"", {}, true};
    for (const auto line : kLines) {
      std::vector<SingularRun> runs;
      for (const auto law : kLaws) {
        runs.push_back(run_line(line, law));
      }
      const std::string name = file_name_of(line);
      add_runs(findings, folder, name, kEndings, runs, figure(line, runs));
      findings.summary += summary(line, runs);
      rows += rows_of(line, runs);
      findings.claims_hold = claim_holds(line, runs) && findings.claims_hold;
    }
    findings.files.push_back({table, rows});
    return findings;
  });
}
