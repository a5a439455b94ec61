#pragma once

#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "emission/emission_context.hpp"
#include "mechanism/mechanism.hpp"

namespace treeline {

/// Returns what the contract of the emitted code says about robot and scene, except choices and
/// functions left out.
EmissionContext describe_scene(const Robot& robot, const Scene& scene, const Mechanism& mechanism);

/// Names and limits of the entries of qd.
std::vector<EmissionContext::VelocityRow> velocity_rows(const Robot& robot,
                                                        const Mechanism& mechanism);

}  // namespace treeline
