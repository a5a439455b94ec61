#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline inspect`: what the generator sees in a URDF. `exit_code` is set when it ran.
void add_inspect(CLI::App& app, int& exit_code);

}  // namespace treeline
