#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/read_robot_files.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/warn_of_limits.hpp"
#include "terminal/print_diagnostics.hpp"
#include "text/diagnostic.hpp"

namespace CLI {
class App;
}

namespace treeline {

/// The files of a command line, and what it says instead of the scene.
struct InputOptions {
  std::string urdf;  ///< or a scene that lists robots
  std::string scene;
  std::string name;                    ///< empty: the scene's
  std::string real;                    ///< `float`, `double`; empty: the scene's
  std::string language;                ///< `c++`, `c`; empty: the scene's
  std::string profile;                 ///< `plain`, `misra`; empty: the scene's
  std::string optimize;                ///< `speed`, `size`; empty: the scene's
  std::string target;                  ///< processor; empty: the scene's
  std::vector<std::string> functions;  ///< empty: the scene's
  std::string package;                 ///< that the code is for; empty: none
  std::string choices;                 ///< manifest.json whose choices to make; empty: by cost
  Warnings warnings = Warnings::summary;
  FunctionsFrom functions_from = FunctionsFrom::scene;
  LimitUse limits_for = LimitUse::code;
};

struct RobotAndScene {
  Robot robot;
  Scene scene;
  RobotFiles files;  ///< what they were read from
};

/// URDF, scene, --real, --functions and --warnings of a subcommand; `options` must outlive it.
void add_input_options(CLI::App& command, InputOptions& options);

/// --language, --profile and --optimize of a subcommand that emits code.
void add_language_option(CLI::App& command, InputOptions& options);

/// Reads all files and applies the options. Faults of any are in `diagnostics`.
std::optional<RobotAndScene> read_inputs(const InputOptions& options, Diagnostics& diagnostics);

}  // namespace treeline
