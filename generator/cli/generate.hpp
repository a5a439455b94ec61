#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline generate`: URDF and scene to a folder of C++ or C. `exit_code` is set when it ran.
void add_generate(CLI::App& app, int& exit_code);

}  // namespace treeline
