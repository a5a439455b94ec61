#include "drive/udp_robot.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <thread>

#include "drive/machine_time.hpp"
#include "drive/udp_socket.hpp"

namespace treeline::drive {

bool is_udp_address(const std::string& text) {
  sockaddr_in address{};
  return udp::read_address(text, address);
}

std::unique_ptr<UdpRobot> UdpRobot::open(const RobotAddress& address, int nq, int nv,
                                         std::string& error) {
  sockaddr_in to{};
  if (!udp::read_address(address.address, to)) {
    error = "expected HOST:PORT with a number as HOST, as in 192.168.1.7:7000";
    return nullptr;
  }
  if (nq + nv > static_cast<int>(kMostPacketNumbers)) {
    error = "the robot has too many joints for a packet";
    return nullptr;
  }
  std::unique_ptr<UdpRobot> robot(new UdpRobot(address.secret));
  robot->socket_ = udp::open_udp_socket();
  if (robot->socket_ < 0 ||
      connect(robot->socket_, reinterpret_cast<const sockaddr*>(&to), sizeof(to)) != 0) {
    error = std::strerror(errno);
    return nullptr;
  }
  robot->robot_ = udp::checksum_number(address.checksum);
  robot->nq_ = nq;
  robot->nv_ = nv;
  robot->state_.resize(static_cast<std::size_t>(nq + nv));
  robot->received_ = robot->state_;
  // Numbers of a program that is started again have to be beyond those of the last run.
  robot->sent_ = static_cast<std::uint64_t>(std::chrono::duration_cast<std::chrono::microseconds>(
                                                std::chrono::system_clock::now().time_since_epoch())
                                                .count());
  robot->first_ = robot->sent_ + 1;
  return robot;
}

UdpRobot::~UdpRobot() {
  if (socket_ >= 0) close(socket_);
}

void UdpRobot::receive() noexcept {
  constexpr int kMostAtOnce = 64;  // a flood is not to hold the cycle
  for (int i = 0; i < kMostAtOnce; ++i) {
    const ssize_t size = recv(socket_, bytes_.data(), bytes_.size(), 0);
    if (size < 0) return;
    const auto opened = seal_.open(bytes_, static_cast<std::size_t>(size));
    PacketHead head;
    if (!opened) {
      ++counts_.foreign;
    } else if (!read_packet(bytes_.data(), *opened, received_.size(), head, received_.data()) ||
               head.kind != PacketKind::state || !udp::all_finite(received_)) {
      ++counts_.malformed;
    } else {
      take(head);
    }
  }
}

/// Takes the state that was received, if it is of this robot, later than the last one, and an
/// answer to this object: none that was recorded before.
void UdpRobot::take(const PacketHead& head) noexcept {
  const bool first = heard_ < 0.0;
  const bool answers = head.answers >= first_ && head.answers <= sent_;
  if (head.robot != robot_ || !answers || (!first && head.run != run_)) {
    ++counts_.foreign;
  } else if (!first && !is_next(head.sequence, newest_)) {
    ++counts_.repeated;
  } else {
    newest_ = head.sequence;
    run_ = head.run;
    heard_ = machine_time();
    std::copy(received_.begin(), received_.end(), state_.begin());
  }
}

void UdpRobot::send(PacketKind kind, const double* tau, int count) noexcept {
  const PacketHead head{kind, robot_, ++sent_, 0, kind == PacketKind::command ? run_ : 0};
  const std::size_t size =
      seal_.close(bytes_, write_packet(head, tau, static_cast<std::size_t>(count), bytes_));
  (void)::send(socket_, bytes_.data(), size, MSG_NOSIGNAL);  // the robot's silence tells of errors
}

bool UdpRobot::wait_for_state(double seconds) {
  for (const double end = machine_time() + seconds; machine_time() < end && heard_ < 0.0;) {
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
    return machine_time() - robot.heard_ < kSilence;
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

}  // namespace treeline::drive
