#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "drive/end_stops.hpp"
#include "drive/flat_feet.hpp"
#include "drive/ground.hpp"
#include "drive/held_places.hpp"
#include "drive/link_forces.hpp"
#include "drive/robot_library.hpp"
#include "servo/gear_backlash.hpp"
#include "servo/integrate.hpp"
#include "servo/joint_friction.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::drive {

/// Normally distributed numbers that are the same in every run.
class Noise {
 public:
  /// The next one, with mean 0 and standard deviation 1: the method of Box and Muller (1958) on
  /// numbers of the generator splitmix64 (Steele, Lea, Flood 2014).
  double next() noexcept {
    const double radius = std::sqrt(-2.0 * std::log(uniform()));
    return radius * std::cos(6.283185307179586 * uniform());
  }

 private:
  double uniform() noexcept {
    state_ += 0x9e3779b97f4a7c15U;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
    z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
    z ^= z >> 31U;
    return (static_cast<double>(z >> 11U) + 0.5) * 0x1p-53;
  }
  std::uint64_t state_ = 0;
};

/// A robot that is simulated by its forward dynamics, with friction, gears, a delay, sensors and
/// contacts, as `SimulationOptions` and `Surroundings` say. Without any it is the ideal one of
/// `servo::SimulatedRobot`, to the bit.
///
/// Torques are constant between writes and take effect `delay` cycles later. Where a gear has play,
/// the torque and the friction act on the rotor, and the encoder is at the motor, see
/// `servo::gear_torque`. Where positions are measured with noise or in steps, speeds are their
/// differences behind a low-pass filter with a time constant of 3 ms. Obstacles push guarded points
/// out like springs with dampers, without friction. Joints end at `EndStops`. A motion whose
/// numbers are not finite any more, or beyond 1000 rad/s or m/s, is measured as such once; then the
/// robot rests where it last was, until `restore` puts it where it began.
///
/// On a ground (`kIsOnGround`) it moves by the generated step there: nothing else carries its base,
/// the motors neither, and it may slip and fall, until `restore` puts it where it began.
template <class F>
class ImperfectRobot {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;
  using Floating = servo::FloatingJoints<nq, nv>;
  using State = servo::StateOf<F>;

  ImperfectRobot(const State& start, int substeps, const Floating& floating,
                 const SimulationOptions& simulation, const Surroundings& surroundings,
                 const double* lower = nullptr, const double* upper = nullptr,
                 const double* torque = nullptr) noexcept
      : start_(start),
        links_(start),
        motors_(start),
        substeps_(substeps),
        floating_(floating),
        places_(start.q),
        stops_(floating, lower, upper, start.q),
        feet_(start.q) {
    for (int i = 0; i < nv; ++i) limit_[i] = torque != nullptr ? torque[i] : kUnlimited;
    find_coordinates();
    take_options(simulation);
    take_surroundings(surroundings);
    measured_ = start;
  }

  /// Whether steps of `seconds` can follow the gears; takes more of them where that is needed.
  bool can_follow_gears(double seconds) noexcept;

  void read(State& state) const noexcept {
    state = has_sensors_ ? measured_ : seen();
    if (lost_) state.qd[0] = std::numeric_limits<double>::quiet_NaN();
  }
  void write(const double (&tau)[nv]) noexcept {
    copy(tau, given_);
    if constexpr (kStands<F>) stand(given_);
    if (!written_) {  // what was commanded before is as good as this
      for (auto& entry : line_) copy(given_, entry);
    }
    written_ = true;
    copy(given_, line_[static_cast<std::size_t>(next_)]);
    next_ = (next_ + 1) % (delay_ + 1);
    copy(line_[static_cast<std::size_t>(next_)], tau_);
  }
  /// What was written last, on a ground less what the feet cannot bear.
  const double (&given() const noexcept)[nv] { return given_; }
  void pass_time(double seconds) noexcept {
    lost_ = false;
    if constexpr (kIsOnGround<F>) {
      constexpr double kLongest = 2.5e-4;  // s: a light foot errs with the square
      const int steps = std::max(substeps_, static_cast<int>(std::ceil(seconds / kLongest)));
      for (int k = 0; k < steps && !lost_; ++k) step_on_ground(seconds / steps);
      on_ground_.fell = on_ground_.fell || is_down<F>(start_.q, links_.q);
    } else {
      for (int k = 0; k < substeps_ && !lost_; ++k) integrate(seconds / substeps_);
    }
    feel(links_);
    if (has_sensors_) measure(seconds);
  }

  /// Pushes a robot on a ground by joint forces in every step until this is called again.
  void push(const double (&force)[nv]) noexcept {
    if constexpr (kIsOnGround<F>) copy(force, on_ground_.push);
  }

