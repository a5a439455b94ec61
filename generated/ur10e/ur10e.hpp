#pragma once
// ur10e: rigid-body dynamics as straight-line code.
//
// From ur10e.urdf and scene.yaml by
//   treeline generate ur10e.urdf scene.yaml --output ur10e
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
//   q 0       qd 0       shoulder_pan (revolute): -6.283185307179586 .. 6.283185307179586 rad, 330 N m, 2.0944 rad/s
//   q 1       qd 1       shoulder_lift (revolute): -6.283185307179586 .. 6.283185307179586 rad, 330 N m, 2.0944 rad/s
//   q 2       qd 2       elbow (revolute): -3.141592653589793 .. 3.141592653589793 rad, 150 N m, 3.1416 rad/s
//   q 3       qd 3       wrist_1 (revolute): -6.283185307179586 .. 6.283185307179586 rad, 56 N m, 3.1416 rad/s
//   q 4       qd 4       wrist_2 (revolute): -6.283185307179586 .. 6.283185307179586 rad, 56 N m, 3.1416 rad/s
//   q 5       qd 5       wrist_3 (revolute): -6.283185307179586 .. 6.283185307179586 rad, 56 N m, 3.1416 rad/s
// Operational points, rows of task vectors:
//   from 0    tool on tool, origin (0, 0, 0) m in the link, world axes: x y z rx ry rz
// Gravity (0.0, 0.0, -9.81) m/s^2 in world axes.
// Bounds of rounding errors hold for inputs, taken as exact, of |q| <= 6.283 6.283 3.141 6.283
//   6.283 6.283, |qd| <= 2.094 2.094 3.141 3.141 3.141 3.141, |qdd| <= 100, |qdd_0| <= 100, |tau|
//   <= 330 330 150 56 56 56, |xdd_cmd| <= 100.

