#pragma once

#include <string>
#include <vector>

#include "interpreter/forward_kinematics.hpp"
#include "oracle/model_from_robot.hpp"

/// Figures that MuJoCo computed (write_figures.mjs), in our conventions.
namespace treeline::tests {

using DoubleVector = interpreter::Vector<double>;
using DoubleMatrix = interpreter::Matrix<double>;

struct MujocoState {
  DoubleVector q, qd, qdd;
  DoubleMatrix mass_matrix;
  DoubleVector nonlinear_effects, inverse_dynamics;
  std::vector<interpreter::PointPose<double>> poses;  ///< of the links' frames in the world
};

struct MujocoFigures {
  std::string refused;  ///< why MuJoCo refuses the robot; empty: it does not
  int nv = 0;
  unsigned seed = 0;               ///< seed of the states
  std::vector<std::string> links;  ///< links whose poses are listed
  std::vector<MujocoState> states;
};

/// Reads NAME_fixed.json or NAME_floating.json. All conversions of conventions are done here:
///  - MuJoCo's quaternions are w x y z, ours x y z w.
///  - A free joint's velocity is linear in world axes and angular in the link's axes; ours has both
///    in the link's axes. Accelerations are the time derivatives of either.
///  - Joints have another order and are matched by name.
///  - A link named world is renamed under a floating base, where it is not the world.
///  - Mimic joints are independent in MuJoCo: read the robot without mimics.
///  - Inertias that MuJoCo refuses are set after its compiler (set_inertias.mjs).
/// Dampers, friction and armature are not in these figures: they are neither in M nor in the bias.
/// Throws std::runtime_error if the file is missing or does not belong to the robot.
MujocoFigures read_mujoco_figures(const std::string& path, const Robot& robot,
                                  const interpreter::Model<double>& model);

}  // namespace treeline::tests
