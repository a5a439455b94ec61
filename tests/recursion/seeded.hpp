#pragma once

#include <cstdint>
#include <ostream>

#include "random_mechanism.hpp"

namespace treeline::tests {

/// How a random robot is drawn; failures print the seed.
struct Seeded {
  std::uint64_t seed;
  RandomOptions options;
};

inline std::ostream& operator<<(std::ostream& out, const Seeded& robot) {
  return out << "seed " << robot.seed;
}

}  // namespace treeline::tests
