#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drive/robot_description.hpp"
#include "drive/robot_library.hpp"
#include "launch/launch.hpp"

namespace treeline {

/// Whether the robot can hold its weight at rest at `q` with this share of its effort limits.
bool holds_weight(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                  const std::vector<double>& q, double share = 1.0);

/// z of the operational points together, m.
double height_of_points(const drive::RobotLibrary& library, const drive::RobotDescription& robot,
                        const std::vector<double>& q);

/// The joints whose effort limits are too low to hold the weight at rest at `q`, those that lack
/// most first: "elbow needs 31 of 28 N m, ...". Empty: there are none.
std::string describe_overload(const drive::RobotLibrary& library,
                              const drive::RobotDescription& robot, const std::vector<double>& q);

/// Takes the effort limits from all joints where some are too weak to hold the weight at rest at
/// `q`: those of the others are no better known, and hardly suffice for a motion. An arm whose file
/// has placeholders for limits could not be driven anywhere otherwise. Returns the names and
/// figures of the weak ones as `describe_overload` does; empty: there are none, and nothing is
/// changed.
std::string free_weak_robot(const drive::RobotLibrary& library, drive::RobotDescription& robot,
                            const std::vector<double>& q);

/// Whether a robot may start there.
using AdmitsStart = std::function<bool(const std::vector<double>& q)>;

/// Where a robot can hold its weight with 70 % of its effort limits, found by moving one joint
/// after the other from `start`, from the base on; the best that was found where there is no such
/// place. Nothing if it can hold its weight at `start`.
std::optional<std::vector<double>> find_holdable_start(const drive::RobotLibrary& library,
                                                       const drive::RobotDescription& robot,
                                                       const std::vector<double>& start,
                                                       const AdmitsStart& admits);

/// A place near `start` where the operational points can be moved well in every row of their task:
/// stretched arms are bent. Found by moving the joint that helps most, one after the other, where
/// the robot still holds its weight with 70 % of its effort limits, or all of them where it needs
/// more at `start`, and where `admits` does. Nothing if the task is far from singular at `start`,
/// or no better place was found.
std::optional<std::vector<double>> find_bent_start(const drive::RobotLibrary& library,
                                                   const drive::RobotDescription& robot,
                                                   const std::vector<double>& start,
                                                   const AdmitsStart& admits);

/// Where a robot stands well on a ground: its feet, those of `constraints`, as level and as far
/// apart as with all joints at 0, its legs bent by 6 % of its height where they can be, and its
/// centre of mass above the middle of what of them touches the ground. Nothing where no such place
/// is near, where the robot could not hold its weight there, or where it is not admitted.
std::optional<std::vector<double>> find_standing_start(const LaunchedRobot& robot,
                                                       const std::vector<double>& start,
                                                       const AdmitsStart& admits);

}  // namespace treeline
