#pragma once
// puma560: rigid-body dynamics as straight-line code.
//
// From puma560.urdf and scene.yaml by
//   treeline generate puma560.urdf scene.yaml --output puma560
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
//   q 0       qd 0       joint1 (revolute): -2.79 .. 2.79 rad, 97.6 N m, 8 rad/s
//   q 1       qd 1       joint2 (revolute): -3.93 .. 0.79 rad, 186.4 N m, 10 rad/s
//   q 2       qd 2       joint3 (revolute): -0.79 .. 3.93 rad, 89.4 N m, 10 rad/s
//   q 3       qd 3       joint4 (revolute): -1.92 .. 2.97 rad, 24.2 N m, 10 rad/s
//   q 4       qd 4       joint5 (revolute): -1.75 .. 1.75 rad, 20.1 N m, 10 rad/s
//   q 5       qd 5       joint6 (revolute): -4.64 .. 4.64 rad, 21.3 N m, 10 rad/s
// Operational points, rows of task vectors:
//   from 0    tool on tool, origin (0, 0, 0) m in the link, world axes: x y z rx ry rz
// Gravity (0.0, 0.0, -9.81) m/s^2 in world axes.
// Bounds of rounding errors hold for inputs, taken as exact, of |q| <= 2.79 3.93 3.93 2.97 1.75
//   4.64, |qd| <= 8 10 10 10 10 10, |qdd| <= 100, |qdd_0| <= 100, |tau| <= 97.6 186.4 89.4 24.2
//   20.1 21.3, |xdd_cmd| <= 100.

