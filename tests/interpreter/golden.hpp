#pragma once

#include <string>
#include <vector>

#include "oracle/model_from_robot.hpp"

/// Figures of an established library in our conventions.
namespace treeline::tests {

using DoubleVector = interpreter::Vector<double>;
using DoubleMatrix = interpreter::Matrix<double>;

struct GoldenPoint {
  DoubleVector position;          ///< 3
  DoubleMatrix rotation;          ///< frame to world
  DoubleMatrix J_local, J_world;  ///< 6 x nv
  DoubleVector bias_local, bias_world;
};

struct GoldenState {
  std::string note;
  DoubleVector q, qd, qdd, tau, xdd;
  DoubleVector rnea, aba, gravity, nonlinear_effects;
  DoubleMatrix M;
  std::vector<GoldenPoint> points;
  DoubleMatrix Lambda_inverse_local, Lambda_inverse_world;
  DoubleMatrix Lambda_local, Lambda_world;  ///< empty where the task is singular
  DoubleVector control_torque;              ///< empty where the task is singular; world axes
};

/// Places of our coordinates in the file. The file's joints are in alphabetical order within a
/// link, ours in the order of the URDF. For a continuous joint the file has cosine and sine of its
/// angle.
struct GoldenOrder {
  std::vector<int> q, v;
  std::vector<bool> angle_from_cosine_and_sine;  ///< of each of our q
};

struct GoldenRobot {
  Robot robot;  ///< without mimic tags, which these figures ignore
  Scene scene;  ///< operational points as listed, all rows, world axes
  std::vector<GoldenState> states;
  GoldenOrder order;
};

/// Reads NAME.json of tests/data/golden and the URDF that it names. All conversions of conventions
/// are done here. Throws if a file is bad or missing.
GoldenRobot read_golden(const std::string& name);

}  // namespace treeline::tests
