// Would catch: a packet that is read otherwise than written, or accepted though it is cut, of
// another version, changed on its way or no packet at all; a seal that is not HMAC-SHA256.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "drive/robot_packet.hpp"

namespace treeline::drive {
namespace {

TEST(RobotPacket, ReadsWhatWasWritten) {
  PacketBytes bytes{};
  const std::array<double, 3> numbers = {-1.5, 5e-324, 1e300};
  const PacketHead written{PacketKind::state, 0x0123456789abcdef, 7, 6, 5};
  const std::size_t size = write_packet(written, numbers.data(), 3, bytes);
  EXPECT_EQ(size, 64U);
  EXPECT_EQ(bytes[4], 2);     // version, little-endian
  EXPECT_EQ(bytes[8], 0xef);  // the checksum's lowest byte
  PacketHead head;
  std::array<double, 3> read{};
  ASSERT_TRUE(read_packet(bytes.data(), size, 3, head, read.data()));
  EXPECT_EQ(read, numbers);
  EXPECT_EQ(head.robot, written.robot);
  EXPECT_EQ(head.sequence, 7U);
  EXPECT_EQ(head.answers, 6U);
  EXPECT_EQ(head.run, 5U);
  for (std::size_t other = 0; other < 120; ++other) {
    EXPECT_EQ(read_packet(bytes.data(), other, 3, head, read.data()), other == size) << other;
  }
  for (const std::size_t at : {0U, 3U, 4U, 5U}) {
    PacketBytes changed = bytes;
    changed[at] ^= 0x40;
    EXPECT_FALSE(read_packet(changed.data(), size, 3, head, read.data())) << at;
  }
}

// Three cases of RFC 4231, which publishes codes that others have computed.
TEST(RobotPacket, SealsByHmacSha256) {
  const auto code = [](const std::string& key, const std::string& message) {
    std::array<unsigned char, core::Sha256::kSize> bytes{};
    core::MessageCode(key.data(), key.size()).write(message.data(), message.size(), bytes.data());
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
  const PacketSeal seal("a secret that two know");
  PacketBytes bytes{};
  const double tau = 3.0;
  const std::size_t size = write_packet({PacketKind::command, 0xaa, 7, 0, 1}, &tau, 1, bytes);
  const std::size_t sealed = seal.close(bytes, size);
  ASSERT_EQ(sealed, size + 16);
  EXPECT_EQ(seal.open(bytes, sealed), size);
  EXPECT_FALSE(PacketSeal("a secret that two knew").open(bytes, sealed));
  for (std::size_t cut = 0; cut < sealed; ++cut) EXPECT_FALSE(seal.open(bytes, cut)) << cut;
  for (std::size_t bit = 0; bit < 8 * sealed; ++bit) {
    PacketBytes changed = bytes;
    changed[bit / 8] = static_cast<unsigned char>(changed[bit / 8] ^ (1U << bit % 8));
    EXPECT_FALSE(seal.open(changed, sealed)) << bit;
  }
}

TEST(RobotPacket, NumbersMayWrapAndNotLeap) {
  constexpr std::uint64_t kLast = ~std::uint64_t{0};
  EXPECT_TRUE(is_next(8, 7));
  EXPECT_TRUE(is_next(0, kLast));
  EXPECT_TRUE(is_next(7 + kLargestGap, 7));
  EXPECT_FALSE(is_next(7, 7));
  EXPECT_FALSE(is_next(6, 7));
  EXPECT_FALSE(is_next(kLast, 7));
  EXPECT_FALSE(is_next(8 + kLargestGap, 7));
}

}  // namespace
}  // namespace treeline::drive
