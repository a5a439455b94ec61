#include <Eigen/Eigenvalues>
#include <algorithm>
#include <tuple>
#include <utility>

#include "finite/extreme_states.hpp"
#include "interpreter/instances.hpp"
#include "oracle/entries.hpp"

namespace treeline::tests {
namespace {

constexpr int kLines = 12;   ///< coordinates searched along from each start
constexpr int kGrid = 12;    ///< samples on a line
constexpr int kThirds = 40;  ///< times that the range around the minimum loses a third

/// Smallest eigenvalue of Lambda^-1 with its rows scaled to a unit diagonal.
double smallest(const StateSpace& space, const std::vector<double>& q) {
  const Eigen::MatrixXd A = interpreter::lambda_inverse<double>(
      space.subject.model, space.subject.points, vector_of<double>(q));
  const Eigen::VectorXd s = A.diagonal().cwiseMax(1e-300).cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = s.asDiagonal() * A * s.asDiagonal();
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly)
      .eigenvalues()(0);
}

/// Moves one coordinate to where the eigenvalue is smallest.
void go_down(const StateSpace& space, std::size_t i, std::vector<double>& q) {
  const auto [low, high] = space.coordinates[i].ordinary_range();
  const auto at = [&](double x) {
    std::vector<double> moved = q;
    moved[i] = x;
    return smallest(space, moved);
  };
  const double step = (high - low) / kGrid;
  double best = q[i], least = at(q[i]);
  for (int k = 0; k <= kGrid; ++k) {
    const double value = at(low + k * step);
    if (value < least) std::tie(best, least) = std::pair{low + k * step, value};
  }
  double a = std::max(low, best - step), b = std::min(high, best + step);
  for (int k = 0; k < kThirds; ++k) {
    const double c = a + (b - a) / 3, d = b - (b - a) / 3;
    if (at(c) < at(d)) {
      b = d;
    } else {
      a = c;
    }
  }
  const double middle = a + (b - a) / 2;
  q[i] = at(middle) < least ? middle : best;
}

}  // namespace

std::vector<std::vector<double>> find_singular_poses(const StateSpace& space, int count) {
  std::vector<std::vector<double>> poses;
  if (space.subject.points.empty() || space.coordinates.empty()) return poses;
  std::vector<std::size_t> moving;
  for (std::size_t i = 0; i < space.coordinates.size(); ++i) {
    if (!space.coordinates[i].is_of_quaternion()) moving.push_back(i);
  }
  Rng rng(space.seed);
  for (int start = 0; start < count; ++start) {
    std::vector<double> q = draw_state(space, start).q;
    for (const std::size_t i : moving) {
      const auto [low, high] = space.coordinates[i].ordinary_range();
      q[i] = rng.within(low, high);
    }
    for (int line = 0; line < kLines; ++line) go_down(space, moving[rng.below(moving.size())], q);
    poses.push_back(q);
  }
  return poses;
}

}  // namespace treeline::tests
