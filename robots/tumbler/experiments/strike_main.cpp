// The tumbler is struck at each of its links, as a program.
#include "command_line/run_experiment.hpp"
#include "strike.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CLI::App app{
      "A free tree of nine links is struck at each of them in turn. Exit status 3 if a "
      "claim is broken."};
  OutputPaths paths;
  double impulse = 1;
  app.add_option("--impulse", impulse, "N s, of each blow")->capture_default_str();
  add_outputs(app, paths, "write a line for each link here", "draw the flights into this file");
  return run_experiment(app, argc, argv, [&] {
    std::string error;
    const auto model = load_floating(TREELINE_TUMBLER_URDF, error);
    if (!model) return bad_input(error);
    const auto run = run_strikes(*model, impulse, 1);
    return Findings{strike_summary(run),
                    {{paths.csv, strike_csv(run)}, svg_file(paths.svg, strike_figure(run))},
                    strike_claims_hold(run)};
  });
}
