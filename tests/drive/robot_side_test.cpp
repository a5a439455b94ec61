// Would catch: a robot that is taken for another, obeys old commands, or does not brake when it is
// left alone; one that strangers command, lock, or end by a number; a torque beyond the limits that
// is obeyed; a secret that proves nothing.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <limits>
#include <thread>

#include "drive/udp_robot.hpp"

namespace treeline::drive {
namespace {

/// Somebody who sends packets as he likes.
class Stranger {
 public:
  explicit Stranger(const std::string& address) : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in to{};
    to.sin_family = AF_INET;
    to.sin_port = htons(static_cast<std::uint16_t>(std::stoi(address.substr(10))));
    to.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const timeval patience{5, 0};
    ::setsockopt(socket_, SOL_SOCKET, SO_RCVTIMEO, &patience, sizeof(patience));
    EXPECT_EQ(::connect(socket_, reinterpret_cast<sockaddr*>(&to), sizeof(to)), 0);
  }
  ~Stranger() { ::close(socket_); }
  Stranger(const Stranger&) = delete;
  Stranger& operator=(const Stranger&) = delete;

  void send(const TreelinePacketHead& head, const double* tau,
            const TreelinePacketSeal& seal = make_seal("")) {
    PacketBytes bytes{};
    const std::size_t count = head.kind == treeline_packet_command ? 1 : 0;
    const std::size_t size = treeline_seal_close(
        &seal, bytes.data(), treeline_packet_write(&head, tau, count, bytes.data()));
    (void)::send(socket_, bytes.data(), size, 0);
  }
  /// The head of the next state; kind command: none came.
  TreelinePacketHead receive(const TreelinePacketSeal& seal = make_seal("")) {
    PacketBytes bytes{};
    TreelinePacketHead head;
    const ssize_t size = ::recv(socket_, bytes.data(), bytes.size(), 0);
    const std::size_t opened =
        size < 0 ? 0 : treeline_seal_open(&seal, bytes.data(), static_cast<std::size_t>(size));
    std::array<double, 2> state{};
    (void)treeline_packet_read(bytes.data(), opened, 2, &head, state.data());
    return head;
  }

