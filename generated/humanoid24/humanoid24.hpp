#pragma once
// humanoid24: rigid-body dynamics as straight-line code.
//
// From humanoid24.urdf and scene.yaml by
//   treeline generate humanoid24.urdf scene.yaml --output humanoid24
//
// Generated; edit the inputs, not this file. It belongs to whoever ran the generator, who may use,
// change and pass it on without condition. It needs C++17 and nothing else: no library, no heap, no
// exception, no branch, no global state. Same input, same bits, same time.
// Compile without -ffast-math.
//
// Conventions: SI units and radians; spatial vectors are linear over angular; matrices are
// row-major. Arguments of one call must not overlap.
//
// Joints, in the order of q and of qd, qdd, tau (fixed base):
//   q 0       qd 0       ankle (revolute): -0.6 .. 0.9 rad, 250 N m, 8 rad/s
//   q 1       qd 1       knee (revolute): -2.4 .. 0 rad, 400 N m, 8 rad/s
//   q 2       qd 2       hip (revolute): -0.5 .. 2.2 rad, 400 N m, 8 rad/s
//   q 3       qd 3       waist_yaw (revolute): -0.8 .. 0.8 rad, 200 N m, 8 rad/s
//   q 4       qd 4       waist_pitch (revolute): -0.4 .. 1.2 rad, 250 N m, 8 rad/s
//   q 5       qd 5       waist_roll (revolute): -0.6 .. 0.6 rad, 200 N m, 8 rad/s
//   q 6       qd 6       left_shoulder_pitch (revolute): -3 .. 1.2 rad, 120 N m, 10 rad/s
//   q 7       qd 7       left_shoulder_roll (revolute): -0.5 .. 2.8 rad, 120 N m, 10 rad/s
//   q 8       qd 8       left_shoulder_yaw (revolute): -1.8 .. 1.8 rad, 100 N m, 10 rad/s
//   q 9       qd 9       left_elbow (revolute): -2.5 .. 0 rad, 80 N m, 12 rad/s
//   q 10      qd 10      left_wrist_yaw (revolute): -2 .. 2 rad, 30 N m, 15 rad/s
//   q 11      qd 11      left_wrist_pitch (revolute): -1.4 .. 1.4 rad, 30 N m, 15 rad/s
//   q 12      qd 12      left_wrist_roll (revolute): -0.9 .. 0.9 rad, 30 N m, 15 rad/s
//   q 13      qd 13      right_shoulder_pitch (revolute): -3 .. 1.2 rad, 120 N m, 10 rad/s
//   q 14      qd 14      right_shoulder_roll (revolute): -2.8 .. 0.5 rad, 120 N m, 10 rad/s
//   q 15      qd 15      right_shoulder_yaw (revolute): -1.8 .. 1.8 rad, 100 N m, 10 rad/s
//   q 16      qd 16      right_elbow (revolute): -2.5 .. 0 rad, 80 N m, 12 rad/s
//   q 17      qd 17      right_wrist_yaw (revolute): -2 .. 2 rad, 30 N m, 15 rad/s
//   q 18      qd 18      right_wrist_pitch (revolute): -1.4 .. 1.4 rad, 30 N m, 15 rad/s
//   q 19      qd 19      right_wrist_roll (revolute): -0.9 .. 0.9 rad, 30 N m, 15 rad/s
//   q 20      qd 20      neck_yaw (revolute): -1.4 .. 1.4 rad, 20 N m, 8 rad/s
//   q 21      qd 21      head_pitch (revolute): -0.6 .. 0.8 rad, 20 N m, 8 rad/s
//   q 22      qd 22      left_eye (revolute): -0.7 .. 0.7 rad, 2 N m, 20 rad/s
//   q 23      qd 23      right_eye (revolute): -0.7 .. 0.7 rad, 2 N m, 20 rad/s
// Operational points, rows of task vectors:
//   from 0    left_hand on left_hand, origin (0, 0, -0.086) m in the link, world axes: x y z rx ry rz
//   from 6    right_hand on right_hand, origin (0, 0, -0.086) m in the link, world axes: x y z rx ry rz
// Gravity (0.0, 0.0, -9.81) m/s^2 in world axes.
// Bounds of rounding errors hold for inputs, taken as exact, of |q| <= 0.9 2.4 2.2 0.8 1.2 0.6 3
//   2.8 1.8 2.5 2 1.4 0.9 3 2.8 1.8 2.5 2 1.4 0.9 1.4 0.8 0.7 0.7, |qd| <= 8 8 8 8 8 8 10 10 10 12
//   15 15 15 10 10 10 12 15 15 15 8 8 20 20, |qdd| <= 100, |qdd_0| <= 100, |tau| <= 250 400 400 200
//   250 200 120 120 100 80 30 30 30 120 120 100 80 30 30 30 20 20 2 2, |xdd_cmd| <= 100.

