#pragma once
// Packets over UDP between `treeline drive` and a robot, or a control loop, in another process.
// C99 and C++17.
//
//     bytes 0..3    "TLRB"
//           4..5    version, 2
//           6..7    kind, see `TreelinePacketKind`
//           8..15   checksum of the robot: the first 8 bytes of its digest
//           16..23  sequence number, grows from packet to packet of one sender
//           24..31  of a state and a motion: sequence number of the newest packet of the one it is
//                   sent to that was obeyed; else 0
//           32..39  of a state and a motion: a number that the sender's process has drawn; of a
//                   command and a goal: the same one, so that none is obeyed that was recorded
//                   before; else 0
//           40..    numbers in double, N m or N; rad, m, rad/s, m/s
//     the last 16   with a shared secret: the first half of HMAC-SHA256 (RFC 2104) of all bytes
//                   before, under the secret; without one they are not there
//
// All is little-endian.

#include <string.h>

#include "core/sha256.h"

/// What a packet is. A robot is commanded, and sends states. A control loop sends motions, and gets
/// goals. Both are asked by requests to send, and brake meanwhile.
enum TreelinePacketKind {
  treeline_packet_command = 1,  ///< tau
  treeline_packet_state = 2,    ///< q, qd
  treeline_packet_request = 3,  ///< nothing
  treeline_packet_motion = 4,   ///< q, qd, tau; of each named number 16 bytes of its name, then it
  treeline_packet_goal = 5      ///< mode, control, q, qd; of each point x y z qx qy qz qw
};

enum {
  treeline_packet_version = 2,
  treeline_packet_head_size = 40,
  treeline_packet_seal_size = 16,
  treeline_packet_numbers = 1024,  ///< the most
  treeline_packet_size =
      treeline_packet_head_size + 8 * treeline_packet_numbers + treeline_packet_seal_size,
  treeline_packet_gap = 1 << 20,  ///< numbers that a sender may pass over: more are no loss
  treeline_named_numbers = 16,    ///< the most of one motion
  treeline_name_size = 16         ///< bytes of a name; what is left is 0
};

typedef struct TreelinePacketHead {
  uint16_t kind;
  uint64_t robot, sequence, answers, run;
} TreelinePacketHead;

/// Whether a packet follows another of the same sender. Numbers may wrap.
static inline int treeline_packet_is_next(uint64_t sequence, uint64_t newest) {
  return sequence - newest - 1 < treeline_packet_gap;
}

static inline void treeline_packet_put(unsigned char* to, uint64_t word, size_t size) {
  for (size_t i = 0; i < size; ++i) {
    to[i] = (unsigned char)(word >> (8 * i));
  }
}

static inline uint64_t treeline_packet_get(const unsigned char* from, size_t size) {
  uint64_t word = 0;
  for (size_t i = 0; i < size; ++i) {
    word |= (uint64_t)from[i] << (8 * i);
  }
  return word;
}

/// Writes a packet of `count` <= `treeline_packet_numbers` numbers into room for the largest.
/// Returns its size in bytes, without a seal.
static inline size_t treeline_packet_write(const TreelinePacketHead* head, const double* numbers,
                                           size_t count, unsigned char* bytes) {
  memcpy(bytes, "TLRB", 4);
  treeline_packet_put(bytes + 4, treeline_packet_version, 2);
  treeline_packet_put(bytes + 6, head->kind, 2);
  treeline_packet_put(bytes + 8, head->robot, 8);
  treeline_packet_put(bytes + 16, head->sequence, 8);
  treeline_packet_put(bytes + 24, head->answers, 8);
  treeline_packet_put(bytes + 32, head->run, 8);
  for (size_t i = 0; i < count; ++i) {
    uint64_t bits = 0;
    memcpy(&bits, numbers + i, sizeof(bits));
    treeline_packet_put(bytes + treeline_packet_head_size + 8 * i, bits, 8);
  }
  return treeline_packet_head_size + 8 * count;
}

