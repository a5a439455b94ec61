#pragma once

#include "core/spline.hpp"

/// The tool's paths into, through and out of the PUMA's elbow lock and wrist lock (Chang fig. A.1).
namespace treeline::experiments {

/// A wanted pose and its rates; world axes, linear over angular.
struct ToolMotion {
  double position[3] = {};
  double rotation[9] = {};
  double velocity[6] = {};
  double acceleration[6] = {};
};

enum class Lock { elbow, wrist };

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
/// elbow is to come back on its other side. Wrist: turns joint 5 to zero, then turns about the
/// direction that is lost there, then back through the lock to the other side.
LockPath make_path(Lock lock);

/// Joint 3 (rad) where shoulder, elbow and wrist are in line.
double elbow_lock();

/// Where the tool is wanted at time t (s).
ToolMotion motion_at(const LockPath& path, double t);

}  // namespace treeline::experiments
