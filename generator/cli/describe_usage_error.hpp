#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "text/diagnostic.hpp"

namespace treeline {

/// The first argument where that is no command and no option: the near name, or all there are.
/// Nothing is added where it is one, or where there is no argument.
void reject_unknown_command(const CLI::App& app, const std::vector<std::string>& arguments,
                            Diagnostics& diagnostics);

/// What is wrong with a command line that the parser refused, in words, with what to write instead.
Diagnostic describe_usage_error(const CLI::App& app, const CLI::ParseError& error);

}  // namespace treeline
