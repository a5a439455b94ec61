#include <memory>
#include <string>

#include "cli/commands.hpp"
#include "description/read_robot_text.hpp"
#include "description/read_urdf.hpp"
#include "terminal/exit_code.hpp"
#include "terminal/option_values.hpp"
#include "terminal/print_diagnostics.hpp"
#include "terminal/write_output.hpp"

namespace treeline {
namespace {

struct ConvertOptions {
  std::string robot;
  std::string output;  ///< empty: standard output
  Warnings warnings = Warnings::summary;
};

/// The text is printed only if it is a robot.
int run(const ConvertOptions& options) {
  Diagnostics diagnostics;
  const auto text = read_robot_text(options.robot, diagnostics);
  const bool is_robot = text && parse_robot(*text, diagnostics).has_value();
  const bool to_file = !options.output.empty() && options.output != "-";
  const bool written = is_robot && to_file &&
                       write_output_file(options.output, text->urdf, diagnostics, {options.robot});
  print_diagnostics(diagnostics, options.warnings);
  if (!is_robot || to_file) return written ? kOk : kBadInput;
  return write_output(text->urdf, OutputForm::text, kOk);
}

}  // namespace

void add_convert(CLI::App& app, int& exit_code) {
  auto options = std::make_shared<ConvertOptions>();
  CLI::App* command = app.add_subcommand("convert", "Print the URDF as which SDF or MJCF is read");
  command->add_option("robot", options->robot, "Robot, SDF or MJCF")->required();
  command->add_option("-o,--output", options->output, "File to write, else standard output")
      ->check(no_equals_sign());
  add_warnings_option(*command, options->warnings);
  command->footer(
      "Every command reads SDF and MJCF where it reads URDF; this shows what it makes of it.\n"
      "Examples:\n"
      "  treeline convert model.sdf > model.urdf\n"
      "  treeline convert humanoid.xml -o humanoid.urdf");
  command->callback([options, &exit_code] { exit_code = run(*options); });
}

}  // namespace treeline
