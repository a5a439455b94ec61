#include "two_robots.hpp"

#include "core/orientation.hpp"
#include "samm_grip.hpp"

namespace treeline::experiments {
namespace {

static_assert(samm_grip::kVelocities == kJoints && samm_grip::kTaskRows == 6);

constexpr double kGravity[3] = {0.0, 0.0, -9.81};
constexpr double kDamping = 100.0;     // 1/s
constexpr double kStiffness = 2500.0;  // 1/s^2

/// The object's axes in each robot's flange. The object lies ahead of the first robot, and the
/// second one stands opposite.
constexpr double kObjectInFlange[2][9] = {{0, 0, -1, 0, 1, 0, 1, 0, 0},
                                          {0, 0, -1, 0, -1, 0, -1, 0, 0}};

struct Seen {
  double position[3];
  double rotation[9];
  double velocity[6];
  double J[6 * kJoints];
};

Seen see(int robot, const PairState& state) {
  Seen seen{};
  double flange[9];
  samm_grip::forward_kinematics(state.q[robot], seen.position, flange);
  samm_grip::jacobian(state.q[robot], seen.J);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (int k = 0; k < 3; ++k) {
        seen.rotation[3 * i + j] += flange[3 * i + k] * kObjectInFlange[robot][3 * k + j];
      }
    }
  }
  for (int row = 0; row < 6; ++row) {
    for (int i = 0; i < kJoints; ++i) {
      seen.velocity[row] += seen.J[row * kJoints + i] * state.qd[robot][i];
    }
  }
  return seen;
}

/// Rotates a force and a moment into the object's axes or, with `back`, out of them.
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

core::GraspedObject<double> beam() {
  return {8.0, {0.05, 0.0, 0.0}, {0.0133, 0, 0, 0, 0.433, 0, 0, 0, 0.433}};
}

core::TwoGrasps<double> beam_grasps() {
  constexpr double kLeft[3] = {-0.4, 0.0, 0.0};
  constexpr double kRight[3] = {0.4, 0.0, 0.0};
  core::TwoGrasps<double> grasps;
  core::make_two_grasps(kLeft, kRight, grasps);
  return grasps;
}

ObjectSeen see_object(const PairState& state) {
  const Seen first = see(0, state);
  const Seen second = see(1, state);
  ObjectSeen seen;
  for (int i = 0; i < 3; ++i) {
    seen.position[i] = first.position[i];
    seen.drift[i] = second.position[i] - first.position[i];
  }
  for (int i = 0; i < 9; ++i) {
    seen.rotation[i] = first.rotation[i];
  }
  for (int i = 0; i < 6; ++i) {
    seen.velocity[i] = first.velocity[i];
    seen.drift_rate[i] = second.velocity[i] - first.velocity[i];
  }
  for (int axis = 0; axis < 3; ++axis) {
    const double a[3] = {first.rotation[axis], first.rotation[3 + axis], first.rotation[6 + axis]};
    const double b[3] = {second.rotation[axis], second.rotation[3 + axis],
                         second.rotation[6 + axis]};
    double turned[3];
    core::steps::cross(a, b, turned);
    for (int i = 0; i < 3; ++i) {
      seen.drift[3 + i] += 0.5 * turned[i];
    }
  }
  return seen;
}

void grasp_object(const double (&position)[3], const double (&rotation)[9], PairState& state) {
  constexpr int kIterations = 10;
  for (int robot = 0; robot < 2; ++robot) {
    for (int iteration = 0; iteration < kIterations; ++iteration) {
      const Seen seen = see(robot, state);
      double step[6];
      core::pose_error(seen.position, seen.rotation, position, rotation, step);
      double A[36] = {};
      for (int row = 0; row < 6; ++row) {
        for (int column = 0; column < 6; ++column) {
          for (int i = 0; i < kJoints; ++i) {
            A[6 * row + column] += seen.J[row * kJoints + i] * seen.J[column * kJoints + i];
          }
        }
      }
      core::ldlt_factor<6>(A);
      core::ldlt_solve<6>(A, step);
      for (int i = 0; i < kJoints; ++i) {
        for (int row = 0; row < 6; ++row) {
          state.q[robot][i] += seen.J[row * kJoints + i] * step[row];
        }
      }
    }
  }
}

