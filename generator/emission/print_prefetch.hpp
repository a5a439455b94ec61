#pragma once

#include <span>
#include <string>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline {

/// NAME_prefetch and prefetch, header and source in the context's language: functions that load the
/// code of each of the programs' functions into caches. None unless the scene asks for them.
std::vector<GeneratedFile> print_prefetch(const EmissionContext& context,
                                          std::span<const Program> programs);

/// What stands before the source of a function whose code can be loaded: the macro that gives it a
/// section of its own. Empty unless the scene asks for it.
std::string print_prefetch_macro(const EmissionContext& context, const Program& program);

/// What stands before the function itself.
std::string print_prefetch_section(const EmissionContext& context);

}  // namespace treeline
