#pragma once

#include <string>

#include "check/step_library.hpp"

namespace treeline {

/// A step, seen from outside.
struct SeenStep {
  const StepLibrary& library;
  const StepNumbers& config;  ///< that is sound
  const StepNumbers& before;  ///< the state that the step was given
  const StepNumbers& input;
  const StepNumbers& output;
  bool reset = false;  ///< whether a reset was commanded
  double unit = 0;     ///< ulp of one

  /// Number `i` of a member of that name.
  [[nodiscard]] long double number(StepPart part, const char* member, std::size_t i = 0) const;
  [[nodiscard]] std::uint32_t bits(StepPart part, const char* member) const;
};

/// Rule that the step breaks and no law may break; empty if none.
std::string find_broken_rule(const SeenStep& seen);

}  // namespace treeline
