#pragma once

#include <atomic>
#include <deque>
#include <string>
#include <thread>
#include <vector>

#include "drive/report.hpp"
#include "drive/session.hpp"
#include "driving/loop_handle.hpp"

namespace treeline {

/// A message and when a loop is to take it.
struct TimedMessage {
  double time = 0;  ///< s of that loop
  servo::Message message;
};

/// A twin of the robot, simulated from where the robot stands, to which commands go until the robot
/// is told to do the same. Messages reach either loop in the cycle that they are meant for, so that
/// two loops that begin in the same state do the same to the last bit.
class Rehearsal {
 public:
  /// Where and how the rehearsal begins.
  struct Begin {
    std::vector<double> q;     ///< of the robot, at rest
    std::vector<double> home;  ///< where the robot began
    double rate = 1000;
    bool real_time = true;
    /// Messages that make the twin control as the robot does: its control and gains.
    std::vector<servo::Message> settings;
  };

  Rehearsal(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
            const Begin& begin);
  ~Rehearsal();
  Rehearsal(const Rehearsal&) = delete;
  Rehearsal& operator=(const Rehearsal&) = delete;

  /// Gives the twin a message that the robot may get later. False: there are too many.
  bool take(const servo::Message& message);
  /// One cycle; only without real time.
  void step();
  /// Takes the twin's reports.
  void receive();

  /// Whether the twin moves or has messages that it has not taken yet.
  [[nodiscard]] bool moving() const;
  [[nodiscard]] const drive::Session& twin() const { return session_; }
  [[nodiscard]] const std::vector<double>& begin() const { return begin_; }
  /// Messages given to the twin, with times from the beginning of the rehearsal, s; the settings
  /// and the beginning itself included.
  [[nodiscard]] const std::deque<TimedMessage>& messages() const { return messages_; }

 private:
  void run();
  void schedule(const servo::Message& message, double time);
  [[nodiscard]] double twin_time() const { return session_.report().head.time; }

  std::vector<double> begin_;
  double period_;
  LoopHandle loop_;
  drive::Session session_;
  std::vector<double> numbers_;
  std::deque<TimedMessage> messages_;
  double origin_ = 0;  ///< twin's time at which the rehearsal begins
  double last_ = 0;    ///< twin's time of the newest message
  std::atomic<bool> ended_{false};
  std::thread servo_;
};

}  // namespace treeline