  /// Whether it lies, once it has stood on its feet.
  bool has_fallen() const noexcept {
    if constexpr (kIsOnGround<F>) return on_ground_.fell;
    return false;
  }

  /// A robot whose motion was lost, or which fell, rests where it began; others stay where they
  /// are.
  void restore() noexcept {
    if (!broken_ && !has_fallen()) return;
    broken_ = lost_ = false;
    on_ground_ = {};
    links_ = motors_ = measured_ = start_;
    for (auto& entry : line_) std::fill(std::begin(entry), std::end(entry), 0.0);
    std::fill(std::begin(tau_), std::end(tau_), 0.0);
    written_ = false;
  }

  /// What the ground does to a robot on it: of each point that is pressed, the deepest first.
  void list_touches(Touches& touches) const noexcept {
    touches.count = 0;
    if constexpr (kIsOnGround<F>) {
      touches.count = std::min(static_cast<int>(on_ground_.report.contacts), kMostTouches);
      for (int k = 0; k < touches.count; ++k) {
        const double* const entry = on_ground_.report.touches + 6 * k;
        Touch& touch = touches.list[k];
        for (int i = 0; i < 3; ++i) {
          touch.at[i] = entry[i];
          touch.force[i] = entry[3 + i] / on_ground_.dt;
        }
      }
    }
  }

  /// Force (N, world axes) of the obstacles on a guarded point.
  const double (&contact_force(int guarded) const noexcept)[3] {
    return forces_[static_cast<std::size_t>(guarded)].f;
  }
  int guarded_count() const noexcept { return guarded_count_; }
  const GuardedPoint& guarded(int i) const noexcept {
    return guarded_[static_cast<std::size_t>(i)];
  }
  /// State of the links, not of the sensors.
  const State& links() const noexcept { return links_; }

 private:
  struct Force {
    double f[3] = {};
  };
  struct Joint {
    int coordinate = -1;  ///< -1: part of a floating joint
    servo::JointFriction friction;
    servo::GearBacklash gear;
    double rotor = 0.0;  ///< 0: no gear
    double noise = 0.0;
    double quantum = 0.0;
  };
  static constexpr double kSlipSpeed = 0.01;     ///< rad/s or m/s
  static constexpr double kFilter = 0.003;       ///< s, of measured speeds
  static constexpr double kWallStiffness = 2e4;  ///< N/m
  static constexpr double kWallDamping = 200.0;  ///< N s/m
  static constexpr double kUnlimited = 1e6;      ///< N m or N: a larger limit is none

  static void copy(const double (&from)[nv], double (&to)[nv]) noexcept {
    for (int i = 0; i < nv; ++i) to[i] = from[i];
  }
  void find_coordinates() noexcept;
  void take_options(const SimulationOptions& options) noexcept;
  void take_surroundings(const Surroundings& surroundings) noexcept;
  State seen() const noexcept;
  void measure(double seconds) noexcept;
  void feel(const State& links) noexcept;
  void add_contacts(const State& links, double (&tau)[nv]) noexcept;
  void accelerations(const State& links, const State& motors, double (&of_links)[nv],
                     double (&of_motors)[nv]) noexcept;
  void integrate(double dt) noexcept;
  void step_on_ground(double dt) noexcept;
  void stand(double (&tau)[nv]) const noexcept;
  void accept(const State& links, const State& motors) noexcept;

  State start_;
  State links_;
  State motors_;  ///< only where there are gears
  State measured_;
  bool lost_ = false;    ///< the last step led to numbers that are no motion
  bool broken_ = false;  ///< one did since the last `restore`
  int substeps_;
  Floating floating_;
  HeldPlaces<F> places_;
  EndStops<F> stops_;
  std::array<Joint, static_cast<std::size_t>(nv)> joints_{};
  bool has_sensors_ = false;
  bool has_gears_ = false;
  double tau_[nv] = {};
  double line_[static_cast<std::size_t>(kLongestDelay + 1)][nv] = {};
  int delay_ = 0;
  int next_ = 0;
  bool written_ = false;
  Noise noise_;
  std::array<Obstacle, kMostObstacles> obstacles_{};
  std::array<GuardedPoint, kMostGuardedPoints> guarded_{};
  std::array<Force, kMostGuardedPoints> forces_{};
  int obstacle_count_ = 0;
  int guarded_count_ = 0;
  LinkForces<F> link_forces_;
  OnGround<F> on_ground_;
  Feet<F> feet_;
  double given_[nv] = {};
  double limit_[nv];  ///< of torque
};

}  // namespace treeline::drive

#include "drive/imperfect_robot_body.hpp"
