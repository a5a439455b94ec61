// Force control with a moving selection frame, as a program: the PUMA 560 presses on a rocking
// plate.
#include "command_line/run_experiment.hpp"
#include "press_surface.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "PUMA 560 presses on a springy plate that rocks and heaves, and slides on it in a circle, "
      "at\n"
      "1 kHz: with the selection frame moving with the plate, and with a fixed one. Exit status 3\n"
      "if force or circle are off by more than claimed."};
  OutputPaths paths;
  add_outputs(command, paths, "write the run with the moving frame here, the other to FILE.fixed",
              "draw both runs into this file");
  return run_experiment(command, argc, argv, [&paths] {
    const auto moving = run_press(Frame::moving);
    const auto fixed = run_press(Frame::fixed);
    return Findings{
        press_summary(moving, fixed),
        files_of_both(paths, moving.table, ".fixed", fixed.table, press_figure(moving, fixed)),
        press_claim_holds(moving, fixed)};
  });
}
