#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emission_context.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// What the contract of the emitted code says about robot and scene, but for choices and skips.
EmissionContext describe_scene(const Robot& robot, const Scene& scene, const Mechanism& mechanism);

}  // namespace treeline
