#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string_view>

#include "core/sha256.hpp"

namespace treeline::drive {

/// Packet over UDP between the loop and a robot: one each way in a cycle, little-endian, of fixed
/// size for a robot.
///
///     bytes 0..3    "TLRB"
///           4..5    version, 2
///           6..7    kind: 1 command (tau follows), 2 state (q and qd follow), 3 request (nothing
///                   follows: the robot is to send states, and brakes as before)
///           8..15   checksum of the robot: the first 8 bytes of its digest
///           16..23  sequence number, grows from packet to packet of one sender
///           24..31  of a state: sequence number of the newest packet of the one it is sent to that
///                   was obeyed; else 0
///           32..39  of a state: a number that the robot's process has drawn; of a command: the
///                   same one, so that none is obeyed that was recorded before; else 0
///           40..    numbers in double, N m or N; rad, m, rad/s, m/s
///     the last 16   with a shared secret: the first half of HMAC-SHA256 (RFC 2104) of all bytes
///                   before, under the secret; without one they are not there
enum class PacketKind : std::uint16_t { command = 1, state = 2, request = 3 };

inline constexpr std::size_t kPacketHead = 40;
inline constexpr std::size_t kMostPacketNumbers = 1024;
inline constexpr std::size_t kPacketSeal = 16;
inline constexpr std::size_t kLargestPacket = kPacketHead + 8 * kMostPacketNumbers + kPacketSeal;
inline constexpr std::uint16_t kPacketVersion = 2;

/// Sequence numbers that a sender may pass over: more are no loss of packets.
inline constexpr std::uint64_t kLargestGap = std::uint64_t{1} << 20;

/// Whether a packet follows another of the same sender. Numbers may wrap.
inline bool is_next(std::uint64_t sequence, std::uint64_t newest) noexcept {
  return sequence - newest - 1 < kLargestGap;
}

struct PacketHead {
  PacketKind kind = PacketKind::command;
  std::uint64_t robot = 0;
  std::uint64_t sequence = 0;
  std::uint64_t answers = 0;
  std::uint64_t run = 0;
};

using PacketBytes = std::array<unsigned char, kLargestPacket>;

namespace packet {

template <class Word>
void put(unsigned char* to, Word word) noexcept {
  for (std::size_t i = 0; i < sizeof(Word); ++i) {
    to[i] = static_cast<unsigned char>(word >> (8 * i));
  }
}
template <class Word>
Word get(const unsigned char* from) noexcept {
  Word word = 0;
  for (std::size_t i = 0; i < sizeof(Word); ++i) {
    word = static_cast<Word>(word | static_cast<Word>(static_cast<Word>(from[i]) << (8 * i)));
  }
  return word;
}

}  // namespace packet

/// Writes a packet of `count` <= kMostPacketNumbers numbers. Returns its size in bytes.
inline std::size_t write_packet(const PacketHead& head, const double* numbers, std::size_t count,
                                PacketBytes& bytes) noexcept {
  std::memcpy(bytes.data(), "TLRB", 4);
  packet::put(bytes.data() + 4, kPacketVersion);
  packet::put(bytes.data() + 6, static_cast<std::uint16_t>(head.kind));
  packet::put(bytes.data() + 8, head.robot);
  packet::put(bytes.data() + 16, head.sequence);
  packet::put(bytes.data() + 24, head.answers);
  packet::put(bytes.data() + 32, head.run);
  for (std::size_t i = 0; i < count; ++i) {
    std::uint64_t bits = 0;
    std::memcpy(&bits, numbers + i, sizeof(bits));
    packet::put(bytes.data() + kPacketHead + 8 * i, bits);
  }
  return kPacketHead + 8 * count;
}

/// Reads a packet of exactly `count` numbers, of this version. Returns false, and leaves head and
/// numbers as they are, if it is anything else.
inline bool read_packet(const unsigned char* bytes, std::size_t size, std::size_t count,
                        PacketHead& head, double* numbers) noexcept {
  if (size != kPacketHead + 8 * count || std::memcmp(bytes, "TLRB", 4) != 0 ||
      packet::get<std::uint16_t>(bytes + 4) != kPacketVersion) {
    return false;
  }
  head.kind = static_cast<PacketKind>(packet::get<std::uint16_t>(bytes + 6));
  head.robot = packet::get<std::uint64_t>(bytes + 8);
  head.sequence = packet::get<std::uint64_t>(bytes + 16);
  head.answers = packet::get<std::uint64_t>(bytes + 24);
  head.run = packet::get<std::uint64_t>(bytes + 32);
  for (std::size_t i = 0; i < count; ++i) {
    const auto bits = packet::get<std::uint64_t>(bytes + kPacketHead + 8 * i);
    std::memcpy(numbers + i, &bits, sizeof(bits));
  }
  return true;
}

/// Proves that a packet comes from somebody who knows the shared secret.
class PacketSeal {
 public:
  /// `secret` empty: packets carry no proof.
  explicit PacketSeal(std::string_view secret) noexcept {
    if (!secret.empty()) code_.emplace(secret.data(), secret.size());
  }

  bool is_wanted() const noexcept { return code_.has_value(); }

  /// Puts the seal behind a packet of `size` bytes. Returns its size with it.
  std::size_t close(PacketBytes& bytes, std::size_t size) const noexcept {
    if (!code_) return size;
    unsigned char code[core::Sha256::kSize];
    code_->write(bytes.data(), size, code);
    std::memcpy(bytes.data() + size, code, kPacketSeal);
    return size + kPacketSeal;
  }

  /// The size of a packet without its seal; none: it does not come from who knows the secret.
  std::optional<std::size_t> open(const PacketBytes& bytes, std::size_t size) const noexcept {
    if (!code_) return size;
    if (size < kPacketSeal || size > bytes.size()) return std::nullopt;
    unsigned char code[core::Sha256::kSize];
    code_->write(bytes.data(), size - kPacketSeal, code);
    unsigned difference = 0;  // found in a time that tells nothing of where it is
    for (std::size_t i = 0; i < kPacketSeal; ++i) {
      difference |= static_cast<unsigned>(code[i] ^ bytes[size - kPacketSeal + i]);
    }
    if (difference != 0) return std::nullopt;
    return size - kPacketSeal;
  }

 private:
  std::optional<core::MessageCode> code_;
};

}  // namespace treeline::drive
