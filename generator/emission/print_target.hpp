#pragma once

#include <string>

#include "emission/emission_context.hpp"

namespace treeline {

/// Texts about the processor that generated files are for. All are empty for `generic`.

/// Lines of the contract: processor, flags, sections, how to measure on the processor.
std::string describe_target(const EmissionContext& context);
/// Definition of the macro before a function, which places its code in memory.
std::string print_section_macro(const EmissionContext& context);
/// Use of the macro that places code in memory, on a line of its own before a definition.
std::string print_section(const EmissionContext& context);
/// Flags of the processor for the emitted CMakeLists.txt.
std::string print_target_flags(const EmissionContext& context);
/// Lines of the manifest.
std::string print_target_lines(const EmissionContext& context);

/// Whether the emitted CMakeLists.txt lets the compiler fuse products and sums: ON or OFF.
const char* contraction_default(const EmissionContext& context);

}  // namespace treeline
