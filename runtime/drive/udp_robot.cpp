#include "drive/udp_robot.hpp"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstring>
#include <thread>

namespace treeline::drive {
namespace {

double now() noexcept {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// The 16 hexadecimal digits of a robot's checksum as a number; others count as 0.
std::uint64_t checksum_number(const std::string& digits) {
  std::uint64_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number, 16);
  return number;
}

bool read_address(const std::string& text, sockaddr_in& address) {
  const std::size_t colon = text.rfind(':');
  if (colon == std::string::npos) return false;
  const std::string host = text.substr(0, colon);
  const char* const begin = text.data() + colon + 1;
  const char* const end = text.data() + text.size();
  std::uint16_t port = 0;
  const auto [stopped, error] = std::from_chars(begin, end, port);
  address = {};
  address.sin_family = AF_INET;
  address.sin_port = htons(port);
  return error == std::errc{} && stopped == end &&
         inet_pton(AF_INET, host.c_str(), &address.sin_addr) == 1;
}

int open_socket() {
  return socket(AF_INET, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0);
}

bool all_finite(const std::vector<double>& numbers) noexcept {
  return std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); });
}

}  // namespace

bool is_udp_address(const std::string& text) {
  sockaddr_in address{};
  return read_address(text, address);
}

std::unique_ptr<UdpRobot> UdpRobot::open(const std::string& address, const std::string& checksum,
                                         int nq, int nv, std::string& error) {
  sockaddr_in to{};
  if (!read_address(address, to)) {
    error = "expected HOST:PORT with a number as HOST, as in 192.168.1.7:7000";
    return nullptr;
  }
  if (nq + nv > static_cast<int>(kMostPacketNumbers)) {
    error = "the robot has too many joints for a packet";
    return nullptr;
  }
  std::unique_ptr<UdpRobot> robot(new UdpRobot);
  robot->socket_ = open_socket();
  if (robot->socket_ < 0 ||
      connect(robot->socket_, reinterpret_cast<const sockaddr*>(&to), sizeof(to)) != 0) {
    error = std::strerror(errno);
    return nullptr;
  }
  robot->robot_ = checksum_number(checksum);
  robot->nq_ = nq;
  robot->nv_ = nv;
  robot->state_.resize(static_cast<std::size_t>(nq + nv));
  robot->received_ = robot->state_;
  // Numbers of a program that is started again have to be beyond those of the last run.
  robot->sent_ = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(
                                                std::chrono::system_clock::now().time_since_epoch())
                                                .count());
  return robot;
}

UdpRobot::~UdpRobot() {
  if (socket_ >= 0) close(socket_);
}

void UdpRobot::receive() noexcept {
  for (;;) {
    const ssize_t size = recv(socket_, bytes_.data(), bytes_.size(), 0);
    if (size < 0) return;
    PacketHead head;
    if (!read_packet(bytes_.data(), static_cast<std::size_t>(size), received_.size(), head,
                     received_.data()) ||
        head.kind != PacketKind::state || !all_finite(received_)) {
      ++counts_.malformed;
    } else if (head.robot != robot_) {
      ++counts_.foreign;
    } else if (heard_ >= 0.0 && head.sequence <= newest_) {
      ++counts_.repeated;
    } else {
      newest_ = head.sequence;
      heard_ = now();
      std::copy(received_.begin(), received_.end(), state_.begin());
    }
  }
}

void UdpRobot::send(PacketKind kind, const double* tau, int count) noexcept {
  const PacketHead head{kind, robot_, ++sent_, 0};
  const std::size_t size = write_packet(head, tau, static_cast<std::size_t>(count), bytes_);
  (void)::send(socket_, bytes_.data(), size, MSG_NOSIGNAL);  // the robot's silence tells of errors
}

