#pragma once

#include "circle_plan.hpp"
#include "core/command_laws.hpp"
#include "samm.hpp"
#include "servo/message.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::experiments {

/// The generated functions of generated/samm in the form that the servo library expects of a robot.
struct Samm {
  static constexpr int kCoordinates = samm::kCoordinates;
  static constexpr int kVelocities = samm::kVelocities;
  static constexpr bool kDrivesInJoints = false;  // the scene has no armature and no friction
  static constexpr int kTaskRows = samm::kTaskRows;
  static constexpr auto& inverse_dynamics = samm::inverse_dynamics;
  static constexpr auto& forward_dynamics = samm::forward_dynamics;
};
static_assert(Samm::kCoordinates == 9 && Samm::kVelocities == 9 && Samm::kTaskRows == 6);

/// Gains of tool and base, and the inertia of the motors.
struct CircleGains {
  core::Gains<double> tool{1600.0, 80.0};
  core::Gains<double> base{400.0, 40.0};
  /// Rotor inertias that the torque shall accelerate in addition (Drive::rotor); zero: none.
  double rotors[9] = {};
};

/// Moves tool and base on their circles by Chang table 6.1: the tool is the task, the motion of the
/// base is a posture in its null space. The posture is the acceleration qdd_0 = M^-1 S^T f whose
/// part in the dynamically consistent null space gives the base its desired acceleration:
///
///     W f = b - S Jbar (xdd_cmd - Jd qd),   W = S (M^-1 - Jbar Lambda^-1 Jbar^T) S^T.
///
/// S are the base's rows and b is its desired acceleration with feedback. The null space has the
/// base's three degrees of freedom, so both motions are achieved exactly. The tool is not affected
/// by f.
class CircleController {
 public:
  using State = servo::StateOf<Samm>;

  /// Place of tool and base at the last call of `control`, according to the state that it received.
  struct Tracking {
    CircleMotion wanted;         ///< the tool as in CircleMotion, relative to its start
    double tool_wanted[3] = {};  ///< m, world axes
    double tool[3] = {};
    double error[6] = {};
    double base_error[3] = {};
  };

  CircleController(const CirclePlan& plan, const CircleGains& gains) noexcept
      : plan_(plan), gains_(gains) {}

  /// Starts the circles at the present places of tool and base.
  void start(double time, const State& state) noexcept;
  void apply(double, const servo::Message&) noexcept {}
  void control(double time, const State& state, double (&tau)[9]) noexcept;

  const Tracking& tracking() const noexcept { return tracking_; }

 private:
  CirclePlan plan_;
  CircleGains gains_;
  double start_time_ = 0.0;
  double position_[3] = {};
  double rotation_[9] = {};
  double base_[3] = {};
  Tracking tracking_;
};

/// qdd_0 of the law of this class. `b` is the acceleration of base_x, base_y, base_yaw.
void base_posture(const double (&q)[9], const double (&qd)[9], const double (&xdd_cmd)[6],
                  const double (&b)[3], double (&qdd_0)[9]) noexcept;

}  // namespace treeline::experiments
