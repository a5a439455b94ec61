#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline simulate URDF [SCENE]`: lets a robot go and says what became of its energy.
void add_simulate(CLI::App& app, int& exit_code);

}  // namespace treeline
