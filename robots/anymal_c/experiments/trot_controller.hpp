#pragma once

#include "anymal_left_limited.hpp"
#include "anymal_on_feet.hpp"
#include "anymal_right_limited.hpp"
#include "anymal_stand_limited.hpp"
#include "command_line/limit_figures.hpp"
#include "core/spline.hpp"
#include "servo/message.hpp"
#include "trot_plan.hpp"

namespace treeline::experiments {

/// N.
double weight_of_anymal() noexcept;

/// What a cycle of the controller came to.
struct TrotCommand {
  TrotPhase phase;
  LimitFigures within;       ///< torques and forces
  double away[3] = {};       ///< of the body from its path, m
  double swing_error = 0.0;  ///< largest distance of a swinging foot from its path, m
};

/// Trots by `limited_control_torque` of three scenes: one for four feet that stand, and one for
/// each pair. It takes feet that carry to be held by the ground. Where feet land is planned from
/// the path of the body.
class TrotController {
 public:
  static constexpr int kRates = AnymalOnFeet::kVelocities;
  using Vectors = AnymalOnFeet::Vectors;

  explicit TrotController(const TrotPlan& plan) noexcept : plan_(plan) {}

  void start(double time, const AnymalState& state) noexcept;
  void apply(double time, const servo::Message& message) noexcept;
  void control(double time, const AnymalState& state, double (&tau)[kRates]) noexcept;

  const TrotCommand& last() const noexcept { return command_; }

 private:
  using Swing = core::CubicSegment<2, double>;

  void plan_swing(double time, const Vectors& feet) noexcept;
  void ask_body(double time, const AnymalState& state, double (&xdd)[6]) noexcept;
  void ask_foot(int foot, double time, const Vectors& x, const Vectors& v, double* xdd) noexcept;
  double wanted_load(int foot) const noexcept;

  void stand(const double (&body)[6], const AnymalState& state, double (&tau)[kRates]) noexcept;
  void swing(double (&body)[6], const Vectors& x, const Vectors& v, const AnymalState& state,
             double (&tau)[kRates]) noexcept;
  template <int held, class Law, class Limits, class Limited, int rows>
  void obey(const Law& law, const Limits& limits, Limited& limited, const double (&xdd)[rows],
            const AnymalState& state, double (&tau)[kRates]) noexcept;

  TrotPlan plan_;
  double begin_ = 0.0;
  double weight_ = 0.0;    ///< N
  double body_[3] = {};    ///< where the body was, m
  double shift_[2] = {};   ///< from there to where its mass is amid the feet, m
  Vectors places_{};       ///< of the feet against the body's path, m
  int planned_step_ = -1;  ///< whose swings are those below
  Swing swings_[kFeet]{};
  TrotCommand command_;
  anymal_stand::LimitedTorque on_all_{};
  anymal_left::LimitedTorque on_left_{};
  anymal_right::LimitedTorque on_right_{};
};

}  // namespace treeline::experiments
