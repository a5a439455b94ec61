#include "share_law.hpp"

#include "core/closed_chain.hpp"
#include "core/command_laws.hpp"
#include "core/orientation.hpp"
#include "samm_grip.hpp"

namespace treeline::experiments {
namespace {

static_assert(samm_grip::kVelocities == kJoints && samm_grip::kTaskRows == 6);

constexpr double kGravity[3] = {0.0, 0.0, -9.81};

/// The object's axes in each robot's hand.
constexpr double kObjectInHand[2][9] = {{0, 0, -1, 0, 1, 0, 1, 0, 0},
                                        {0, 0, -1, 0, -1, 0, -1, 0, 0}};

/// The beam of `pair.yaml`, as each robot knows it.
core::GraspedObject<double> beam() {
  return {8.0, {0.05, 0.0, 0.0}, {0.0133, 0, 0, 0, 0.433, 0, 0, 0, 0.433}};
}

core::TwoGrasps<double> beam_grasps() {
  constexpr double kFirst[3] = {-0.4, 0.0, 0.0};
  constexpr double kSecond[3] = {0.4, 0.0, 0.0};
  core::TwoGrasps<double> grasps;
  core::make_two_grasps(kFirst, kSecond, grasps);
  return grasps;
}

/// The object as the robot's own joints tell.
struct Seen {
  double position[3] = {};
  double rotation[9] = {};
  double velocity[6] = {};
};

Seen see(int robot, const double (&q)[kJoints], const double (&qd)[kJoints]) {
  Seen seen;
  double hand[9];
  double J[6 * kJoints];
  samm_grip::forward_kinematics(q, seen.position, hand);
  samm_grip::jacobian(q, J);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        seen.rotation[3 * i + j] += hand[3 * i + k] * kObjectInHand[robot][3 * k + j];
      }
    }
  }
  for (int row = 0; row < 6; ++row) {
    for (int i = 0; i < kJoints; ++i) {
      seen.velocity[row] += J[row * kJoints + i] * qd[i];
    }
  }
  return seen;
}

/// Rotates a force and a moment into the object's axes or, with `back` false, out of them.
void turn(const double (&R)[9], const double (&from)[6], double (&to)[6], bool back) {
  for (int half = 0; half < 6; half += 3) {
    const double v[3] = {from[half], from[half + 1], from[half + 2]};
    double turned[3];
    core::steps::rotate(R, v, turned, back);
    for (int i = 0; i < 3; ++i) {
      to[half + i] = turned[i];
    }
  }
}

}  // namespace

void control_share(int robot, const CarryPlan& plan, const Wanted& wanted,
                   const double (&internal)[6], const double (&q)[kJoints],
                   const double (&qd)[kJoints], const double (&qdd_0)[kJoints],
                   double (&tau)[kJoints]) {
  const Seen seen = see(robot, q, qd);
  double error[6], xdd[6], wrench[6], in_object[6], forces[2][6], reaction[6];
  core::pose_error(seen.position, seen.rotation, wanted.position, wanted.rotation, error);
  core::tracking_law<6, double>({plan.stiffness, plan.damping}, error, seen.velocity,
                                wanted.velocity, wanted.acceleration, xdd);
  const double w[3] = {seen.velocity[3], seen.velocity[4], seen.velocity[5]};
  core::object_wrench(beam(), seen.rotation, w, xdd, kGravity, wrench);
  turn(seen.rotation, wrench, in_object, true);
  core::split_over_grasps(beam_grasps(), in_object, internal, forces);
  turn(seen.rotation, forces[robot], reaction, false);
  for (double& x : reaction) {
    x = -x;
  }
  samm_grip::control_torque(q, qd, qdd_0, xdd, reaction, tau);
}

}  // namespace treeline::experiments
