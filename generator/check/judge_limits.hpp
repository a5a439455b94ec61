#pragma once

#include <vector>

#include "check/generated_library.hpp"
#include "check/report.hpp"
#include "description/robot.hpp"
#include "description/scene.hpp"
#include "generation/generate_code.hpp"
#include "oracle/reference.hpp"

namespace treeline {

/// Stem of the source with the entry of limited_control_torque, and the name of the entry.
inline constexpr const char* kLimitedName = "limited_control_torque";

/// What is compiled beside the functions of a scene with limits: nothing for other scenes.
std::vector<WorkSource> limited_sources(const Scene& scene, const Generation& generation);

/// Calls limited_control_torque at the states, each without a start from the one before. At most
/// `kMostCertified` of those that are limited, spread evenly over them, are certified.
LimitsReport judge_limits(const Robot& robot, const Scene& scene, const Generation& generation,
                          const std::vector<StateReference>& references,
                          const GeneratedLibrary& library, int threads);
inline constexpr int kMostCertified = 100;

}  // namespace treeline
