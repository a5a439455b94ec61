#pragma once

#include <string>
#include <vector>

#include "comparison/match_robots.hpp"
#include "description/scene.hpp"

namespace treeline {

/// By how much a link that both robots have differs. SI units.
struct LinkDifference {
  std::string first, second;  ///< its name in each
  double position = 0;        ///< of its frame, against the reference link; m, worst of all states
  double rotation = 0;        ///< likewise; rad
  double first_mass = 0, second_mass = 0;  ///< kg
  double mass = 0;                         ///< relative to the larger
  double centre = 0;                       ///< of mass, in the link's frame; m
  double inertia = 0;  ///< about the centre of mass, in the link's axes; Frobenius norm, relative
};

/// What differs of a joint that both robots have: its type, what it mimics, its limits; in words
/// with the numbers of both.
struct JointDifference {
  std::string first, second;
  std::vector<std::string> faults;
};

/// A difference over all states, relative to the scale; and where it is largest.
struct Deviation {
  double relative = 0;
  double absolute = 0;  ///< at `joint`: N m or N
  std::string joint, unit;
};

/// Of the coordinates that both robots have, with the others at rest.
struct DynamicsDifference {
  int coordinates = 0;  ///< velocities in both; 0: nothing was compared
  /// |M1 - M2| at ij over sqrt(M_ii M_jj), the largest.
  double mass_matrix = 0;
  std::string row, column;  ///< joints of the entry
  /// Norms weighted by 1 / M_ii, which takes the units out, over the largest of all states.
  Deviation gravity, inverse_dynamics;
};

/// By how much two robots differ.
struct RobotDifference {
  std::string first_file, second_file, first_name, second_name;
  Base base = Base::fixed;
  double tolerance = 0;
  int states = 0;         ///< random ones within the limits, the same in every run
  std::string reference;  ///< link of the first robot that poses are relative to
  std::vector<std::string> links_only_in_first, links_only_in_second;
  std::vector<std::string> joints_only_in_first, joints_only_in_second;
  double first_mass = 0, second_mass = 0;  ///< of all links, kg
  std::vector<LinkDifference> links;       ///< all that are in both, in the order of the first
  std::vector<JointDifference> joints;     ///< likewise
  DynamicsDifference dynamics;

  /// Beyond the tolerance: m, rad, relative.
  [[nodiscard]] bool differs(const LinkDifference& link) const;
  [[nodiscard]] bool differs(const JointDifference& joint) const;
  [[nodiscard]] bool differs() const;
};

/// `tolerance`: m of poses and centres, rad, and relative of masses, inertias, limits and dynamics.
RobotDifference compare_robots(const Robot& first, const Robot& second, Base base,
                               double tolerance);

/// For people: what differs, the sum of it first.
std::string print_text(const RobotDifference& difference);

/// For programs: every field by its name.
std::string print_json(const RobotDifference& difference);

}  // namespace treeline
