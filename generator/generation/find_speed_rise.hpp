#pragma once

#include <vector>

#include "emission/controller_unit.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Seconds in which all joints can rise from rest to their limits of speed by half of the torque
/// that holding the robot leaves their motors: in the middle one of 15 ordinary poses, of the joint
/// that takes longest, up to 10, rounded up to hundredths. At least a tenth of a torque counts as
/// left. 0 where no limit is stated.
double find_speed_rise(const Mechanism& mechanism,
                       const std::vector<ControllerUnit::Joint>& joints);

}  // namespace treeline
