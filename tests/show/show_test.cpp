// Would catch: a control loop whose motion, torques and numbers do not reach the drive, or that
// gets other goals than the drive sends; a loop that goes on after STOP, or in silence; one that
// obeys a stranger, another drive beside its own, or what was recorded; a drive that does not find
// its loop again.
#include "show/show.h"

#include <gtest/gtest.h>

#include <array>
#include <string>
#include <thread>

#include "drive/udp_robot.hpp"
#include "loop_in_c.h"

namespace treeline::drive {
namespace {

using namespace std::chrono_literals;

constexpr const char* kSecret = "0123456789abcdef0123456789abcdef";
/// mode, control, q, qd and a point.
using Goal = std::array<double, 13>;
constexpr Goal kGoal = {1, 0, 0.1, 0.2, 0.3, 0.4, 1, 2, 3, 0, 0, 0, 1};

/// A loop, and drives that lead it, in turn in one thread.
class ShowTest : public ::testing::Test {
 protected:
  void SetUp() override { begin(""); }
  void TearDown() override { treeline_show_close(&show_); }
  void begin(const std::string& secret) {
    port_ = 20000 + ::getpid() % 20000;
    treeline_show_close(&show_);
    ASSERT_EQ(treeline_show_open(&show_, "127.0.0.1", port_, 2, 2, secret.c_str()), 0);
  }
  std::unique_ptr<UdpRobot> open(const std::string& secret = "") const {
    std::string error;
    auto drive = UdpRobot::open(
        {"127.0.0.1:" + std::to_string(port_), "00000000000000aa", secret, true}, 2, 2, 1, error);
    EXPECT_NE(drive, nullptr) << error;
    return drive;
  }
  void step() {
    const double q[2] = {1.5, -2.5};
    step_loop_in_c(&show_, q, &loop_);
    std::this_thread::sleep_for(1ms);
  }
  /// A cycle of both; whether the drive hears the loop.
  bool lead(const ExternalRobot& drive, const Goal& goal = kGoal) {
    drive.lead(drive.self, goal.data());
    step();
    return drive.connected(drive.self);
  }
  /// Leads until the loop is enabled; whether it is.
  bool enable(const ExternalRobot& drive) {
    for (int i = 0; i < 100 && loop_.enabled == 0; ++i) lead(drive);
    return loop_.enabled == 1;
  }

