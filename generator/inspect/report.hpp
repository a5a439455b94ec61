#pragma once

#include <array>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"

namespace treeline {

/// A link and the joint that carries it. SI units.
struct LinkReport {
  std::string name;
  int parent = -1;          ///< index into Report::links; -1 for the root
  int depth = 0;            ///< number of joints between the root and the link
  std::string joint;        ///< empty for the root
  std::string joint_type;   ///< as in URDF; empty for the root
  bool moves = false;       ///< relative to its parent, in this scene
  std::string motion;       ///< "fixed", "locked at 0.3", "follows j", else the joint's type
  std::string lumped_with;  ///< link of whose body it is part; empty: its own
  bool has_inertial = false;
  double mass = 0;                  ///< kg
  std::array<double, 3> com{};      ///< centre of mass in the link's frame, m
  std::array<double, 3> moments{};  ///< principal, about the centre of mass, ascending, kg m^2
  std::optional<std::string> unphysical;  ///< why no body can have this inertia
  std::optional<Inertial> nearest;        ///< nearest possible inertia, if this is impossible
  bool felt = false;                      ///< the motion depends on the impossible inertia
  std::optional<std::string> flat;        ///< "a point", "a rod", "a plate"
};

/// Values of the scene for a joint: kg m^2, N m s/rad, N m, rad/s, N m/rad and rad, or the same of
/// translation. A value of 0 is absent.
struct DriveReport {
  double rotor = 0, damping = 0, friction = 0, width = 0, stiffness = 0, rest = 0;
};

/// A moving joint, in the order of q. Limits are infinite if the file sets none.
struct JointReport {
  std::string name;
  std::string type;
  int q = 0, nq = 0;  ///< first entry of q and number; for a mimic of the joint that it follows
  int v = 0, nv = 0;  ///< first entry of qd and their number
  std::string unit;   ///< of q: "rad", "m", or empty for several degrees of freedom
  double lower = -std::numeric_limits<double>::infinity();
  double upper = std::numeric_limits<double>::infinity();
  double effort = std::numeric_limits<double>::infinity();    ///< N m or N
  double velocity = std::numeric_limits<double>::infinity();  ///< rad/s or m/s
  std::string follows;                                        ///< "2 * j + 0.1" for a mimic
  std::optional<DriveReport> drive;
};

/// An operational point, or the place of an external force.
struct PointReport {
  std::string name, link, axes;
  std::string rows;  ///< "x y z rx ry rz"; empty for a force, which has all rows
};

/// A moving link before and after the reductions, which leave the equations of motion unchanged.
struct ReductionReport {
  std::string link;
  double mass_before = 0, mass_after = 0;     ///< kg
  int numbers_before = 0, numbers_after = 0;  ///< nonzero ones of the ten inertial parameters
};

struct NoteReport {
  std::string step, link, text;
};

/// The mass matrix at coordinates 0 and neutral quaternions.
struct MassMatrixReport {
  double least = 0, largest = 0;  ///< eigenvalues, SI units
  double condition = 0;           ///< ratio of the eigenvalues; infinite if M is singular
  /// Condition number after scaling rows and columns to a unit diagonal, so that units do not
  /// matter.
  double scaled_condition = 0;
  std::vector<double> diagonal;
};

/// A cause of lost digits, see `inspect_risks` and `inspect_loops`.
struct RiskReport {
  std::string joint;       ///< one or several joints; empty if the task as a whole is meant
  std::string kind;        ///< "inertia", "mass", "singularity", "task", "angle", "loop"
  double digits_lost = 0;  ///< of double's 15.7: log10 of a condition number
  std::string finding, advice;
};

/// Motion that constraints between links and couplings leave, in poses that close the loops.
struct LoopsReport {
  int rows = 0;
  int dependent = 0;  ///< rows that the others imply
  int freedoms = 0;   ///< of the joints that play a part
  int unheld = 0;     ///< freedoms left while all motors are at rest
};

/// Everything that `treeline inspect` prints.
struct Report {
  std::string robot, urdf, scene;  ///< name and files; `scene` is empty if there is none
  std::string base;                ///< "fixed" or "floating"
  std::array<double, 3> gravity{};
  int nq = 0, nv = 0;
  double mass = 0;                ///< of all links, kg
  double moving_mass = 0;         ///< of the links that move in the world, kg
  std::array<double, 3> com{};    ///< of all links, in the root's frame at the neutral pose, m
  std::vector<LinkReport> links;  ///< depth-first, in the order of the numbering
  std::vector<JointReport> joints;
  std::vector<PointReport> operational_points, external_forces;
  std::vector<ReductionReport> reductions;
  std::vector<NoteReport> notes;
  std::optional<MassMatrixReport> mass_matrix;  ///< nothing if no joint moves
  std::optional<LoopsReport> loops;             ///< nothing if there are none that close
  std::vector<RiskReport> risks;
};

}  // namespace treeline
