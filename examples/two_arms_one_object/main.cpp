// Two arms hold one tray, lead it once around a circle and squeeze it meanwhile.
#include <cmath>
#include <core/orientation.hpp>
#include <cstdio>

#include "two_arms.hpp"

int main() {
  // Tools at (0.45, 0, 0.45) m, each in its base's axes, pointing at each other.
  const double pose[6] = {2.592085260,  -2.014636757, 2.306004640,
                          -0.291367884, 1.021288933,  -1.570796327};
  const double level[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, squeeze[6] = {-30}, posture[12] = {};
  const double closing[2] = {100, 2500};  // 1/s, 1/s^2: keeps the simulated grasps together
  const double period = 1e-3, duration = 4, radius = 0.12, turn = 2 * std::acos(-1.0);
  double q[12], qd[12] = {}, astray = 0, force = 0;
  for (int i = 0; i < 12; ++i) q[i] = pose[i % 6];
  std::printf("time_s,q0,q1,q2,q3,q4,q5,q6,q7,q8,q9,q10,q11\n");
  for (int step = 0; step <= 4500; ++step) {
    // Where the tray should be: an angle around the circle, from rest to rest, and its derivatives.
    const double u = std::fmin(step * period / duration, 1);
    const double angle = turn * u * u * u * (10 + u * (6 * u - 15));
    const double rate = turn * 30 * u * u * (1 - u) * (1 - u) / duration;
    const double bend = turn * 60 * u * (1 - u) * (1 - 2 * u) / (duration * duration);
    const double s = std::sin(angle), c = std::cos(angle);
    const double goal[3] = {0.7, radius * s, 0.45 + radius * (1 - c)};
    const double speed[3] = {0, radius * rate * c, radius * rate * s};
    const double acceleration[3] = {0, radius * (bend * c - rate * rate * s),
                                    radius * (bend * s + rate * rate * c)};

    // The law.
    double position[3], rotation[9], velocity[6], drift[6], drift_rate[6], error[6], xdd[6];
    two_arms::object_state(q, qd, position, rotation, velocity, drift, drift_rate);
    treeline::core::pose_error(position, rotation, goal, level, error);
    for (int i = 0; i < 6; ++i) xdd[i] = 100 * error[i] - 20 * velocity[i];
    for (int i = 0; i < 3; ++i) xdd[i] += acceleration[i] + 20 * speed[i];
    double tau[12], qdd[12], of_tray[6], hands[12], internal[6];
    two_arms::object_control_torque(q, qd, posture, xdd, squeeze, tau);

    // The plant: both arms and the tray between them.
    two_arms::object_forward_dynamics(q, qd, tau, closing, qdd, of_tray, hands, internal);
    for (const double e : error) astray = std::fmax(astray, std::fabs(e));
    force = std::fmax(force, std::fabs(internal[0] + 30));
    if (step % 50 == 0) {
      std::printf("%.3f", step * period);
      for (const double coordinate : q) std::printf(",%.9f", coordinate);
      std::printf("\n");
    }
    for (int i = 0; i < 12; ++i) {
      qd[i] += period * qdd[i];
      q[i] += period * qd[i];
    }
  }
  std::fprintf(stderr, "tray off its way by %.2f mm at most, squeezed by 30 N within %.2f N\n",
               1e3 * astray, force);
  return astray < 1e-3 ? 0 : 1;
}
