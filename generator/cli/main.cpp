#include <fcntl.h>
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <sstream>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include "cli/commands.hpp"
#include "cli/describe_usage_error.hpp"
#include "emission/generated_file.hpp"
#include "interruption/clean_up.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/write_output.hpp"
#include "text/align_columns.hpp"
#include "text/printable.hpp"

namespace {

/// `help` and `help COMMAND` are `--help` and `COMMAND --help`, and `version` is `--version`.
std::vector<std::string> read_arguments(int argc, char** argv) {
  std::vector<std::string> arguments(argv + std::min(argc, 1), argv + argc);
  if (arguments == std::vector<std::string>{"version"}) return {"--version"};
  if (arguments.empty() || arguments.front() != "help") return arguments;
  arguments.erase(arguments.begin());
  if (arguments == std::vector<std::string>{"help"}) arguments.clear();
  arguments.emplace_back("--help");
  return arguments;
}

/// Keeps memory that is freed: traces take and free megabytes, hundreds of times, and glibc would
/// hand them back to the kernel and ask for them again.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int kBytes = 64 << 20;
  (void)mallopt(M_TRIM_THRESHOLD, kBytes);
  (void)mallopt(M_TOP_PAD, kBytes);
  (void)mallopt(M_MMAP_THRESHOLD, kBytes / 2);
#endif
}

/// Gives closed standard streams a place. Else a file that is opened later takes their numbers, and
/// messages go into it. Input that was closed still cannot be read, nor output be written to, so
/// that both are noticed; messages are lost.
void reserve_standard_streams() {
  for (const auto& [stream, access] :
       {std::pair(0, O_WRONLY), std::pair(1, O_RDONLY), std::pair(2, O_WRONLY)}) {
    if (fcntl(stream, F_GETFD) == -1) (void)open("/dev/null", access);  // the lowest that is free
  }
}

void add_commands(CLI::App& app, int& exit_code) {
  app.name("treeline");
  app.set_version_flag("--version", fmt::format("treeline {}", treeline::generator_version()));
  app.require_subcommand(1);
  app.footer(
      "treeline help COMMAND says more of one. - is standard input, as URDF or as scene.\n"
      "Exit: 0 done, 1 bad input, 2 usage, 3 stale or out of bounds, 70 internal fault.\n"
      "With TREELINE_MESSAGES=json in the environment each message is a line of JSON.");
  treeline::add_generate(app, exit_code);
  treeline::add_check(app, exit_code);
  treeline::add_certify(app, exit_code);
  treeline::add_bench(app, exit_code);
  treeline::add_inspect(app, exit_code);
  treeline::add_keys(app, exit_code);
  treeline::add_init_scene(app, exit_code);
  treeline::add_convert(app, exit_code);
  treeline::add_diff(app, exit_code);
  treeline::add_simulate(app, exit_code);
  treeline::add_draw(app, exit_code);
  treeline::add_drive(app, exit_code);
  treeline::add_interpret(app, exit_code);
  treeline::add_doctor(app, exit_code);
}

int run(int argc, char** argv) {
  CLI::App app{
      "Straight-line, fixed-size C++ for a robot's dynamics and operational-space control"};
  int exit_code = treeline::kOk;
  add_commands(app, exit_code);
  std::vector<std::string> arguments = read_arguments(argc, argv);
  treeline::Diagnostics diagnostics;
  treeline::reject_unknown_command(app, arguments, diagnostics);
  if (diagnostics.has_errors()) {
    treeline::print_diagnostics(diagnostics);
    return treeline::kUsage;
  }
  std::reverse(arguments.begin(), arguments.end());  // as the parser takes them
  try {
    app.parse(std::move(arguments));
  } catch (const CLI::Success& asked) {  // help or version
    std::ostringstream text;
    (void)app.exit(asked, text, text);
    return treeline::write_output(text.str(), treeline::OutputForm::text, treeline::kOk);
  } catch (const CLI::ParseError& error) {
    diagnostics.add(treeline::describe_usage_error(app, error));
    treeline::print_diagnostics(diagnostics);
    return treeline::kUsage;
  }
  return exit_code;
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  reserve_standard_streams();
  treeline::clean_up_on_signals();
  treeline::fit_to_terminal();
  try {
    return run(argc, argv);
  } catch (const std::system_error& error) {  // of the disk, the memory or the processes
    treeline::print_message("treeline: error: " + treeline::printable(error.what()) + "\n");
    return treeline::kBadInput;
  } catch (const std::exception& error) {
    treeline::print_message("treeline: internal fault: " + treeline::printable(error.what()) +
                            "\n");
    return treeline::kInternal;
  }
}
