#pragma once

namespace treeline::servo {

/// Gear between a motor and its joint, seen from the joint's side. Its teeth touch when the motor
/// leads or lags by half the play, and then yield elastically.
struct GearBacklash {
  double play = 0.0;       ///< from flank to flank, rad or m; 0: no play
  double stiffness = 0.0;  ///< of touching teeth, N m/rad or N/m; positive
  double damping = 0.0;    ///< of touching teeth, N m s/rad or N s/m
};

/// Torque (N m or N) that the motor's side exerts on the link's side if it leads by `lead` (rad or
/// m), which grows at `rate`. Within the play it is zero. Teeth push and never pull.
inline double gear_torque(const GearBacklash& gear, double lead, double rate) noexcept {
  const double half = 0.5 * gear.play;
  if (half > 0.0 && lead < half && lead > -half) {
    return 0.0;
  }
  const double depth = lead > 0.0 ? lead - half : lead + half;
  const double torque = gear.stiffness * depth + gear.damping * rate;
  const bool pulls = half > 0.0 && torque * depth < 0.0;
  return pulls ? 0.0 : torque;
}

}  // namespace treeline::servo
