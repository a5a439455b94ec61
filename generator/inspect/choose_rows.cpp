#include <algorithm>
#include <cmath>
#include <numbers>

#include "bounds/rng.hpp"
#include "description/scene_queries.hpp"
#include "inspect/propose_scene.hpp"
#include "interpreter/instances.hpp"
#include "mechanism/build_mechanism.hpp"
#include "oracle/model_from_robot.hpp"

namespace treeline {
namespace {

using Matrices = std::vector<Eigen::MatrixXd>;

constexpr std::uint64_t kRowSeed = 1;
/// A row is independent of those before it if at least this share of it remains in half of the
/// states.
constexpr double kIndependent = 0.03;
/// Rows below this share of the largest row of their kind, of translations or rotations, are
/// rounding errors: files give right angles with few digits, as 1.57.
constexpr double kRounding = 2e-3;

/// Draws a value within a coordinate's limits, or within one turn or 1 m if it has none.
double draw(const std::vector<Coordinate>& all, const Coordinate& coordinate, Rng& rng) {
  if (turns_what_floats(all, coordinate)) return coordinate.neutral();
  const auto [lower, upper] = coordinate.ordinary_range();
  return rng.within(lower, upper);
}

/// Computes Jacobians at random states, six rows per point.
Matrices draw_jacobians(const Robot& robot, const Scene& scene,
                        const std::vector<ScenePoint>& points) {
  const auto model = model_from_robot<double>(robot, scene);
  if (model.nv == 0) {
    return {kRowStates, Eigen::MatrixXd::Zero(static_cast<long>(6 * points.size()), 1)};
  }
  const auto mechanism = build_mechanism(robot, scene);
  const auto places = points_from_scene(model, points);
  Rng rng(kRowSeed);
  Matrices jacobians;
  for (int state = 0; state < kRowStates; ++state) {
    interpreter::Vector<double> q(model.nq);
    for (int i = 0; i < model.nq; ++i) {
      q[i] = draw(mechanism.coordinates, mechanism.coordinates[static_cast<std::size_t>(i)], rng);
    }
    jacobians.push_back(interpreter::jacobian<double>(model, places, q));
  }
  return jacobians;
}

/// Selects rows as long as they are independent of those selected before.
class Independence {
 public:
  explicit Independence(const Matrices& jacobians)
      : jacobians_(jacobians), bases_(jacobians.size()) {
    for (const Eigen::MatrixXd& J : jacobians) {
      for (int row = 0; row < J.rows(); ++row) {
        double& largest = largest_[kind_of(row)];
        largest = std::max(largest, J.row(row).norm());
      }
    }
  }

  bool take(int row) {
    std::vector<double> shares;
    std::vector<Eigen::VectorXd> rests;
    for (std::size_t k = 0; k < jacobians_.size(); ++k) {
      const Eigen::VectorXd whole = jacobians_[k].row(row);
      Eigen::VectorXd rest = whole;
      for (int twice = 0; twice < 2; ++twice) {
        for (const Eigen::VectorXd& taken : bases_[k]) rest -= taken.dot(rest) * taken;
      }
      const bool is_there = whole.norm() > kRounding * largest_[kind_of(row)];
      shares.push_back(is_there ? rest.norm() / whole.norm() : 0);
      rests.push_back(rest);
    }
    std::vector<double> sorted = shares;
    std::nth_element(sorted.begin(), sorted.begin() + kRowStates / 2, sorted.end());
    if (sorted[kRowStates / 2] < kIndependent) return false;
    for (std::size_t k = 0; k < rests.size(); ++k) {
      if (shares[k] > kRounding) bases_[k].push_back(rests[k].normalized());
    }
    return true;
  }

 private:
  /// 0: a translation, 1: a rotation; a point has three rows of each.
  static std::size_t kind_of(int row) { return row % 6 < 3 ? 0 : 1; }

  const Matrices& jacobians_;
  std::vector<std::vector<Eigen::VectorXd>> bases_;
  std::array<double, 2> largest_{};  ///< of translations and rotations
};

/// Selects the row for a point that one coordinate moves: the row that it moves in every state.
std::array<bool, 6> steadiest_row(const Matrices& jacobians, int first) {
  std::array<double, 6> least{};
  for (int i = 0; i < 6; ++i) {
    double& value = least[static_cast<std::size_t>(i)];
    value = jacobians.front().row(first + i).norm();
    for (const Eigen::MatrixXd& J : jacobians) value = std::min(value, J.row(first + i).norm());
  }
  const auto best = std::max_element(least.begin(), least.end());
  std::array<bool, 6> rows{};
  if (*best > 0) rows[static_cast<std::size_t>(best - least.begin())] = true;
  return rows;
}

/// Number of coordinates that move a link, except those of floating joints.
int count_own(const Robot& robot, const Scene& still, const std::string& link) {
  int own = 0;
  for (const auto& [joint, number] : find_freedoms_of_link(robot, still, link)) {
    const bool floats = robot.joints[static_cast<std::size_t>(joint)].type == JointType::floating;
    own += floats ? 0 : number;
  }
  return own;
}

/// Returns the Jacobians with floating joints held.
Matrices held(Matrices jacobians, const interpreter::Model<double>& model) {
  for (const auto& body : model.bodies) {
    if (body.kind != interpreter::JointKind::floating) continue;
    for (Eigen::MatrixXd& J : jacobians) J.middleCols(body.v, 6).setZero();
  }
  return jacobians;
}

void choose_alone(const Matrices& jacobians, const Robot& robot, const Scene& still,
                  std::vector<ScenePoint>& points) {
  for (std::size_t p = 0; p < points.size(); ++p) {
    const int first = static_cast<int>(6 * p);
    const int own = count_own(robot, still, points[p].link);
    if (own == 0) continue;  // moves only with the base, or not at all
    if (own == 1) {
      points[p].rows = steadiest_row(jacobians, first);
      continue;
    }
    Independence independence(jacobians);
    for (int i = 0; i < 6; ++i) {
      points[p].rows[static_cast<std::size_t>(i)] = independence.take(first + i);
    }
  }
}

void choose_together(const Matrices& jacobians, std::vector<ScenePoint>& points) {
  Independence independence(jacobians);
  for (const int half : {0, 3}) {
    for (std::size_t p = 0; p < points.size(); ++p) {
      for (int i = half; i < half + 3; ++i) {
        bool& row = points[p].rows[static_cast<std::size_t>(i)];
        row = row && independence.take(static_cast<int>(6 * p) + i);
      }
    }
  }
}

}  // namespace

void choose_rows(const Robot& robot, const Scene& scene, std::vector<ScenePoint>& points) {
  Scene still = scene;
  still.base = Base::fixed;
  choose_alone(held(draw_jacobians(robot, still, points), model_from_robot<double>(robot, still)),
               robot, still, points);
  keep_independent_rows(robot, scene, points);
}

void keep_independent_rows(const Robot& robot, const Scene& scene,
                           std::vector<ScenePoint>& points) {
  std::vector<ScenePoint> whole = points;
  for (ScenePoint& point : whole) point.rows.fill(true);
  choose_together(draw_jacobians(robot, scene, whole), points);
}

}  // namespace treeline
