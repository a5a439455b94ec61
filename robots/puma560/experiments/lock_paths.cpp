#include "lock_paths.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "core/orientation.hpp"
#include "puma560.hpp"

namespace treeline::experiments {
namespace {

// Dimensions in the URDF (README.md): upper arm, forearm with its small offset, height, flange.
constexpr double kUpperArm = 0.4318;
constexpr double kForearmAlong = 0.4331;
constexpr double kForearmAcross = 0.0203;
constexpr double kShoulderHeight = 0.6718;
constexpr double kFlange = 0.05625;
constexpr double kShoulderOffset = 0.2435 - 0.0934;  // of the arm's plane from joint 1's axis

core::CubicSegment<1, double> segment(double from, double to, double duration) {
  const double a[1] = {from};
  const double b[1] = {to};
  return core::rest_to_rest(a, b, duration);
}

/// out = rotation about `axis` by `angle`, times R.
void turn(const double (&axis)[3], double angle, double (&R)[9]) {
  const double vector[3] = {angle * axis[0], angle * axis[1], angle * axis[2]};
  double by[9];
  double kept[9];
  core::rotation_from_vector(vector, by);
  std::copy(std::begin(R), std::end(R), std::begin(kept));
  for (int i = 0; i < 9; ++i) {
    R[i] = 0.0;
    for (int k = 0; k < 3; ++k) {
      R[i] += by[i / 3 * 3 + k] * kept[3 * k + i % 3];
    }
  }
}

void make_elbow_path(LockPath& path) {
  const double start[6] = {0.0, -0.9, elbow_lock() - 0.6, 0.0, 1.4, 0.0};
  std::copy(std::begin(start), std::end(start), std::begin(path.start));
  puma560::forward_kinematics(path.start, path.position, path.rotation);
  // Joint 1 is zero, so the arm's plane is y = const. The wrist is behind the flange by its length.
  const double wrist_x = path.position[0] - kFlange * path.rotation[2];
  const double wrist_z = path.position[2] - kFlange * path.rotation[8] - kShoulderHeight;
  const double distance = std::hypot(wrist_x, wrist_z);
  path.line[0] = wrist_x / distance;
  path.line[2] = wrist_z / distance;
  const double reach = kUpperArm + std::hypot(kForearmAlong, kForearmAcross);
  const double far = reach - distance + 0.02;
  path.travel[0] = segment(0.0, far, 1.5);
  path.travel[1] = segment(far, 0.0, 1.5);
  path.duration = 4.0;
}

void make_head_path(LockPath& path) {
  constexpr double kBent = 0.7;
  constexpr double kAhead = 0.1;
  const double q3 = elbow_lock() + kBent;
  const double start[6] = {0.0, overhead(q3, kAhead), q3, 1.57, 1.3, 0.0};
  std::copy(std::begin(start), std::end(start), std::begin(path.start));
  puma560::forward_kinematics(path.start, path.position, path.rotation);
  double away[2];
  for (int i = 0; i < 2; ++i) {
    away[i] = path.position[i] - kFlange * path.rotation[3 * i + 2];
  }
  const double distance = std::hypot(away[0], away[1]);
  path.line[0] = -away[0] / distance;
  path.line[1] = -away[1] / distance;
  const double far = distance - kShoulderOffset + 0.02;
  path.travel[0] = segment(0.0, far, 1.5);
  path.travel[1] = segment(far, 0.0, 1.5);
  path.duration = 4.0;
}

void make_wrist_path(LockPath& path) {
  const double start[6] = {0.0, -0.9, elbow_lock() + 1.2, 0.0, 0.5, 0.0};
  const double lock[6] = {start[0], start[1], start[2], 0.0, 0.0, 0.0};
  std::copy(std::begin(start), std::end(start), std::begin(path.start));
  puma560::forward_kinematics(path.start, path.position, path.rotation);
  // At the lock, y of the flange's frame is along axis 5 and x along the lost direction.
  double position[3];
  double R[9];
  puma560::forward_kinematics(lock, position, R);
  double square = 0.0;
  for (int i = 0; i < 3; ++i) {
    path.line[i] = position[i] - path.position[i];
    path.axes[0][i] = R[3 * i + 1];
    path.axes[1][i] = R[3 * i];
    square += path.line[i] * path.line[i];
  }
  const double far = std::sqrt(square);
  for (double& component : path.line) {
    component /= far;
  }
  path.travel[0] = segment(0.0, far, 1.0);
  path.travel[1] = segment(far, far, 1.0);
  path.turns[0] = segment(0.0, -start[4], 1.0);
  path.turns[1] = segment(0.0, 0.6, 1.5);
  path.turns[2] = segment(0.6, -0.6, 1.5);
  path.duration = 4.5;
}

/// Adds the linear or angular rates of a segment along or about `direction`.
void add_rates(const core::Motion<1, double>& s, const double (&direction)[3], int first,
               ToolMotion& motion) {
  for (int i = 0; i < 3; ++i) {
    motion.velocity[first + i] += s.velocity[0] * direction[i];
    motion.acceleration[first + i] += s.acceleration[0] * direction[i];
  }
}

}  // namespace

double elbow_lock() {
  return std::atan2(kForearmAlong, -kForearmAcross);
}

const char* name_of(Lock lock) {
  switch (lock) {
    case Lock::elbow:
      return "Elbow lock";
    case Lock::head:
      return "Head lock";
    case Lock::wrist:
      return "Wrist lock";
  }
  return "";
}

double overhead(double q3, double ahead) {
  // Joint 2 rotates the wrist's centre about y, starting from its place at zero.
  const double forearm = std::hypot(kForearmAlong, kForearmAcross);
  const double leaning = q3 + std::atan2(-kForearmAcross, kForearmAlong);
  const double x = kUpperArm + forearm * std::sin(leaning);
  const double z = forearm * std::cos(leaning);
  return std::asin(ahead / std::hypot(x, z)) - std::atan2(x, z);
}

LockPath make_path(Lock lock) {
  LockPath path;
  path.travel[0] = path.travel[1] = segment(0.0, 0.0, 1.0);
  path.turns[0] = path.turns[1] = path.turns[2] = segment(0.0, 0.0, 1.0);
  if (lock == Lock::elbow) {
    make_elbow_path(path);
  } else if (lock == Lock::head) {
    make_head_path(path);
  } else {
    make_wrist_path(path);
  }
  return path;
}

ToolMotion motion_at(const LockPath& path, double t) {
  ToolMotion motion;
  const bool back = t > path.travel[0].duration;
  const auto s = back ? path.travel[1].at(t - path.travel[0].duration) : path.travel[0].at(t);
  for (int i = 0; i < 3; ++i) {
    motion.position[i] = path.position[i] + s.position[0] * path.line[i];
  }
  add_rates(s, path.line, 0, motion);
  // Only one rotation takes place at a time, so rates add although rotations do not commute.
  std::copy(std::begin(path.rotation), std::end(path.rotation), std::begin(motion.rotation));
  const auto first = path.turns[0].at(t);
  const double after = t - path.turns[0].duration;
  const bool last = after > path.turns[1].duration;
  const auto second =
      last ? path.turns[2].at(after - path.turns[1].duration) : path.turns[1].at(after);
  turn(path.axes[0], first.position[0], motion.rotation);
  turn(path.axes[1], second.position[0], motion.rotation);
  add_rates(first, path.axes[0], 3, motion);
  add_rates(second, path.axes[1], 3, motion);
  return motion;
}

}  // namespace treeline::experiments
