#pragma once

#include <map>
#include <string>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// Text of every function's source in the holes of a template, whatever computes the function:
/// `head`, `cost`, `name`, `section` and `signature`. `definition` is the function's head without a
/// brace.
std::map<std::string, std::string> list_source_holes(const EmissionContext& context,
                                                     const Program& program,
                                                     const std::string& definition);

}  // namespace treeline
