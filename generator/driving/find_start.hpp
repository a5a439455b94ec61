#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "drive/robot_description.hpp"
#include "drive/robot_library.hpp"

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

}  // namespace treeline
