#pragma once

#include <CLI/CLI.hpp>

namespace treeline {

/// `treeline certify`.
void add_certify(CLI::App& app, int& exit_code);

}  // namespace treeline
