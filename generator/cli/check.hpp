#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline check`: generated code, compiled and run, against the interpreter in 50 digits.
/// `exit_code` is set when it ran.
void add_check(CLI::App& app, int& exit_code);

}  // namespace treeline
