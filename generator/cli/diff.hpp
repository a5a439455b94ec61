#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline diff FIRST SECOND`: by how much two robots differ. `exit_code` is set when it ran.
void add_diff(CLI::App& app, int& exit_code);

}  // namespace treeline