namespace ur10e {

using Real = double;
inline constexpr int kCoordinates = 6;  // of q
inline constexpr int kVelocities = 6;  // of qd, qdd, tau
inline constexpr int kTaskRows = 6;  // stacked over the operational points

/// x_world = R x_point + p, for every operational point
/// By outward recursion.
/// in  q (6): joint coordinates
/// out position (3): positions in the world, m, one point after the other
/// out rotation (9): rotation matrices, row-major, point's axes to world, one point after the other
/// Cost: 73 flops (add 25, mul 48, div 0), sine and cosine of 6 angles.
/// Stack: at most 28 values live at once, 224 bytes.
/// Rounding: at most 1.6e-15 in position (at position[0]), 5 ulp of 1.7e+00, the most that
///   position can be; at most 2.9e-15 in rotation (at rotation[0]), 8 ulp of 1.8e+00, the most that
///   rotation can be.
void forward_kinematics(const Real (&q)[6], Real (&position)[3], Real (&rotation)[9]) noexcept;

/// xd = J qd, rows stacked over operational points
/// By rows carried inward from each point.
/// in  q (6): joint coordinates
/// out J (6x6): Jacobian
/// Cost: 59 flops (add 17, mul 42, div 0), sine and cosine of 5 angles.
/// Stack: at most 22 values live at once, 176 bytes.
/// Rounding: at most 1.8e-15 in J (at J[23]), 5 ulp of 1.8e+00, the most that J can be.
void jacobian(const Real (&q)[6], Real (&J)[36]) noexcept;

/// xdd = J qdd + Jd qd: the term Jd qd
/// By outward recursion, Chang eq. 6.11.
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// out bias (6): accelerations of the task rows at qdd = 0
/// Cost: 142 flops (add 52, mul 90, div 0), sine and cosine of 5 angles.
/// Stack: at most 33 values live at once, 264 bytes.
/// Rounding: at most 1.3e-12 in bias (at bias[3]), 14 ulp of 4.1e+02, the most that bias can be.
void bias_acceleration(const Real (&q)[6], const Real (&qd)[6], Real (&bias)[6]) noexcept;

/// tau = M qdd + b + g - J_ext^T f_ext
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// in  qdd (6): joint accelerations
/// out tau (6): joint forces
/// Cost: 262 flops (add 110, mul 152, div 0), sine and cosine of 4 angles.
/// Stack: at most 63 values live at once, 504 bytes.
/// Rounding: at most 5.2e-12 in tau (at tau[1]), 8 ulp of 3.1e+03, the most that tau can be.
void inverse_dynamics(const Real (&q)[6], const Real (&qd)[6], const Real (&qdd)[6],
    Real (&tau)[6]) noexcept;

/// g: the joint forces that hold the robot at rest
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (6): joint coordinates
/// out g (6): joint forces
/// Cost: 25 flops (add 8, mul 17, div 0), sine and cosine of 4 angles.
/// Stack: at most 11 values live at once, 88 bytes.
/// Rounding: at most 6.8e-14 in g (at g[1]), 3 ulp of 1.3e+02, the most that g can be.
void gravity(const Real (&q)[6], Real (&g)[6]) noexcept;

/// h = b + g: the joint forces at qdd = 0
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// out h (6): joint forces
/// Cost: 200 flops (add 76, mul 124, div 0), sine and cosine of 4 angles.
/// Stack: at most 49 values live at once, 392 bytes.
/// Rounding: at most 7.8e-13 in h (at h[1]), 10 ulp of 3.9e+02, the most that h can be.
void nonlinear_effects(const Real (&q)[6], const Real (&qd)[6], Real (&h)[6]) noexcept;

/// tau = M qdd + b + g: the matrix M
/// By composite rigid bodies, RBDA table 6.2.
/// in  q (6): joint coordinates
/// out M (6x6): joint-space inertia
/// Cost: 107 flops (add 44, mul 63, div 0), sine and cosine of 4 angles.
/// Stack: at most 33 values live at once, 264 bytes.
/// Rounding: at most 2.1e-14 in M (at M[0]), 7 ulp of 1.6e+01, the most that M can be.
void mass_matrix(const Real (&q)[6], Real (&M)[36]) noexcept;

/// qdd = M^-1 (tau - b - g + J_ext^T f_ext)
/// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// in  tau (6): joint forces
/// out qdd (6): joint accelerations
/// Cost: 410 flops (add 175, mul 231, div 4), sine and cosine of 4 angles.
/// Stack: at most 82 values live at once, 656 bytes.
/// Rounding: at most 1e-09 in qdd (at qdd[5]), 44 ulp of 2e+05, to first order, 4 times what a
///   search met.
void forward_dynamics(const Real (&q)[6], const Real (&qd)[6], const Real (&tau)[6],
    Real (&qdd)[6]) noexcept;

/// Lambda^-1 = J M^-1 J^T
/// By M = L^T D L, J carried inward, in the axes asked for at the points.
/// in  q (6): joint coordinates
/// out Lambda_inv (6x6): inverse operational-space inertia
/// Cost: 576 flops (add 235, mul 337, div 4), sine and cosine of 5 angles.
/// Stack: at most 91 values live at once, 728 bytes.
/// Rounding: at most 3e-11 in Lambda_inv (at Lambda_inv[21]), 67 ulp of 2e+03, to first order, 4
///   times what a search met.
void lambda_inverse(const Real (&q)[6], Real (&Lambda_inv)[36]) noexcept;

/// Lambda = (J M^-1 J^T)^-1
/// By M = L^T D L, J carried inward, in the axes asked for at the points.
/// in  q (6): joint coordinates
/// out Lambda (6x6): operational-space inertia
/// Cost: 792 flops (add 325, mul 457, div 10), sine and cosine of 5 angles.
/// Stack: at most 87 values live at once, 696 bytes.
/// Rounding: in 50, 90, 99 of 100 states, to first order, at most 2e-11 (4000 ulp of 3e+01), 5e-08
///   (60000 ulp of 4e+03), 3e-03 (8e+07 ulp of 2e+05) in Lambda; more towards singularities.
void lambda(const Real (&q)[6], Real (&Lambda)[36]) noexcept;

/// tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
/// By Chang table 6.1, fused; Lambda^-1: M = L^T D L, J carried inward, in the axes of link 5 (wrist_2) at link origins.
/// in  q (6): joint coordinates
/// in  qd (6): joint velocities
/// in  qdd_0 (6): joint accelerations that the posture asks for
/// in  xdd_cmd (6): commanded accelerations of the task rows
/// out tau (6): joint forces
/// Cost: 810 flops (add 347, mul 454, div 9), sine and cosine of 5 angles.
/// Stack: at most 105 values live at once, 840 bytes.
/// Rounding: in 50, 90, 99 of 100 states, to first order, at most 3e-11 (200 ulp of 2e+03), 2e-09
///   (3000 ulp of 3e+03), 2e-06 (200000 ulp of 6e+04) in tau; more towards singularities.
void control_torque(const Real (&q)[6], const Real (&qd)[6], const Real (&qdd_0)[6],
    const Real (&xdd_cmd)[6], Real (&tau)[6]) noexcept;

}  // namespace ur10e
