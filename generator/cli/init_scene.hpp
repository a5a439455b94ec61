#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline init-scene URDF`: a commented scene to start from. `exit_code` is set when it ran.
void add_init_scene(CLI::App& app, int& exit_code);

}  // namespace treeline
