#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drive/robot_library.hpp"
#include "show/packet.h"

namespace treeline::drive {

/// Packets that were not obeyed, by reason. `foreign`: of another robot, of another run of its
/// process, or without the shared secret.
struct PacketCounts {
  std::atomic<std::uint64_t> malformed{0}, foreign{0}, repeated{0};
};

/// How a robot is reached, and known.
struct RobotAddress {
  std::string address;          ///< HOST:PORT with a number as HOST
  std::string checksum;         ///< of the robot
  std::string secret;           ///< shared by both sides; empty: nobody proves who he is
  bool has_controller = false;  ///< of its own: `show/show.h`
};

/// Room for a packet.
using PacketBytes = std::array<unsigned char, treeline_packet_size>;
/// How packets prove who sends them; `secret` empty: they do not.
TreelinePacketSeal make_seal(const std::string& secret);

/// Whether a text is HOST:PORT with a number as HOST.
bool is_udp_address(const std::string& text);

/// A robot that is reached over UDP. After `open`, its functions are for the servo thread; none of
/// them waits or allocates.
class UdpRobot {
 public:
  /// Silence after which the robot counts as gone, s.
  static constexpr double kSilence = 0.1;

  /// `nq` and `nv` are the sizes of q and tau, `points` is how many have goals. Returns null and
  /// says why in `error` if there is no such address.
  static std::unique_ptr<UdpRobot> open(const RobotAddress& address, int nq, int nv, int points,
                                        std::string& error);
  ~UdpRobot();
  UdpRobot(const UdpRobot&) = delete;
  UdpRobot& operator=(const UdpRobot&) = delete;

  /// Asks until the robot's first state has come, at most `seconds`. Returns whether it has.
  bool wait_for_state(double seconds);
  /// Functions of this object for `LoopOptions::robot`.
  ExternalRobot functions();
  const std::vector<double>& state() const { return state_; }
  const PacketCounts& counts() const { return counts_; }

 private:
  explicit UdpRobot(const RobotAddress& address);
  void receive() noexcept;
  bool read(std::size_t size, TreelinePacketHead& head) noexcept;
  void take(const TreelinePacketHead& head) noexcept;
  void send(TreelinePacketKind kind, const double* numbers, std::size_t count) noexcept;
  void lead(const double* goal) noexcept;
  void show(double* tau, Shown& shown) const noexcept;
  bool is_heard() const noexcept;
  std::size_t goal_size() const noexcept { return 2 + nq_ + nv_ + 7 * points_; }

  int socket_ = -1;
  std::uint64_t robot_ = 0;
  bool has_controller_;
  std::size_t nq_ = 0, nv_ = 0, points_ = 0;
  TreelinePacketSeal seal_;
  std::uint64_t first_ = 0;  ///< number of the first packet that this object has sent
  std::uint64_t sent_ = 0;
  std::uint64_t newest_ = 0;
  std::uint64_t run_ = 0;
  double heard_ = -1.0;
  std::vector<double> state_;  ///< q, qd; of a controller then tau and what it shows
  std::vector<double> received_;
  std::size_t shown_ = 0, received_shown_ = 0;  ///< how many numbers by name are in them
  PacketBytes bytes_{};
  PacketCounts counts_;
};

/// The robot's side: obeys commands over UDP with a simulation of its own, in real time. It sends
/// its states to whoever commands it, and for 1 s to the last eight who have asked. Another sender
/// commands after the first was silent for 1 s; requests give nobody the command. Without a command
/// for 50 ms the robot brakes by itself.
struct RobotSide {
  RobotAddress address;  ///< to listen on
  double rate = 1000.0;
  int nq = 0;
  std::vector<double> torque;  ///< of each velocity: commands are cut to it
  /// Advances the simulation by `seconds` under `tau`; null: the robot brakes.
  std::function<void(const double* tau, double seconds)> advance;
  /// Writes q and qd.
  std::function<void(double* state)> read;
};

/// Runs until `ended` becomes true. Returns the error in words, or an empty text.
std::string run_robot_side(const RobotSide& side, const std::atomic<bool>& ended);

}  // namespace treeline::drive
