#pragma once

#include <span>
#include <vector>

#include "emission/emission_context.hpp"
#include "program/program.hpp"

namespace treeline {

/// Everything that a folder is printed from.
struct Contents {
  Contents(const EmissionContext& facts, std::span<const Program> asked,
           std::span<const Program> in_batches);
  const EmissionContext& context;
  std::span<const Program> programs;  ///< functions that the scene asks for
  std::span<const Program> batch;     ///< functions of several states, without packs
  std::vector<Program> all;           ///< `programs`, then those that only add-ons call
};

}  // namespace treeline
