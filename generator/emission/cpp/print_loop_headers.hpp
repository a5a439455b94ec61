#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emission/emission_context.hpp"
#include "emission/generated_file.hpp"
#include "program/program.hpp"

namespace treeline::cpp {

/// A header of the runtime as it is.
struct LoopTemplate {
  std::string stem;  ///< `link_pose`
  std::string_view text;
};

/// The headers `runtime/core/link_*.hpp` that `programs` may need, each behind those that it
/// includes.
std::vector<LoopTemplate> list_loop_templates(std::span<const Program> programs);

/// Prints these headers with only what `programs` need. The programs loop over a table of links.
/// The code is in the namespace of the runtime.
std::vector<GeneratedFile> print_loop_headers(const EmissionContext& context,
                                              std::span<const Program> programs);

}  // namespace treeline::cpp
