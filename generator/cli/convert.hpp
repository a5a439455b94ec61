#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline convert SDF`: the URDF as which the program reads it. `exit_code` is set when it ran.
void add_convert(CLI::App& app, int& exit_code);

}  // namespace treeline
