#pragma once

#include <array>

#include "core/spline.hpp"

/// The tool's paths into, through and out of the three basic singularities of the PUMA (Chang
/// appendix A, fig. A.1): elbow, head and wrist lock.
namespace treeline::experiments {

/// A wanted pose and its rates; world axes, linear over angular.
struct ToolMotion {
  double position[3] = {};
  double rotation[9] = {};
  double velocity[6] = {};
  double acceleration[6] = {};
};

enum class Lock { elbow, head, wrist };
inline constexpr std::array kLocks{Lock::elbow, Lock::head, Lock::wrist};
/// "Elbow lock" and so on.
const char* name_of(Lock lock);

/// From a start configuration along one direction or about one axis at a time; rests between.
struct LockPath {
  double start[6] = {};  ///< q, rad
  double duration = 0.0;
  double position[3] = {};  ///< of the tool at the start
  double rotation[9] = {};
  double line[3] = {};     ///< unit vector of translation
  double axes[2][3] = {};  ///< unit vectors, world: of the first turn, and of the others
  core::CubicSegment<1, double> travel[2];  ///< m along `line`, one after the other
  core::CubicSegment<1, double> turns[3];   ///< rad
};

/// Elbow: outward along shoulder-wrist to 2 cm beyond reach and back again, orientation kept; the
/// elbow is to come back on its other side. Head: the wrist's centre goes horizontally towards
/// joint 1's axis to 2 cm nearer than the shoulder's offset lets it come, overhead, and back again,
/// orientation kept; joint 1 is to come back turned and the arm leaning the other way. Wrist: turns
/// joint 5 to zero, then turns about the direction that is lost there, then back through the lock
/// to the other side.
LockPath make_path(Lock lock);

/// Joint 2 (rad) where the wrist's centre is in joint 1's axis plus `ahead` (m) in the arm's plane,
/// for a given joint 3. At 0 it is as near to the axis as the shoulder's offset lets it be.
double overhead(double q3, double ahead = 0.0);

/// Joint 3 (rad) where shoulder, elbow and wrist are in line.
double elbow_lock();

/// Where the tool is wanted at time t (s).
ToolMotion motion_at(const LockPath& path, double t);

}  // namespace treeline::experiments
