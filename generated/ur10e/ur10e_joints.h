// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_UR10E_JOINTS_H
#define TREELINE_UR10E_JOINTS_H
// ur10e: names and limits, as arrays in the order of the arguments of ur10e.h.
// Generated; it needs no other file.

/// Stands for a limit that the URDF does not state: the largest finite number.
#define UR10E_UNLIMITED 1.7976931348623157e+308

/// Of each entry of q: its joint, and what it measures.
static const char* const ur10e_coordinate_joints[6] = {
    "shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"};
static const char* const ur10e_coordinate_meanings[6] = {
    "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad", "angle, rad"};

/// A state to begin with: 0, or the limit next to it; quaternions turn nothing.
static const double ur10e_home[6] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

/// Limits of each entry of q, rad or m.
static const double ur10e_lower_limits[6] = {
    -6.283185307179586, -6.283185307179586, -3.141592653589793, -6.283185307179586,
    -6.283185307179586, -6.283185307179586};
static const double ur10e_upper_limits[6] = {
    6.283185307179586, 6.283185307179586, 3.141592653589793, 6.283185307179586, 6.283185307179586,
    6.283185307179586};

/// Of each entry of qd, qdd and tau: its joint, and its name with the unit of qd.
static const char* const ur10e_velocity_joints[6] = {
    "shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"};
static const char* const ur10e_velocity_names[6] = {
    "shoulder_pan, rad/s", "shoulder_lift, rad/s", "elbow, rad/s", "wrist_1, rad/s",
    "wrist_2, rad/s", "wrist_3, rad/s"};

/// The largest magnitude of each entry of qd, rad/s or m/s, and of tau, N m or N.
static const double ur10e_velocity_limits[6] = {
    2.0944, 2.0944, 3.1416, 3.1416, 3.1416, 3.1416};
static const double ur10e_effort_limits[6] = {
    330.0, 330.0, 150.0, 56.0, 56.0, 56.0};

/// Of each task row: its point, and along or about which axis it is.
static const char* const ur10e_task_row_names[6] = {
    "tool x", "tool y", "tool z", "tool rx", "tool ry", "tool rz"};

#endif  // TREELINE_UR10E_JOINTS_H
