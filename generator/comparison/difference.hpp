#pragma once

#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// A link or joint that both robots have, by its index in each.
struct Match {
  int first = -1, second = -1;
};

/// The correspondence of links and joints of two robots.
struct RobotMatch {
  std::vector<Match> links, joints;  ///< in the order of the first robot
  std::vector<int> links_only_in_first, links_only_in_second;
  std::vector<int> joints_only_in_first, joints_only_in_second;
};

/// Matches links and joints of the same name. The others are matched as renamed by their places in
/// the tree: the roots; the children of a joint that is in both; a joint that connects two links
/// that are in both; and, of the joints that leave such a link, those of the same type whose
/// origins are nearest to each other.
RobotMatch match_robots(const Robot& first, const Robot& second);

/// Difference of a link that both robots have. SI units.
struct LinkDifference {
  std::string first, second;  ///< name in each robot
  double position = 0;        ///< of the frame, relative to the reference link; m, largest
  double rotation = 0;        ///< of the frame, relative to the reference link; rad, largest
  double first_mass = 0, second_mass = 0;  ///< kg
  double mass = 0;                         ///< relative to the larger mass
  double centre = 0;                       ///< of the centre of mass, in the link's frame; m
  double inertia = 0;  ///< about the centre of mass, in the link's axes; relative, Frobenius norm
};

/// Difference of a joint that both robots have, in type, mimic or limits: in words, with the
/// numbers of both.
struct JointDifference {
  std::string first, second;
  std::vector<std::string> faults;
};

/// Largest difference over all states, relative to the scale, and the joint where it occurs.
struct Deviation {
  double relative = 0;
  double absolute = 0;  ///< at `joint`: N m or N
  std::string joint, unit;
};

/// Difference of the dynamics in the coordinates that both robots have, with all others at rest.
struct DynamicsDifference {
  int coordinates = 0;  ///< number of shared velocities; 0: nothing was compared
  /// Largest |M1 - M2| at ij over sqrt(M_ii M_jj).
  double mass_matrix = 0;
  std::string row, column;  ///< joints of that entry
  /// Norms of differences weighted by 1 / M_ii, so that units do not matter, relative to the
  /// largest of all states.
  Deviation gravity, inverse_dynamics;
};

/// Differences of two robots.
struct RobotDifference {
  std::string first_file, second_file, first_name, second_name;
  Base base = Base::fixed;
  double tolerance = 0;
  int states = 0;         ///< number of random states within the limits, the same in every run
  std::string reference;  ///< link of the first robot to which poses are relative
  std::vector<std::string> links_only_in_first, links_only_in_second;
  std::vector<std::string> joints_only_in_first, joints_only_in_second;
  double first_mass = 0, second_mass = 0;  ///< of all links, kg
  std::vector<LinkDifference> links;       ///< links of both, in the order of the first robot
  std::vector<JointDifference> joints;     ///< joints of both, in the order of the first robot
  DynamicsDifference dynamics;

  /// Whether the link differs by more than the tolerance.
  [[nodiscard]] bool differs(const LinkDifference& link) const;
  [[nodiscard]] bool differs(const JointDifference& joint) const;
  [[nodiscard]] bool differs() const;
};

/// Compares two robots. `tolerance` is in m for poses and centres of mass, in rad, and relative for
/// masses, inertias, limits and dynamics.
RobotDifference compare_robots(const Robot& first, const Robot& second, Base base,
                               double tolerance);

/// Prints the differences for people, a summary first.
std::string print_text(const RobotDifference& difference);

/// Prints every field as JSON, for programs.
std::string print_json(const RobotDifference& difference);

/// Compares masses, centres of mass and inertias of the links that both robots have.
void compare_inertias(const Robot& first, const Robot& second, const RobotMatch& match,
                      RobotDifference& difference);

/// Compares types, mimics and limits of the joints that both robots have.
void compare_joints(const Robot& first, const Robot& second, const RobotMatch& match,
                    RobotDifference& difference);

/// Compares poses, mass matrix, gravity and inverse dynamics at random states, see
/// `RobotDifference`.
void compare_motion(const Robot& first, const Robot& second, const RobotMatch& match,
                    RobotDifference& difference);

}  // namespace treeline
