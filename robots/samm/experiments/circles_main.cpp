// Chang fig. 6.6 to 6.11, as a program: SAMM's tool moves in a circle, with the base at rest and
// with the base on a circle of its own, with ideal drives and with friction and backlash.
#include "circles.hpp"
#include "command_line/run_experiment.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "SAMM draws a circle with its tool at 1 kHz: base at rest, then base on a circle of its own\n"
      "in the tool's null space; each with ideal drives, friction, backlash, and both (worn).\n"
      "Prints the errors beside the thesis's 4 %; exit status 3 if a claim is broken."};
  std::string folder;
  add_output_folder(command, folder, "RUN.csv and RUN.svg of each run");
  return run_experiment(command, argc, argv, [&folder] {
    const auto runs = run_all_circles();
    const std::string broken = broken_circle_claims(runs);
    Findings findings{circles_summary(runs) + broken, {}, broken.empty()};
    for (const auto& run : runs) {
      const std::string name = file_name(run);
      findings.files.push_back(csv_file(file_in(folder, name + ".csv"), run.table));
      findings.files.push_back(svg_file(file_in(folder, name + ".svg"), circles_figure(run)));
    }
    return findings;
  });
}
