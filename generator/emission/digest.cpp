#include "emission/digest.hpp"

#include <fmt/format.h>

#include <array>

#include "core/sha256.h"

namespace treeline {

std::string digest(std::string_view bytes) {
  TreelineSha256 hash;
  treeline_sha256_begin(&hash);
  treeline_sha256_absorb(&hash, bytes.data(), bytes.size());
  std::array<unsigned char, treeline_sha256_size> result{};
  treeline_sha256_finish(&hash, result.data());
  std::string text;
  for (const unsigned char byte : result) {
    text += fmt::format("{:02x}", byte);
  }
  return text;
}

}  // namespace treeline