bool UdpRobot::wait_for_state(double seconds) {
  for (const double end = now() + seconds; now() < end && heard_ < 0.0;) {
    send(PacketKind::request, nullptr, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    receive();
  }
  return heard_ >= 0.0;
}

ExternalRobot UdpRobot::functions() {
  ExternalRobot functions;
  functions.self = this;
  functions.connected = [](void* self) {
    auto& robot = *static_cast<UdpRobot*>(self);
    robot.receive();
    return now() - robot.heard_ < kSilence;
  };
  functions.read = [](void* self, double* q, double* qd) {
    const auto& robot = *static_cast<UdpRobot*>(self);
    std::copy_n(robot.state_.data(), robot.nq_, q);
    std::copy_n(robot.state_.data() + robot.nq_, robot.nv_, qd);
  };
  functions.write = [](void* self, const double* tau) {
    auto& robot = *static_cast<UdpRobot*>(self);
    robot.send(PacketKind::command, tau, robot.nv_);
  };
  return functions;
}

namespace {

/// What the robot's side knows of the one who commands it.
struct Commander {
  sockaddr_in address{};
  std::uint64_t newest = 0;
  double heard = -1.0;
  double commanded = -1.0;
};

bool same(const sockaddr_in& a, const sockaddr_in& b) {
  return a.sin_addr.s_addr == b.sin_addr.s_addr && a.sin_port == b.sin_port;
}

/// Takes the newest command that has come.
void receive_commands(int socket, std::uint64_t robot, Commander& commander,
                      std::vector<double>& tau, PacketBytes& bytes) {
  constexpr double kRelieved = 1.0;  // s
  std::vector<double> numbers = tau;
  for (;;) {
    sockaddr_in from{};
    socklen_t length = sizeof(from);
    const ssize_t size = recvfrom(socket, bytes.data(), bytes.size(), 0,
                                  reinterpret_cast<sockaddr*>(&from), &length);
    if (size < 0) return;
    PacketHead head;
    const auto count = static_cast<std::size_t>(size);
    const bool asks =
        read_packet(bytes.data(), count, 0, head, nullptr) && head.kind == PacketKind::request;
    const bool commands = !asks &&
                          read_packet(bytes.data(), count, numbers.size(), head, numbers.data()) &&
                          head.kind == PacketKind::command && all_finite(numbers);
    const bool good = (asks || commands) && head.robot == robot;
    const bool known = commander.heard >= 0.0 && now() - commander.heard < kRelieved;
    const bool next =
        known ? same(from, commander.address) && head.sequence > commander.newest : true;
    if (!good || !next) continue;
    commander = {from, head.sequence, now(), commands ? now() : commander.commanded};
    if (commands) tau = numbers;
  }
}

}  // namespace

std::string run_robot_side(const RobotSide& side, const std::atomic<bool>& ended) {
  constexpr double kBrakes = 0.05;  // s without a command
  sockaddr_in address{};
  if (!read_address(side.address, address)) return "expected HOST:PORT with a number as HOST";
  const int socket = open_socket();
  if (socket < 0 ||
      bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    const std::string error = std::strerror(errno);
    if (socket >= 0) close(socket);
    return error;
  }
  const std::uint64_t robot = checksum_number(side.checksum);
  const auto period = std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 / side.rate));
  std::vector<double> tau(static_cast<std::size_t>(side.nv));
  std::vector<double> state(static_cast<std::size_t>(side.nq + side.nv));
  PacketBytes bytes{};
  Commander commander;
  std::uint64_t sent = 0;
  for (auto tick = std::chrono::steady_clock::now(); !ended; tick += period) {
    std::this_thread::sleep_until(tick);
    receive_commands(socket, robot, commander, tau, bytes);
    const bool commanded = commander.commanded >= 0.0 && now() - commander.commanded < kBrakes;
    side.advance(commanded ? tau.data() : nullptr, 1.0 / side.rate);
    if (commander.heard < 0.0) continue;
    side.read(state.data());
    const PacketHead head{PacketKind::state, robot, ++sent, commander.newest};
    const std::size_t size = write_packet(head, state.data(), state.size(), bytes);
    (void)sendto(socket, bytes.data(), size, MSG_NOSIGNAL,  // a lost packet is followed by the next
                 reinterpret_cast<const sockaddr*>(&commander.address), sizeof(sockaddr_in));
  }
  close(socket);
  return {};
}

}  // namespace treeline::drive
