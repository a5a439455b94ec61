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

TreelinePacketSeal make_seal(const std::string& secret) {
  TreelinePacketSeal seal;
  treeline_seal_begin(&seal, secret.c_str());
  return seal;
}

UdpRobot::UdpRobot(const RobotAddress& address)
    : robot_(udp::checksum_number(address.checksum)),
      has_controller_(address.has_controller),
      seal_(make_seal(address.secret)) {}

std::unique_ptr<UdpRobot> UdpRobot::open(const RobotAddress& address, int nq, int nv, int points,
                                         std::string& error) {
  sockaddr_in to{};
  if (!udp::read_address(address.address, to)) {
    error = "expected HOST:PORT with a number as HOST, as in 192.168.1.7:7000";
    return nullptr;
  }
  std::unique_ptr<UdpRobot> robot(new UdpRobot(address));
  robot->nq_ = static_cast<std::size_t>(nq);
  robot->nv_ = static_cast<std::size_t>(nv);
  robot->points_ = static_cast<std::size_t>(points);
  robot->state_.resize(robot->nq_ + robot->nv_ +
                       (address.has_controller ? robot->nv_ + 3 * treeline_named_numbers : 0));
  robot->received_ = robot->state_;
  if (std::max(robot->state_.size(), robot->goal_size()) > treeline_packet_numbers) {
    error = "the robot has too many joints for a packet";
    return nullptr;
  }
  robot->socket_ = udp::open_udp_socket();
  if (robot->socket_ < 0 ||
      connect(robot->socket_, reinterpret_cast<const sockaddr*>(&to), sizeof(to)) != 0) {
    error = std::strerror(errno);
    return nullptr;
  }
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

/// A controller moves its robot by itself: one that is held up for a moment need not be stopped.
bool UdpRobot::is_heard() const noexcept {
  constexpr double kSilenceOfController = 0.5;  // s
  const double silence = has_controller_ ? kSilenceOfController : kSilence;
  return heard_ >= 0.0 && machine_time() - heard_ < silence;
}

void UdpRobot::receive() noexcept {
  constexpr int kMostAtOnce = 64;  // a flood is not to hold the cycle
  for (int i = 0; i < kMostAtOnce; ++i) {
    const ssize_t came = recv(socket_, bytes_.data(), bytes_.size(), 0);
    if (came < 0) return;
    const std::size_t size =
        treeline_seal_open(&seal_, bytes_.data(), static_cast<std::size_t>(came));
    TreelinePacketHead head;
    if (size == 0) {
      ++counts_.foreign;
    } else if (!read(size, head)) {
      ++counts_.malformed;
    } else {
      take(head);
    }
  }
}

/// Reads a packet of `size` bytes into `received_`. False: it is no state of this robot.
bool UdpRobot::read(std::size_t size, TreelinePacketHead& head) noexcept {
  const std::size_t count = treeline_packet_count(size);
  const std::size_t plain = nq_ + nv_ + (has_controller_ ? nv_ : 0);
  if (count < plain || count > received_.size() || (count - plain) % 3 != 0) return false;
  if (!treeline_packet_read(bytes_.data(), size, count, &head, received_.data())) return false;
  received_shown_ = (count - plain) / 3;
  return head.kind == (has_controller_ ? treeline_packet_motion : treeline_packet_state) &&
         udp::all_finite({received_.data(), plain});
}

/// Takes the state that was received, if it is of this robot, later than the last one, and an
/// answer to this object: none that was recorded before. A controller that was silent may have been
/// started again.
void UdpRobot::take(const TreelinePacketHead& head) noexcept {
  const bool first = heard_ < 0.0 || (has_controller_ && head.run != run_ && !is_heard());
  const bool answers = head.answers >= first_ && head.answers <= sent_;
  if (!answers || (!first && head.run != run_) || (head.robot != robot_)) {
    ++counts_.foreign;
  } else if (!first && !treeline_packet_is_next(head.sequence, newest_)) {
    ++counts_.repeated;
  } else {
    newest_ = head.sequence;
    run_ = head.run;
    heard_ = machine_time();
    shown_ = received_shown_;
    std::copy(received_.begin(), received_.end(), state_.begin());
  }
}

void UdpRobot::send(TreelinePacketKind kind, const double* numbers, std::size_t count) noexcept {
  const bool asks = kind == treeline_packet_request;
  const TreelinePacketHead head{static_cast<std::uint16_t>(kind), robot_, ++sent_, 0,
                                asks ? 0 : run_};
  const std::size_t size = treeline_seal_close(
      &seal_, bytes_.data(), treeline_packet_write(&head, numbers, count, bytes_.data()));
  (void)::send(socket_, bytes_.data(), size, MSG_NOSIGNAL);  // the robot's silence tells of errors
}

bool UdpRobot::wait_for_state(double seconds) {
  for (const double end = machine_time() + seconds; machine_time() < end && heard_ < 0.0;) {
    send(treeline_packet_request, nullptr, 0);
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    receive();
  }
  return heard_ >= 0.0;
}

/// A controller that is silent is asked: it may have been started again.
void UdpRobot::lead(const double* goal) noexcept {
  if (is_heard()) {
    send(treeline_packet_goal, goal, goal_size());
  } else {
    send(treeline_packet_request, nullptr, 0);
  }
}

void UdpRobot::show(double* tau, Shown& shown) const noexcept {
  const double* const from = state_.data() + nq_ + nv_;
  std::copy_n(from, nv_, tau);
  shown.count = static_cast<int>(shown_);
  for (std::size_t i = 0; i < shown_; ++i) {
    const double* const number = from + nv_ + 3 * i;
    treeline_packet_read_name(number, shown.numbers[i].name);
    shown.numbers[i].value = number[2];
  }
}

ExternalRobot UdpRobot::functions() {
  ExternalRobot functions;
  functions.self = this;
  functions.connected = [](void* self) {
    auto& robot = *static_cast<UdpRobot*>(self);
    robot.receive();
    return robot.is_heard();
  };
  functions.read = [](void* self, double* q, double* qd) {
    const auto& robot = *static_cast<UdpRobot*>(self);
    std::copy_n(robot.state_.data(), robot.nq_, q);
    std::copy_n(robot.state_.data() + robot.nq_, robot.nv_, qd);
  };
  if (has_controller_) {
    functions.lead = [](void* self, const double* goal) {
      static_cast<UdpRobot*>(self)->lead(goal);
    };
    functions.show = [](void* self, double* tau, Shown& shown) {
      static_cast<const UdpRobot*>(self)->show(tau, shown);
    };
  } else {
    functions.write = [](void* self, const double* tau) {
      auto& robot = *static_cast<UdpRobot*>(self);
      robot.send(treeline_packet_command, tau, robot.nv_);
    };
  }
  return functions;
}

}  // namespace treeline::drive
