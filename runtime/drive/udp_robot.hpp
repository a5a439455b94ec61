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

/// Packets that were not obeyed, by reason.
struct PacketCounts {
  std::atomic<std::uint64_t> malformed{0}, foreign{0}, repeated{0};
};

/// Whether a text is HOST:PORT with a number as HOST.
bool is_udp_address(const std::string& text);

/// A robot that is reached over UDP. After `open`, its functions are for the servo thread; none of
/// them waits or allocates.
class UdpRobot {
 public:
  /// Silence after which the robot counts as gone, s.
  static constexpr double kSilence = 0.1;

  /// `address` is HOST:PORT with a number as HOST. `nq` and `nv` are the sizes of q and tau.
  /// Returns null and says why in `error` if there is no such address.
  static std::unique_ptr<UdpRobot> open(const std::string& address, const std::string& checksum,
                                        int nq, int nv, std::string& error);
  ~UdpRobot();
  UdpRobot(const UdpRobot&) = delete;
  UdpRobot& operator=(const UdpRobot&) = delete;

  /// Asks until the robot's first state has come, at most `seconds`. Returns whether it has.
  bool wait_for_state(double seconds);
  /// For `LoopOptions::robot`.
  ExternalRobot functions();
  const std::vector<double>& state() const { return state_; }
  const PacketCounts& counts() const { return counts_; }

 private:
  UdpRobot() = default;
  void receive() noexcept;
  void send(PacketKind kind, const double* tau, int count) noexcept;

  int socket_ = -1;
  std::uint64_t robot_ = 0;
  int nq_ = 0;
  int nv_ = 0;
  std::uint64_t sent_ = 0;
  std::uint64_t newest_ = 0;
  double heard_ = -1.0;
  std::vector<double> state_;  ///< q, qd
  std::vector<double> received_;
  PacketBytes bytes_{};
  PacketCounts counts_;
};

/// The robot's side: obeys commands over UDP with a simulation of its own, in real time. It answers
/// whoever sent the newest command; another sender is heard after a silence of 1 s. Without a
/// command for 50 ms the robot brakes by itself.
struct RobotSide {
  std::string address;  ///< HOST:PORT to listen on, HOST as a number
  std::string checksum;
  double rate = 1000.0;
  int nq = 0, nv = 0;
  /// Advances the simulation by `seconds` under `tau`; null: the robot brakes.
  std::function<void(const double* tau, double seconds)> advance;
  /// Writes q and qd.
  std::function<void(double* state)> read;
};

/// Runs until `ended` becomes true. Returns the error in words, or an empty text.
std::string run_robot_side(const RobotSide& side, const std::atomic<bool>& ended);

}  // namespace treeline::drive
