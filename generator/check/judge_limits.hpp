#pragma once

#include <vector>

#include "check/report.hpp"
#include "compilation/generated_library.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Sources compiled beside the functions of a scene with limits: none for other scenes.
std::vector<WorkSource> limited_sources(const Scene& scene, const Generation& generation);

/// Calls limited_control_torque, of one state or of a batch, at the states, each without a start
/// from the one before. At most `kMostCertified` of those that are limited, spread evenly over
/// them, are certified.
LimitsReport judge_limits(const Robot& robot, const Scene& scene, const Generation& generation,
                          const std::vector<StateReference>& references,
                          const GeneratedLibrary& library, bool batch, int threads);
inline constexpr int kMostCertified = 100;

}  // namespace treeline
