#pragma once

namespace treeline::servo {

/// The gear between a motor and its joint, all at the joint's side: teeth that touch after half the
/// play either way and then yield elastically.
struct GearBacklash {
  double play = 0.0;       ///< rad or m, from flank to flank; 0: none
  double stiffness = 0.0;  ///< N m/rad or N/m, of touching teeth; positive
  double damping = 0.0;    ///< N m s/rad or N s/m, of touching teeth
};

/// The torque that the motor's side exerts on the link's when it is ahead by `lead` (rad or m),
/// which grows by `rate`: none within the play; teeth push, they never pull.
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
