#pragma once
// SHA-256 (FIPS 180-4) and the code of a message by it (HMAC, RFC 2104). C99 and C++17,
// freestanding, without memory of its own.

#include <stddef.h>
#include <stdint.h>

enum { treeline_sha256_block = 64, treeline_sha256_size = 32 };

/// SHA-256 of bytes that come piece by piece, after `treeline_sha256_begin`.
typedef struct TreelineSha256 {
  uint32_t state[8];
  unsigned char block[treeline_sha256_block];
  uint64_t length;  ///< bytes that have come
} TreelineSha256;

static inline void treeline_sha256_begin(TreelineSha256* hash) {
  static const TreelineSha256 kBegin = {{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f,
                                         0x9b05688c, 0x1f83d9ab, 0x5be0cd19},
                                        {0},
                                        0};
  *hash = kBegin;
}

static inline uint32_t treeline_sha256_turn(uint32_t word, int by) {
  return (word >> by) | (word << (32 - by));
}

static inline void treeline_sha256_expand(const unsigned char* block, uint32_t* w) {
  for (size_t i = 0; i < 16; ++i) {
    w[i] = 0;
    for (size_t k = 0; k < 4; ++k) {
      w[i] = (w[i] << 8) | block[4 * i + k];
    }
  }
  for (size_t i = 16; i < 64; ++i) {
    const uint32_t a = w[i - 15];
    const uint32_t b = w[i - 2];
    w[i] = w[i - 16] + (treeline_sha256_turn(a, 7) ^ treeline_sha256_turn(a, 18) ^ (a >> 3)) +
           w[i - 7] + (treeline_sha256_turn(b, 17) ^ treeline_sha256_turn(b, 19) ^ (b >> 10));
  }
}

static inline void treeline_sha256_compress(TreelineSha256* hash) {
  static const uint32_t kRound[64] = {
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
  uint32_t w[64];
  treeline_sha256_expand(hash->block, w);
  uint32_t s[8];
  for (size_t i = 0; i < 8; ++i) {
    s[i] = hash->state[i];
  }
  for (size_t i = 0; i < 64; ++i) {
    const uint32_t t1 = s[7] +
                        (treeline_sha256_turn(s[4], 6) ^ treeline_sha256_turn(s[4], 11) ^
                         treeline_sha256_turn(s[4], 25)) +
                        ((s[4] & s[5]) ^ (~s[4] & s[6])) + kRound[i] + w[i];
    const uint32_t t2 = (treeline_sha256_turn(s[0], 2) ^ treeline_sha256_turn(s[0], 13) ^
                         treeline_sha256_turn(s[0], 22)) +
                        ((s[0] & s[1]) ^ (s[0] & s[2]) ^ (s[1] & s[2]));
    for (size_t k = 7; k > 0; --k) {
      s[k] = s[k - 1];
    }
    s[4] += t1;
    s[0] = t1 + t2;
  }
  for (size_t i = 0; i < 8; ++i) {
    hash->state[i] += s[i];
  }
}

static inline void treeline_sha256_absorb(TreelineSha256* hash, const void* bytes, size_t size) {
  const unsigned char* const from = (const unsigned char*)bytes;
  for (size_t i = 0; i < size; ++i) {
    hash->block[hash->length++ % treeline_sha256_block] = from[i];
    if (hash->length % treeline_sha256_block == 0) {
      treeline_sha256_compress(hash);
    }
  }
}

/// Writes the 32 bytes of the result. Nothing may be absorbed after it.
static inline void treeline_sha256_finish(TreelineSha256* hash, unsigned char* result) {
  const uint64_t bits = 8 * hash->length;
  const unsigned char one = 0x80;
  const unsigned char zero = 0;
  treeline_sha256_absorb(hash, &one, 1);
  while (hash->length % treeline_sha256_block != treeline_sha256_block - 8) {
    treeline_sha256_absorb(hash, &zero, 1);
  }
  for (int shift = 56; shift >= 0; shift -= 8) {
    const unsigned char byte = (unsigned char)(bits >> shift);
    treeline_sha256_absorb(hash, &byte, 1);
  }
  for (size_t i = 0; i < treeline_sha256_size; ++i) {
    result[i] = (unsigned char)(hash->state[i / 4] >> (24 - 8 * (i % 4)));
  }
}

/// HMAC-SHA256 under one key, which is hashed once.
typedef struct TreelineMessageCode {
  TreelineSha256 inner, outer;
} TreelineMessageCode;

static inline void treeline_message_code_begin(TreelineMessageCode* code, const void* key,
                                               size_t size) {
  unsigned char block[treeline_sha256_block] = {0};
  TreelineSha256* const parts[2] = {&code->inner, &code->outer};
  if (size > treeline_sha256_block) {
    treeline_sha256_begin(&code->inner);
    treeline_sha256_absorb(&code->inner, key, size);
    treeline_sha256_finish(&code->inner, block);
  } else {
    for (size_t i = 0; i < size; ++i) {
      block[i] = ((const unsigned char*)key)[i];
    }
  }
  for (size_t part = 0; part < 2; ++part) {
    treeline_sha256_begin(parts[part]);
    for (size_t i = 0; i < treeline_sha256_block; ++i) {
      const unsigned char padded = (unsigned char)(block[i] ^ (part == 0 ? 0x36 : 0x5c));
      treeline_sha256_absorb(parts[part], &padded, 1);
    }
  }
}

/// Writes the 32 bytes of the message's code.
static inline void treeline_message_code_write(const TreelineMessageCode* code, const void* message,
                                               size_t size, unsigned char* result) {
  TreelineSha256 hash = code->inner;
  treeline_sha256_absorb(&hash, message, size);
  treeline_sha256_finish(&hash, result);
  hash = code->outer;
  treeline_sha256_absorb(&hash, result, treeline_sha256_size);
  treeline_sha256_finish(&hash, result);
}
