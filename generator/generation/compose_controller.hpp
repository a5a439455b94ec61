#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/controller_unit.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// The controller that the scene asks for. Its functions take sines and cosines as arguments, so
/// that a step computes each joint's once. Poses and velocities of points and the torque of gravity
/// are one function: they share transforms. The law stands between it and the torque, since it
/// takes square roots and comparisons, which expression graphs do not have. With `optimize: size`
/// dynamics loop over links where that is smaller. `mechanism` is that of the whole scene.
ControllerUnit compose_controller(const Robot& robot, const Scene& scene,
                                  const Mechanism& mechanism);

}  // namespace treeline
