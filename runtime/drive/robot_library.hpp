#pragma once

#include <cstddef>
#include <cstdint>

#include "servo/message.hpp"

namespace treeline::drive {

/// Grows whenever a struct below changes: the program refuses a library of another version.
inline constexpr int kLibraryVersion = 1;

/// A robot outside the library, instead of the simulated one. None of the functions may wait.
struct ExternalRobot {
  void* self = nullptr;
  bool (*connected)(void* self) = nullptr;  ///< null: the robot is simulated
  void (*read)(void* self, double* q, double* qd) = nullptr;
  void (*write)(void* self, const double* tau) = nullptr;
};

/// What a loop begins with. Arrays are in the order of q (nq entries) or of qd and tau (nv); they
/// are copied. Infinite limits are none.
struct LoopOptions {
  double rate = 1000.0;              ///< Hz
  bool real_time = true;             ///< false: time passes as fast as cycles can be computed
  int substeps = 2;                  ///< integration steps of the simulated robot in a cycle
  int overruns_in_a_row = 3;         ///< late cycles that are no fault
  const double* start = nullptr;     ///< nq
  const double* lower = nullptr;     ///< nq: goals stay within, rad or m
  const double* upper = nullptr;     ///< nq
  double beyond = 0.02;              ///< how far beyond these limits is a fault, rad or m
  const double* velocity = nullptr;  ///< nv: rad/s or m/s
  const double* torque = nullptr;    ///< nv: N m or N; commands are cut to it
  double pull_stiffness = 100.0;     ///< N/m
  double pull_force = 50.0;          ///< N, the most that a pull exerts
  ExternalRobot robot;
};

/// The part of a report that has the same size for every robot. Times are in ns.
struct ReportHead {
  std::int64_t cycle = 0;
  double time = 0.0;  ///< s
  int mode = 0;       ///< servo::Mode
  int control = 0;    ///< drive::Control
  int fault_kind = 0;
  int fault_index = -1;
  double fault_value = 0.0;
  double fault_limit = 0.0;
  std::int64_t period = 0, jitter = 0, busy = 0, control_time = 0, skipped = 0;
  std::uint64_t dropped_messages = 0;
  std::uint64_t dropped_reports = 0;
  bool moving = false;     ///< a motion has not ended, or has ended within the last 0.3 s
  bool saturated = false;  ///< a torque was cut in this cycle
  bool pulled = false;
  int pulled_link = -1;
};

/// Where in the numbers of a report which begins. `goal` is the desired state now, `target` where
/// its motion ends; both are in the order of q. Poses of points are position (3) and quaternion
/// (4), `free` is 1 for a released point.
struct ReportLayout {
  int q, qd, tau, goal, target, point_poses, point_goals, point_targets, free, center_of_mass,
      pull_at, pull_force, size;
};

constexpr ReportLayout report_layout(int nq, int nv, int points) noexcept {
  ReportLayout at{};
  int next = 0;
  const auto take = [&next](int count) {
    const int first = next;
    next += count;
    return first;
  };
  at.q = take(nq);
  at.qd = take(nv);
  at.tau = take(nv);
  at.goal = take(nq);
  at.target = take(nq);
  at.point_poses = take(7 * points);
  at.point_goals = take(7 * points);
  at.point_targets = take(7 * points);
  at.free = take(points);
  at.center_of_mass = take(3);
  at.pull_at = take(3);
  at.pull_force = take(3);
  at.size = next;
  return at;
}

/// What a compiled robot offers. One thread calls `step`, one other `send` and `receive`, which
/// never wait. `step` allocates nothing.
struct RobotLibrary {
  int version = kLibraryVersion;
  int coordinates = 0, velocities = 0, points = 0, links = 0;
  bool has_center_of_mass = false;
  void* (*create)(const LoopOptions* options) = nullptr;
  void (*destroy)(void* loop) = nullptr;
  bool (*step)(void* loop) = nullptr;  ///< one cycle; false: the loop has ended
  bool (*send)(void* loop, const servo::Message* message) = nullptr;  ///< false: full
  /// The oldest report that was not received, `ReportLayout::size` numbers; false: there is none.
  bool (*receive)(void* loop, ReportHead* head, double* numbers) = nullptr;
  /// The simulated robot without a loop, for a process of its own. Of the options only `start`,
  /// `substeps` and `torque` count. `tau` null: it brakes. `state` receives q and qd.
  void* (*create_robot)(const LoopOptions* options) = nullptr;
  void (*destroy_robot)(void* robot) = nullptr;
  void (*advance_robot)(void* robot, const double* tau, double seconds) = nullptr;
  void (*read_robot)(void* robot, double* state) = nullptr;
};

/// The library's only symbol, of type `const RobotLibrary* (*)()`.
inline constexpr const char* kLibrarySymbol = "treeline_drive_library";

}  // namespace treeline::drive
