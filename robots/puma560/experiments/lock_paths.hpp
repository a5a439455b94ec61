#pragma once

#include <array>

#include "core/spline.hpp"

/// Paths of the tool into, through and out of the three basic singularities of the PUMA (Chang
/// appendix A, fig. A.1): elbow, head and wrist lock.
namespace treeline::experiments {

/// Desired pose and its rates; world axes, linear over angular.
struct ToolMotion {
  double position[3] = {};
  double rotation[9] = {};
  double velocity[6] = {};
  double acceleration[6] = {};
};

enum class Lock { elbow, head, wrist };
inline constexpr std::array kLocks{Lock::elbow, Lock::head, Lock::wrist};
/// Name of a lock: "Elbow lock" and so on.
const char* name_of(Lock lock);

/// Path from a start configuration, along one direction or about one axis at a time, with rests
/// between.
struct LockPath {
  double start[6] = {};  ///< q, rad
  double duration = 0.0;
  double position[3] = {};  ///< of the tool at the start, m
  double rotation[9] = {};
  double line[3] = {};     ///< unit vector of translation
  double axes[2][3] = {};  ///< unit vectors, world: axis of the first rotation, and of the others
  core::CubicSegment<1, double> travel[2];  ///< m along `line`, one after the other
  core::CubicSegment<1, double> turns[3];   ///< rad
};

/// Makes the path through a lock. Elbow: outward along the line from shoulder to wrist, to 2 cm
/// beyond reach, and back, with constant orientation; the elbow shall come back on its other side.
/// Head: the wrist's centre moves horizontally towards joint 1's axis, overhead, to 2 cm nearer
/// than the shoulder's offset permits, and back, with constant orientation; joint 1 shall come back
/// rotated, with the arm leaning the other way. Wrist: rotates until joint 5 is zero, then about
/// the direction that is lost there, then back through the lock to the other side.
LockPath make_path(Lock lock);

/// Angle of joint 2 (rad) at which the wrist's centre is `ahead` (m) of joint 1's axis in the arm's
/// plane, for a given angle of joint 3. At 0 it is as near to the axis as the shoulder's offset
/// permits.
double overhead(double q3, double ahead = 0.0);

/// Angle of joint 3 (rad) at which shoulder, elbow and wrist are in line.
double elbow_lock();

/// Desired motion of the tool at time t (s).
ToolMotion motion_at(const LockPath& path, double t);

}  // namespace treeline::experiments
