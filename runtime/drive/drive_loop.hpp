#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstring>
#include <memory>

#include "core/orientation.hpp"
#include "drive/closed_loops.hpp"
#include "drive/drive_controller.hpp"
#include "drive/driven_robot.hpp"
#include "drive/loop_settings.hpp"
#include "drive/robot_library.hpp"
#include "servo/clock.hpp"
#include "servo/loop.hpp"

namespace treeline::drive {

/// The machine's clock, or one that passes as fast as cycles can be computed.
class DriveClock {
 public:
  explicit DriveClock(bool real_time) noexcept : real_time_(real_time) {}
  std::int64_t now() const noexcept { return real_time_ ? steady_.now() : simulated_.now(); }
  void sleep_until(std::int64_t time) noexcept {
    if (real_time_) {
      steady_.sleep_until(time);
    } else {
      simulated_.sleep_until(time);
    }
  }

 private:
  bool real_time_;
  servo::SteadyClock steady_;
  servo::SimulatedClock simulated_;
};

/// Everything that runs in the servo thread for a robot F, and its mailbox and ring of reports.
template <class F>
class DriveLoop {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;
  static constexpr ReportLayout kLayout = report_layout(nq, nv, F::kPoints);

  explicit DriveLoop(const LoopOptions& options)
      : robot_(start_of<F>(options), F::kFloating, options),
        controller_(control_settings<nq, nv>(options), robot_.torque()),
        clock_(options.real_time),
        loop_(loop_settings(options), safety_limits<nq, nv>(options), robot_, controller_, clock_,
              mailbox_) {}

  /// Whether the simulated robot's steps can follow its gears.
  bool can_follow_gears(double rate) noexcept {
    return !robot_.is_simulated() || robot_.simulated().can_follow_gears(1.0 / rate);
  }
  bool step() {
    apply_timed();
    return loop_.step([this](const servo::Report<F>& report) { observe(report); });
  }
  bool send(const servo::Message& message) noexcept {
    generation_.fetch_add(1, std::memory_order_release);
    return mailbox_.push(message);
  }
  bool send_at(const servo::Message& message, double time) noexcept {
    return timed_.push({message, time, generation_.load(std::memory_order_relaxed)});
  }
  bool receive(ReportHead& head, double* numbers) noexcept {
    if (!reports_.pop(received_)) {
      return false;
    }
    head = received_.head;
    std::memcpy(numbers, received_.numbers, sizeof(received_.numbers));
    return true;
  }

 private:
  struct Item {
    ReportHead head;
    double numbers[static_cast<std::size_t>(kLayout.size)] = {};
  };
  /// A message with its time; whatever was sent after it ends it.
  struct Timed {
    servo::Message message;
    double time = 0.0;
    std::uint64_t generation = 0;
  };

  /// Gives the controller what was meant for this cycle.
  void apply_timed() noexcept {
    constexpr double kSlack = 1e-7;  // s, of times that are sums
    for (;;) {
      if (!has_next_) has_next_ = timed_.pop(next_);
      if (!has_next_) return;
      const bool forgotten = next_.generation != generation_.load(std::memory_order_acquire);
      if (!forgotten && next_.time > loop_.time() + kSlack) return;
      has_next_ = false;
      if (!forgotten && loop_.mode() == servo::Mode::running) {
        controller_.apply(loop_.time(), next_.message);
      }
    }
  }

