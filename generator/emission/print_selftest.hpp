#pragma once

#include <span>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline {

/// Stem of the source.
inline constexpr const char* kSelftestStem = "selftest";

/// NAME_selftest.h and the source that calls the functions, where the context has numbers for it;
/// else none.
std::vector<GeneratedFile> print_selftest(const EmissionContext& context,
                                          std::span<const Program> programs);

}  // namespace treeline
