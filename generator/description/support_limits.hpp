#pragma once

#include <array>
#include <optional>
#include <string>

namespace treeline {

/// Limits against slipping, turning, tipping and lifting of a constraint. To the world, its normal
/// is the z axis of the constraint's axes and its forces are those of the world on the robot.
/// Between two links, its normal is z of `other_origin`, along which the second pushes the first.
struct SceneCone {
  std::string constraint;
  double friction = 0;              ///< largest ratio of tangential to normal force
  int sides = 4;                    ///< of the pyramid within the cone of friction: 4 or 8
  double least_force = 0;           ///< along the normal, N
  std::optional<double> torsional;  ///< largest ratio of the moment about z to the normal force, m
  /// Half lengths along x and y within which the centre of pressure stays, m.
  std::optional<std::array<double, 2>> half_extents;
};

}  // namespace treeline
