// The tumbler falls onto the ground and bounces, as a program.
#include "command_line/run_experiment.hpp"
#include "drop.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "A falling tree of nine links bounces: without loss, with it, and with friction. "
      "Exit status 3 if a claim is broken."};
  OutputPaths paths;
  double duration = 2.5;
  command.add_number("--duration", duration, {0.1, 60.0}, "s of each run");
  add_outputs(command, paths, "write the run with friction here", "draw all runs into this file");
  return run_experiment(command, argc, argv, [&] {
    std::string error;
    const auto model = load_floating(TREELINE_TUMBLER_URDF, error);
    if (!model) return bad_input(error);
    const auto runs = run_drops(*model, duration);
    Findings findings{"", files_of(paths, runs.back().table, drop_figure(runs)), true};
    for (const auto& run : runs) {
      findings.summary += drop_summary(run);
      findings.claims_hold = drop_claims_hold(run) && findings.claims_hold;
    }
    return findings;
  });
}
