#include "two_robots.hpp"

#include <algorithm>

#include "core/ldlt.hpp"
#include "core/orientation.hpp"
#include "samm_pair.hpp"

namespace treeline::experiments {
namespace {

constexpr int kBoth = 2 * kJoints;
constexpr int kRows = samm_pair::kTaskRows;
static_assert(samm_pair::kVelocities == kBoth && kRows == 12);

constexpr double kStabilisation[2] = {100.0, 2500.0};  // 1/s, 1/s^2

/// The object seen from each hand, as the scene has it: 0.4 m ahead, and these axes.
constexpr double kReach = 0.4;
constexpr double kObjectInHand[2][9] = {{0, 0, -1, 0, 1, 0, 1, 0, 0},
                                        {0, 0, -1, 0, -1, 0, -1, 0, 0}};

/// Values of both robots, one after the other, as the generated functions take them.
struct Both {
  explicit Both(const double (&values)[2][kJoints]) {
    std::copy(&values[0][0], &values[0][0] + kBoth, all);
  }
  double all[kBoth];
};

void take(const double (&all)[kBoth], double (&values)[2][kJoints]) {
  std::copy(all, all + kBoth, &values[0][0]);
}

/// The pose of a hand that holds the object at this pose.
void find_hand(int robot, const double (&position)[3], const double (&rotation)[9], double (&p)[3],
               double (&R)[9]) {
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      R[3 * i + j] = 0.0;
      for (int k = 0; k < 3; ++k) {
        R[3 * i + j] += rotation[3 * i + k] * kObjectInHand[robot][3 * j + k];
      }
    }
    p[i] = position[i] - kReach * R[3 * i + 2];
  }
}

/// The small motion of both hands that takes them to where they hold the object.
void find_errors(const double (&q)[kBoth], const double (&position)[3], const double (&rotation)[9],
                 double (&error)[kRows]) {
  double positions[6];
  double rotations[18];
  samm_pair::forward_kinematics(q, positions, rotations);
  for (int robot = 0; robot < 2; ++robot) {
    double p[3], R[9], wanted_p[3], wanted_R[9], own[6];
    std::copy(positions + 3 * robot, positions + 3 * robot + 3, p);
    std::copy(rotations + 9 * robot, rotations + 9 * robot + 9, R);
    find_hand(robot, position, rotation, wanted_p, wanted_R);
    core::pose_error(p, R, wanted_p, wanted_R, own);
    std::copy(own, own + 6, error + 6 * robot);
  }
}

}  // namespace

ObjectSeen see_object(const PairState& state) {
  ObjectSeen seen;
  samm_pair::object_state(Both(state.q).all, Both(state.qd).all, seen.position, seen.rotation,
                          seen.velocity, seen.drift, seen.drift_rate);
  return seen;
}

void grasp_object(const double (&position)[3], const double (&rotation)[9], PairState& state) {
  constexpr int kIterations = 10;
  Both q(state.q);
  for (int iteration = 0; iteration < kIterations; ++iteration) {
    double step[kRows];
    double J[kRows * kBoth];
    double A[kRows * kRows] = {};
    find_errors(q.all, position, rotation, step);
    samm_pair::jacobian(q.all, J);
    for (int row = 0; row < kRows; ++row) {
      for (int column = 0; column < kRows; ++column) {
        for (int i = 0; i < kBoth; ++i) {
          A[kRows * row + column] += J[row * kBoth + i] * J[column * kBoth + i];
        }
      }
    }
    core::ldlt_factor<kRows>(A);
    core::ldlt_solve<kRows>(A, step);
    for (int i = 0; i < kBoth; ++i) {
      for (int row = 0; row < kRows; ++row) {
        q.all[i] += J[row * kBoth + i] * step[row];
      }
    }
  }
  take(q.all, state.q);
}

PairTorques control_pair(const PairState& state, const double (&xdd)[6],
                         const double (&internal)[6], const double (&qdd_0)[2][kJoints]) {
  double tau[kBoth];
  samm_pair::object_control_torque(Both(state.q).all, Both(state.qd).all, Both(qdd_0).all, xdd,
                                   internal, tau);
  PairTorques torques;
  take(tau, torques.tau);
  return torques;
}

PairMotion move_pair(const PairState& state, const PairTorques& torques) {
  double qdd[kBoth];
  PairMotion motion;
  samm_pair::object_forward_dynamics(Both(state.q).all, Both(state.qd).all, Both(torques.tau).all,
                                     kStabilisation, qdd, motion.xdd, motion.forces,
                                     motion.internal);
  take(qdd, motion.qdd);
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