namespace puma560 {

using Real = double;
inline constexpr int kCoordinates = 6;  // of q
inline constexpr int kVelocities = 6;  // of qd, qdd, tau
inline constexpr int kTaskRows = 6;  // stacked over the operational points

/// x_world = R x_point + p, for every operational point
/// By outward recursion.
/// in  q (6): joint coordinates
/// out position (3): positions in the world, m, one point after the other
/// out rotation (9): rotation matrices, row-major, point's axes to world, one point after the other
/// Cost: 83 flops (add 28, mul 55, div 0), sine and cosine of 6 angles.
/// Stack: at most 33 values live at once, 264 bytes.
/// Rounding: at most 1.1e-15 in position (at position[0]), 3 ulp of 1.7e+00, the most that
///   position can be; at most 3.2e-15 in rotation (at rotation[0]), 9 ulp of 1.8e+00, the most that
///   rotation can be.
void forward_kinematics(const Real (&q)[6], Real (&position)[3], Real (&rotation)[9]) noexcept;

/// xd = J qd, rows stacked over operational points
/// By rows carried inward from each point.
/// in  q (6): joint coordinates
/// out J (6x6): Jacobian
/// Cost: 72 flops (add 21, mul 51, div 0), sine and cosine of 5 angles.
/// Stack: at most 32 values live at once, 256 bytes.
/// Rounding: at most 2.2e-15 in J (at J[23]), 6 ulp of 1.8e+00, the most that J can be.
void jacobian(const Real (&q)[6], Real (&J)[36]) noexcept;

/// xdd = J qdd + Jd qd: the term Jd qd
/// By outward recursion, Chang eq. 6.11.
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// out bias (6): accelerations of the task rows at qdd = 0
/// Cost: 170 flops (add 60, mul 110, div 0), sine and cosine of 5 angles.
/// Stack: at most 40 values live at once, 320 bytes.
/// Rounding: at most 1.5e-11 in bias (at bias[0]), 18 ulp of 3.9e+03, the most that bias can be.
void bias_acceleration(const Real (&q)[6], const Real (&qd)[6], Real (&bias)[6]) noexcept;

/// tau = M qdd + b + g - J_ext^T f_ext
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// in  qdd (6): joint accelerations
/// out tau (6): joint forces
/// Cost: 277 flops (add 119, mul 158, div 0), sine and cosine of 4 angles.
/// Stack: at most 59 values live at once, 472 bytes.
/// Rounding: at most 1.8e-12 in tau (at tau[0]), 8 ulp of 1.1e+03, the most that tau can be.
void inverse_dynamics(const Real (&q)[6], const Real (&qd)[6], const Real (&qdd)[6],
    Real (&tau)[6]) noexcept;

/// g: the joint forces that hold the robot at rest
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (6): joint coordinates
/// out g (6): joint forces
/// Cost: 35 flops (add 10, mul 25, div 0), sine and cosine of 4 angles.
/// Stack: at most 13 values live at once, 104 bytes.
/// Rounding: at most 3.0e-14 in g (at g[1]), 3 ulp of 4.7e+01, the most that g can be.
void gravity(const Real (&q)[6], Real (&g)[6]) noexcept;

/// h = b + g: the joint forces at qdd = 0
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// out h (6): joint forces
/// Cost: 224 flops (add 87, mul 137, div 0), sine and cosine of 4 angles.
/// Stack: at most 52 values live at once, 416 bytes.
/// Rounding: at most 1.2e-12 in h (at h[0]), 10 ulp of 5.5e+02, the most that h can be.
void nonlinear_effects(const Real (&q)[6], const Real (&qd)[6], Real (&h)[6]) noexcept;

/// tau = M qdd + b + g: the matrix M
/// By composite rigid bodies, RBDA table 6.2.
/// in  q (6): joint coordinates
/// out M (6x6): joint-space inertia
/// Cost: 139 flops (add 59, mul 80, div 0), sine and cosine of 4 angles.
/// Stack: at most 46 values live at once, 368 bytes.
/// Rounding: at most 3.8e-15 in M (at M[0]), 4 ulp of 4.3e+00, the most that M can be.
void mass_matrix(const Real (&q)[6], Real (&M)[36]) noexcept;

/// qdd = M^-1 (tau - b - g + J_ext^T f_ext)
/// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// in  tau (6): joint forces
/// out qdd (6): joint accelerations
/// Cost: 460 flops (add 189, mul 267, div 4), sine and cosine of 4 angles.
/// Stack: at most 83 values live at once, 664 bytes.
/// Rounding: at most 2e-09 in qdd (at qdd[5]), 12 ulp of 6e+05, to first order, 4 times what a
///   search met.
void forward_dynamics(const Real (&q)[6], const Real (&qd)[6], const Real (&tau)[6],
    Real (&qdd)[6]) noexcept;

/// Lambda^-1 = J M^-1 J^T
/// By M = L^T D L, J carried inward, in the axes asked for at link origins.
/// in  q (6): joint coordinates
/// out Lambda_inv (6x6): inverse operational-space inertia
/// Cost: 566 flops (add 232, mul 330, div 4), sine and cosine of 5 angles.
/// Stack: at most 61 values live at once, 488 bytes.
/// Rounding: at most 4e-10 in Lambda_inv (at Lambda_inv[28]), 66 ulp of 3e+04, to first order, 4
///   times what a search met.
void lambda_inverse(const Real (&q)[6], Real (&Lambda_inv)[36]) noexcept;

/// Lambda = (J M^-1 J^T)^-1
/// By M = L^T D L, J carried inward, in the axes asked for at link origins.
/// in  q (6): joint coordinates
/// out Lambda (6x6): operational-space inertia
/// Cost: 782 flops (add 322, mul 450, div 10), sine and cosine of 5 angles.
/// Stack: at most 65 values live at once, 520 bytes.
/// Rounding: in 50, 90, 99 of 100 states, to first order, at most 2e-11 (2000 ulp of 5e+01), 7e-07
///   (800000 ulp of 4e+03), 4e+00 (1e+09 ulp of 2e+07) in Lambda; more towards singularities.
void lambda(const Real (&q)[6], Real (&Lambda)[36]) noexcept;

/// tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
/// By resolved acceleration, spherical wrist, J in the axes of link 2 (link2).
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// in  qdd_0 (6): joint accelerations that the posture asks for
/// in  xdd_cmd (6): commanded accelerations of the task rows
/// out tau (6): joint forces
/// Cost: 465 flops (add 190, mul 273, div 2), sine and cosine of 5 angles.
/// Stack: at most 78 values live at once, 624 bytes.
/// Rounding: in 50, 90, 99 of 100 states, to first order, at most 8e-12 (50 ulp of 8e+02), 7e-11
///   (80 ulp of 5e+03), 7e-08 (2000 ulp of 2e+05) in tau; more towards singularities.
void control_torque(const Real (&q)[6], const Real (&qd)[6], const Real (&qdd_0)[6],
    const Real (&xdd_cmd)[6], Real (&tau)[6]) noexcept;

}  // namespace puma560
