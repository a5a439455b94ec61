#pragma once

#include "anymal_on_feet.hpp"
#include "anymal_trot_limited.hpp"
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
  LimitFigures within;          ///< torques and forces
  double away[3] = {};          ///< of the body from its path, m
  double swing_error = 0.0;     ///< largest distance of a swinging foot from its path, m
  double beyond_in_part = 0.0;  ///< most by which a foot held in part is beyond its cone, N
  double torque_step = 0.0;     ///< largest change of a torque since the last cycle, N m
};

/// Trots by `limited_control_torque` of one scene, whose feet and tasks come and go. It takes feet
/// that carry to be held by the ground. Where feet land is planned from the path of the body.
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

  void obey(const double (&xdd)[anymal_trot::kTaskRows], const AnymalState& state,
            double (&tau)[kRates]) noexcept;

  TrotPlan plan_;
  double begin_ = 0.0;
  double weight_ = 0.0;    ///< N
  double body_[3] = {};    ///< where the body was, m
  double shift_[2] = {};   ///< from there to where its mass is amid the feet, m
  Vectors places_{};       ///< of the feet against the body's path, m
  int planned_step_ = -1;  ///< whose swings are those below
  Swing swings_[kFeet]{};
  TrotCommand command_;
  anymal_trot::LimitedTorque limited_{};
  double last_tau_[kRates] = {};
};

}  // namespace treeline::experiments
