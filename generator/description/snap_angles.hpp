#pragma once

#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The widest tolerance for `Scene::snap_angles`, rad: 3.1416 is 7.3e-6 rad from pi.
inline constexpr double kWidestSnap = 1e-5;

/// Angles at the origins of joints, masses and points are written as decimals. One counts as a
/// rounded number of quarter turns if it has four decimals or more and is that number, rounded or
/// cut off at its last decimal: 1.5708 and 1.570796 are pi/2, 1.57 and 1.570795 are angles of their
/// own. What is within 1e-12 of a quarter turn counts as that. The multiple of pi/2 that `angle`
/// (rad) stands for, as a double, if it is at most `tolerance` (rad) away; nothing where `angle` is
/// that double or within `kResolution` of it. Other fractions of pi would save no operation.
std::optional<double> rounded_quarter_turns(double angle, double tolerance);

/// `-3 pi/2` for a multiple of pi/2.
std::string name_quarter_turns(double angle);

/// The robot with rounded quarter turns at origins of its joints and masses replaced by exact ones;
/// as it is for a tolerance of 0.
Robot with_snapped_angles(Robot robot, double tolerance);

/// Replaces rounded quarter turns in the scene's own points by exact ones, and says of every angle
/// of robot and scene that is replaced, each value once, what it was, what it counts as and how to
/// leave it. With a tolerance of 0 nothing is replaced: then one note says what could be.
void snap_angles(const Robot& robot, Scene& scene, Diagnostics& diagnostics);

}  // namespace treeline
