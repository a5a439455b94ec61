// Would catch: a packet that is read otherwise than written, or accepted though it is cut, of
// another version or no packet at all; a robot that is taken for another, obeys old commands, or
// does not brake when it is left alone.
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cmath>
#include <thread>

#include "drive/udp_robot.hpp"

namespace treeline::drive {
namespace {

TEST(RobotPacket, ReadsWhatWasWritten) {
  PacketBytes bytes{};
  const std::array<double, 3> numbers = {-1.5, 5e-324, 1e300};
  const PacketHead written{PacketKind::state, 0x0123456789abcdef, 7, 6};
  const std::size_t size = write_packet(written, numbers.data(), 3, bytes);
  EXPECT_EQ(size, 56U);
  EXPECT_EQ(bytes[4], 1);     // version, little-endian
  EXPECT_EQ(bytes[8], 0xef);  // the checksum's lowest byte
  PacketHead head;
  std::array<double, 3> read{};
  ASSERT_TRUE(read_packet(bytes.data(), size, 3, head, read.data()));
  EXPECT_EQ(read, numbers);
  EXPECT_EQ(head.robot, written.robot);
  EXPECT_EQ(head.sequence, 7U);
  EXPECT_EQ(head.answers, 6U);
  for (std::size_t other = 0; other < 120; ++other) {
    EXPECT_EQ(read_packet(bytes.data(), other, 3, head, read.data()), other == size) << other;
  }
  for (const std::size_t at : {0U, 3U, 4U, 5U}) {
    PacketBytes changed = bytes;
    changed[at] ^= 0x40;
    EXPECT_FALSE(read_packet(changed.data(), size, 3, head, read.data())) << at;
  }
}

/// A robot of one joint whose position is the sum of what it is commanded.
class UdpTest : public ::testing::Test {
 protected:
  void SetUp() override {
    address_ = "127.0.0.1:" + std::to_string(20000 + ::getpid() % 20000);
    side_.address = address_;
    side_.checksum = "00000000000000aa";
    side_.nq = side_.nv = 1;
    side_.advance = [this](const double* tau, double) {
      if (tau == nullptr) {
        ++braked_;
      } else {
        last_ = tau[0];
      }
    };
    side_.read = [this](double* state) {
      state[0] = last_;
      state[1] = 0.0;
    };
    thread_ = std::thread([this] { error_ = run_robot_side(side_, ended_); });
  }
  void TearDown() override {
    ended_ = true;
    thread_.join();
    EXPECT_EQ(error_, "");
  }
  std::unique_ptr<UdpRobot> open(const std::string& checksum) {
    std::string error;
    return UdpRobot::open(address_, checksum, 1, 1, error);
  }

  RobotSide side_;
  std::string address_, error_;
  std::atomic<bool> ended_{false};
  std::atomic<double> last_{0.0};
  std::atomic<int> braked_{0};
  std::thread thread_;
};

TEST_F(UdpTest, ObeysAndBrakesWhenLeftAlone) {
  const auto robot = open("00000000000000aa");
  ASSERT_NE(robot, nullptr);
  ASSERT_TRUE(robot->wait_for_state(5.0));
  EXPECT_EQ(last_, 0.0);  // a request is no command
  const ExternalRobot functions = robot->functions();
  double q = 0.0;
  double qd = 0.0;
  for (int i = 0; i < 1000 && q != 4.25; ++i) {
    const double tau = 4.25;
    functions.write(functions.self, &tau);
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    if (functions.connected(functions.self)) functions.read(functions.self, &q, &qd);
  }
  EXPECT_EQ(q, 4.25);
  const int before = braked_;
  for (int i = 0; i < 1000 && braked_ < before + 5; ++i) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  EXPECT_GE(braked_, before + 5);
}

TEST_F(UdpTest, IgnoresWhoDrivesAnotherRobot) {
  const auto stranger = open("00000000000000ab");
  ASSERT_NE(stranger, nullptr);
  EXPECT_FALSE(stranger->wait_for_state(0.2));
  const double tau = 9.0;
  const ExternalRobot functions = stranger->functions();
  for (int i = 0; i < 20; ++i) functions.write(functions.self, &tau);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(last_, 0.0);
  EXPECT_FALSE(functions.connected(functions.self));
  const auto robot = open("00000000000000aa");
  EXPECT_TRUE(robot->wait_for_state(5.0));
}

TEST(UdpRobot, SaysWhatAnAddressIs) {
  for (const char* address :
       {"", "7000", "host:7000", "127.0.0.1:", "127.0.0.1:70000", "1.2.3:5"}) {
    std::string error;
    EXPECT_EQ(UdpRobot::open(address, "aa", 1, 1, error), nullptr) << address;
    EXPECT_NE(error.find("HOST:PORT"), std::string::npos) << address;
  }
}

}  // namespace
}  // namespace treeline::drive
