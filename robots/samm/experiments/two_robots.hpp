#pragma once

#include "core/closed_chain.hpp"

namespace treeline::experiments {

inline constexpr int kJoints = 9;

/// Two SAMMs, each in its own coordinates, with one object.
struct PairState {
  double q[2][kJoints] = {};
  double qd[2][kJoints] = {};
};

/// What both robots' joints do.
struct PairTorques {
  double tau[2][kJoints] = {};
};

/// The object where the first robot has it, and how far the second one disagrees; world axes.
struct ObjectSeen {
  double position[3] = {};
  double rotation[9] = {};
  double velocity[6] = {};
  double drift[6] = {};  ///< position over turn
  double drift_rate[6] = {};
};

/// What moves the pair.
struct PairMotion {
  double qdd[2][kJoints] = {};
  double xdd[6] = {};       ///< of the object
  double internal[6] = {};  ///< forces of the virtual linkage that act
};

/// The object: a beam of 0.8 x 0.1 x 0.1 m and 8 kg along its x axis, its centre of mass 0.05 m off
/// the middle, held at its ends.
core::GraspedObject<double> beam();
core::TwoGrasps<double> beam_grasps();

ObjectSeen see_object(const PairState& state);

/// Moves both robots, by the least change of their joints, to where each has the object at this
/// pose: for starts whose figures are rounded (Newton's method).
void grasp_object(const double (&position)[3], const double (&rotation)[9], PairState& state);

/// Torques that give the object the acceleration `xdd` and the internal forces `internal`, each
/// robot by its own generated control (Chang table 7.1 over two robots).
PairTorques control_pair(const PairState& state, const ObjectSeen& seen, const double (&xdd)[6],
                         const double (&internal)[6], const double (&qdd_0)[2][kJoints]);

/// The motion under held torques (Chang table 7.2 over two robots), grasps that drift apart drawn
/// together by Baumgarte's stabilisation at 50 /s.
PairMotion move_pair(const PairState& state, const PairTorques& torques);

/// One step of `dt` seconds under held torques by the classical Runge-Kutta method.
void integrate_pair(const PairTorques& torques, double dt, PairState& state);

}  // namespace treeline::experiments
