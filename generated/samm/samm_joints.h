// SPDX-License-Identifier: 0BSD
#ifndef TREELINE_SAMM_JOINTS_H
#define TREELINE_SAMM_JOINTS_H
// samm: names and limits, as arrays in the order of the arguments of samm.h.
// Generated; it needs no other file.

/// Stands for a limit that the URDF does not state: the largest finite number.
#define SAMM_UNLIMITED 1.7976931348623157e+308

/// Of each entry of q: its joint, and what it measures.
static const char* const samm_coordinate_joints[9] = {
    "base_x", "base_y", "base_yaw", "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"};
static const char* const samm_coordinate_meanings[9] = {
    "displacement, m", "displacement, m", "angle, rad", "angle, rad", "angle, rad", "angle, rad",
    "angle, rad", "angle, rad", "angle, rad"};

/// A state to begin with: 0, or the limit next to it; quaternions turn nothing.
static const double samm_home[9] = {
    0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0};

/// Limits of each entry of q, rad or m.
static const double samm_lower_limits[9] = {
    -10.0, -10.0, -SAMM_UNLIMITED, -2.79, -3.93, -0.79, -1.92, -1.75, -4.64};
static const double samm_upper_limits[9] = {
    10.0, 10.0, SAMM_UNLIMITED, 2.79, 0.79, 3.93, 2.97, 1.75, 4.64};

/// Of each entry of qd, qdd and tau: its joint, and its name with the unit of qd.
static const char* const samm_velocity_joints[9] = {
    "base_x", "base_y", "base_yaw", "joint1", "joint2", "joint3", "joint4", "joint5", "joint6"};
static const char* const samm_velocity_names[9] = {
    "base_x, m/s", "base_y, m/s", "base_yaw, rad/s", "joint1, rad/s", "joint2, rad/s",
    "joint3, rad/s", "joint4, rad/s", "joint5, rad/s", "joint6, rad/s"};

/// The largest magnitude of each entry of qd, rad/s or m/s, and of tau, N m or N.
static const double samm_velocity_limits[9] = {
    1.5, 1.5, 2.5, 8.0, 10.0, 10.0, 10.0, 10.0, 10.0};
static const double samm_effort_limits[9] = {
    1000.0, 1000.0, 300.0, 97.6, 186.4, 89.4, 24.2, 20.1, 21.3};

/// Of each task row: its point, and along or about which axis it is.
static const char* const samm_task_row_names[6] = {
    "tool x", "tool y", "tool z", "tool rx", "tool ry", "tool rz"};

#endif  // TREELINE_SAMM_JOINTS_H
