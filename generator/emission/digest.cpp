#include "emission/digest.hpp"

#include <fmt/format.h>

#include <array>

#include "core/sha256.hpp"

namespace treeline {

std::string digest(std::string_view bytes) {
  core::Sha256 hash;
  hash.absorb(bytes.data(), bytes.size());
  std::array<unsigned char, core::Sha256::kSize> result{};
  hash.finish(result.data());
  std::string text;
  for (const unsigned char byte : result) {
    text += fmt::format("{:02x}", byte);
  }
  return text;
}

}  // namespace treeline
