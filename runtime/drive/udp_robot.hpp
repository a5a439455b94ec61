#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "drive/robot_library.hpp"
#include "drive/robot_packet.hpp"

namespace treeline::drive {

/// Packets that were not obeyed, by reason. `foreign`: of another robot, of another run of its
/// process, or without the shared secret.
struct PacketCounts {
  std::atomic<std::uint64_t> malformed{0}, foreign{0}, repeated{0};
};

/// How a robot is reached, and known.
struct RobotAddress {
  std::string address;   ///< HOST:PORT with a number as HOST
  std::string checksum;  ///< of the robot
  std::string secret;    ///< shared by both sides; empty: nobody proves who he is
};

/// Whether a text is HOST:PORT with a number as HOST.
bool is_udp_address(const std::string& text);

/// A robot that is reached over UDP. After `open`, its functions are for the servo thread; none of
/// them waits or allocates.
class UdpRobot {
 public:
  /// Silence after which the robot counts as gone, s.
  static constexpr double kSilence = 0.1;

  /// `nq` and `nv` are the sizes of q and tau. Returns null and says why in `error` if there is no
  /// such address.
  static std::unique_ptr<UdpRobot> open(const RobotAddress& address, int nq, int nv,
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
  explicit UdpRobot(const std::string& secret) : seal_(secret) {}
  void receive() noexcept;
  void take(const PacketHead& head) noexcept;
  void send(PacketKind kind, const double* tau, int count) noexcept;

  int socket_ = -1;
  std::uint64_t robot_ = 0;
  int nq_ = 0;
  int nv_ = 0;
  PacketSeal seal_;
  std::uint64_t first_ = 0;  ///< number of the first packet that this object has sent
  std::uint64_t sent_ = 0;
  std::uint64_t newest_ = 0;
  std::uint64_t run_ = 0;
  double heard_ = -1.0;
  std::vector<double> state_;  ///< q, qd
  std::vector<double> received_;
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
