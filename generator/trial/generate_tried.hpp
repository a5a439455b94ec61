#pragma once

#include <optional>
#include <vector>

#include "generation/generate_code.hpp"
#include "trial/try_functions.hpp"

namespace treeline {

/// What becomes of functions that fail by every algorithm.
enum class Failing {
  left_out,  ///< named as errors; the files are made without them
  kept       ///< for those who judge the code themselves
};

/// How code is generated.
struct TriedOptions {
  Choices choices = {};  ///< override the choice by cost
  TellFunction tell = {};
  Failing failing = Failing::left_out;
};

struct TriedGeneration {
  Generation generation;            ///< without files if every function failed
  std::vector<FailedTrial> failed;  ///< functions beyond their bounds by every algorithm
};

/// Generates all files for a robot in a scene: chooses an algorithm for every function that is
/// asked for, tries each (see `retry_routes`), and emits. Returns nothing if the scene asks for
/// what there is not, as told in `diagnostics`.
std::optional<TriedGeneration> generate_tried(const Robot& robot, const Scene& scene,
                                              const Provenance& provenance,
                                              const TriedOptions& options,
                                              Diagnostics& diagnostics);

}  // namespace treeline
