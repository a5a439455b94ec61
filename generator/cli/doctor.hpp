#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline doctor`: what of this machine's programs is there, and for what. `exit_code` is set
/// when it ran.
void add_doctor(CLI::App& app, int& exit_code);

}  // namespace treeline
