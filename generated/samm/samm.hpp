#pragma once
// samm: rigid-body dynamics as straight-line code.
//
// From samm.urdf and scene.yaml by
//   treeline generate samm.urdf scene.yaml --output samm
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
//   q 0       qd 0       base_x (prismatic): -10 .. 10 m, 1000 N, 1.5 m/s
//   q 1       qd 1       base_y (prismatic): -10 .. 10 m, 1000 N, 1.5 m/s
//   q 2       qd 2       base_yaw (continuous): 300 N m, 2.5 rad/s
//   q 3       qd 3       joint1 (revolute): -2.79 .. 2.79 rad, 97.6 N m, 8 rad/s
//   q 4       qd 4       joint2 (revolute): -3.93 .. 0.79 rad, 186.4 N m, 10 rad/s
//   q 5       qd 5       joint3 (revolute): -0.79 .. 3.93 rad, 89.4 N m, 10 rad/s
//   q 6       qd 6       joint4 (revolute): -1.92 .. 2.97 rad, 24.2 N m, 10 rad/s
//   q 7       qd 7       joint5 (revolute): -1.75 .. 1.75 rad, 20.1 N m, 10 rad/s
//   q 8       qd 8       joint6 (revolute): -4.64 .. 4.64 rad, 21.3 N m, 10 rad/s
// Operational points, rows of task vectors:
//   from 0    tool on tool, origin (0, 0, 0) m in the link, world axes: x y z rx ry rz
// Gravity (0.0, 0.0, -9.81) m/s^2 in world axes.
// Bounds of rounding errors hold for inputs, taken as exact, of |q| <= 10 10 3.141 2.79 3.93 3.93
//   2.97 1.75 4.64, |qd| <= 1.5 1.5 2.5 8 10 10 10 10 10, |qdd| <= 100, |qdd_0| <= 100, |tau| <=
//   1000 1000 300 97.6 186.4 89.4 24.2 20.1 21.3, |xdd_cmd| <= 100.

