#pragma once

#include <cstdint>

namespace treeline {

/// The hash of a sequence that goes on with `word`, by that of what came before: multiplication by
/// 2^64 over the golden ratio (Knuth, The Art of Computer Programming 6.4).
inline std::uint64_t hash_word(std::uint64_t hash, std::uint64_t word) {
  hash = (hash ^ word) * 0x9e3779b97f4a7c15U;
  return hash ^ (hash >> 32);
}

}  // namespace treeline
