#include "recursion/methods/task_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "recursion/algebra/capped_inverse.hpp"
#include "recursion/methods/loop_rows.hpp"
#include "recursion/methods/order_pivots.hpp"
#include "recursion/methods/ordinary_states.hpp"
#include "recursion/methods/resolved_by_pivots.hpp"

namespace treeline {
namespace {

/// Matrix that the LDL^T of a law factors.
DenseMatrix<double> matrix_at(const Posed<double>& posed, TaskLaw::Kind kind, TaskBasis basis) {
  const std::size_t rows = count_rows(posed.tree);
  if (has_loops(posed.tree)) {
    const auto tasks = task_points(posed.tree, {}, world_poses(posed.tree, posed.X));
    const auto J =
        jacobian_with_loops(posed.tree, posed.X, tasks, rows, loop_jacobian(posed.tree, posed.X));
    return lambda_inverse_by_factors(posed.tree, posed.X, J);
  }
  const auto poses = poses_seen_from(posed.tree, posed.X, basis.axes_link);
  auto A = lambda_inverse(posed.tree, posed.X, poses, {basis, LambdaRoute::factors_inward}, rows);
  if (kind != TaskLaw::Kind::grasp_forces) return A;
  const std::vector<double> rest(static_cast<std::size_t>(posed.tree.nv), 0);
  const std::vector<double> gains{0, 0};
  const auto state = held_objects<double>(posed.tree, posed.objects, posed.X, rest, gains);
  std::size_t at = 0;
  for (std::size_t k = 0; k < posed.objects.size(); ++k) {
    const auto free = free_object(posed.tree, posed.objects[k], state.held[k].front());
    const std::size_t size = 6 * posed.objects[k].grasps.size();
    for (std::size_t i = 0; i < size; ++i) {
      for (std::size_t j = 0; j < size; ++j) A(at + i, at + j) += free.inverse_Lambda(i % 6, j % 6);
    }
    at += size;
  }
  return A;
}

OrdinaryPivots ordinary_pivots(const Mechanism& mechanism, TaskLaw::Kind kind, LawPoints points,
                               TaskBasis basis) {
  OrdinaryPivots pivots;
  const auto constants = unposed<double>(mechanism, points);
  for (int state = 0; state < kOrdinaryStates; ++state) {
    const auto posed = pose(constants, points, ordinary_state(mechanism, state));
    pivots.add(matrix_at(posed, kind, basis));
  }
  return pivots;
}

/// For each row whether nothing that comes before can ever hold it: an object's own matter moves
/// the rows of its first grasp.
std::vector<bool> first_grasps(const std::vector<TreeObject<double>>& objects) {
  std::vector<bool> first;
  for (const auto& object : objects) {
    for (std::size_t i = 0; i < 6 * object.grasps.size(); ++i) first.push_back(i < 6);
  }
  return first;
}

std::vector<double> row_borders(const Mechanism& mechanism, TaskLaw::Kind kind, LawPoints points,
                                TaskBasis basis, const BoundedInverseShape& shape) {
  const auto posed = pose<double>(mechanism, points, ordinary_state(mechanism, 0));
  const auto free =
      kind == TaskLaw::Kind::grasp_forces ? first_grasps(posed.objects) : always_free(posed.tree);
  auto borders = ordinary_pivots(mechanism, kind, points, basis).borders(shape);
  for (std::size_t k = 0; k < borders.size(); ++k) {
    if (k < free.size() && free[k]) borders[k] = 0;  // rows of loops follow, which are not free
  }
  return borders;
}

/// One for each contact: a share of the mean of its three diagonal entries.
std::vector<double> normal_borders(const Mechanism& mechanism) {
  const CappedInverseShape shape = effective_mass_shape(mechanism.real);
  const auto pivots =
      ordinary_pivots(mechanism, TaskLaw::Kind::normals, LawPoints::contacts, TaskBasis{});
  std::vector<double> borders;
  for (std::size_t row = 0; row < pivots.rows(); row += 3) {
    const double sum = pivots.diagonal(row) + pivots.diagonal(row + 1) + pivots.diagonal(row + 2);
    borders.push_back(std::max(rounded_border(shape.share * sum / 3), shape.least));
  }
  return borders;
}

/// The caps of effective masses, one per contact, and a plural.
std::string list_caps(const std::vector<double>& borders) {
  std::string list;
  for (std::size_t i = 0; i < borders.size(); ++i) {
    const char* const before = i == 0 ? "" : i + 1 < borders.size() ? ", " : " and ";
    list += fmt::format("{}{:.2g}", before, 1 / borders[i]);
  }
  return list;
}

/// One for each row: a share of the sum over its point's rows of its kind.
std::vector<double> mobility_floors(const Mechanism& mechanism) {
  constexpr double kShare = 0x1p-6;
  const auto pivots =
      ordinary_pivots(mechanism, TaskLaw::Kind::priorities, LawPoints::operational, TaskBasis{});
  std::vector<double> floors;
  for (const MechanismPoint& point : mechanism.operational_points) {
    for (const std::ptrdiff_t first : {0, 3}) {
      const auto begin = point.rows.begin() + first;
      const auto count = static_cast<std::size_t>(std::count(begin, begin + 3, true));
      double sum = 0;
      for (std::size_t i = 0; i < count; ++i) sum += pivots.diagonal(floors.size() + i);
      floors.insert(floors.end(), count, rounded_border(kShare * sum));
    }
  }
  return floors;
}

/// Borders of the pivots of J; of those that are constant 0.
std::vector<double> jacobian_borders(const TaskLaw& law, const std::vector<bool>& constant,
                                     const BoundedInverseShape& shape) {
  std::vector<std::vector<double>> sizes(6);
  const auto [lone, a, b] = law.arm.rows();
  const std::vector<Pivot> last(law.pivots.begin() + 3, law.pivots.end());
  const auto constants = unposed<double>(*law.mechanism, LawPoints::operational);
  for (int state = 0; state < kOrdinaryStates; ++state) {
    const auto posed =
        pose(constants, LawPoints::operational, ordinary_state(*law.mechanism, state));
    const auto J = wrist_jacobian(posed.tree, posed.X, law.basis.axes_link);
    sizes[0].push_back(std::abs(J(lone, 0)));
    sizes[2].push_back(std::abs(J(a, 1) * J(b, 2) - J(b, 1) * J(a, 2)));
    eliminate(block_of(wrist_jacobian(posed.tree, posed.X, law.angular_axes_link), 3, 3), {0, 0, 0},
              last, [&](std::size_t k, double c) {
                sizes[3 + k].push_back(std::abs(c));
                return 1 / c;
              });
  }
  std::vector<double> borders;
  for (std::size_t k = 0; k < 6; ++k) {
    const bool bare = k == 1 || (k >= 3 && constant[k - 3]);
    borders.push_back(bare ? 0 : rounded_border(median(sizes[k]), shape));
  }
  return borders;
}

/// 1 over the squared distance of the wrist's centre from the third joint's axis.
double inverse_square_of_forearm(const Mechanism& mechanism) {
  const Digits50Vector3& p = mechanism.links[3].placement.p;
  const Digits50 square = p(0) * p(0) + p(1) * p(1);
  return square > 0 ? static_cast<double>(Digits50(1 / square)) : 0;
}

LawAxes rows_of(const Matrix3<Digits50>& A) {
  return {{{A.row_x.x, A.row_x.y, A.row_x.z},
           {A.row_y.x, A.row_y.y, A.row_y.z},
           {A.row_z.x, A.row_z.y, A.row_z.z}}};
}

/// Out of the axes of an arm's linear rows: across the third joint's column, along it, and alone.
Matrix3<Digits50> arm_rows(const Posed<Digits50>& posed, const TaskLaw& law,
                           const Matrix3<Digits50>& axes) {
  const auto J = wrist_jacobian(posed.tree, posed.X, law.basis.axes_link);
  const auto [lone, a, b] = law.arm.rows();
  const auto& e_a = row_of(axes, static_cast<int>(a));
  const auto& e_b = row_of(axes, static_cast<int>(b));
  const Digits50 inverse(law.arm.inverse_square);
  return {e_a * J(b, 2) - e_b * J(a, 2), (e_a * J(a, 2) + e_b * J(b, 2)) * inverse,
          row_of(axes, static_cast<int>(lone))};
}

}  // namespace

std::vector<LawFrame> law_frames(const TaskLaw& law, const std::vector<double>& q,
                                 const GivenTools& tools) {
  const TaskBasis& basis = law.basis;
  if (!basis.in_link_axes && !basis.at_link_origin && basis.axes_link < 0) return {};
  const auto posed = pose<Digits50>(*law.mechanism, law.points, q, tools);
  const auto poses = world_poses(posed.tree, posed.X);
  const auto axes_of = [&](int link, const TreePoint<Digits50>& point) {
    if (link < 0 && !basis.in_link_axes && point.axes == Axes::world) return identity3<Digits50>();
    if (link < 0 && !basis.in_link_axes) return transposed(point_pose(poses, point).R);
    return transposed(poses[static_cast<std::size_t>(link < 0 ? point.link : link)].R);
  };
  std::vector<LawFrame> frames;
  for (const TreePoint<Digits50>& point : posed.tree.operational_points) {
    if (point.link < 0) {
      frames.push_back({rows_of(identity3<Digits50>()), rows_of(identity3<Digits50>()), {}});
      continue;
    }
    const int angular = law.angular_axes_link >= 0 ? law.angular_axes_link : basis.axes_link;
    const Vector3<Digits50> arm = poses[static_cast<std::size_t>(point.link)].R * point.p;
    const Matrix3<Digits50> axes = axes_of(basis.axes_link, point);
    const bool of_arm = law.kind == TaskLaw::Kind::jacobian;
    LawFrame frame{
        rows_of(of_arm ? arm_rows(posed, law, axes) : axes), rows_of(axes_of(angular, point)), {}};
    if (basis.at_link_origin) frame.shift = {-arm.x, -arm.y, -arm.z};
    frames.push_back(frame);
  }
  return frames;
}

/// Shares of what is ordinary, in words: below the first a row yields, above the other it is exact.
struct YieldWords {
  const char *yields, *exact;
};

YieldWords words_of_inertia(bool single, bool early) {
  if (single) return {"5e-4", "3e-2"};
  return early ? YieldWords{"1e-4", "2e-2"} : YieldWords{"8e-6", "1e-3"};
}

YieldWords words_of_jacobian(bool single, bool early) {
  if (single) return {"8e-3", "0.2"};
  return early ? YieldWords{"8e-3", "0.25"} : YieldWords{"1e-3", "0.03"};
}

std::string describe(const TaskLaw& law) {
  const bool single = law.mechanism->real == Real::float32;
  const bool early = law.mechanism->singular == SingularTasks::early;
  const YieldWords inertia = words_of_inertia(single, early);
  const YieldWords jacobian = words_of_jacobian(single, early);
  switch (law.kind) {
    case TaskLaw::Kind::inverse_inertia:
    case TaskLaw::Kind::grasp_forces:
      return fmt::format(
          "finite everywhere; a row that those before it leave nothing to move with yields, "
          "smoothly and alone, where its inverse inertia falls below {} of what is ordinary, and "
          "is exact to rounding above {}.",
          inertia.yields, inertia.exact);
    case TaskLaw::Kind::jacobian:
      return fmt::format(
          "finite everywhere; at the elbow, overhead and at the wrist's lock one direction yields, "
          "smoothly, where its pivot falls below {} of what is ordinary, and is exact to rounding "
          "above {}.",
          jacobian.yields, jacobian.exact);
    case TaskLaw::Kind::priorities:
      return "finite everywhere; a row that those before it leave 2^-13 of what its point has "
             "yields, smoothly and alone.";
    case TaskLaw::Kind::supported:
      if (law.mechanism->singular == SingularTasks::exact) return kBareSolve;
      return fmt::format(
          "finite everywhere; a row that constraints, passive joints and the rows before it leave "
          "nothing to move with yields, smoothly and alone, where its inverse inertia falls below "
          "{} of what is ordinary, and is exact to rounding above {}. Constraints that cannot "
          "carry the motion leave part of it to forces that tau lacks.",
          inertia.yields, inertia.exact);
    case TaskLaw::Kind::eliminated:
      return fmt::format(
          "finite everywhere; where passive joints do not follow the others, one of them does not "
          "hold its loop, smoothly and alone: where the square of its hold falls below {} of what "
          "is ordinary. Exact to rounding above {}.",
          single ? "5e-4" : "8e-6", single ? "3e-2" : "1e-3");
    case TaskLaw::Kind::normals:
      return fmt::format(
          "finite everywhere; along what cannot be moved the mass grows smoothly to a cap of {} "
          "kg{}; it is never above the exact mass, and below it by at most (exact mass / cap)^4.",
          list_caps(law.rule.borders), law.rule.borders.size() > 1 ? ", contact by contact" : "");
  }
  return {};
}

TaskLaws::TaskLaws(const Mechanism& mechanism)
    : mechanism_(std::make_shared<const Mechanism>(mechanism)) {}

std::shared_ptr<const TaskLaw> TaskLaws::find(TaskLaw::Kind kind, LawPoints points,
                                              TaskBasis basis) {
  if (mechanism_->singular == SingularTasks::exact) return nullptr;
  const Key key{kind, points, basis.in_link_axes, basis.at_link_origin, basis.axes_link};
  auto& found = found_[key];
  if (found) return found;
  const BoundedInverseShape shape = inverse_inertia_shape(mechanism_->real, mechanism_->singular);
  TaskLaw law;
  law.kind = kind;
  law.points = points;
  law.mechanism = mechanism_;
  law.basis = basis;
  law.rule.power = shape.power;
  if (kind == TaskLaw::Kind::normals) {
    law.rule = {4, normal_borders(*mechanism_)};
  } else if (kind == TaskLaw::Kind::priorities) {
    law.rule.borders = mobility_floors(*mechanism_);
  } else {
    law.rule.borders = row_borders(*mechanism_, kind, points, basis, shape);
  }
  return found = std::make_shared<const TaskLaw>(std::move(law));
}

std::shared_ptr<const TaskLaw> TaskLaws::resolved(int axes_link) {
  const auto lone_row = find_lone_row(*mechanism_, axes_link);
  const auto wrist = order_wrist_pivots(*mechanism_);
  const double inverse_square = inverse_square_of_forearm(*mechanism_);
  if (!lone_row || !wrist || inverse_square == 0) return nullptr;
  const BoundedInverseShape shape = jacobian_shape(mechanism_->real, mechanism_->singular);
  TaskLaw law;
  law.kind = TaskLaw::Kind::jacobian;
  law.mechanism = mechanism_;
  law.basis = {false, true, axes_link};
  law.angular_axes_link = wrist->axes_link;
  law.arm = {*lone_row, inverse_square};
  law.pivots = {{2, 0}, {1, 2}, {0, 1}};
  law.pivots.insert(law.pivots.end(), wrist->order.begin(), wrist->order.end());
  law.rule = {shape.power, jacobian_borders(law, wrist->constant, shape)};
  return std::make_shared<const TaskLaw>(std::move(law));
}

}  // namespace treeline
