#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline drive URDF [SCENE]`: compiles a robot's code with a control loop, simulates it, and
/// lets people drive it.
void add_drive(CLI::App& app, int& exit_code);

}  // namespace treeline
