#pragma once

#include "core/spline.hpp"
#include "humanoid24_push_limited.hpp"
#include "humanoid_on_soles.hpp"
#include "servo/message.hpp"

namespace treeline::experiments {

using HumanoidState = servo::StateOf<HumanoidOnSoles>;

/// When motions of the waist and of the hand begin and end, s.
struct PushTimes {
  double lean_end = 6.0;  ///< the waist leans to one side and the other before
  double reach = 6.5;     ///< the hand leaves its place
  double hold = 9.0;      ///< it is there
  double back = 10.0;     ///< it leaves for its place
  double rest = 12.5;     ///< it is back
};

/// Stands by `limited_control_torque`, or, to compare, by the unlimited law: the hand follows its
/// path as the task, the posture is advised by springs and by the law of balance. It does not know
/// of pushes, and takes feet to be held by the ground.
class PushController {
 public:
  static constexpr int kHeldRows = 12;

  explicit PushController(bool within_limits) noexcept : within_limits_(within_limits) {}

  void start(double time, const HumanoidState& state) noexcept;
  void apply(double time, const servo::Message& message) noexcept;
  void control(double time, const HumanoidState& state,
               double (&tau)[HumanoidOnSoles::kVelocities]) noexcept;

  /// What the last cycle came to: forces of the feet that were chosen, what became of the limits,
  /// distance of the hand from its path (m), and the centre of mass.
  const double (&forces() const noexcept)[kHeldRows] { return f_; }
  const humanoid24_push::LimitedTorque& limited() const noexcept { return limited_; }
  double hand_error() const noexcept { return hand_error_; }
  const double (&center_of_mass() const noexcept)[3] { return com_; }

 private:
  void ask_hand(double time, const HumanoidState& state, double (&xdd_cmd)[3]) noexcept;
  void advise(double time, const HumanoidState& state,
              double (&qdd_0)[HumanoidOnSoles::kVelocities]) noexcept;

  bool within_limits_;
  double begin_ = 0.0;
  HumanoidState start_{};
  core::CubicSegment<3, double> out_{}, back_{};
  humanoid24_push::LimitedTorque limited_{};
  double f_[kHeldRows] = {};
  double hand_error_ = 0.0;
  double com_[3] = {};
};

/// Angle of the waist at a time, rad: from rest to one side, to the other and back to rest.
double lean_at(double time) noexcept;

}  // namespace treeline::experiments
