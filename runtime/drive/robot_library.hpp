#pragma once

#include <cstddef>
#include <cstdint>

#include "drive/obstacle.hpp"
#include "drive/reference_motion.hpp"
#include "servo/message.hpp"

namespace treeline::drive {

/// Grows whenever a struct below changes: the program refuses a library of another version.
inline constexpr int kLibraryVersion = 5;

/// A number that a robot's own controller shows by a name.
struct NamedNumber {
  char name[16] = {};  ///< what is left of it is 0
  double value = 0.0;
};
inline constexpr int kMostNamedNumbers = 16;

/// What the controller of a robot shows of a cycle.
struct Shown {
  int count = 0;  ///< of `numbers`
  NamedNumber numbers[kMostNamedNumbers];
};

/// A point that the ground presses: where, m, and how much, N; world axes.
struct Touch {
  double at[3], force[3];
};
inline constexpr int kMostTouches = 16;
struct Touches {
  int count = 0;
  Touch list[kMostTouches];
};

/// A robot outside the library, instead of the simulated one. None of the functions may wait.
struct ExternalRobot {
  void* self = nullptr;
  bool (*connected)(void* self) = nullptr;  ///< null: the robot is simulated
  void (*read)(void* self, double* q, double* qd) = nullptr;
  void (*write)(void* self, const double* tau) = nullptr;
  /// Where the robot has a controller of its own, instead of `write`: gives it a goal, see
  /// `treeline_packet_goal`.
  void (*lead)(void* self, const double* goal) = nullptr;
  /// Writes the torque that it exerts, and what it shows.
  void (*show)(void* self, double* tau, Shown& shown) = nullptr;

  bool has_controller() const noexcept { return lead != nullptr; }
};

/// Imperfections of a simulated robot. The arrays have an entry for each velocity, in N m and rad
/// or in N and m; null: 0 for all. They do not concern floating joints.
struct SimulationOptions {
  const double* coulomb = nullptr;  ///< friction of the drive
  const double* viscous = nullptr;  ///< friction of the drive by its speed
  const double* play = nullptr;     ///< backlash of the gear, from flank to flank
  const double* rotor = nullptr;  ///< inertia of the rotor seen from the joint; positive with play
  const double* gear_stiffness = nullptr;  ///< of touching teeth, N m/rad or N/m; likewise
  const double* noise = nullptr;           ///< standard deviation of measured positions
  const double* quantum = nullptr;         ///< step of measured positions
  int delay = 0;  ///< cycles from a command to its effect, at most `kLongestDelay`
};

/// Delay that a simulated robot can have, cycles.
inline constexpr int kLongestDelay = 63;

/// Obstacles that the robot avoids, and the points of it that avoid them.
struct Surroundings {
  const Obstacle* obstacles = nullptr;
  int obstacle_count = 0;  ///< at most `kMostObstacles`
  const GuardedPoint* guarded = nullptr;
  int guarded_count = 0;  ///< at most `kMostGuardedPoints`
  Repulsion repulsion;
};

/// Options with which a loop begins. Arrays are in the order of q (nq entries) or of qd and tau
/// (nv); they are copied. Infinite limits are none.
struct LoopOptions {
  double rate = 1000.0;              ///< Hz
  bool real_time = true;             ///< false: time passes as fast as cycles can be computed
  int substeps = 2;                  ///< integration steps of the simulated robot in a cycle
  int overruns_in_a_row = 3;         ///< late cycles that are no fault
  double longest_delay = 0.05;       ///< s: a cycle that is later is one
  const double* start = nullptr;     ///< nq
  const double* home = nullptr;      ///< nq: where `go_home` leads; null: to the start
  const double* lower = nullptr;     ///< nq: goals stay within, rad or m
  const double* upper = nullptr;     ///< nq
  double beyond = 0.02;              ///< how far beyond these limits is a fault, rad or m
  const double* velocity = nullptr;  ///< nv: rad/s or m/s
  const double* torque = nullptr;    ///< nv: N m or N; commands are cut to it
  double pull_stiffness = 100.0;     ///< N/m
  double pull_force = 50.0;          ///< N, the most that a pull exerts
  ExternalRobot robot;
  SimulationOptions simulation;
  Surroundings surroundings;
  RecordedMotion reference;  ///< not copied
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
  Shown shown;      ///< by the robot's own controller
  Touches touches;  ///< of a simulated robot on a ground
};

/// Places of the numbers in a report. `goal` is the desired state now, `target` the end of its
/// motion; both are in the order of q. Poses of points are position (3) and quaternion (4), `free`
/// is 1 for a released point. `contact_forces` are forces (3, world axes) of obstacles on the
/// points of a simulated robot, `nearest` is the distance of each point from the nearest obstacle.
struct ReportLayout {
  int q, qd, tau, goal, target, point_poses, point_goals, point_targets, free, center_of_mass,
      pull_at, pull_force, contact_forces, nearest, size;
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
  at.contact_forces = take(3 * points);
  at.nearest = take(points);
  at.size = next;
  return at;
}

/// Functions of a compiled robot. One thread calls `step`, one other `send` and `receive`, which
/// never wait. `step` allocates nothing.
struct RobotLibrary {
  int version = kLibraryVersion;
  int coordinates = 0, velocities = 0, points = 0, links = 0;
  bool has_center_of_mass = false;
  /// Null: the gears are too stiff to be simulated, see `SimulationOptions::gear_stiffness`.
  void* (*create)(const LoopOptions* options) = nullptr;
  void (*destroy)(void* loop) = nullptr;
  bool (*step)(void* loop) = nullptr;  ///< one cycle; false: the loop has ended
  /// False: full. What `send_at` has scheduled before is forgotten.
  bool (*send)(void* loop, const servo::Message* message) = nullptr;
  /// An instruction for the first cycle of the loop's time `time` (s) or later; in the order of
  /// their times. False: full.
  bool (*send_at)(void* loop, const servo::Message* message, double time) = nullptr;
  /// The oldest report that was not received, `ReportLayout::size` numbers; false: there is none.
  bool (*receive)(void* loop, ReportHead* head, double* numbers) = nullptr;
  /// The simulated robot without a loop, for a process of its own. Of the options only `start`,
  /// `substeps`, `lower`, `upper`, `torque`, `simulation` and `surroundings` count. `tau` null: it
  /// brakes. `state` receives q and qd.
  void* (*create_robot)(const LoopOptions* options) = nullptr;
  void (*destroy_robot)(void* robot) = nullptr;
  void (*advance_robot)(void* robot, const double* tau, double seconds) = nullptr;
  void (*read_robot)(void* robot, double* state) = nullptr;
  /// Closes the loops of the robot's own near `q`; returns the largest error that is left, m or
  /// rad. 0, and nothing changes, where there are none.
  double (*close_loops)(double* q) = nullptr;
  int task_rows = 0;
  /// The task's Jacobian at `q`: task_rows x velocities numbers. Null where there is no task.
  void (*jacobian)(const double* q, double* J) = nullptr;
};

/// The library's only symbol, of type `const RobotLibrary* (*)()`.
inline constexpr const char* kLibrarySymbol = "treeline_drive_library";

}  // namespace treeline::drive
