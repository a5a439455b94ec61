#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline bench URDF SCENE`.
void add_bench(CLI::App& app, int& exit_code);

}  // namespace treeline
