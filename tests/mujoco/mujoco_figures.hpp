#pragma once

#include <map>
#include <string>
#include <vector>

#include "interpreter/forward_kinematics.hpp"
#include "oracle/model_from_robot.hpp"

/// Figures that MuJoCo computed (write_figures.mjs), in our conventions.
namespace treeline::tests {

using DoubleVector = interpreter::Vector<double>;
using DoubleMatrix = interpreter::Matrix<double>;

/// Of everything, matter that is fixed to the world included.
struct MujocoWhole {
  DoubleVector center_of_mass;           ///< 3
  DoubleMatrix center_of_mass_jacobian;  ///< 3 x nv
  DoubleMatrix momentum_matrix;          ///< A_G, 6 x nv
  DoubleVector momentum;                 ///< h_G, 6
  double potential_energy = 0;
};

struct MujocoState {
  DoubleVector q, qd, qdd;
  DoubleMatrix mass_matrix;
  DoubleMatrix mass_matrix_with_rotors;   ///< with `MujocoFigures::armature`
  double kinetic_energy_with_rotors = 0;  ///< the same
  DoubleVector nonlinear_effects, inverse_dynamics;
  /// With rotors, viscous friction and springs of `MujocoFigures`: inverse dynamics, and the
  /// acceleration by the forces `applied`.
  DoubleVector inverse_dynamics_with_drives, applied, forward_dynamics_with_drives;
  std::vector<interpreter::PointPose<double>> poses;  ///< of the links' frames in the world
  /// Six of each link: of its frame, linear over angular, world axes.
  DoubleVector velocities, accelerations;
  MujocoWhole whole;
};

struct MujocoFigures {
  std::string refused;  ///< why MuJoCo refuses the robot; empty: it does not
  int nv = 0;
  unsigned seed = 0;                       ///< seed of the states
  std::vector<std::string> links;          ///< links whose poses are listed
  std::map<std::string, double> armature;  ///< of motors, by joint, where a state has rotors
  std::map<std::string, double> damping, stiffness;  ///< the same; springs are slack at 0
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
/// Dampers, friction and armature of the file are not in these figures: they are neither in M nor
/// in the bias. Dry friction is none that can be compared: it is a constraint in MuJoCo. Throws
/// std::runtime_error if the file is missing or does not belong to the robot.
MujocoFigures read_mujoco_figures(const std::string& path, const Robot& robot,
                                  const interpreter::Model<double>& model);

}  // namespace treeline::tests
