#pragma once

#include <cstdint>
#include <vector>

#include "check/fixture.hpp"
#include "random_mechanism.hpp"

namespace treeline::tests {

/// What changes a random mechanism and its scene.
using Change = void (*)(Rng& rng, RandomMechanism& made);

struct Sweep {
  const char* name;
  RandomOptions options;
  int contacts = 0;
  Change change = nullptr;
};

/// Kinds of robots and scenes on which equations are tried.
const std::vector<Sweep>& sweeps();

/// A random robot and scene of the sweep.
Subjects draw_subjects(const Sweep& sweep, std::uint64_t seed);

}  // namespace treeline::tests
