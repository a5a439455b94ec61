#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "mechanism/mechanism.hpp"
#include "recursion/algebra/pivot_rule.hpp"
#include "recursion/methods/passive_joints.hpp"
#include "recursion/methods/task_basis.hpp"

namespace treeline {

/// One step of an elimination: the equation (row) and the unknown that it gives (column).
struct Pivot {
  std::size_t row = 0, column = 0;
};

/// The first three joints of an arm with a spherical wrist. The axes of the second and third are
/// parallel.
struct ArmPlane {
  std::size_t lone_row = 0;   ///< row of the wrist's velocity that only the first joint moves
  double inverse_square = 0;  ///< 1 over the squared distance from the third joint to the wrist

  /// The lone row, followed by the two others in cyclic order.
  [[nodiscard]] std::array<std::size_t, 3> rows() const {
    return {lone_row, (lone_row + 1) % 3, (lone_row + 2) % 3};
  }
};

/// Points whose rows a law concerns.
enum class LawPoints { operational, grasps, contacts };

/// Task law: the results of a function that solves for task forces, near singularities of the task.
/// The rows are eliminated in order, in the coordinates of `basis`. The pivot of row k is its
/// inverse inertia while the rows before it are held. Where the pivot vanishes, `rule` relaxes row
/// k, and only this row. Borders are constants: a share of the pivot's median over ordinary states.
/// A check needs all of this, because what is relaxed in directions that cannot move depends on the
/// coordinates.
struct TaskLaw {
  enum class Kind {
    inverse_inertia,  ///< LDL^T of Lambda^-1
    grasp_forces,     ///< LDL^T of Lambda_e^-1 + C Lambda_obj^-1 C^T
    normals,          ///< n^T Lambda_c^-1 n of each contact separately, see `capped_inverse`
    priorities,       ///< borders are added to mobilities, see `rows_by_priority`
    supported,        ///< of a supported control torque, see `split_rules`
    eliminated,       ///< passive velocities out of rows of loops, see `LoopedVelocities`
    jacobian          ///< resolved acceleration: elimination of J in the order of `pivots`
  };
  Kind kind = Kind::inverse_inertia;
  LawPoints points = LawPoints::operational;
  std::shared_ptr<const Mechanism> mechanism;  ///< mechanism as it was traced
  TaskBasis basis;
  int angular_axes_link = -1;  ///< for `jacobian`: of the angular rows; `basis`: the linear ones
  PivotRule rule;
  /// For `jacobian`: the pivots, in the rows of `law_frames`. Those of the arm are across the third
  /// joint's column, along it, and the lone row; those of the wrist are in its axes. For
  /// `eliminated`: the rows of loops that are kept, and beside them, in the order in which they are
  /// eliminated, the dependent velocities.
  std::vector<Pivot> pivots;
  /// Whether something may yield where the robot is at work: a route with this law is taken only
  /// where it is named.
  bool only_by_name = false;
  ArmPlane arm;
};

/// The rules of a law for a supported control torque. Its mechanism comes from `with_supports`; its
/// borders are those of Lambda^-1, of the constraints with motors locked if passive joints can move
/// then, and of the equations for forces.
SupportRules split_rules(const TaskLaw& law);

/// Describes in one sentence for users what a function with this law returns at singularities.
std::string describe(const TaskLaw& law);

/// Describes the results at singularities of a function that inverts a possibly singular matrix
/// without a law.
inline constexpr const char* kBareSolve =
    "not finite where rows cannot be moved independently (singular: exact).";

/// Added for Lambda itself.
inline constexpr const char* kYieldingLambda =
    " What yields has no inertia: this is the Lambda of control_torque, F = Lambda xdd stays "
    "finite. The inertia itself grows without bound there; lambda_inverse is exact.";

/// Directions in the world, row by row.
using LawAxes = std::array<std::array<Digits50, 3>, 3>;

/// Rows of one point at a state. Linear rows are along `linear`, at the point moved by `shift`
/// (world axes); angular rows are along `angular`. In laws of a Jacobian, the rows of `linear` need
/// not have unit length.
struct LawFrame {
  LawAxes linear, angular;
  std::array<Digits50, 3> shift;
};

/// Run-time arguments for operational points: entries of `tool` and `tool_orientation`. Where they
/// are empty, the values of the scene apply.
struct GivenTools {
  std::vector<double> origins, orientations;
};

/// Frames of the law's rows at `q`, one per point; empty if all rows are those of the scene.
std::vector<LawFrame> law_frames(const TaskLaw& law, const std::vector<double>& q,
                                 const GivenTools& tools = {});

/// Makes the task laws of a mechanism's functions, each once.
class TaskLaws {
 public:
  explicit TaskLaws(const Mechanism& mechanism);

  /// Returns the law for these rows, or null if the scene has `singular: exact`.
  std::shared_ptr<const TaskLaw> find(TaskLaw::Kind kind, LawPoints points, TaskBasis basis);

  /// Law of resolved acceleration, with the wrist's velocity in the axes of `axes_link`. Null if
  /// the scene has `singular: exact`, if the arm has no plane, or if the wrist's equations have no
  /// order of pivots; a pivot could then vanish where the robot is not singular.
  std::shared_ptr<const TaskLaw> resolved(int axes_link);

  /// Law of a supported control torque; the mechanism must come from `with_supports`. With
  /// `singular: exact` the rows of tasks have no borders. Those of constraints have: they depend on
  /// each other as a rule, and what they hold does not.
  std::shared_ptr<const TaskLaw> supported();

 private:
  using Key = std::tuple<TaskLaw::Kind, LawPoints, bool, bool, int>;

  std::shared_ptr<const Mechanism> mechanism_;
  std::map<Key, std::shared_ptr<const TaskLaw>> found_;
};

}  // namespace treeline