 private:
  int socket_;
};

/// A robot of one joint whose position is what it is commanded.
class UdpTest : public ::testing::Test {
 protected:
  void SetUp() override { begin(""); }
  void begin(const std::string& secret) {
    address_ = "127.0.0.1:" + std::to_string(20000 + ::getpid() % 20000);
    side_.address = {address_, "00000000000000aa", secret};
    side_.nq = 1;
    side_.torque = {50.0};
    side_.advance = [this](const double* tau, double) {
      ++cycles_;
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
  std::unique_ptr<UdpRobot> open(const std::string& checksum, const std::string& secret = "") {
    std::string error;
    return UdpRobot::open({address_, checksum, secret}, 1, 1, 0, error);
  }
  /// Lets cycles of the robot pass.
  void pass(int cycles) const {
    for (const int end = cycles_ + cycles; cycles_ < end;) ::usleep(500);
  }

  RobotSide side_;
  std::string address_, error_;
  std::atomic<bool> ended_{false};
  std::atomic<double> last_{0.0};
  std::atomic<int> braked_{0}, cycles_{0};
  std::thread thread_;
};

class SecretUdpTest : public UdpTest {
 protected:
  static constexpr const char* kSecret = "0123456789abcdef0123456789abcdef";
  void SetUp() override { begin(kSecret); }
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

TEST_F(UdpTest, CutsTorquesToTheLimits) {
  const auto robot = open("00000000000000aa");
  ASSERT_TRUE(robot->wait_for_state(5.0));
  const ExternalRobot functions = robot->functions();
  for (const double tau : {1e6, -1e6, 49.0}) {
    const double cut = std::clamp(tau, -50.0, 50.0);
    for (int i = 0; i < 1000 && last_ != cut; ++i) {
      functions.write(functions.self, &tau);
      pass(1);
    }
    EXPECT_EQ(last_, cut);
  }
}

// Would catch: a torque of NaN that passes a clamp, and makes the robot's state NaN until somebody
// starts it again.
TEST_F(UdpTest, ObeysNoNumberThatIsNotFinite) {
  Stranger stranger(address_);
  TreelinePacketHead state;
  std::uint64_t sent = 0;
  for (int i = 0; i < 1000 && state.kind != treeline_packet_state; ++i) {
    pass(1);  // until it listens
    stranger.send({treeline_packet_request, 0xaa, ++sent, 0, 0}, nullptr);
    state = stranger.receive();
  }
  ASSERT_EQ(state.kind, treeline_packet_state);
  const auto command = [&](double tau) {
    stranger.send({treeline_packet_command, 0xaa, ++sent, 0, state.run}, &tau);
    pass(1);
  };
  for (int i = 0; i < 1000 && last_ != 7.0; ++i) command(7.0);
  ASSERT_EQ(last_, 7.0);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  for (const double odd : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -kInfinity}) {
    const int before = braked_;
    for (int i = 0; i < 5; ++i) command(odd);
    EXPECT_EQ(last_, 7.0) << odd;
    // Nor do they keep the robot from braking, as commands would.
    for (int i = 0; i < 1000 && braked_ < before + 5; ++i) command(odd);
    EXPECT_GE(braked_, before + 5) << odd;
    for (int i = 0; i < 1000 && last_ != 7.0; ++i) command(7.0);
  }
  for (int i = 0; i < 1000 && last_ != 8.0; ++i) command(8.0);
  EXPECT_EQ(last_, 8.0);
}

// A packet that was made without asking the robot is of no run of its process.
TEST_F(UdpTest, ObeysNoPacketFromTheBlue) {
  Stranger stranger(address_);
  const double tau = 40.0;
  for (std::uint64_t i = 1; i < 20; ++i)
    stranger.send({treeline_packet_command, 0xaa, i, 0, i}, &tau);
  pass(20);
  EXPECT_EQ(last_, 0.0);
}

// Somebody asks again and again while another commands.
TEST_F(UdpTest, RequestsLockNobodyOut) {
  Stranger stranger(address_);
  std::uint64_t asked = 0;
  stranger.send({treeline_packet_request, 0xaa, ++asked, 0, 0}, nullptr);
  const auto robot = open("00000000000000aa");
  ASSERT_TRUE(robot->wait_for_state(5.0));
  const ExternalRobot functions = robot->functions();
  const double tau = 5.0;
  bool connected = true;
  for (int i = 0; i < 300; ++i) {
    stranger.send({treeline_packet_request, 0xaa, ++asked, 0, 0}, nullptr);
    functions.write(functions.self, &tau);
    pass(1);
    connected = connected && functions.connected(functions.self);
  }
  EXPECT_TRUE(connected);
  EXPECT_EQ(last_, 5.0);
}

// Whoever commands is not relieved by a stranger who knows the run.
TEST_F(UdpTest, ObeysOneAtATime) {
  const auto robot = open("00000000000000aa");
  ASSERT_TRUE(robot->wait_for_state(5.0));
  const ExternalRobot functions = robot->functions();
  Stranger stranger(address_);
  stranger.send({treeline_packet_request, 0xaa, 1, 0, 0}, nullptr);
  const TreelinePacketHead state = stranger.receive();
  ASSERT_EQ(state.kind, treeline_packet_state);
  const double tau = 5.0;
  const double other = 6.0;
  for (std::uint64_t i = 0; i < 50; ++i) {
    functions.write(functions.self, &tau);
    pass(1);
    stranger.send({treeline_packet_command, 0xaa, ~std::uint64_t{0} - i, 0, state.run}, &other);
  }
  pass(2);
  EXPECT_EQ(last_, 5.0);
}

/// A robot whose states a test makes.
class MadeUpRobot {
 public:
  MadeUpRobot() : socket_(::socket(AF_INET, SOCK_DGRAM, 0)) {
    sockaddr_in own{};
    own.sin_family = AF_INET;
    own.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&own), sizeof(own)), 0);
    socklen_t length = sizeof(own);
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&own), &length);
    port_ = ntohs(own.sin_port);
  }
  ~MadeUpRobot() { ::close(socket_); }
  MadeUpRobot(const MadeUpRobot&) = delete;
  MadeUpRobot& operator=(const MadeUpRobot&) = delete;

  std::string address() const { return "127.0.0.1:" + std::to_string(port_); }
  /// Waits for a request, and returns its number.
  std::uint64_t hear() {
    PacketBytes bytes{};
    TreelinePacketHead head;
    socklen_t length = sizeof(from_);
    const ssize_t size = ::recvfrom(socket_, bytes.data(), bytes.size(), 0,
                                    reinterpret_cast<sockaddr*>(&from_), &length);
    (void)treeline_packet_read(bytes.data(), static_cast<std::size_t>(size), 0, &head, nullptr);
    return head.sequence;
  }
  void send(std::uint64_t sequence, std::uint64_t answers, std::uint64_t run, double q) {
    PacketBytes bytes{};
    const std::array<double, 2> state = {q, 0.0};
    const TreelinePacketHead head{treeline_packet_state, 0xaa, sequence, answers, run};
    const std::size_t size = treeline_packet_write(&head, state.data(), 2, bytes.data());
    ::sendto(socket_, bytes.data(), size, 0, reinterpret_cast<sockaddr*>(&from_), sizeof(from_));
  }

 private:
  int socket_;
  std::uint16_t port_ = 0;
  sockaddr_in from_{};
};

