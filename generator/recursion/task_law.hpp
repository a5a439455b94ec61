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
#include "recursion/pivot_rule.hpp"
#include "recursion/task_basis.hpp"

namespace treeline {

/// One step of an elimination: which equation gives which unknown.
struct Pivot {
  std::size_t row = 0, column = 0;
};

/// The first three joints of an arm with a spherical wrist, the second and third parallel.
struct ArmPlane {
  std::size_t lone_row = 0;   ///< of the wrist's velocity, that only the first joint moves
  double inverse_square = 0;  ///< 1 over the squared distance from the third joint to the wrist

  /// The lone row, then the two others, in the order of a turn.
  [[nodiscard]] std::array<std::size_t, 3> rows() const {
    return {lone_row, (lone_row + 1) % 3, (lone_row + 2) % 3};
  }
};

/// What the rows of a law are about.
enum class LawPoints { operational, grasps, contacts };

/// What a function that solves for task forces answers near singularities of the task. Its rows are
/// eliminated in order, in the coordinates of `basis`; the pivot of row k is how easily it moves
/// while those before it are held, and where it vanishes `rule` lets row k yield, and it alone.
/// Borders are constants: a share of the pivot's median over ordinary states. A check needs all of
/// this, since what yields where nothing can be moved depends on the coordinates.
struct TaskLaw {
  enum class Kind {
    inverse_inertia,  ///< LDL^T of Lambda^-1
    grasp_forces,     ///< LDL^T of Lambda_e^-1 + C Lambda_obj^-1 C^T
    normals,          ///< n^T Lambda_c^-1 n of each contact by itself
    priorities,       ///< borders are added to mobilities, see `rows_by_priority`
    jacobian          ///< resolved acceleration: elimination of J in the order of `pivots`
  };
  Kind kind = Kind::inverse_inertia;
  LawPoints points = LawPoints::operational;
  std::shared_ptr<const Mechanism> mechanism;  ///< as it was traced
  TaskBasis basis;
  int angular_axes_link = -1;  ///< of `jacobian`, whose linear rows alone are in those of `basis`
  PivotRule rule;
  /// Of `jacobian`, in the rows of `law_frames`: of the arm across the third joint's column, along
  /// it and the lone one, of the wrist those of its axes.
  std::vector<Pivot> pivots;
  ArmPlane arm;
};

/// What a function with this law answers at singularities, in one sentence for its reader.
std::string describe(const TaskLaw& law);

/// The same of a function that inverts what may be singular without any law.
inline constexpr const char* kBareSolve =
    "not finite where rows cannot be moved independently (singular: exact).";

/// Directions in the world, row by row.
using ExactRows = std::array<std::array<Exact, 3>, 3>;

/// Where the rows of one point stand at a state: linear ones along `linear` at the point moved by
/// `shift` (world axes), angular ones along `angular`. Of laws of a Jacobian the rows of `linear`
/// have lengths of their own.
struct LawFrame {
  ExactRows linear, angular;
  std::array<Exact, 3> shift;
};

/// One frame a point, or none where all rows are as asked.
std::vector<LawFrame> law_frames(const TaskLaw& law, const std::vector<double>& q);

/// Makes the laws of a mechanism's functions, each once.
class TaskLaws {
 public:
  explicit TaskLaws(const Mechanism& mechanism);

  /// Null where the scene says `singular: exact`.
  std::shared_ptr<const TaskLaw> find(TaskLaw::Kind kind, LawPoints points, TaskBasis basis);

  /// Of resolved acceleration with the wrist's velocity in the axes of `axes_link`, where the scene
  /// does not say `singular: exact`. Null where the arm has no plane or the wrist's equations have
  /// no order of pivots: then a pivot could vanish where the robot is not singular.
  std::shared_ptr<const TaskLaw> resolved(int axes_link);

 private:
  using Key = std::tuple<TaskLaw::Kind, LawPoints, bool, bool, int>;

  std::shared_ptr<const Mechanism> mechanism_;
  std::map<Key, std::shared_ptr<const TaskLaw>> found_;
};

}  // namespace treeline
