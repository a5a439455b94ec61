#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <exception>

#include "cli/bench.hpp"
#include "cli/check.hpp"
#include "cli/exit_code.hpp"
#include "cli/generate.hpp"
#include "cli/inspect.hpp"
#include "cli/simulate.hpp"

int main(int argc, char** argv) {
  CLI::App app{
      "Straight-line, fixed-size C++ for a robot's dynamics and operational-space control"};
  app.require_subcommand(1);
  app.footer("Exit: 0 done, 1 bad input, 2 usage, 3 stale or out of bounds, 70 internal fault.");
  int exit_code = treeline::kOk;
  treeline::add_generate(app, exit_code);
  treeline::add_check(app, exit_code);
  treeline::add_bench(app, exit_code);
  treeline::add_inspect(app, exit_code);
  treeline::add_simulate(app, exit_code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? treeline::kOk : treeline::kUsage;
  } catch (const std::exception& error) {
    fmt::print(stderr, "treeline: internal fault: {}\n", error.what());
    return treeline::kInternal;
  }
  return exit_code;
}
