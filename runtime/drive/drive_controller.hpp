#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/command_laws.hpp"
#include "core/ldlt.hpp"
#include "core/orientation.hpp"
#include "drive/avoidance.hpp"
#include "drive/ground.hpp"
#include "drive/instruction.hpp"
#include "drive/reference_motion.hpp"
#include "drive/smooth_reference.hpp"
#include "servo/message.hpp"
#include "servo/motion_coordinates.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::drive {

/// A row of the task: its point, and its axis among x y z rx ry rz.
struct TaskRow {
  int point = 0;
  int axis = 0;
};

/// Limits and strengths of a controller. Arrays are per coordinate and per velocity.
template <int nq, int nv>
struct ControlSettings {
  std::array<double, static_cast<std::size_t>(nq)> lower, upper;      ///< goals stay within
  std::array<double, static_cast<std::size_t>(nq)> home;              ///< where the robot began
  std::array<double, static_cast<std::size_t>(nv)> velocity, torque;  ///< infinite: none
  double period = 1e-3;                                               ///< s
  double pull_stiffness = 100.0;                                      ///< N/m
  double pull_force = 50.0;                                           ///< N
  bool only_leads = false;    ///< goals move, and another controller follows them: no torque
  Surroundings surroundings;  ///< copied
  RecordedMotion reference;   ///< not copied
};

/// Moves joints or operational points to goals, or lets the robot be led by hand:
///   joint    tau = ID(q, qd, qdd_ref + kv (qd_ref - qd) + kp (q_ref - q))
///   task     tau = control_torque(q, qd, posture law, xdd_ref + kv (xd_ref - xd) + kp (x_ref - x))
///   gravity  tau = ID(q, qd, -damping qd) plus a pull, within limits of position and speed
/// On a ground a pull is no part of tau: it is the robot's to bear (`push`).
/// In each, guarded points keep away from obstacles: see `Avoidance`.
/// Goals are led smoothly. Where the control changes, the torque's step is taken away and fades. A
/// floating joint has a pose as its goal in every control. Nothing is allocated.
///
/// F offers the generated functions of a robot, see templates/drive/robot.cpp.in.
template <class F>
class DriveController {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;
  static constexpr int kPoints = F::kPoints;
  static constexpr int kFloating = nq - nv;
  using Settings = ControlSettings<nq, nv>;
  using State = servo::StateOf<F>;

  /// `last_torque` is what the robot was given last, in every mode of the loop.
  DriveController(const Settings& settings, const double (&last_torque)[nv]) noexcept
      : settings_(settings),
        last_torque_(last_torque),
        avoidance_(settings.surroundings, settings.period),
        reference_(settings.reference, nq) {
    find_led_points();
    control_ = kPoints > 0 ? Control::task : Control::joint;
  }

  void start(double time, const State& state) noexcept {
    state_ = state;
    std::copy_n(state.qd, nv, foreseen_);
    std::fill_n(unforeseen_, nv, 0.0);
    begin_joints(time, state);
    begin_points(time, state);
    blend_asked_ = true;
    pull_until_ = time;
    pulled_ = false;
    pull_share_ = 0.0;
    reference_.end();
  }

  void apply(double time, const servo::Message& message) noexcept;
  void control(double time, const State& state, double (&tau)[nv]) noexcept;

  Control control_kind() const noexcept { return control_; }
  bool saturated() const noexcept { return saturated_; }
  bool pulled() const noexcept { return pull_share_ > 0.0; }
  int pulled_link() const noexcept { return pull_link_; }
  const double (&pull_at() const noexcept)[3] { return pull_at_; }
  const double (&pull_force() const noexcept)[3] { return pull_force_; }
  /// Joint forces of a hand that pulls a robot on a ground, which its motors do not exert.
  const double (&push() const noexcept)[nv] { return push_; }
  const SmoothNumber& joint(int coordinate) const noexcept { return joints_[at(coordinate)]; }
  const SmoothPose& floating(int joint) const noexcept { return floating_[at(joint)]; }
  const SmoothPose& point(int k) const noexcept { return points_[at(k)]; }
  bool free(int k) const noexcept { return free_[at(k)]; }
  /// Velocities at which the goals of the joints move.
  void find_goal_velocity(double (&qd)[nv]) const noexcept;
  /// Distance of a point from the nearest avoided obstacle, m.
  double nearest(int k) const noexcept { return avoidance_.nearest(k); }
  /// Whether a motion has not ended or ended within the last `margin` seconds.
  bool moving(double time, double margin) const noexcept;

