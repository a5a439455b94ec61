// Pushes on a humanoid that stands within its limits, as a program.
#include "command_line/run_experiment.hpp"
#include "push.hpp"

int main(int argc, char** argv) {
  using namespace treeline::experiments;  // NOLINT: a program, not a header
  CommandLine command{
      "The humanoid stands on two feet that can tip, shifts its weight, reaches far, and is "
      "pushed\n"
      "at its chest from behind, from before and from the side. Torques and forces stay within\n"
      "their limits, and it recovers. By the unlimited law it falls. Exit status 3 if it does "
      "not."};
  OutputPaths paths;
  std::string table;
  add_outputs(command, paths, "write the run within limits here", "draw both runs into this file");
  add_page_table(command, table);
  return run_experiment(command, argc, argv, [&paths, &table] {
    const auto limited = run_push(true);
    const auto unlimited = run_push(false);
    auto files = files_of(paths, limited.table, push_figure(limited, unlimited));
    files.push_back({table, push_page_table(limited, unlimited)});
    return Findings{push_summary(limited, unlimited), files, push_claim_holds(limited, unlimited)};
  });
}
