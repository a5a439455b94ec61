// A control loop of one's own, which the page of `treeline drive` shows, leads and stops.
#include <show/show.h>

#include <chrono>
#include <core/orientation.hpp>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "arm.hpp"

// Torques towards the goals of the page, of the joints or of the tool; without goals they brake.
void law(const TreelineShow& page, const double (&q)[6], const double (&qd)[6], double (&tau)[6]) {
  const bool to_joints = page.enabled && page.control == 0;
  double qdd[6];
  for (int i = 0; i < 6; ++i) {
    qdd[i] = to_joints ? 225 * (page.q[i] - q[i]) + 30 * (page.qd[i] - qd[i]) : -20 * qd[i];
  }
  arm::inverse_dynamics(q, qd, qdd, tau);
  if (!page.enabled || page.control != 1) return;
  const double* goal = page.points;  // x y z qx qy qz qw
  double place[3], turn[9], wanted[9], error[6], J[36];
  arm::forward_kinematics(q, place, turn);
  arm::jacobian(q, J);
  treeline::core::rotation_from_quaternion({goal[3], goal[4], goal[5], goal[6]}, wanted);
  treeline::core::pose_error(place, turn, {goal[0], goal[1], goal[2]}, wanted, error);
  for (int row = 0; row < 6; ++row) {
    for (int i = 0; i < 6; ++i) tau[i] += J[6 * row + i] * (row < 3 ? 5000 : 500) * error[row];
  }
}

int main() {
  const char* secret = std::getenv("TREELINE_ROBOT_SECRET");
  static TreelineShow page;
  if (treeline_show_open(&page, "127.0.0.1", 7000, 6, 6, secret == nullptr ? "" : secret) != 0) {
    std::perror("127.0.0.1:7000");
    return 1;
  }
  double q[6] = {0, -0.9, 1.5, -0.6, 1.2, 0}, qd[6] = {}, qdd[6], tau[6];
  for (auto tick = std::chrono::steady_clock::now();; tick += std::chrono::milliseconds(1)) {
    std::this_thread::sleep_until(tick);
    const bool was_enabled = page.enabled;
    treeline_show_receive(&page);
    if (was_enabled && !page.enabled) std::fprintf(stderr, "stopped: elbow at %.2f rad\n", q[2]);
    law(page, q, qd, tau);
    double power = 0;
    for (int i = 0; i < 6; ++i) power += tau[i] * qd[i];
    treeline_show_value(&page, "power", power);
    treeline_show_send(&page, q, qd, tau);
    // Your motors and encoders take the place of this.
    arm::forward_dynamics(q, qd, tau, qdd);
    for (int i = 0; i < 6; ++i) q[i] += 1e-3 * (qd[i] += 1e-3 * qdd[i]);
  }
}
