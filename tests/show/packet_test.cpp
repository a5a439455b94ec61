// Would catch: a packet that is read otherwise than written, or accepted though it is cut, of
// another version, changed on its way or no packet at all; a seal that is not HMAC-SHA256.
#include "show/packet.h"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace treeline {
namespace {

using PacketBytes = std::array<unsigned char, treeline_packet_size>;

TreelinePacketSeal make_seal(const char* secret) {
  TreelinePacketSeal seal;
  treeline_seal_begin(&seal, secret);
  return seal;
}

TEST(RobotPacket, ReadsWhatWasWritten) {
  PacketBytes bytes{};
  const std::array<double, 3> numbers = {-1.5, 5e-324, 1e300};
  const TreelinePacketHead written{treeline_packet_state, 0x0123456789abcdef, 7, 6, 5};
  const std::size_t size = treeline_packet_write(&written, numbers.data(), 3, bytes.data());
  EXPECT_EQ(size, 64U);
  EXPECT_EQ(bytes[4], 2);     // version, little-endian
  EXPECT_EQ(bytes[8], 0xef);  // the checksum's lowest byte
  TreelinePacketHead head;
  std::array<double, 3> read{};
  ASSERT_TRUE(treeline_packet_read(bytes.data(), size, 3, &head, read.data()));
  EXPECT_EQ(read, numbers);
  EXPECT_EQ(head.robot, written.robot);
  EXPECT_EQ(head.sequence, 7U);
  EXPECT_EQ(head.answers, 6U);
  EXPECT_EQ(head.run, 5U);
  for (std::size_t other = 0; other < 120; ++other) {
    EXPECT_EQ(treeline_packet_read(bytes.data(), other, 3, &head, read.data()), other == size)
        << other;
  }
  for (const std::size_t at : {0U, 3U, 4U, 5U}) {
    PacketBytes changed = bytes;
    changed[at] ^= 0x40;
    EXPECT_FALSE(treeline_packet_read(changed.data(), size, 3, &head, read.data())) << at;
  }
}

// Three cases of RFC 4231, which publishes codes that others have computed.
TEST(RobotPacket, SealsByHmacSha256) {
  const auto code = [](const std::string& key, const std::string& message) {
    std::array<unsigned char, treeline_sha256_size> bytes{};
    TreelineMessageCode under_key;
    treeline_message_code_begin(&under_key, key.data(), key.size());
    treeline_message_code_write(&under_key, message.data(), message.size(), bytes.data());
    std::string digits;
    for (const unsigned char byte : bytes) {
      digits += "0123456789abcdef"[byte >> 4U];
      digits += "0123456789abcdef"[byte & 15U];
    }
    return digits;
  };
  EXPECT_EQ(code("Jefe", "what do ya want for nothing?"),
            "5bdcc146bf60754e6a042426089575c75a003f089d2739839dec58b964ec3843");
  EXPECT_EQ(code(std::string(20, '\xaa'), std::string(50, '\xdd')),
            "773ea91e36800e46854db8ebd09181a72959098b3ef8c122d9635514ced565fe");
  EXPECT_EQ(
      code(std::string(131, '\xaa'), "Test Using Larger Than Block-Size Key - Hash Key First"),
      "60e431591ee0b67f0d8a26aacbf5b77f8e0bc6213728c5140546040f0ee37f54");
}

TEST(RobotPacket, OpensNothingThatWasChanged) {
  const TreelinePacketSeal seal = make_seal("a secret that two know");
  const TreelinePacketSeal other = make_seal("a secret that two knew");
  PacketBytes bytes{};
  const double tau = 3.0;
  const TreelinePacketHead head{treeline_packet_command, 0xaa, 7, 0, 1};
  const std::size_t size = treeline_packet_write(&head, &tau, 1, bytes.data());
  const std::size_t sealed = treeline_seal_close(&seal, bytes.data(), size);
  ASSERT_EQ(sealed, size + 16);
  EXPECT_EQ(treeline_seal_open(&seal, bytes.data(), sealed), size);
  EXPECT_EQ(treeline_seal_open(&other, bytes.data(), sealed), 0U);
  for (std::size_t cut = 0; cut < sealed; ++cut) {
    EXPECT_EQ(treeline_seal_open(&seal, bytes.data(), cut), 0U) << cut;
  }
  for (std::size_t bit = 0; bit < 8 * sealed; ++bit) {
    PacketBytes changed = bytes;
    changed[bit / 8] = static_cast<unsigned char>(changed[bit / 8] ^ (1U << bit % 8));
    EXPECT_EQ(treeline_seal_open(&seal, changed.data(), sealed), 0U) << bit;
  }
}

TEST(RobotPacket, NumbersMayWrapAndNotLeap) {
  constexpr std::uint64_t kLast = ~std::uint64_t{0};
  EXPECT_TRUE(treeline_packet_is_next(8, 7));
  EXPECT_TRUE(treeline_packet_is_next(0, kLast));
  EXPECT_TRUE(treeline_packet_is_next(7 + treeline_packet_gap, 7));
  EXPECT_FALSE(treeline_packet_is_next(7, 7));
  EXPECT_FALSE(treeline_packet_is_next(6, 7));
  EXPECT_FALSE(treeline_packet_is_next(kLast, 7));
  EXPECT_FALSE(treeline_packet_is_next(8 + treeline_packet_gap, 7));
}

}  // namespace
}  // namespace treeline
