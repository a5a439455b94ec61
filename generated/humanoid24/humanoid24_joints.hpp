// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_HUMANOID24_JOINTS_HPP
#define TREELINE_HUMANOID24_JOINTS_HPP
// humanoid24: names and limits, as arrays in the order of the arguments of humanoid24.hpp.
// Generated; it needs no other file.

namespace humanoid24 {

/// Stands for a limit that the URDF does not state: the largest finite number.
inline constexpr double kUnlimited = 1.7976931348623157e+308;

/// The joint of each entry of q, and what the entry measures.
inline constexpr const char* kCoordinateJoints[24] = {
    "ankle", "knee", "hip", "waist_yaw", "waist_pitch", "waist_roll", "left_shoulder_pitch",
    "left_shoulder_roll", "left_shoulder_yaw", "left_elbow", "left_wrist_yaw", "left_wrist_pitch",
    "left_wrist_roll", "right_shoulder_pitch", "right_shoulder_roll", "right_shoulder_yaw",
    "right_elbow", "right_wrist_yaw", "right_wrist_pitch", "right_wrist_roll", "neck_yaw",
    "head_pitch", "left_eye", "right_eye"};
inline constexpr const char* kCoordinateMeanings[24] = {
    "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad",
    "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad",
    "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad",
    "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad"};

/// A state to begin with: 0, or the limit next to it; quaternions turn nothing.
inline constexpr double kHome[24] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
    0.0, 0.0, 0.0, 0.0, 0.0};

/// Limits of each entry of q, rad or m.
inline constexpr double kLowerLimits[24] = {
    -0.6, -2.4, -0.5, -0.8, -0.4, -0.6, -3.0, -0.5, -1.8, -2.5, -2.0, -1.4, -0.9, -3.0, -2.8, -1.8,
    -2.5, -2.0, -1.4, -0.9, -1.4, -0.6, -0.7, -0.7};
inline constexpr double kUpperLimits[24] = {
    0.9, 0.0, 2.2, 0.8, 1.2, 0.6, 1.2, 2.8, 1.8, 0.0, 2.0, 1.4, 0.9, 1.2, 0.5, 1.8, 0.0, 2.0, 1.4,
    0.9, 1.4, 0.8, 0.7, 0.7};

/// The joint of each entry of qd, qdd and tau, and the entry's name with the unit of qd.
inline constexpr const char* kVelocityJoints[24] = {
    "ankle", "knee", "hip", "waist_yaw", "waist_pitch", "waist_roll", "left_shoulder_pitch",
    "left_shoulder_roll", "left_shoulder_yaw", "left_elbow", "left_wrist_yaw", "left_wrist_pitch",
    "left_wrist_roll", "right_shoulder_pitch", "right_shoulder_roll", "right_shoulder_yaw",
    "right_elbow", "right_wrist_yaw", "right_wrist_pitch", "right_wrist_roll", "neck_yaw",
    "head_pitch", "left_eye", "right_eye"};
inline constexpr const char* kVelocityNames[24] = {
    "ankle, rad/s", "knee, rad/s", "hip, rad/s", "waist_yaw, rad/s", "waist_pitch, rad/s",
    "waist_roll, rad/s", "left_shoulder_pitch, rad/s", "left_shoulder_roll, rad/s",
    "left_shoulder_yaw, rad/s", "left_elbow, rad/s", "left_wrist_yaw, rad/s",
    "left_wrist_pitch, rad/s", "left_wrist_roll, rad/s", "right_shoulder_pitch, rad/s",
    "right_shoulder_roll, rad/s", "right_shoulder_yaw, rad/s", "right_elbow, rad/s",
    "right_wrist_yaw, rad/s", "right_wrist_pitch, rad/s", "right_wrist_roll, rad/s",
    "neck_yaw, rad/s", "head_pitch, rad/s", "left_eye, rad/s", "right_eye, rad/s"};

/// The largest magnitude of each entry of qd, rad/s or m/s, and of tau, N m or N.
inline constexpr double kVelocityLimits[24] = {
    8.0, 8.0, 8.0, 8.0, 8.0, 8.0, 10.0, 10.0, 10.0, 12.0, 15.0, 15.0, 15.0, 10.0, 10.0, 10.0, 12.0,
    15.0, 15.0, 15.0, 8.0, 8.0, 20.0, 20.0};
inline constexpr double kEffortLimits[24] = {
    250.0, 400.0, 400.0, 200.0, 250.0, 200.0, 120.0, 120.0, 100.0, 80.0, 30.0, 30.0, 30.0, 120.0,
    120.0, 100.0, 80.0, 30.0, 30.0, 30.0, 20.0, 20.0, 2.0, 2.0};

/// Of each task row: its point, and along or about which axis it is.
inline constexpr const char* kTaskRowNames[12] = {
    "left_hand x", "left_hand y", "left_hand z", "left_hand rx", "left_hand ry", "left_hand rz",
    "right_hand x", "right_hand y", "right_hand z", "right_hand rx", "right_hand ry",
    "right_hand rz"};

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

}  // namespace humanoid24

#endif  // TREELINE_HUMANOID24_JOINTS_HPP