PairTorques control_pair(const PairState& state, const ObjectSeen& seen, const double (&xdd)[6],
                         const double (&internal)[6], const double (&qdd_0)[2][kJoints]) {
  const double w[3] = {seen.velocity[3], seen.velocity[4], seen.velocity[5]};
  double wrench[6];
  double in_object[6];
  double forces[2][6];
  core::object_wrench(beam(), seen.rotation, w, xdd, kGravity, wrench);
  turn(seen.rotation, wrench, in_object, true);
  core::split_over_grasps(beam_grasps(), in_object, internal, forces);
  PairTorques torques;
  for (int robot = 0; robot < 2; ++robot) {
    double reaction[6];
    turn(seen.rotation, forces[robot], reaction, false);
    for (double& x : reaction) {
      x = -x;
    }
    samm_grip::control_torque(state.q[robot], state.qd[robot], qdd_0[robot], xdd, reaction,
                              torques.tau[robot]);
  }
  return torques;
}

PairMotion move_pair(const PairState& state, const PairTorques& torques) {
  const ObjectSeen object = see_object(state);
  const double w[3] = {object.velocity[3], object.velocity[4], object.velocity[5]};
  const double at_rest[6] = {};
  double Lambda[2][36];
  double xdd_free[2][6] = {};
  for (int robot = 0; robot < 2; ++robot) {
    double qdd[kJoints];
    samm_grip::forward_dynamics(state.q[robot], state.qd[robot], torques.tau[robot], at_rest, qdd);
    samm_grip::bias_acceleration(state.q[robot], state.qd[robot], xdd_free[robot]);
    samm_grip::lambda(state.q[robot], Lambda[robot]);
    const Seen seen = see(robot, state);
    for (int row = 0; row < 6; ++row) {
      for (int i = 0; i < kJoints; ++i) {
        xdd_free[robot][row] += seen.J[row * kJoints + i] * qdd[i];
      }
      if (robot == 1) {
        xdd_free[1][row] += kDamping * object.drift_rate[row] + kStiffness * object.drift[row];
      }
    }
  }
  double Lambda_object[36];
  double bias[6];
  double forces[2][6];
  double in_object[2][6];
  PairMotion motion;
  core::object_inertia(beam(), object.rotation, Lambda_object);
  core::object_wrench(beam(), object.rotation, w, at_rest, kGravity, bias);
  core::grasp_forces<2>(Lambda_object, bias, Lambda, xdd_free, motion.xdd, forces);
  for (int robot = 0; robot < 2; ++robot) {
    double reaction[6];
    for (int i = 0; i < 6; ++i) {
      reaction[i] = -forces[robot][i];
    }
    samm_grip::forward_dynamics(state.q[robot], state.qd[robot], torques.tau[robot], reaction,
                                motion.qdd[robot]);
    turn(object.rotation, forces[robot], in_object[robot], true);
  }
  core::read_internal_forces(beam_grasps(), in_object, motion.internal);
  return motion;
}

void integrate_pair(const PairTorques& torques, double dt, PairState& state) {
  constexpr double kFractions[4] = {0.0, 0.5, 0.5, 1.0};
  constexpr double kWeights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
  PairState rates;
  PairState sum = state;
  for (int stage = 0; stage < 4; ++stage) {
    PairState at = state;
    for (int robot = 0; robot < 2; ++robot) {
      for (int i = 0; i < kJoints; ++i) {
        at.q[robot][i] += kFractions[stage] * dt * rates.q[robot][i];
        at.qd[robot][i] += kFractions[stage] * dt * rates.qd[robot][i];
      }
    }
    const PairMotion motion = move_pair(at, torques);
    for (int robot = 0; robot < 2; ++robot) {
      for (int i = 0; i < kJoints; ++i) {
        rates.q[robot][i] = at.qd[robot][i];
        rates.qd[robot][i] = motion.qdd[robot][i];
        sum.q[robot][i] += kWeights[stage] * dt * rates.q[robot][i];
        sum.qd[robot][i] += kWeights[stage] * dt * rates.qd[robot][i];
      }
    }
  }
  state = sum;
}

}  // namespace treeline::experiments
