#pragma once

#include <cstddef>
#include <cstdint>
#include <random>

namespace treeline {

/// Random numbers, computed with its own arithmetic, so that they are the same with every standard
/// library.
class Rng {
 public:
  explicit Rng(std::uint64_t seed) : engine_(seed) {}

  std::uint64_t bits() { return engine_(); }
  /// A number in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11) * 0x1p-53; }
  double within(double low, double high) { return low + (high - low) * unit(); }
  double within(double size) { return within(-size, size); }
  bool chance(double probability) { return unit() < probability; }
  /// An index in 0..count-1.
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(unit() * static_cast<double>(count));
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace treeline
