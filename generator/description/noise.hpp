#pragma once

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// CAD programs write what their own rounding left: angles of 1.1e-27 rad, half turns that are
/// 7e-16 rad off, offsets of 3e-17 m. What double cannot resolve is taken as the exact number that
/// it stands beside; the rest is kept as it is written.

/// Doubles about pi are 2^-51 apart: no angle that a program computed in double means less. Of
/// lengths, the share of the robot's longest offset that means nothing beside it.
inline constexpr double kResolution = 0x1p-51;

/// The largest `Scene::noise`.
inline constexpr double kMostNoise = 1e-9;

/// Limits below which numbers of a robot's files are noise; nothing is noise where both are 0.
struct NoiseLimits {
  double angle = 0;   ///< rad; of an axis, share of its largest component
  double length = 0;  ///< m
};

/// `scene.noise`, and that share of the longest offset in the robot's joints and masses.
NoiseLimits noise_limits(const Robot& robot, const Scene& scene);

/// The robot with angles within `limits.angle` of a quarter turn, lesser components of axes, and
/// offsets within `limits.length` exact; angles, and offsets, that differ by no more, but for
/// signs, are made equal. Components of centres of mass near their joints are noise only beside
/// that distance. `decisions`: what is, appended.
Robot without_noise(Robot robot, const NoiseLimits& limits, NoiseDecisions* decisions = nullptr);

/// Likewise the poses of the scene's points, objects and grasps.
Scene without_noise(Scene scene, const NoiseLimits& limits, NoiseDecisions* decisions = nullptr);

/// The robot as `scene.snap_angles` and a `scene.noise` above `kResolution` ask for it: what the
/// generator starts from, and what its results are checked against.
Robot as_asked(Robot robot, const Scene& scene);

/// One note for each file in which numbers are taken as exact, and how to see and undo it.
void note_noise(const NoiseDecisions& decisions, const Scene& scene, Diagnostics& diagnostics);

/// Number of resolutions of a centre of mass's distance from its joint within which a component of
/// it may be noise. The moment that a light tip exerts on its own joint is as small as that
/// distance, so noise of the robot's size may be much beside it. What is left out costs that moment
/// 64 ulp at most. With fewer, noise of 1e-16 m beside centimetres would stay and cost operations.
inline constexpr double kOfDistance = 32;

}  // namespace treeline
