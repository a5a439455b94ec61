// The tumbler is struck at each of its links, as a program.
#include "command_line/run_experiment.hpp"
#include "strike.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "A free tree of nine links is struck at each of them in turn. Exit status 3 if a "
      "claim is broken."};
  OutputPaths paths;
  double impulse = 1;
  command.add_number("--impulse", impulse, {1e-6, 1e6}, "N s, of each blow");
  add_outputs(command, paths, "write a line for each link here", "draw the flights into this file");
  return run_experiment(command, argc, argv, [&] {
    std::string error;
    const auto model = load_floating(TREELINE_TUMBLER_URDF, error);
    if (!model) return bad_input(error);
    const auto run = run_strikes(*model, impulse, 1);
    return Findings{strike_summary(run),
                    {{paths.csv, strike_csv(run)}, svg_file(paths.svg, strike_figure(run))},
                    strike_claims_hold(run)};
  });
}
