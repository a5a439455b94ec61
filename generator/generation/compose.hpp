#pragma once

#include <map>
#include <string>
#include <vector>

#include "bounds/domain.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/controller_unit.hpp"
#include "emission/emission_context.hpp"
#include "emission/ground_unit.hpp"
#include "generation/generate_code.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// The controller that the scene asks for. Its functions take sines and cosines as arguments, so
/// that a step computes each joint's once. Poses and velocities of points and the torque of gravity
/// are one function: they share transforms. The law stands between it and the torque, since it
/// takes square roots and comparisons, which expression graphs do not have. With `optimize: size`
/// dynamics loop over links where that is smaller. `mechanism` is that of the whole scene.
ControllerUnit compose_controller(const Robot& robot, const Scene& scene,
                                  const Mechanism& mechanism);

/// The step on the ground that the scene asks for, of a robot of which something that moves may
/// touch it. Its functions are those of the robot alone: the scene's points play no part.
GroundUnit compose_ground(const Robot& robot, const Scene& scene);

/// Seconds in which all joints can rise from rest to their limits of speed by half of the torque
/// that holding the robot leaves their motors: in the middle one of 15 ordinary poses, of the joint
/// that takes longest, up to 10, rounded up to hundredths. At least a tenth of a torque counts as
/// left. 0 where no limit is stated.
double find_speed_rise(const Mechanism& mechanism,
                       const std::vector<ControllerUnit::Joint>& joints);

/// Describes the rounding errors of `damped_control_torque` for the contract: those of 50, 90 and
/// 99 of 100 states drawn from the domain. They are measured against extended precision, because no
/// bound can be proven for the sweeps of an eigenvalue solver. `functions` must include those that
/// it calls.
std::string describe_damped_rounding(const std::vector<GeneratedFunction>& functions,
                                     const Scene& scene, const Domain& domain);

/// Counts what each argument that is of the robot costs, by function: how many operations more than
/// in a scene that does not list it under `inputs`. Empty if the scene lists nothing there.
std::map<std::string, std::vector<EmissionContext::InputCost>> count_inputs(
    const Robot& robot, const Scene& scene, const std::vector<GeneratedFunction>& functions);

}  // namespace treeline
