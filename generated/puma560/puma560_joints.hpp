// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_PUMA560_JOINTS_HPP
#define TREELINE_PUMA560_JOINTS_HPP
// puma560: names and limits, as arrays in the order of the arguments of puma560.hpp.
// Generated; it needs no other file.

namespace puma560 {

/// Stands for a limit that the URDF does not state: the largest finite number.
inline constexpr double kUnlimited = 1.7976931348623157e+308;

/// The joint of each entry of q, and what the entry measures.
inline constexpr const char* kCoordinateJoints[6] = {
    "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"};
inline constexpr const char* kCoordinateMeanings[6] = {
    "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad"};

/// A state to begin with: 0, or the limit next to it; quaternions turn nothing.
inline constexpr double kHome[6] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

/// Limits of each entry of q, rad or m.
inline constexpr double kLowerLimits[6] = {
    -2.79, -3.93, -0.79, -1.92, -1.75, -4.64};
inline constexpr double kUpperLimits[6] = {
    2.79, 0.79, 3.93, 2.97, 1.75, 4.64};

/// The joint of each entry of qd, qdd and tau, and the entry's name with the unit of qd.
inline constexpr const char* kVelocityJoints[6] = {
    "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"};
inline constexpr const char* kVelocityNames[6] = {
    "joint1, rad/s", "joint2, rad/s", "joint3, rad/s", "joint4, rad/s", "joint5, rad/s",
    "joint6, rad/s"};

/// The largest magnitude of each entry of qd, rad/s or m/s, and of tau, N m or N.
inline constexpr double kVelocityLimits[6] = {
    8.0, 10.0, 10.0, 10.0, 10.0, 10.0};
inline constexpr double kEffortLimits[6] = {
    97.6, 186.4, 89.4, 24.2, 20.1, 21.3};

/// Of each task row: its point, and along or about which axis it is.
inline constexpr const char* kTaskRowNames[6] = {
    "tool x", "tool y", "tool z", "tool rx", "tool ry", "tool rz"};

/// Where a name first stands in a list of names; -1 if nowhere.
template <decltype(sizeof(0)) size>
constexpr int index_of(const char* const (&names)[size], const char* name) noexcept {
  int index = 0;
  for (const char* const each : names) {
    int k = 0;
    while (each[k] != '\0' && each[k] == name[k]) ++k;
    if (each[k] == name[k]) return index;
    ++index;
  }
  return -1;
}
/// First entry of a joint in q, or in qd, qdd and tau; -1 if no joint of this name moves.
constexpr int coordinate_index(const char* joint) noexcept {
  return index_of(kCoordinateJoints, joint);
}
constexpr int velocity_index(const char* joint) noexcept {
  return index_of(kVelocityJoints, joint);
}

}  // namespace puma560

#endif  // TREELINE_PUMA560_JOINTS_HPP
