// Identification of a simulated PUMA 560, as a program.
#include "command_line/run_experiment.hpp"
#include "identify.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "Finds the base parameters, rotors and friction of a simulated PUMA 560 from noisy torques "
      "of\n"
      "an exciting motion, with their standard deviations, and predicts the torques of another\n"
      "motion. Exit status 3 if they are off by more than the noise explains."};
  OutputPaths paths;
  add_outputs(command, paths, "write the torques of the other motion here",
              "draw them into this file");
  std::string table;
  add_page_table(command, table);
  return run_experiment(command, argc, argv, [&paths, &table] {
    const auto result = identify();
    auto files = files_of(paths, result.held_out, identify_figure(result));
    files.push_back({table, identify_page_table(result)});
    return Findings{identify_summary(result), files, identify_claim_holds(result)};
  });
}
