#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emission_context.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Returns what the contract of the emitted code says about robot and scene, except choices and
/// functions left out.
EmissionContext describe_scene(const Robot& robot, const Scene& scene, const Mechanism& mechanism);

}  // namespace treeline
