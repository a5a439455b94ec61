// Chang fig. 2.4 and 2.5, as a program.
#include "command_line/run_experiment.hpp"
#include "null_space.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "3R planar arm: null-space motion with two generalised inverses. Exit "
      "status 3 if the claim is broken."};
  OutputPaths paths;
  add_outputs(
      command, paths,
      "write the run with the dynamically consistent inverse here, and the other to FILE.pseudo",
      "draw both figures into this file");
  return run_experiment(command, argc, argv, [&paths] {
    const auto pseudo = run_null_space(Inverse::pseudo);
    const auto consistent = run_null_space(Inverse::dynamic_consistent);
    return Findings{null_space_summary(pseudo, consistent),
                    files_of_both(paths, consistent.table, ".pseudo", pseudo.table,
                                  null_space_figure(pseudo, consistent)),
                    null_space_claim_holds(pseudo, consistent)};
  });
}
