#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// A header of the runtime as it is.
struct LoopTemplate {
  std::string stem;  ///< `link_pose`
  std::string_view text;
};

/// The headers `runtime/core/link_*.hpp` that `programs` may need, each behind those that it
/// includes.
std::vector<LoopTemplate> list_loop_templates(std::span<const Program> programs);

}  // namespace treeline
