// Two mobile manipulators carry one object: centralised, decentralised and hybrid control compared
// (Chang 7.3.1), as a program.
#include "command_line/run_experiment.hpp"
#include "cooperation.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "Two mobile manipulators carry one object by three laws: one computer for both, each robot "
      "by "
      "itself, and each by itself with forces exchanged. Exit status 3 if a claim is broken."};
  OutputPaths paths;
  add_outputs(command, paths, "write the errors of all runs to this file");
  return run_experiment(command, argc, argv, [&paths] {
    const auto comparison = compare_laws({});
    return Findings{summary(comparison),
                    {{paths.csv, csv_text(comparison)}, svg_file(paths.svg, figure(comparison))},
                    claims_hold(comparison)};
  });
}
