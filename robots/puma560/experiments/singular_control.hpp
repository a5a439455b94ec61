#pragma once

#include <array>

#include "core/singularity.hpp"
#include "puma560.hpp"

/// Torques for the PUMA 560's tool by three laws that differ only near singularities.
namespace treeline::experiments {

inline constexpr int kJoints = puma560::kVelocities;
static_assert(kJoints == 6 && puma560::kTaskRows == 6 && puma560::kCoordinates == 6);

/// Length (m) that corresponds to a radian in the scaled rows: about half the arm's reach.
inline constexpr double kLength = 0.4;
inline constexpr double kScales[6] = {kLength, kLength, kLength, 1.0, 1.0, 1.0};

/// Commanded motion of the tool: xdd_cmd, and the remaining displacement (m, rad, world axes), by
/// which the lost directions are driven or rotated.
struct ToolCommand {
  double acceleration[6] = {};
  double displacement[6] = {};
};

enum class Strategy {
  none,      ///< table 6.1 as it stands, `singular: exact`
  damped,    ///< damped least squares (Nakamura & Hanafusa 1986)
  singular,  ///< the lost direction leaves the task, appendix A
};
inline constexpr std::array kStrategies{Strategy::none, Strategy::damped, Strategy::singular};
const char* name_of(Strategy strategy);

/// The weakest direction of the task in a configuration.
struct WeakestDirection {
  core::SingularDirections<6, 6, double> all;
  core::LostDirection<6, double> lost;
  double motion[6] = {};  ///< n, unit
  core::SingularityType type = core::SingularityType::none;
};

/// Examines direction `i` of the scaled Jacobian; 5 is the weakest. The sign of n is that of joints
/// 3 and 4 together.
WeakestDirection look_at_direction(const double (&q)[6], int i);

/// Torque by one of the laws. `branch` is the side of a type 1 singularity to go to: +1 is the side
/// where joint 3 grows.
void control(Strategy strategy, const double (&q)[6], const double (&qd)[6],
             const ToolCommand& command, double branch, double (&tau)[6]);

}  // namespace treeline::experiments
