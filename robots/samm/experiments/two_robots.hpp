#pragma once

namespace treeline::experiments {

inline constexpr int kJoints = 9;

/// State of two SAMMs, each in its own coordinates, that hold one object.
struct PairState {
  double q[2][kJoints] = {};
  double qd[2][kJoints] = {};
};

/// Joint forces of both robots.
struct PairTorques {
  double tau[2][kJoints] = {};
};

/// Pose and velocity of the object according to the first robot, and the deviation of the second
/// robot; world axes.
struct ObjectSeen {
  double position[3] = {};
  double rotation[9] = {};
  double velocity[6] = {};
  double drift[6] = {};  ///< position over rotation
  double drift_rate[6] = {};
};

/// Acceleration of the pair.
struct PairMotion {
  double qdd[2][kJoints] = {};
  double xdd[6] = {};       ///< of the object
  double forces[12] = {};   ///< force and moment of each hand on the object, world axes
  double internal[6] = {};  ///< internal forces of the virtual linkage
};

ObjectSeen see_object(const PairState& state);

/// Moves both robots, by the least change of their joints, to where each holds the object at this
/// pose (Newton's method). For starts that are given by rounded figures.
void grasp_object(const double (&position)[3], const double (&rotation)[9], PairState& state);

/// Torques that give the object the acceleration `xdd` and the internal forces `internal` (Chang
/// table 7.1 for the two robots of `pair.yaml`).
PairTorques control_pair(const PairState& state, const double (&xdd)[6],
                         const double (&internal)[6], const double (&qdd_0)[2][kJoints]);

/// Motion under constant torques (Chang table 7.2 for two robots). Baumgarte's stabilisation closes
/// the drift of the grasps at 50 /s.
PairMotion move_pair(const PairState& state, const PairTorques& torques);

/// Advances the state by `dt` seconds under constant torques, by one step of the classical
/// Runge-Kutta method.
void integrate_pair(const PairTorques& torques, double dt, PairState& state);

}  // namespace treeline::experiments