TEST(UdpRobot, NoNumberOfAStateEndsTheDrive) {
  MadeUpRobot side;
  std::string error;
  const auto robot = UdpRobot::open({side.address(), "00000000000000aa", ""}, 1, 1, 0, error);
  ASSERT_NE(robot, nullptr) << error;
  std::uint64_t asked = 0;
  std::thread answers([&] {
    asked = side.hear();
    side.send(90, asked - 1, 5, 9.0);  // recorded earlier: it answers nobody here
    side.send(100, asked, 5, 1.0);
  });
  EXPECT_TRUE(robot->wait_for_state(5.0));
  answers.join();
  const ExternalRobot functions = robot->functions();
  side.send(~std::uint64_t{0}, asked, 5, 2.0);
  side.send(101, asked, 6, 3.0);  // of another run
  side.send(101, asked, 5, 4.0);
  double q = 0.0;
  double qd = 0.0;
  for (int i = 0; i < 1000 && q != 4.0; ++i) {
    ::usleep(1000);
    (void)functions.connected(functions.self);
    functions.read(functions.self, &q, &qd);
    EXPECT_TRUE(q == 1.0 || q == 4.0) << q;
  }
  EXPECT_EQ(q, 4.0);
}

TEST_F(SecretUdpTest, HearsOnlyWhoKnowsTheSecret) {
  for (const char* secret : {"", "0123456789abcdef0123456789abcdee"}) {
    EXPECT_FALSE(open("00000000000000aa", secret)->wait_for_state(0.2)) << secret;
  }
  const auto robot = open("00000000000000aa", kSecret);
  ASSERT_TRUE(robot->wait_for_state(5.0));
  const ExternalRobot functions = robot->functions();
  const double tau = 5.0;
  for (int i = 0; i < 1000 && last_ != 5.0; ++i) {
    functions.write(functions.self, &tau);
    pass(1);
  }
  EXPECT_EQ(last_, 5.0);
}

// Packets that somebody has recorded on their way, sent again from where they came.
TEST_F(SecretUdpTest, ObeysNothingTwice) {
  const TreelinePacketSeal seal = make_seal(kSecret);
  Stranger drive(address_);
  TreelinePacketHead state;
  for (std::uint64_t i = 1000; i < 1100 && state.kind != treeline_packet_state; ++i) {
    drive.send({treeline_packet_request, 0xaa, i, 0, 0}, nullptr, seal);
    pass(2);
    state = drive.receive(seal);
  }
  ASSERT_EQ(state.kind, treeline_packet_state);
  const double tau = 5.0;
  const TreelinePacketHead command{treeline_packet_command, 0xaa, 2001, 0, state.run};
  drive.send(command, &tau, seal);
  while (last_ != 5.0) pass(1);
  const int braked = braked_;
  while (braked_ == braked) pass(1);
  last_ = 0.0;
  for (int i = 0; i < 60; ++i) {  // beyond the second after which others may command
    drive.send(command, &tau, seal);
    drive.send({treeline_packet_command, 0xaa, 2002, 0, state.run}, &tau);
    drive.send({treeline_packet_command, 0xaa, 2002, 0, state.run + 1}, &tau, seal);
    pass(20);
  }
  EXPECT_EQ(last_, 0.0);
  drive.send({treeline_packet_command, 0xaa, 2002, 0, state.run}, &tau, seal);
  while (last_ != 5.0) pass(1);
}

TEST(UdpRobot, SaysWhatAnAddressIs) {
  for (const char* address :
       {"", "7000", "host:7000", "127.0.0.1:", "127.0.0.1:70000", "1.2.3:5"}) {
    std::string error;
    EXPECT_EQ(UdpRobot::open({address, "aa", ""}, 1, 1, 0, error), nullptr) << address;
    EXPECT_NE(error.find("HOST:PORT"), std::string::npos) << address;
  }
}

}  // namespace
}  // namespace treeline::drive
