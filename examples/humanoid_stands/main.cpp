// A humanoid stands on the ground and reaches forward with its left hand. Its base has no motor.
#include <cmath>
#include <cstdio>

#include "humanoid.hpp"

constexpr int kJoints = humanoid::kVelocities - 6;

int main() {
  double q[kJoints + 7] = {}, qd[kJoints + 6] = {}, bent[kJoints] = {0.25, -0.45, 0.2};
  bent[9] = bent[16] = -0.8;  // elbows
  q[6] = 1;                   // the quaternion of the foot, which is the base: upright
  for (int i = 0; i < kJoints; ++i) q[7 + i] = bent[i];
  double start[3], rotation[9], off = 0, least = 1e9, toe = 0, base = 0, fingers[3];
  humanoid::forward_kinematics(q, start, rotation);
  std::printf("time_s");
  for (int i = 0; i < kJoints + 7; ++i) std::printf(",q%d", i);
  for (int step = 0; step <= 3000; ++step) {
    // The law: the hand to a place 0.35 m ahead and 0.2 m higher within two seconds, joints back to
    // their posture.
    const double u = std::fmin(step / 2000.0, 1), way = u * u * (3 - 2 * u);
    const double goal[3] = {start[0] + 0.35 * way, start[1], start[2] + 0.2 * way};
    double J[3 * (kJoints + 6)], xdd[3], posture[kJoints + 6] = {}, tau[kJoints + 6], f[6];
    const double even[6] = {};
    humanoid::forward_kinematics(q, fingers, rotation);
    humanoid::jacobian(q, J);
    for (int row = 0; row < 3; ++row) {
      double velocity = 0;
      for (int i = 0; i < kJoints + 6; ++i) velocity += J[row * (kJoints + 6) + i] * qd[i];
      xdd[row] = 400 * (goal[row] - fingers[row]) - 40 * velocity;
    }
    for (int i = 0; i < kJoints; ++i) posture[6 + i] = 25 * (bent[i] - q[7 + i]) - 10 * qd[6 + i];
    humanoid::supported_control_torque(q, qd, posture, xdd, even, tau, f);

    // The plant: soles that the ground holds. f is what it bears with, and where, as the law chose.
    const double stabilisation[2] = {100, 0}, drift[6] = {};
    double qdd[kJoints + 6], ground[6];
    humanoid::constrained_forward_dynamics(q, qd, tau, stabilisation, drift, qdd, ground);
    for (int i = 0; i < 6; ++i) base = std::fmax(base, std::fabs(tau[i]));
    least = std::fmin(least, ground[2]);
    toe = std::fmax(toe, -ground[4] / ground[2]);
    if (step % 50 == 0) {
      std::printf("\n%.3f", 1e-3 * step);
      for (const double coordinate : q) std::printf(",%.9f", coordinate);
    }
    for (int i = 0; i < kJoints; ++i) {  // the base stands
      qd[6 + i] += 1e-3 * qdd[6 + i];
      q[7 + i] += 1e-3 * qd[6 + i];
    }
    for (int i = 0; i < 6; ++i) off = std::fmax(off, std::fabs(qdd[i]));
  }
  std::printf("\n");
  std::fprintf(stderr, "the hand went %.3f m forward and %.3f m up, with %.0f N m at the base\n",
               fingers[0] - start[0], fingers[2] - start[2], base);
  std::fprintf(stderr, "the ground bears %.0f N or more, %.3f m ahead of the ankles at most\n",
               least, toe);
  return base == 0 && off < 1e-9 && least > 0 && toe < 0.18 ? 0 : 1;
}