 private:
  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }
  static constexpr std::size_t room(int size) noexcept { return at(size > 0 ? size : 1); }
  static constexpr double kLongestGuess = 30.0;  ///< s
  static constexpr double kShortestGuess = 0.5;  ///< s
  static constexpr double kSpeed = 1.0;          ///< rad/s or m/s of a joint without limit
  static constexpr double kPointSpeed = 0.25;    ///< m/s
  static constexpr double kTurnSpeed = 1.0;      ///< rad/s
  static constexpr double kPeak = 1.875;         ///< of a quintic: peak speed by mean speed
  static constexpr double kLead = 0.8;    ///< of a limit of speed, the most that goals move at
  static constexpr double kRise = 0.05;   ///< s in which a limit of speed is neared by 63 %
  static constexpr double kBlend = 0.25;  ///< s
  static constexpr double kPostureRate =
      3.0;  ///< rad/s, of the joint with the largest inertia, by its spring
  static constexpr double kHandDamping = 2.0;  ///< 1/s, in gravity control
  static constexpr double kGrip = 0.05;        ///< s in which a hand takes hold and lets go
  static constexpr double kHandFilter = 25.0;  ///< 1/s, of where the hand is

  /// How near to its limits a joint is led by something else than a goal of its own.
  struct JointBounds {
    double margin;   ///< to the limits of position, rad or m, at most a tenth of the range
    double share;    ///< of the limit of speed
    double fastest;  ///< what counts as the limit of joints that have none or a higher one
  };
  static constexpr JointBounds kHandBounds{0.03, 0.6, 5.0 * kSpeed};
  static constexpr JointBounds kBounds{0.0, 0.85, 20.0 * kSpeed};

  /// Calls single(coordinate, velocity) or floating(which, coordinate, velocity) for each joint.
  template <class Single, class Floating>
  static void for_each_joint(Single&& single, Floating&& floating) noexcept {
    int iq = 0;
    int iv = 0;
    for (int k = 0; k <= kFloating; ++k) {
      const int end = k < kFloating ? F::kFloating[at(k)] : nq;
      for (; iq < end; ++iq, ++iv) {
        single(iq, iv);
      }
      if (k < kFloating) {
        floating(k, iq, iv);
        iq += 7;
        iv += 6;
      }
    }
  }
  /// Whether a joint has no motor: the loops of the robot lead it.
  static constexpr bool is_passive(int velocity) noexcept { return !servo::has_motor<F>(velocity); }
  /// How far a joint is from `from` to `to`: the short way round if it turns without end.
  static double way(int velocity, double from, double to) noexcept {
    return servo::turns_without_end<F>(velocity) ? core::shortest_turn(to - from) : to - from;
  }
  static constexpr int task_rows() noexcept {
    if constexpr (kPoints > 0) {
      return F::kTaskRows;
    } else {
      return 0;
    }
  }
  /// Whether the posture is held by springs of one stiffness, see `accelerate_posture`.
  static constexpr bool has_springs() noexcept {
    if constexpr (kFloating > 0 || requires { F::kPassive; }) {
      return false;
    } else {
      return requires {
        F::mass_matrix;
      };
    }
  }
  static int velocity_of(int coordinate) noexcept {
    int found = -1;
    for_each_joint([&](int iq, int iv) { found = iq == coordinate ? iv : found; },
                   [](int, int, int) {});
    return found;
  }

  void find_led_points() noexcept;
  void avoid_obstacles(const State& state, double (&qdd)[nv]) noexcept;
  void begin_joints(double time, const State& state) noexcept;
  void begin_points(double time, const State& state) noexcept;
  void find_velocities(const State& state, const double* rotations,
                       double* velocities) const noexcept;
  void set_control(double time, const State& state, Control wanted) noexcept;
  void apply_to_joints(double time, Instruction instruction,
                       const servo::Message& message) noexcept;
  void apply_to_point(double time, Instruction instruction, const servo::Message& message) noexcept;
  void move_joint(double time, const servo::Message& message) noexcept;
  void go_home(double time, double duration) noexcept;
  void move_pose(double time, const servo::Message& message, SmoothPose& pose) noexcept;
  void turn_pose(double time, const servo::Message& message, SmoothPose& pose) noexcept;
  void drag_pose(double time, const servo::Message& message, SmoothPose& pose) noexcept;
  void drag_joint(double time, const servo::Message& message) noexcept;
  void advance_pull(double time) noexcept;
  void begin_pull(double time, const servo::Message& message) noexcept;
  void set_gains(const servo::Message& message) noexcept;
  SmoothPose* pose_of(int point) noexcept;
  void hold_all(double time) noexcept;
  void begin_following(double time, double duration) noexcept;
  void stop_following(double time, Instruction next) noexcept;
  void follow_reference(double time) noexcept;
  void let_passive_follow(double time) noexcept;
  void end_leases(double time) noexcept;
  void advance(double time) noexcept;
  double guess_duration(double distance, double limit, double asked) const noexcept;
  void accelerate_joints(const core::Gains<double>& gains, const State& state,
                         double (&qdd)[nv]) const noexcept;
  void accelerate_floating(const core::Gains<double>& gains, const SmoothPose& goal,
                           const double* q, const double* qd, double* qdd) const noexcept;
  void accelerate_posture(const State& state, double (&qdd)[nv]) const noexcept;
  void accelerate_by_springs(const State& state, double (&qdd)[nv]) const noexcept;
  void push_from_limits(const State& state, double (&qdd)[nv]) const noexcept;
  /// 1/s: how sharply joints are led to a limit.
  double limit_rate() const noexcept { return std::fmin(30.0, 0.1 / settings_.period); }
  void observe(const State& state) noexcept;
  std::array<double, 2> leave_room(double least, double most, int iv) const noexcept;
  std::array<double, 2> speed_range(const JointBounds& bounds, const State& state,
                                    int iv) const noexcept;
  bool stay_within(const JointBounds& bounds, double brakes, const State& state,
                   double (&qdd)[nv]) const noexcept;
  /// A motion that slows all joints down alike, and its torques.
  struct Braking {
    double share = 1.0;  ///< of `limit_rate` at which they slow down
    double weight[nv];   ///< torques that hold the robot here
    double qdd[nv];
    double tau[nv];
    bool bears[nv];  ///< motors that can hold the robot's weight
  };
  Braking find_braking(const State& state) const noexcept;
  static void find_weight(const double (&q)[nq], double (&weight)[nv]) noexcept;
  double share_that_is_borne(const State& state, const Braking& braking,
                             const double (&qdd)[nv]) const noexcept;
  void keep_limits(const State& state, const double* J, double (&tau)[nv]) noexcept;
  void share_torque(const Braking& braking, const bool (&shares)[nv], double (&tau)[nv]) noexcept;
  void yield_to_hand(const State& state, double (&tau)[nv]) noexcept;
  void measure_points(double time, const State& state, double* rotations, double* errors) noexcept;
  void find_turning(const State& state, double* turning) const noexcept;
  double command_row(int row, const double* rotations, const double* errors, const double* turning,
                     double velocity) const noexcept;
  void add_acceleration(const State& state, const double (&qdd)[nv], double (&tau)[nv]) noexcept;
  void command_task(double time, const State& state, double* jacobian, double (&tau)[nv]) noexcept;
  bool add_pull(const State& state, double (&tau)[nv]) noexcept;
  void leave_to_motors(const State& state, double (&tau)[nv]) const noexcept;
  void blend(double time, double (&tau)[nv]) noexcept;
  void cut(double (&tau)[nv]) noexcept;

  Settings settings_;
  const double (&last_torque_)[nv];
  Avoidance<F> avoidance_;
  ReferenceMotion reference_;
  std::array<bool, room(kPoints)> led_{};  ///< whose x, y and z are all rows of the task
  Control control_ = Control::joint;
  core::Gains<double> joint_gains_{kStiffness, kDamping};
  core::Gains<double> task_gains_{kStiffness, kDamping};
  core::Gains<double> posture_gains_{36.0, 12.0};
  std::array<SmoothNumber, room(nq)> joints_{};
  std::array<double, room(nq)> joint_leases_{};
  std::array<SmoothPose, room(kFloating)> floating_{};
  std::array<double, room(kFloating)> floating_leases_{};
  std::array<SmoothPose, room(kPoints)> points_{};
  std::array<double, room(kPoints)> point_leases_{};
  std::array<bool, room(kPoints)> free_{};
  State state_{};               ///< of the last cycle of control
  double foreseen_[nv] = {};    ///< qd of this cycle by the model
  double unforeseen_[nv] = {};  ///< accelerations that the model does not explain
  bool blend_asked_ = false;
  double blend_start_ = -1.0;
  double blend_from_[nv] = {};
  bool saturated_ = false;
  bool pulled_ = false;
  double pull_until_ = 0.0;
  int pull_link_ = 0;
  LinkForces<F> hand_;
  double pull_on_link_[3] = {};
  double pull_to_[3] = {};    ///< where the hand was last told to be
  double pull_hand_[3] = {};  ///< where it is
  double pull_share_ = 0.0;   ///< of the spring that acts, 0 to 1
  double pull_at_[3] = {};
  double pull_force_[3] = {};
  double push_[nv] = {};
};

}  // namespace treeline::drive

#include "drive/drive_bounds.hpp"
#include "drive/drive_controller_body.hpp"
#include "drive/drive_goals.hpp"
#include "drive/drive_task_law.hpp"