  void observe(const servo::Report<F>& report) noexcept {
    fill_head(report);
    fill_numbers(report);
    if constexpr (kIsOnGround<F>) {
      const double none[nv] = {};
      robot_.simulated().push(filled_.head.pulled ? controller_.push() : none);
    }
    if (robot_.has_controller()) lead();
    if (!reports_.push(filled_)) {
      ++dropped_reports_;
    }
  }
  /// Gives the robot's own controller the goals of this cycle.
  void lead() noexcept {
    double goal[2 + nq + nv + 7 * F::kPoints];
    double qd[nv] = {};
    if (static_cast<servo::Mode>(filled_.head.mode) == servo::Mode::running) {
      controller_.find_goal_velocity(qd);
    }
    goal[0] = filled_.head.mode;
    goal[1] = filled_.head.control;
    std::copy_n(filled_.numbers + kLayout.goal, nq, goal + 2);
    std::copy_n(qd, nv, goal + 2 + nq);
    std::copy_n(filled_.numbers + kLayout.point_goals, 7 * F::kPoints, goal + 2 + nq + nv);
    robot_.lead(goal);
  }
  void fill_head(const servo::Report<F>& report) noexcept {
    ReportHead& head = filled_.head;
    head.cycle = report.cycle;
    head.time = report.time;
    head.mode = static_cast<int>(report.mode);
    head.control = static_cast<int>(controller_.control_kind());
    head.fault_kind = static_cast<int>(report.fault.kind);
    head.fault_index = report.fault.index;
    head.fault_value = report.fault.value;
    head.fault_limit = report.fault.limit;
    head.period = report.timing.period;
    head.jitter = report.timing.jitter;
    head.busy = report.timing.busy;
    head.skipped = report.timing.skipped;
    head.control_time = report.control_nanoseconds;
    head.dropped_messages = loop_.dropped_messages();
    head.dropped_reports = dropped_reports_;
    const bool running = report.mode == servo::Mode::running;
    head.moving =
        report.mode == servo::Mode::stopping || (running && controller_.moving(report.time, 0.3));
    head.saturated = running && controller_.saturated();
    head.pulled = running && controller_.pulled();
    head.pulled_link = controller_.pulled_link();
    head.shown = robot_.shown();
    robot_.simulated().list_touches(head.touches);
  }
  void fill_numbers(const servo::Report<F>& report) noexcept {
    double* const numbers = filled_.numbers;
    std::copy_n(report.state.q, nq, numbers + kLayout.q);
    std::copy_n(report.state.qd, nv, numbers + kLayout.qd);
    std::copy_n(robot_.torque(), nv, numbers + kLayout.tau);
    const bool running = report.mode == servo::Mode::running;
    for (int i = 0; i < nq; ++i) {
      numbers[kLayout.goal + i] = running ? controller_.joint(i).position() : report.state.q[i];
      numbers[kLayout.target + i] = running ? controller_.joint(i).target() : report.state.q[i];
    }
    for (int k = 0; running && k < nq - nv; ++k) {
      const int first = F::kFloating[static_cast<std::size_t>(k)];
      write_goals(controller_.floating(k), numbers + kLayout.goal + first,
                  numbers + kLayout.target + first);
    }
    fill_points(report, running);
    if constexpr (F::kHasCenterOfMass) {
      double center[3];
      F::center_of_mass(report.state.q, center);
      std::copy_n(center, 3, numbers + kLayout.center_of_mass);
    }
    std::copy_n(controller_.pull_at(), 3, numbers + kLayout.pull_at);
    std::copy_n(controller_.pull_force(), 3, numbers + kLayout.pull_force);
  }
  void fill_points(const servo::Report<F>& report, bool running) noexcept {
    if constexpr (F::kPoints > 0) {
      double positions[3 * F::kPoints];
      double rotations[9 * F::kPoints];
      F::forward_kinematics(report.state.q, positions, rotations);
      for (int k = 0; k < F::kPoints; ++k) {
        double* const pose = filled_.numbers + kLayout.point_poses + 7 * k;
        double* const goal = filled_.numbers + kLayout.point_goals + 7 * k;
        double* const target = filled_.numbers + kLayout.point_targets + 7 * k;
        double rotation[9];
        std::copy_n(rotations + 9 * k, 9, rotation);
        write_pose(positions + 3 * k, rotation, pose);
        const bool led =
            running && controller_.control_kind() == Control::task && !controller_.free(k);
        if (led) {
          write_goals(controller_.point(k), goal, target);
        } else {
          std::copy_n(pose, 7, goal);
          std::copy_n(pose, 7, target);
        }
        filled_.numbers[kLayout.free + k] = controller_.free(k) ? 1.0 : 0.0;
        filled_.numbers[kLayout.nearest + k] = controller_.nearest(k);
      }
      fill_contacts();
    }
  }
  /// Fills in the contact forces at the points of a simulated robot.
  void fill_contacts() noexcept {
    for (int i = 0; robot_.is_simulated() && i < robot_.simulated().guarded_count(); ++i) {
      const int point = robot_.simulated().guarded(i).point;
      if (point < 0) continue;
      std::copy_n(robot_.simulated().contact_force(i), 3,
                  filled_.numbers + kLayout.contact_forces + 3 * point);
    }
  }
  static void write_pose(const double* position, const double (&rotation)[9],
                         double* out) noexcept {
    double quaternion[4];
    core::quaternion_from_rotation(rotation, quaternion);
    std::copy_n(position, 3, out);
    std::copy_n(quaternion, 4, out + 3);
  }
  static void write_goals(const SmoothPose& pose, double* goal, double* target) noexcept {
    double position[3];
    pose.position(position);
    write_pose(position, pose.rotation(), goal);
    pose.goal_position(position);
    write_pose(position, pose.goal_rotation(), target);
  }