/// Reads a packet of exactly `count` numbers, of this version. Returns 0, and leaves head and
/// numbers as they are, if it is anything else.
static inline int treeline_packet_read(const unsigned char* bytes, size_t size, size_t count,
                                       TreelinePacketHead* head, double* numbers) {
  if (size != treeline_packet_head_size + 8 * count || memcmp(bytes, "TLRB", 4) != 0 ||
      treeline_packet_get(bytes + 4, 2) != treeline_packet_version) {
    return 0;
  }
  head->kind = (uint16_t)treeline_packet_get(bytes + 6, 2);
  head->robot = treeline_packet_get(bytes + 8, 8);
  head->sequence = treeline_packet_get(bytes + 16, 8);
  head->answers = treeline_packet_get(bytes + 24, 8);
  head->run = treeline_packet_get(bytes + 32, 8);
  for (size_t i = 0; i < count; ++i) {
    const uint64_t bits = treeline_packet_get(bytes + treeline_packet_head_size + 8 * i, 8);
    memcpy(numbers + i, &bits, sizeof(bits));
  }
  return 1;
}

/// Writes a name of at most 16 bytes in the place of two numbers.
static inline void treeline_packet_write_name(const char* name, double* numbers) {
  unsigned char padded[treeline_name_size] = {0};
  for (int i = 0; i < treeline_name_size && name[i] != 0; ++i) {
    padded[i] = (unsigned char)name[i];
  }
  for (int i = 0; i < 2; ++i) {
    const uint64_t word = treeline_packet_get(padded + 8 * i, 8);
    memcpy(numbers + i, &word, sizeof(word));
  }
}

static inline void treeline_packet_read_name(const double* numbers, char* name) {
  for (int i = 0; i < treeline_name_size; ++i) {
    uint64_t word = 0;
    memcpy(&word, numbers + i / 8, sizeof(word));
    name[i] = (char)(unsigned char)(word >> (8 * (i % 8)));
  }
}

/// How many numbers a packet of so many bytes has, if it is one.
static inline size_t treeline_packet_count(size_t size) {
  return size < treeline_packet_head_size ? 0 : (size - treeline_packet_head_size) / 8;
}

/// Proves that a packet comes from somebody who knows the shared secret.
typedef struct TreelinePacketSeal {
  int is_wanted;
  TreelineMessageCode code;
} TreelinePacketSeal;

/// `secret` empty: packets carry no proof.
static inline void treeline_seal_begin(TreelinePacketSeal* seal, const char* secret) {
  seal->is_wanted = secret[0] != 0;
  treeline_message_code_begin(&seal->code, secret, strlen(secret));
}

/// Puts the seal behind a packet of `size` bytes. Returns its size with it.
static inline size_t treeline_seal_close(const TreelinePacketSeal* seal, unsigned char* bytes,
                                         size_t size) {
  unsigned char code[treeline_sha256_size];
  if (!seal->is_wanted) return size;
  treeline_message_code_write(&seal->code, bytes, size, code);
  memcpy(bytes + size, code, treeline_packet_seal_size);
  return size + treeline_packet_seal_size;
}

/// The size of a packet without its seal; 0: it does not come from who knows the secret.
static inline size_t treeline_seal_open(const TreelinePacketSeal* seal, const unsigned char* bytes,
                                        size_t size) {
  unsigned char code[treeline_sha256_size];
  unsigned difference = 0;  // found in a time that tells nothing of where it is
  if (!seal->is_wanted) return size;
  if (size < treeline_packet_seal_size || size > treeline_packet_size) return 0;
  treeline_message_code_write(&seal->code, bytes, size - treeline_packet_seal_size, code);
  for (size_t i = 0; i < treeline_packet_seal_size; ++i) {
    difference |= (unsigned)(code[i] ^ bytes[size - treeline_packet_seal_size + i]);
  }
  return difference != 0 ? 0 : size - treeline_packet_seal_size;
}
