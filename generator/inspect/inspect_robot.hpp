#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "inspect/report.hpp"
#include "interpreter/points.hpp"

namespace treeline {

/// Describes a robot in a scene. Without a scene the base is fixed and nothing is locked.
Report inspect_robot(const Robot& robot, const std::optional<Scene>& scene);

/// Prints what the robot is, in ten lines for people.
std::string print_summary(const Report& report);

/// Prints the summary, then the whole report as aligned columns with units, within 100 columns.
std::string print_text(const Report& report);

/// Prints every field of the report as JSON, for programs. Infinite limits are null.
std::string print_json(const Report& report);

/// Prints the tree for Graphviz: links are boxes, joints are edges, dashed if they do not move,
/// dotted for mimics. Boxes of impossible inertias are red.
std::string print_dot(const Report& report);

/// Replacement of some bytes of a text.
struct TextEdit {
  std::size_t at = 0, size = 0;
  std::string text;
};

/// Applies the edits to the text. Every other byte stays.
std::string apply_edits(const std::string& text, const std::vector<TextEdit>& edits);

/// Prints the edits as a unified diff with three lines of context, for `patch` and `git apply`.
/// Empty if there are no edits.
std::string print_patch(const std::string& file, const std::string& text,
                        const std::vector<TextEdit>& edits);

/// A link and the inertia that it shall have.
struct InertiaRepair {
  int link = -1;  ///< index into Robot::links
  Inertial inertial;
};

/// Returns the edits of the URDF's text, in order of place: the values of those moments that differ
/// from the robot's, and nothing else. `text` must be the one from which `robot` was read.
std::vector<TextEdit> edit_inertias(const Robot& robot, const std::string& text,
                                    const std::vector<InertiaRepair>& repairs);

/// Whether `text`, when it is read again, gives `robot` with these inertias, so that the edits are
/// at the right places.
bool has_repairs(const std::string& text, const Robot& robot,
                 const std::vector<InertiaRepair>& repairs);

/// Fills in which impossible inertias affect the motion, the possible inertias nearest to them, and
/// which bodies are flat. The report must contain its links already.
void inspect_inertias(const Robot& robot, const Scene& scene, Report& report);

/// Returns the inertias to repair, of the links whose faults affect the motion.
std::vector<InertiaRepair> list_repairs(const Robot& robot, const Report& report);

/// Fills in the report's loops, and adds their singular poses to its risks (Gosselin & Angeles
/// 1990). Each joint of a loop, or each motor if the scene calls joints passive, is led through its
/// range from some closed poses, the same ones in every run, while the loops stay closed. Named are
/// joints on whose way
///  - rows of the loops depend on each other that elsewhere do not: the loop gains a freedom and
///    may leave its path there (a parallelogram that is folded flat);
///  - the motors lose hold: passive joints can move while all motors are at rest (a slider-crank
///    driven by its slider, at the dead point).
/// Does nothing if the scene has no constraints between links and no couplings. The report must
/// contain its joints already.
void inspect_loops(const Robot& robot, const Scene& scene, Report& report);

/// Fills the report's centre of mass and mass matrix, from the interpreter at the neutral pose.
void inspect_masses(const Robot& robot, const Scene& scene, Report& report);

/// Fills in the report's risks: joints by which this robot loses digits in this scene. They are
/// found by the interpreter in double at states within the joints' limits, the same states in every
/// run. The report must contain its joints already.
///  - Inertia: M_ii (M^-1)_ii, the ratio of the inertia that a joint feels with the others locked
///  to
///    the one with the others free. It bounds the loss of a solve with M over joint i. The worst of
///    some states.
///  - Mass: what joints of very different inertias cost Lambda^-1 in any state, see
///    `find_mass_ratio`. If there are such joints, singularities are not searched.
///  - Singularity: the condition number of Lambda^-1, scaled to a unit diagonal, along each joint's
///    range with the other joints at rest in a few states, followed to its peak.
///  - Angle: ranges, of followers by their multipliers, that exceed `farthest_angle`, beyond which
///    sines are not accurate.
void inspect_risks(const Robot& robot, const Scene& scene, Report& report);

/// Finds impossible inertias on which the motion depends. A link is one of them if no choice of
/// possible bodies, of whatever mass, moves like the robot with this link unchanged and every other
/// impossible link repaired. Other faults do not matter: the link is fixed to a body that makes up
/// for it, or is at rest, or is impossible only in what regrouping moves to bodies that can absorb
/// it. `faulty` are indices of links with impossible second moments; returns some of them.
std::vector<int> find_felt_faults(const Robot& robot, const Scene& scene,
                                  const std::vector<int>& faulty);

/// Two joints whose inertias differ so much that Lambda^-1, in which both count, keeps few digits
/// of what the heavy one contributes.
struct MassRatio {
  int light = 0, heavy = 0;  ///< entries of qd
  double share = 1;          ///< ratio of their contributions to Lambda^-1, light to heavy
  double condition = 1;      ///< factor by which this increases the condition number of Lambda^-1
};

/// Finds two such joints. With M = U U^T, U upper triangular, the columns of J U^-T are the
/// contributions of the joints to Lambda^-1 = J U^-T U^-1 J^T, with the joints behind them free:
/// the lighter, the larger. The cost of the inertias is the condition number of Lambda^-1 divided
/// by the one that these columns would have if they were all of one size. The result is the least
/// of all states. Nothing if M is not positive definite in any of them.
std::optional<MassRatio> find_mass_ratio(const interpreter::Model<double>& model,
                                         const interpreter::Points<double>& points,
                                         std::span<const interpreter::Vector<double>> states);

/// Decimal digits that a state costs: from `kSingularDigits` on it counts as singular; double has
/// `kMostDigits` to lose.
inline constexpr double kSingularDigits = 5, kMostDigits = 15.7;

inline constexpr int kRangeSteps = 48;  ///< states that are looked at along a joint's range

/// Condition number of a symmetric matrix after scaling it to a unit diagonal: 1 / smallest
/// eigenvalue. Infinite if A is not positive definite.
double unit_condition(const Eigen::MatrixXd& A);

}  // namespace treeline