  TreelineShow show_{.socket = -1};
  int port_ = 0;
  LoopInC loop_{};
};

TEST_F(ShowTest, ShowsAMotionAndGetsGoals) {
  const auto robot = open();
  const ExternalRobot drive = robot->functions();
  EXPECT_TRUE(drive.has_controller());
  ASSERT_TRUE(enable(drive));
  ASSERT_TRUE(lead(drive));
  std::array<double, 2> q{};
  std::array<double, 2> qd{};
  std::array<double, 2> tau{};
  Shown shown;
  drive.read(drive.self, q.data(), qd.data());
  drive.show(drive.self, tau.data(), shown);
  EXPECT_EQ(q, (std::array{1.5, -2.5}));
  EXPECT_EQ(qd, (std::array{0.5, -0.5}));
  EXPECT_EQ(tau, (std::array{7.0, 8.0}));
  ASSERT_EQ(shown.count, 2);
  EXPECT_STREQ(shown.numbers[0].name, "error");
  EXPECT_EQ(shown.numbers[0].value, 0.25);
  EXPECT_EQ(std::string(shown.numbers[1].name, 16), "sixteen letters!");
  EXPECT_EQ(shown.numbers[1].value, -1.0);
  EXPECT_EQ(loop_.mode, 1);
  EXPECT_EQ(loop_.q[1], 0.2);
  EXPECT_EQ(loop_.qd[0], 0.3);
  EXPECT_EQ(loop_.point_count, 1);
  EXPECT_EQ(loop_.point[2], 3.0);
}

TEST_F(ShowTest, StopsAtOnceAndInSilence) {
  const auto robot = open();
  const ExternalRobot drive = robot->functions();
  ASSERT_TRUE(enable(drive));
  Goal stop = kGoal;
  stop[0] = 3;
  lead(drive, stop);
  EXPECT_EQ(loop_.enabled, 0);
  EXPECT_EQ(loop_.mode, 3);
  ASSERT_TRUE(enable(drive));
  std::this_thread::sleep_for(101ms);
  step();
  EXPECT_EQ(loop_.enabled, 0);
}

TEST_F(ShowTest, FollowsOneDriveAtATime) {
  const auto robot = open();
  const auto other = open();
  ASSERT_TRUE(enable(robot->functions()));
  Goal elsewhere = kGoal;
  elsewhere[2] = 9;
  for (int i = 0; i < 20; ++i) {
    EXPECT_FALSE(lead(other->functions(), elsewhere));
    lead(robot->functions());
  }
  EXPECT_EQ(loop_.q[0], 0.1);
  std::this_thread::sleep_for(1001ms);
  loop_.enabled = 0;
  EXPECT_TRUE(enable(other->functions())) << "the first one has gone";
}

TEST_F(ShowTest, IsFoundAgain) {
  const auto robot = open();
  const ExternalRobot drive = robot->functions();
  ASSERT_TRUE(enable(drive));
  begin("");  // as another process
  std::this_thread::sleep_for(501ms);
  EXPECT_FALSE(drive.connected(drive.self));
  loop_.enabled = 0;
  EXPECT_TRUE(enable(drive));
  EXPECT_TRUE(lead(drive));
}

TEST_F(ShowTest, HearsNobodyWithoutTheSecret) {
  begin(kSecret);
  for (const char* secret : {"", "0123456789abcdef0123456789abcdee"}) {
    const auto stranger = open(secret);
    for (int i = 0; i < 20; ++i) EXPECT_FALSE(lead(stranger->functions()));
  }
  const auto robot = open(kSecret);
  EXPECT_TRUE(enable(robot->functions()));
}

/// A drive whose packets a test makes.
class MadeUpDrive {
 public:
  explicit MadeUpDrive(int port) : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    to.sin_port = htons(static_cast<std::uint16_t>(port));
    EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof(to)), 0);
  }
  ~MadeUpDrive() { ::close(socket_); }
  MadeUpDrive(const MadeUpDrive&) = delete;
  MadeUpDrive& operator=(const MadeUpDrive&) = delete;

  void send(const TreelinePacketHead& head, const Goal& goal, std::size_t count) const {
    PacketBytes bytes{};
    const std::size_t size = treeline_packet_write(&head, goal.data(), count, bytes.data());
    EXPECT_EQ(::send(socket_, bytes.data(), size, 0), static_cast<ssize_t>(size));
  }

 private:
  int socket_;
};

TEST_F(ShowTest, ObeysNoPacketThatIsOldOrOdd) {
  const MadeUpDrive drive(port_);
  const auto goal = [&](std::uint64_t sequence, std::uint64_t run, double q, double mode = 1,
                        std::size_t count = 13) {
    Goal numbers = kGoal;
    numbers[0] = mode;
    numbers[2] = q;
    drive.send({treeline_packet_goal, 0xaa, sequence, 0, run}, numbers, count);
    step();
  };
  drive.send({treeline_packet_request, 0xaa, 1, 0, 0}, kGoal, 0);
  step();
  goal(2, show_.run, 5.0);
  ASSERT_EQ(loop_.q[0], 5.0);
  goal(2, show_.run, 6.0);
  goal(1, show_.run, 6.0);
  goal(3, show_.run + 1, 6.0);  // of another run
  goal(3, show_.run, 6.0, -1);
  goal(3, show_.run, 6.0, 1e300);
  goal(3, show_.run, 6.0, 1, 12);  // half a point
  goal(3, show_.run, 6.0, 1, 5);
  drive.send({treeline_packet_command, 0xaa, 3, 0, show_.run}, {1, 0, 6.0}, 13);
  step();
  EXPECT_EQ(loop_.q[0], 5.0);
  goal(3, show_.run, 7.0);
  EXPECT_EQ(loop_.q[0], 7.0);
}

}  // namespace
}  // namespace treeline::drive