  servo::Mailbox mailbox_;
  servo::Ring<Item, 512> reports_;
  servo::Ring<Timed, 128> timed_;
  Timed next_;
  bool has_next_ = false;
  std::atomic<std::uint64_t> generation_{0};
  Item filled_;
  Item received_;
  std::uint64_t dropped_reports_ = 0;
  DrivenRobot<F> robot_;
  DriveController<F> controller_;
  DriveClock clock_;
  servo::ServoLoop<F, DrivenRobot<F>, DriveController<F>, DriveClock> loop_;
};

/// A simulated robot that brakes by itself where nobody commands it.
template <class F>
class LoneRobot {
 public:
  explicit LoneRobot(const LoopOptions& options) noexcept
      : robot_(start_of(options), options.substeps, F::kFloating, options.simulation,
               options.surroundings, options.lower, options.upper, options.torque),
        safe_({}, 1.0 / options.rate, limits_of(options)) {
    robot_.can_follow_gears(1.0 / options.rate);
  }
  void advance(const double* tau, double seconds) noexcept {
    double torque[F::kVelocities];
    if (tau != nullptr) {
      std::copy_n(tau, F::kVelocities, torque);
      safe_.release(torque);
    } else {
      servo::StateOf<F> state;
      robot_.read(state);
      safe_.see(state);
      safe_.brake(torque);
    }
    robot_.write(torque);
    robot_.pass_time(seconds);
  }
  void read(double* numbers) const noexcept {
    servo::StateOf<F> state;
    robot_.read(state);
    std::copy_n(state.q, F::kCoordinates, numbers);
    std::copy_n(state.qd, F::kVelocities, numbers + F::kCoordinates);
  }

 private:
  using Limits = servo::SafetyLimits<F::kCoordinates, F::kVelocities>;
  static Limits limits_of(const LoopOptions& options) noexcept {
    Limits limits;
    std::copy_n(options.torque, F::kVelocities, limits.torque.begin());
    return limits;
  }
  static servo::StateOf<F> start_of(const LoopOptions& options) noexcept {
    servo::StateOf<F> state;
    std::copy_n(options.start, F::kCoordinates, state.q);
    return state;
  }
  ImperfectRobot<F> robot_;
  servo::SafeState<F> safe_;
};

/// Writes the Jacobian of the task, of the motions that are possible; null for robots without one.
template <class F>
constexpr auto jacobian_of() noexcept -> void (*)(const double*, double*) {
  if constexpr (F::kPoints > 0) {
    return [](const double* q, double* J) {
      double coordinates[F::kCoordinates];
      std::copy_n(q, F::kCoordinates, coordinates);
      if constexpr (requires { F::kHeldRows; }) {
        ClosedLoops<F>::free_jacobian(coordinates, J);
      } else {
        double entries[F::kTaskRows * F::kVelocities];
        F::jacobian(coordinates, entries);
        std::copy_n(entries, F::kTaskRows * F::kVelocities, J);
      }
    };
  } else {
    return nullptr;
  }
}

/// The functions of a library for a robot F.
template <class F>
const RobotLibrary* library_of() noexcept {
  using Loop = DriveLoop<F>;
  static constexpr RobotLibrary kLibrary{
      kLibraryVersion,
      F::kCoordinates,
      F::kVelocities,
      F::kPoints,
      F::kLinks,
      F::kHasCenterOfMass,
      [](const LoopOptions* options) -> void* {
        auto loop = std::make_unique<Loop>(*options);
        return loop->can_follow_gears(options->rate) ? loop.release() : nullptr;
      },
      [](void* loop) { delete static_cast<Loop*>(loop); },
      [](void* loop) { return static_cast<Loop*>(loop)->step(); },
      [](void* loop, const servo::Message* message) {
        return static_cast<Loop*>(loop)->send(*message);
      },
      [](void* loop, const servo::Message* message, double time) {
        return static_cast<Loop*>(loop)->send_at(*message, time);
      },
      [](void* loop, ReportHead* head, double* numbers) {
        return static_cast<Loop*>(loop)->receive(*head, numbers);
      },
      [](const LoopOptions* options) -> void* { return new LoneRobot<F>(*options); },
      [](void* robot) { delete static_cast<LoneRobot<F>*>(robot); },
      [](void* robot, const double* tau, double seconds) {
        static_cast<LoneRobot<F>*>(robot)->advance(tau, seconds);
      },
      [](void* robot, double* state) { static_cast<LoneRobot<F>*>(robot)->read(state); },
      [](double* q) {
        if constexpr (requires { F::kHeldRows; }) {
          double closed[F::kCoordinates];
          std::copy_n(q, F::kCoordinates, closed);
          const double error = ClosedLoops<F>::close(closed);
          std::copy_n(closed, F::kCoordinates, q);
          return error;
        } else {
          (void)q;
          return 0.0;
        }
      },
      F::kTaskRows,
      jacobian_of<F>()};
  return &kLibrary;
}

}  // namespace treeline::drive
