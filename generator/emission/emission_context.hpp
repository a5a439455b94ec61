#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "description/scene.hpp"
#include "emission/limit_facts.hpp"

namespace treeline {

struct ControllerUnit;
struct GroundUnit;
struct SelftestFacts;

/// Facts that the contract and the manifest state beside the functions, in words where they are for
/// the reader: emission knows nothing of mechanisms. There are no paths and no dates, so that the
/// same input gives the same bytes everywhere.
struct EmissionContext {
  std::string name;     ///< identifier: namespace or prefix, target and stem of the header
  std::string robot;    ///< the robot's name as the URDF has it
  std::string command;  ///< that regenerates the folder, file names without directories
  Language language = Language::cpp;
  bool single_precision = false;
  bool misra = false;              ///< written as rules for safe code ask
  std::string target = "generic";  ///< processor, see `find_target`
  Optimize optimize = Optimize::speed;
  int lanes = 1;                ///< numbers that the code may compute together
  bool asks_for_lanes = false;  ///< by the scene; else `lanes` follow the target
  int batch = 0;                ///< states a call of the functions in NAME_batch.hpp; 0: none
  std::vector<double>
      effective_mass_limits;         ///< of each task row, for NAME_damped.hpp; empty: none
  std::optional<LimitFacts> limits;  ///< for NAME_limited.hpp
  std::shared_ptr<const ControllerUnit> controller;  ///< if the scene asks for one
  std::shared_ptr<const GroundUnit> ground;          ///< of a step on it, if the scene asks for one
  std::shared_ptr<const SelftestFacts> selftest;     ///< once it is made
  int coordinates = 0;                               ///< nq
  int velocities = 0;                                ///< nv
  int task_rows = 0;                                 ///< stacked over the operational points
  std::string base;                                  ///< "fixed" or "floating"
  bool gravity_given = false;                        ///< as an argument
  std::array<double, 3> gravity{};                   ///< m/s^2, world axes

  struct Input {
    std::string file;  ///< without directory; empty where no scene was given
    std::string text;  ///< content of the file, for the digest
  };
  std::vector<Input> inputs;

  /// One row of the table of joints, in joint order.
  struct JointRow {
    std::string name;
    std::string type;
    int first_coordinate = 0, coordinates = 1;
    int first_velocity = 0, velocities = 1;
    std::string limits;  ///< "-2.8 .. 2.8 rad, 97.6 Nm, 3 rad/s"; may be empty
  };
  std::vector<JointRow> joints;
  std::vector<std::string> joint_conventions;  ///< what q, qd and tau are

  /// One entry of q, for NAME_joints.hpp; limits in rad or m, infinite where there are none.
  struct CoordinateRow {
    std::string joint;
    std::string meaning;  ///< "angle, rad"
    double lower = 0, upper = 0;
    double home = 0;  ///< within the limits and as near as they permit to no displacement
  };
  std::vector<CoordinateRow> coordinate_rows;

  /// One entry of qd, qdd and tau; limits in rad/s or m/s and N m or N, infinite where there are
  /// none.
  struct VelocityRow {
    std::string joint;
    std::string name;  ///< "elbow, rad/s"
    double velocity = 0, effort = 0;
  };
  std::vector<VelocityRow> velocity_rows;

  /// An operational point or the place of an external force, in order of rows.
  struct PointRow {
    std::string name;
    std::string link;
    std::string frame;  ///< "origin (0, 0, 0.1) m in the link, world axes"
    std::string rows;   ///< "x y z rx ry rz"
    int first_row = 0;
  };
  std::vector<PointRow> operational_points;
  std::vector<PointRow> external_forces;

  /// One decision between methods that give the same function.
  struct Method {
    std::string route;  ///< key of the route
    std::string name;   ///< in words
    int flops = 0;
    double cost = 0;  ///< by which it was chosen, see `Cost::weighted`
    int lanes = 0;    ///< where they were chosen to be others than the scene's
  };
  struct ChoiceRow {
    std::string function;
    Method chosen;
    std::vector<Method> rejected;
  };
  std::vector<ChoiceRow> choices;
  std::string measured;  ///< what the choices were measured with; empty: they were counted

  /// Operations that a function takes because something of the robot is an argument.
  struct InputCost {
    std::string argument;
    int flops = 0;
  };
  std::map<std::string, std::vector<InputCost>> input_costs;  ///< by function

  /// Text about rounding errors of each source, by its name without `.cpp`. `domain` tells the
  /// inputs for which it holds.
  std::map<std::string, std::string> rounding;
  std::string domain;

  std::vector<std::string> notes;  ///< lines for the contract: locked joints, lumped links
};

/// The type of the emitted code's numbers, in C and C++.
inline const char* number_type(const EmissionContext& context) {
  return context.single_precision ? "float" : "double";
}

/// Bytes of one of the emitted code's numbers.
inline int number_bytes(const EmissionContext& context) {
  return context.single_precision ? 4 : 8;
}

}  // namespace treeline
