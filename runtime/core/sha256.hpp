#pragma once
// SHA-256 (FIPS 180-4) and the code of a message by it (HMAC, RFC 2104). C++17, freestanding,
// without memory of its own.

#include <stddef.h>
#include <stdint.h>

namespace treeline::core {

/// SHA-256 of bytes that come piece by piece.
class Sha256 {
 public:
  static constexpr size_t kBlock = 64;
  static constexpr size_t kSize = 32;

  void absorb(const void* bytes, size_t size) noexcept {
    const auto* const from = static_cast<const unsigned char*>(bytes);
    for (size_t i = 0; i < size; ++i) {
      block_[length_++ % kBlock] = from[i];
      if (length_ % kBlock == 0) {
        compress();
      }
    }
  }

  /// Writes the 32 bytes of the result. Nothing may be absorbed after it.
  void finish(unsigned char* result) noexcept {
    const uint64_t bits = 8 * length_;
    const unsigned char one = 0x80;
    const unsigned char zero = 0;
    absorb(&one, 1);
    while (length_ % kBlock != kBlock - 8) {
      absorb(&zero, 1);
    }
    for (int shift = 56; shift >= 0; shift -= 8) {
      const auto byte = static_cast<unsigned char>(bits >> shift);
      absorb(&byte, 1);
    }
    for (size_t i = 0; i < kSize; ++i) {
      result[i] = static_cast<unsigned char>(state_[i / 4] >> (24 - 8 * (i % 4)));
    }
  }

 private:
  static constexpr uint32_t kRound[64] = {
      0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4,
      0xab1c5ed5, 0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe,
      0x9bdc06a7, 0xc19bf174, 0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f,
      0x4a7484aa, 0x5cb0a9dc, 0x76f988da, 0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7,
      0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967, 0x27b70a85, 0x2e1b2138, 0x4d2c6dfc,
      0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85, 0xa2bfe8a1, 0xa81a664b,
      0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070, 0x19a4c116,
      0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
      0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7,
      0xc67178f2};

  static constexpr uint32_t turn(uint32_t word, int by) noexcept {
    return (word >> by) | (word << (32 - by));
  }

  void expand(uint32_t (&w)[64]) const noexcept {
    for (size_t i = 0; i < 16; ++i) {
      w[i] = 0;
      for (size_t k = 0; k < 4; ++k) {
        w[i] = (w[i] << 8) | block_[4 * i + k];
      }
    }
    for (size_t i = 16; i < 64; ++i) {
      const uint32_t a = w[i - 15];
      const uint32_t b = w[i - 2];
      w[i] = w[i - 16] + (turn(a, 7) ^ turn(a, 18) ^ (a >> 3)) + w[i - 7] +
             (turn(b, 17) ^ turn(b, 19) ^ (b >> 10));
    }
  }

  void compress() noexcept {
    uint32_t w[64];
    expand(w);
    uint32_t s[8];
    for (size_t i = 0; i < 8; ++i) {
      s[i] = state_[i];
    }
    for (size_t i = 0; i < 64; ++i) {
      const uint32_t t1 = s[7] + (turn(s[4], 6) ^ turn(s[4], 11) ^ turn(s[4], 25)) +
                          ((s[4] & s[5]) ^ (~s[4] & s[6])) + kRound[i] + w[i];
      const uint32_t t2 = (turn(s[0], 2) ^ turn(s[0], 13) ^ turn(s[0], 22)) +
                          ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
      for (size_t k = 7; k > 0; --k) {
        s[k] = s[k - 1];
      }
      s[4] += t1;
      s[0] = t1 + t2;
    }
    for (size_t i = 0; i < 8; ++i) {
      state_[i] += s[i];
    }
  }

  uint32_t state_[8] = {0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                        0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  unsigned char block_[kBlock] = {};
  uint64_t length_ = 0;
};

/// HMAC-SHA256 under one key, which is hashed once.
class MessageCode {
 public:
  MessageCode(const void* key, size_t size) noexcept {
    unsigned char block[Sha256::kBlock] = {};
    if (size > Sha256::kBlock) {
      Sha256 hash;
      hash.absorb(key, size);
      hash.finish(block);
    } else {
      for (size_t i = 0; i < size; ++i) {
        block[i] = static_cast<const unsigned char*>(key)[i];
      }
    }
    begin(block, 0x36, inner_);
    begin(block, 0x5c, outer_);
  }

  /// Writes the 32 bytes of the message's code.
  void write(const void* message, size_t size, unsigned char* code) const noexcept {
    unsigned char within[Sha256::kSize];
    Sha256 hash = inner_;
    hash.absorb(message, size);
    hash.finish(within);
    hash = outer_;
    hash.absorb(within, sizeof(within));
    hash.finish(code);
  }

 private:
  static void begin(const unsigned char (&key)[Sha256::kBlock], unsigned pad,
                    Sha256& hash) noexcept {
    for (const unsigned char byte : key) {
      const auto padded = static_cast<unsigned char>(byte ^ pad);
      hash.absorb(&padded, 1);
    }
  }

  Sha256 inner_, outer_;
};

}  // namespace treeline::core
