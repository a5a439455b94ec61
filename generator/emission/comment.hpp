#pragma once

#include <string>

#include "emission/emission_context.hpp"

namespace treeline {

/// `mark ` before every line; no blank at the end of an empty one.
std::string comment(const std::string& mark, const std::string& text);

/// Lines of so many columns, broken at blanks; those behind the first are indented.
std::string wrap_text(const std::string& text, std::size_t columns);

/// What the context knows of the rounding errors of a source, wrapped, if anything.
std::string describe_rounding(const EmissionContext& context, const std::string& source);

}  // namespace treeline
