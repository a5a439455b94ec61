#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <random>
#include <thread>

#include "drive/machine_time.hpp"
#include "drive/udp_robot.hpp"
#include "drive/udp_socket.hpp"

namespace treeline::drive {
namespace {

/// Who has sent packets that were obeyed.
struct Peer {
  sockaddr_in address{};
  std::uint64_t newest = 0;
  double heard = -1.0;  ///< s; below 0: never
};

constexpr double kRemembered = 1.0;  // s

bool is_present(const Peer& peer) {
  return peer.heard >= 0.0 && machine_time() - peer.heard < kRemembered;
}

bool is_at(const Peer& peer, const sockaddr_in& address) {
  return peer.address.sin_addr.s_addr == address.sin_addr.s_addr &&
         peer.address.sin_port == address.sin_port;
}

std::uint64_t draw_number() {
  std::random_device source;
  return (std::uint64_t{source()} << 32U) | source();
}

/// Data of the robot's side about those who speak to it.
class RobotPeers {
 public:
  RobotPeers(const RobotSide& side, int socket)
      : socket_(socket),
        robot_(udp::checksum_number(side.address.checksum)),
        seal_(make_seal(side.address.secret)),
        limits_(side.torque),
        tau_(side.torque.size()),
        numbers_(side.torque.size()) {}

  /// Takes what has come. A flood is not to hold the cycle.
  void receive() {
    constexpr int kMostAtOnce = 256;
    for (int i = 0; i < kMostAtOnce; ++i) {
      sockaddr_in from{};
      socklen_t length = sizeof(from);
      const ssize_t size = recvfrom(socket_, bytes_.data(), bytes_.size(), 0,
                                    reinterpret_cast<sockaddr*>(&from), &length);
      if (size < 0) return;
      take(from, treeline_seal_open(&seal_, bytes_.data(), static_cast<std::size_t>(size)));
    }
  }

  /// The torque that is commanded; null: nobody has commanded for 50 ms.
  const double* torque() const {
    constexpr double kBrakes = 0.05;  // s
    const bool commanded = commander_.heard >= 0.0 && machine_time() - commander_.heard < kBrakes;
    return commanded ? tau_.data() : nullptr;
  }

  /// Sends the state to all who are to have it.
  void send(const std::vector<double>& state) {
    ++sent_;
    if (is_present(commander_)) send_to(commander_, state);
    for (const Peer& listener : listeners_) {
      const bool again = is_present(commander_) && is_at(commander_, listener.address);
      if (is_present(listener) && !again) send_to(listener, state);
    }
  }

 private:
  void take(const sockaddr_in& from, std::size_t size) {
    TreelinePacketHead head;
    if (treeline_packet_read(bytes_.data(), size, 0, &head, nullptr) != 0) {
      if (head.kind == treeline_packet_request && head.robot == robot_) listen(from, head);
    } else if (treeline_packet_read(bytes_.data(), size, numbers_.size(), &head, numbers_.data()) !=
               0) {
      const bool good = head.kind == treeline_packet_command && head.robot == robot_ &&
                        head.run == run_ && udp::all_finite(numbers_);
      if (good && may_command(from, head)) command(from, head);
    }
  }

  /// The one who commands goes on; after a silence another may begin. With a secret its number has
  /// to be beyond all that were obeyed, so that a packet that somebody recorded begins nothing.
  bool may_command(const sockaddr_in& from, const TreelinePacketHead& head) const {
    if (is_present(commander_)) {
      return is_at(commander_, from) && treeline_packet_is_next(head.sequence, commander_.newest);
    }
    return seal_.is_wanted == 0 || head.sequence > commander_.newest;
  }

  void command(const sockaddr_in& from, const TreelinePacketHead& head) {
    commander_ = {from, head.sequence, machine_time()};
    for (std::size_t i = 0; i < tau_.size(); ++i) {
      tau_[i] = std::clamp(numbers_[i], -limits_[i], limits_[i]);
    }
  }

  void listen(const sockaddr_in& from, const TreelinePacketHead& head) {
    if (seal_.is_wanted != 0 && head.sequence <= newest_request_) return;
    newest_request_ = head.sequence;
    Peer* place = &listeners_[0];
    for (Peer& listener : listeners_) {
      if (listener.heard >= 0.0 && is_at(listener, from)) {
        place = &listener;
        break;
      }
      if (listener.heard < place->heard) place = &listener;
    }
    *place = {from, head.sequence, machine_time()};
  }

  void send_to(const Peer& peer, const std::vector<double>& state) {
    const TreelinePacketHead head{treeline_packet_state, robot_, sent_, peer.newest, run_};
    const std::size_t size = treeline_seal_close(
        &seal_, bytes_.data(),
        treeline_packet_write(&head, state.data(), state.size(), bytes_.data()));
    (void)sendto(socket_, bytes_.data(), size, MSG_NOSIGNAL,  // the next one follows a lost one
                 reinterpret_cast<const sockaddr*>(&peer.address), sizeof(sockaddr_in));
  }

  int socket_;
  std::uint64_t robot_;
  std::uint64_t run_ = draw_number();
  TreelinePacketSeal seal_;
  std::vector<double> limits_, tau_, numbers_;
  PacketBytes bytes_{};
  Peer commander_;
  std::array<Peer, 8> listeners_;
  std::uint64_t newest_request_ = 0;
  std::uint64_t sent_ = 0;
};

void run(const RobotSide& side, int socket, const std::atomic<bool>& ended) {
  RobotPeers peers(side, socket);
  std::vector<double> state(static_cast<std::size_t>(side.nq) + side.torque.size());
  const auto period = std::chrono::nanoseconds(static_cast<std::int64_t>(1e9 / side.rate));
  for (auto tick = std::chrono::steady_clock::now(); !ended; tick += period) {
    std::this_thread::sleep_until(tick);
    peers.receive();
    side.advance(peers.torque(), 1.0 / side.rate);
    side.read(state.data());
    peers.send(state);
  }
}

}  // namespace

std::string run_robot_side(const RobotSide& side, const std::atomic<bool>& ended) {
  sockaddr_in address{};
  if (!udp::read_address(side.address.address, address)) {
    return "expected HOST:PORT with a number as HOST";
  }
  const int socket = udp::open_udp_socket();
  if (socket < 0 ||
      bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof(address)) != 0) {
    const std::string error = std::strerror(errno);
    if (socket >= 0) close(socket);
    return error;
  }
  run(side, socket, ended);
  close(socket);
  return {};
}

}  // namespace treeline::drive
