#pragma once

#include <memory>
#include <vector>

#include "drive/robot_description.hpp"
#include "drive/robot_library.hpp"

namespace treeline {

/// How a control loop begins.
struct LoopSetup {
  double rate = 1000;  ///< Hz
  bool real_time = true;
  std::vector<double> start;  ///< q
  std::vector<double> home;   ///< q; empty: the start
  drive::SimulationOptions simulation;
  drive::ExternalRobot external;
  drive::RecordedMotion reference;  ///< outlives the loop
};

/// A control loop of a launched robot, simulated or outside.
class LoopHandle {
 public:
  LoopHandle(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
             const LoopSetup& setup);

  /// False: the gears of `simulation` are too stiff to be simulated.
  explicit operator bool() const { return loop_ != nullptr; }

  bool step() { return library_.step(loop_.get()); }
  bool send(const servo::Message& message) { return library_.send(loop_.get(), &message); }
  /// See `drive::RobotLibrary::send_at`.
  bool send_at(const servo::Message& message, double time) {
    return library_.send_at(loop_.get(), &message, time);
  }
  bool receive(drive::ReportHead& head, double* numbers) {
    return library_.receive(loop_.get(), &head, numbers);
  }

 private:
  struct Destroyer {
    void (*destroy)(void*);
    void operator()(void* loop) const { destroy(loop); }
  };
  const drive::RobotLibrary& library_;
  std::unique_ptr<void, Destroyer> loop_;
};

/// Limits and strengths that a loop of this robot begins with. The arrays belong to this object.
struct LoopNumbers {
  explicit LoopNumbers(const drive::RobotDescription& robot);
  std::vector<double> lower, upper, velocity, torque;
  std::vector<drive::Obstacle> obstacles;
};
drive::LoopOptions options_for(const drive::RobotDescription& robot, const LoopNumbers& numbers,
                               const std::vector<double>& start);

/// Where a robot begins if nothing else is said: every coordinate at 0, or, where its limits
/// exclude that, as near as they permit with a margin.
std::vector<double> default_start(const drive::RobotDescription& robot);

}  // namespace treeline
