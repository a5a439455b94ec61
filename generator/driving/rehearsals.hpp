#pragma once

#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "driving/rehearsal.hpp"

namespace treeline {

/// Rehearse, then go: the commands `rehearse`, `go` and `discard` of one robot.
class Rehearsals {
 public:
  /// `start`: where the robot began. All references outlive this object.
  Rehearsals(const drive::RobotLibrary& library, const drive::Session& session, LoopHandle& loop,
             double rate, bool real_time, const std::vector<double>& start);

  /// Obeys `rehearse`, `go` or `discard`.
  drive::Answer obey(drive::Verb verb);
  /// While a rehearsal is on, motions are for the twin. Nothing: this message is for the robot.
  /// False: the twin cannot take it.
  std::optional<bool> divert(drive::Verb verb, const servo::Message& message);
  /// The robot was sent a message, which ends what it was to do by itself.
  void note_sent(const servo::Message& message);
  /// Feeds the robot, and looks whether it has done what was rehearsed; says so by `tell`.
  void attend(const std::function<void(const std::string&)>& tell);
  /// A cycle of the twin, without real time.
  void step();

  /// Whether a motion of the twin, or of the robot after `go`, has not ended.
  [[nodiscard]] bool moving() const;
  /// The twin that is shown; null: there is none.
  [[nodiscard]] const drive::Session* twin() const;

 private:
  drive::Answer begin();
  drive::Answer go();
  [[nodiscard]] std::vector<double> robot_q() const;
  [[nodiscard]] std::vector<double> twin_q() const;

  const drive::RobotLibrary& library_;
  const drive::Session& session_;
  LoopHandle& loop_;
  double rate_;
  bool real_time_;
  std::vector<double> home_;
  std::optional<servo::Message> gains_[3];  ///< last sent to the robot: joint, task, both
  std::unique_ptr<Rehearsal> rehearsal_;
  std::deque<TimedMessage> pending_;  ///< for the robot, in its time
  bool going_ = false;
  double gone_ = 0;  ///< robot's time of the last message
};

}  // namespace treeline