namespace humanoid24 {

using Real = double;
inline constexpr int kCoordinates = 24;  // of q
inline constexpr int kVelocities = 24;  // of qd, qdd, tau
inline constexpr int kTaskRows = 12;  // stacked over the operational points

/// x_world = R x_point + p, for every operational point
/// By outward recursion, alike limbs in lanes.
/// in  q (24): joint coordinates
/// out position (6): positions in the world, m, one point after the other
/// out rotation (18): rotation matrices, row-major, point's axes to world, one point after the other
/// Cost: 370 flops (add 132, mul 238, div 0), sine and cosine of 20 angles.
/// Stack: at most 74 values live at once, 592 bytes.
/// Rounding: at most 5.7e-15 in position (at position[2]), 12 ulp of 2.3e+00, the most that
///   position can be; at most 5.6e-15 in rotation (at rotation[1]), 26 ulp of 1.1e+00, the most that
///   rotation can be.
void forward_kinematics(const Real (&q)[24], Real (&position)[6], Real (&rotation)[18]) noexcept;

/// xd = J qd, rows stacked over operational points
/// By rows carried inward from each point, alike limbs in lanes.
/// in  q (24): joint coordinates
/// out J (12x24): Jacobian
/// Cost: 560 flops (add 192, mul 368, div 0), sine and cosine of 20 angles.
/// Stack: at most 161 values live at once, 1288 bytes.
/// Rounding: at most 9.6e-15 in J (at J[0]), 14 ulp of 3.4e+00, the most that J can be.
void jacobian(const Real (&q)[24], Real (&J)[288]) noexcept;

/// xdd = J qdd + Jd qd: the term Jd qd
/// By outward recursion, Chang eq. 6.11, alike limbs in lanes.
/// in  q (24): joint coordinates
/// in  qd (24): joint velocities
/// out bias (12): accelerations of the task rows at qdd = 0
/// Cost: 824 flops (add 315, mul 509, div 0), sine and cosine of 20 angles.
/// Stack: at most 105 values live at once, 840 bytes.
/// Rounding: at most 4.4e-10 in bias (at bias[0]), 48 ulp of 4.1e+04, the most that bias can be.
void bias_acceleration(const Real (&q)[24], const Real (&qd)[24], Real (&bias)[12]) noexcept;

/// tau = M qdd + b + g - J_ext^T f_ext
/// By recursive Newton-Euler, Chang table 4.1, alike limbs in lanes.
/// in  q (24): joint coordinates
/// in  qd (24): joint velocities
/// in  qdd (24): joint accelerations
/// out tau (24): joint forces
/// Cost: 1939 flops (add 915, mul 1024, div 0), sine and cosine of 24 angles.
/// Stack: at most 312 values live at once, 2496 bytes.
/// Rounding: at most 1.4e-09 in tau (at tau[0]), 35 ulp of 1.9e+05, the most that tau can be.
void inverse_dynamics(const Real (&q)[24], const Real (&qd)[24], const Real (&qdd)[24],
    Real (&tau)[24]) noexcept;

/// g: the joint forces that hold the robot at rest
/// By recursive Newton-Euler, Chang table 4.1, alike limbs in lanes.
/// in  q (24): joint coordinates
/// out g (24): joint forces
/// Cost: 378 flops (add 152, mul 226, div 0), sine and cosine of 24 angles.
/// Stack: at most 97 values live at once, 776 bytes.
/// Rounding: at most 1.4e-12 in g (at g[0]), 8 ulp of 8.1e+02, the most that g can be.
void gravity(const Real (&q)[24], Real (&g)[24]) noexcept;

/// h = b + g: the joint forces at qdd = 0
/// By recursive Newton-Euler, Chang table 4.1, alike limbs in lanes.
/// in  q (24): joint coordinates
/// in  qd (24): joint velocities
/// out h (24): joint forces
/// Cost: 1863 flops (add 863, mul 1000, div 0), sine and cosine of 24 angles.
/// Stack: at most 292 values live at once, 2336 bytes.
/// Rounding: at most 1.5e-09 in h (at h[0]), 36 ulp of 1.9e+05, the most that h can be.
void nonlinear_effects(const Real (&q)[24], const Real (&qd)[24], Real (&h)[24]) noexcept;

/// tau = M qdd + b + g: the matrix M
/// By composite rigid bodies, RBDA table 6.2, alike limbs in lanes.
/// in  q (24): joint coordinates
/// out M (24x24): joint-space inertia
/// Cost: 2233 flops (add 934, mul 1299, div 0), sine and cosine of 23 angles.
/// Stack: at most 226 values live at once, 1808 bytes.
/// Rounding: at most 4.4e-13 in M (at M[0]), 12 ulp of 1.7e+02, the most that M can be.
void mass_matrix(const Real (&q)[24], Real (&M)[576]) noexcept;

/// qdd = M^-1 (tau - b - g + J_ext^T f_ext)
/// By articulated bodies, Chang table 4.2, alike limbs in lanes.
/// in  q (24): joint coordinates
/// in  qd (24): joint velocities
/// in  tau (24): joint forces
/// out qdd (24): joint accelerations
/// Cost: 4579 flops (add 2154, mul 2393, div 32), sine and cosine of 24 angles.
/// Stack: at most 402 values live at once, 3216 bytes.
/// Rounding: at most 4e-07 in qdd (at qdd[6]), 3704 ulp of 5e+05, to first order, 4 times what a
///   search met.
void forward_dynamics(const Real (&q)[24], const Real (&qd)[24], const Real (&tau)[24],
    Real (&qdd)[24]) noexcept;

/// Lambda^-1 = J M^-1 J^T
/// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in lanes.
/// in  q (24): joint coordinates
/// out Lambda_inv (12x12): inverse operational-space inertia
/// Cost: 6251 flops (add 2644, mul 3575, div 32), sine and cosine of 24 angles.
/// Stack: at most 424 values live at once, 3392 bytes.
/// Rounding: at most 2e-10 in Lambda_inv (at Lambda_inv[143]), 210 ulp of 4e+03, to first order, 4
///   times what a search met.
void lambda_inverse(const Real (&q)[24], Real (&Lambda_inv)[144]) noexcept;

/// Lambda = (J M^-1 J^T)^-1
/// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points, alike limbs in lanes.
/// in  q (24): joint coordinates
/// out Lambda (12x12): operational-space inertia
/// Cost: 7979 flops (add 3436, mul 4499, div 44), sine and cosine of 24 angles.
/// Stack: at most 350 values live at once, 2800 bytes.
/// Rounding: in 50, 90, 99 of 100 states, to first order, at most 7e-13 (2000 ulp of 3e+00), 8e-12
///   (4000 ulp of 1e+01), 6e-11 (7000 ulp of 4e+01) in Lambda; more towards singularities.
void lambda(const Real (&q)[24], Real (&Lambda)[144]) noexcept;

/// tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
/// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins, alike limbs in lanes.
/// in  q (24): joint coordinates
/// in  qd (24): joint velocities
/// in  qdd_0 (24): joint accelerations that the posture asks for
/// in  xdd_cmd (12): commanded accelerations of the task rows
/// out tau (24): joint forces
/// Cost: 8497 flops (add 3741, mul 4712, div 44), sine and cosine of 24 angles.
/// Stack: at most 419 values live at once, 3352 bytes.
/// Rounding: in 50, 90, 99 of 100 states, to first order, at most 5e-11 (30 ulp of 1e+04), 2e-10
///   (200 ulp of 5e+03), 3e-10 (200 ulp of 9e+03) in tau; more towards singularities.
void control_torque(const Real (&q)[24], const Real (&qd)[24], const Real (&qdd_0)[24],
    const Real (&xdd_cmd)[12], Real (&tau)[24]) noexcept;

}  // namespace humanoid24
