#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline keys [KEY...]`: what a scene may say. `exit_code` is set when it ran.
void add_keys(CLI::App& app, int& exit_code);

}  // namespace treeline