namespace samm {

using Real = double;
inline constexpr int kCoordinates = 9;  // of q
inline constexpr int kVelocities = 9;  // of qd, qdd, tau
inline constexpr int kTaskRows = 6;  // stacked over the operational points

/// x_world = R x_point + p, for every operational point
/// By outward recursion.
/// in  q (9): joint coordinates
/// out position (3): positions in the world, m, one point after the other
/// out rotation (9): rotation matrices, row-major, point's axes to world, one point after the other
/// Cost: 91 flops (add 32, mul 59, div 0), sine and cosine of 7 angles.
/// Stack: at most 33 values live at once, 264 bytes.
/// Rounding: at most 4.9e-15 in position (at position[0]), 2 ulp of 1.2e+01, the most that
///   position can be; at most 4.0e-15 in rotation (at rotation[0]), 11 ulp of 1.8e+00, the most that
///   rotation can be.
void forward_kinematics(const Real (&q)[9], Real (&position)[3], Real (&rotation)[9]) noexcept;

/// xd = J qd, rows stacked over operational points
/// By rows carried inward from each point.
/// in  q (9): joint coordinates
/// out J (6x9): Jacobian
/// Cost: 78 flops (add 23, mul 55, div 0), sine and cosine of 6 angles.
/// Stack: at most 31 values live at once, 248 bytes.
/// Rounding: at most 2.9e-15 in J (at J[35]), 8 ulp of 1.8e+00, the most that J can be.
void jacobian(const Real (&q)[9], Real (&J)[54]) noexcept;

/// xdd = J qdd + Jd qd: the term Jd qd
/// By outward recursion, Chang eq. 6.11.
/// in  q (9): joint coordinates
/// in  qd (9): joint velocities
/// out bias (6): accelerations of the task rows at qdd = 0
/// Cost: 177 flops (add 63, mul 114, div 0), sine and cosine of 6 angles.
/// Stack: at most 39 values live at once, 312 bytes.
/// Rounding: at most 1.9e-11 in bias (at bias[0]), 19 ulp of 4.4e+03, the most that bias can be.
void bias_acceleration(const Real (&q)[9], const Real (&qd)[9], Real (&bias)[6]) noexcept;

/// tau = M qdd + b + g - J_ext^T f_ext
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (9): joint coordinates
/// in  qd (9): joint velocities
/// in  qdd (9): joint accelerations
/// out tau (9): joint forces
/// Cost: 326 flops (add 142, mul 184, div 0), sine and cosine of 6 angles.
/// Stack: at most 66 values live at once, 528 bytes.
/// Rounding: at most 1.4e-11 in tau (at tau[0]), 3 ulp of 2.4e+04, the most that tau can be.
void inverse_dynamics(const Real (&q)[9], const Real (&qd)[9], const Real (&qdd)[9],
    Real (&tau)[9]) noexcept;

/// g: the joint forces that hold the robot at rest
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (9): joint coordinates
/// out g (9): joint forces
/// Cost: 35 flops (add 10, mul 25, div 0), sine and cosine of 4 angles.
/// Stack: at most 13 values live at once, 104 bytes.
/// Rounding: at most 3.0e-14 in g (at g[4]), 3 ulp of 4.7e+01, the most that g can be.
void gravity(const Real (&q)[9], Real (&g)[9]) noexcept;

/// h = b + g: the joint forces at qdd = 0
/// By recursive Newton-Euler, Chang table 4.1.
/// in  q (9): joint coordinates
/// in  qd (9): joint velocities
/// out h (9): joint forces
/// Cost: 246 flops (add 96, mul 150, div 0), sine and cosine of 6 angles.
/// Stack: at most 58 values live at once, 464 bytes.
/// Rounding: at most 4.1e-12 in h (at h[0]), 9 ulp of 2.2e+03, the most that h can be.
void nonlinear_effects(const Real (&q)[9], const Real (&qd)[9], Real (&h)[9]) noexcept;

/// tau = M qdd + b + g: the matrix M
/// By composite rigid bodies, RBDA table 6.2.
/// in  q (9): joint coordinates
/// out M (9x9): joint-space inertia
/// Cost: 177 flops (add 73, mul 104, div 0), sine and cosine of 6 angles.
/// Stack: at most 50 values live at once, 400 bytes.
/// Rounding: at most 1.1e-14 in M (at M[2]), 1 ulp of 1.9e+02, the most that M can be.
void mass_matrix(const Real (&q)[9], Real (&M)[81]) noexcept;

/// qdd = M^-1 (tau - b - g + J_ext^T f_ext)
/// By M = L^T D L by composite bodies, sparse solve (RBDA section 6.5).
/// in  q (9): joint coordinates
/// in  qd (9): joint velocities
/// in  tau (9): joint forces
/// out qdd (9): joint accelerations
/// Cost: 638 flops (add 266, mul 366, div 6), sine and cosine of 6 angles.
/// Stack: at most 86 values live at once, 688 bytes.
/// Rounding: at most 2e-09 in qdd (at qdd[8]), 12 ulp of 6e+05, to first order, 4 times what a
///   search met.
void forward_dynamics(const Real (&q)[9], const Real (&qd)[9], const Real (&tau)[9],
    Real (&qdd)[9]) noexcept;

/// Lambda^-1 = J M^-1 J^T
/// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
/// in  q (9): joint coordinates
/// out Lambda_inv (6x6): inverse operational-space inertia
/// Cost: 1001 flops (add 395, mul 600, div 6), sine and cosine of 6 angles.
/// Stack: at most 124 values live at once, 992 bytes.
/// Rounding: at most 5e-10 in Lambda_inv (at Lambda_inv[28]), 85 ulp of 3e+04, to first order, 4
///   times what a search met.
void lambda_inverse(const Real (&q)[9], Real (&Lambda_inv)[36]) noexcept;

/// Lambda = (J M^-1 J^T)^-1
/// By unit forces propagated inward (PV-OSIM), in the axes asked for at the points.
/// in  q (9): joint coordinates
/// out Lambda (6x6): operational-space inertia
/// Cost: 1217 flops (add 485, mul 720, div 12), sine and cosine of 6 angles.
/// Stack: at most 114 values live at once, 912 bytes.
/// Rounding: in 50, 90, 99 of 100 states, to first order, at most 3e-11 (8000 ulp of 2e+01), 2e-09
///   (70000 ulp of 1e+02), 1e-07 (200000 ulp of 3e+03) in Lambda; more towards singularities.
void lambda(const Real (&q)[9], Real (&Lambda)[36]) noexcept;

/// tau = J^T F + M qdd_0 + b + g - J_ext^T f_ext, F = Lambda (xdd_cmd - Jd qd - J qdd_0)
/// By Chang table 6.1, fused; Lambda^-1: unit forces propagated inward (PV-OSIM), in link axes at link origins.
/// in  q (9): joint coordinates
/// in  qd (9): joint velocities
/// in  qdd_0 (9): joint accelerations that the posture asks for
/// in  xdd_cmd (6): commanded accelerations of the task rows
/// out tau (9): joint forces
/// Cost: 1087 flops (add 454, mul 622, div 11), sine and cosine of 6 angles.
/// Stack: at most 120 values live at once, 960 bytes.
/// Rounding: in 50, 90, 99 of 100 states, to first order, at most 7e-11 (20 ulp of 2e+04), 1e-09
///   (200 ulp of 3e+04), 4e-09 (500 ulp of 4e+04) in tau; more towards singularities.
void control_torque(const Real (&q)[9], const Real (&qd)[9], const Real (&qdd_0)[9],
    const Real (&xdd_cmd)[6], Real (&tau)[9]) noexcept;

}  // namespace samm
