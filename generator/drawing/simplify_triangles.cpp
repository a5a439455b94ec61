#include "drawing/simplify_triangles.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>

namespace treeline {
namespace {

using Quadric = Eigen::Matrix4d;

/// Squared distances to a plane, times a weight.
Quadric plane_quadric(const Eigen::Vector3d& normal, const Eigen::Vector3d& point, double weight) {
  const Eigen::Vector4d plane(normal.x(), normal.y(), normal.z(), -normal.dot(point));
  return weight * plane * plane.transpose();
}

double error_at(const Quadric& quadric, const Eigen::Vector3d& point) {
  return point.homogeneous().dot(quadric * point.homogeneous());
}

/// An edge that may vanish, as it was when two vertices had these versions.
struct Collapse {
  double error = 0;
  int from = 0, to = 0;
  int versions = 0;

  bool operator<(const Collapse& other) const {  // the least error is the top of a queue
    return std::tie(other.error, other.from, other.to) < std::tie(error, from, to);
  }
};

class Surface {
 public:
  Surface(const std::vector<Triangle>& triangles, const std::vector<std::size_t>& tags) {
    weld(triangles, tags);
    faces_of_.resize(positions_.size());
    versions_.resize(positions_.size());
    quadrics_.resize(positions_.size(), Quadric::Zero());
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      if (is_flat(corners_[t])) continue;
      ++count_;
      for (const int corner : corners_[t]) faces_of_[index(corner)].push_back(static_cast<int>(t));
    }
    add_planes();
  }

  void reduce(std::size_t most) {
    for (const auto& [from, to] : edges_) push(from, to);
    while (count_ > most && !queue_.empty()) {
      const Collapse next = queue_.top();
      queue_.pop();
      const bool is_old = next.versions != versions_[index(next.from)] + versions_[index(next.to)];
      if (is_old || faces_of_[index(next.from)].empty()) continue;
      const Eigen::Vector3d place = best_place(next.from, next.to);
      if (!turns_over(next, place)) collapse(next, place);
    }
  }

  /// Takes over what stays, and drops the rest.
  void give_back(std::vector<Triangle>& triangles, std::vector<std::size_t>& tags) const {
    std::size_t kept = 0;
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      if (is_flat(corners_[t])) continue;
      triangles[kept] = triangles[t];
      tags[kept] = tags[t];
      for (std::size_t i = 0; i < 3; ++i) {
        triangles[kept].corners[i] = positions_[index(corners_[t][i])];
      }
      ++kept;
    }
    triangles.resize(kept);
    tags.resize(kept);
  }

 private:
  using Corners = std::array<int, 3>;

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  static bool is_flat(const Corners& c) { return c[0] == c[1] || c[1] == c[2] || c[2] == c[0]; }

  /// Corners at one place, of one tag, are one vertex. Of many triangles, those in one cell of a
  /// fine grid are, which takes a tenth of the time of letting their edges collapse.
  void weld(const std::vector<Triangle>& triangles, const std::vector<std::size_t>& tags) {
    constexpr std::size_t kMany = 20000;
    constexpr double kCells = 400;  // along the longest side
    Eigen::AlignedBox3d box;
    for (const Triangle& triangle : triangles) {
      for (const Eigen::Vector3d& corner : triangle.corners) box.extend(corner);
    }
    const double cell = triangles.size() < kMany ? 0 : box.sizes().maxCoeff() / kCells;
    const auto snap = [cell](double x) { return cell > 0 ? std::floor(x / cell) : x; };
    std::vector<std::size_t> order(3 * triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    const auto key = [&](std::size_t k) {
      const Eigen::Vector3d& p = triangles[k / 3].corners[k % 3];
      return std::make_tuple(tags[k / 3], snap(p.x()), snap(p.y()), snap(p.z()));
    };
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return key(a) < key(b); });
    corners_.resize(triangles.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
      const std::size_t k = order[i];
      if (i == 0 || key(k) != key(order[i - 1])) {
        positions_.push_back(triangles[k / 3].corners[k % 3]);
      }
      corners_[k / 3][k % 3] = static_cast<int>(positions_.size()) - 1;
    }
  }

  /// Twice the area of a face, along its normal; with a corner that is `moved` to another place.
  [[nodiscard]] Eigen::Vector3d area_of(
      const Corners& c, int moved = -1,
      const Eigen::Vector3d& place = Eigen::Vector3d::Zero()) const {
    const auto at = [&](int corner) { return corner == moved ? place : positions_[index(corner)]; };
    return (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0]));
  }

  /// Each vertex gets the planes of its faces. An edge of one face alone also gets a plane across
  /// it, so that a border stays where it is.
  void add_planes() {
    std::vector<std::array<int, 3>> sides;  // both ends in order, and the face
    for (std::size_t t = 0; t < corners_.size(); ++t) {
      const Corners& c = corners_[t];
      const Eigen::Vector3d area = area_of(c);
      if (is_flat(c)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        quadrics_[index(c[i])] +=
            plane_quadric(area.stableNormalized(), positions_[index(c[0])], area.norm());
        const auto [low, high] = std::minmax(c[i], c[(i + 1) % 3]);
        sides.push_back({low, high, static_cast<int>(t)});
      }
    }
    std::ranges::sort(sides);
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const auto same = [&](std::size_t other) {
        return other < sides.size() && sides[other][0] == sides[i][0] &&
               sides[other][1] == sides[i][1];
      };
      if (i > 0 && same(i - 1)) continue;
      edges_.emplace_back(sides[i][0], sides[i][1]);
      if (!same(i + 1)) hold_border(sides[i]);
    }
  }

  void hold_border(const std::array<int, 3>& side) {
    const Eigen::Vector3d& low = positions_[index(side[0])];
    const Eigen::Vector3d along = positions_[index(side[1])] - low;
    const Eigen::Vector3d across = area_of(corners_[index(side[2])]).cross(along);
    for (const int end : {side[0], side[1]}) {
      quadrics_[index(end)] += plane_quadric(across.stableNormalized(), low, along.squaredNorm());
    }
  }

  /// The place of least error for both ends of an edge: where the planes meet, or an end or the
  /// middle where they do not.
  [[nodiscard]] Eigen::Vector3d best_place(int from, int to) const {
    const Quadric both = quadrics_[index(from)] + quadrics_[index(to)];
    const Eigen::Vector3d& a = positions_[index(from)];
    const Eigen::Vector3d& b = positions_[index(to)];
    const Eigen::Vector3d middle = 0.5 * (a + b);
    const Eigen::Matrix3d normal = both.topLeftCorner<3, 3>();
    const double scale = normal.trace() / 3;
    if (normal.determinant() > 1e-3 * scale * scale * scale) {
      const Eigen::Vector3d met = normal.inverse() * -both.topRightCorner<3, 1>();
      if ((met - middle).norm() <= (b - a).norm()) return met;
    }
    return std::min({a, b, middle}, [&](const Eigen::Vector3d& x, const Eigen::Vector3d& y) {
      return error_at(both, x) < error_at(both, y);
    });
  }

  void push(int from, int to) {
    constexpr double kOfLength = 1e-6;  // so that in flat parts short edges vanish first
    const double length = (positions_[index(to)] - positions_[index(from)]).squaredNorm();
    const Quadric both = quadrics_[index(from)] + quadrics_[index(to)];
    queue_.push({error_at(both, best_place(from, to)) + kOfLength * length * length, from, to,
                 versions_[index(from)] + versions_[index(to)]});
  }

  [[nodiscard]] bool turns_over(const Collapse& next, const Eigen::Vector3d& place) const {
    for (const int vertex : {next.from, next.to}) {
      for (const int face : faces_of_[index(vertex)]) {
        const Corners& c = corners_[index(face)];
        if (is_flat(c)) continue;
        const bool vanishes = std::ranges::count(c, next.from) + std::ranges::count(c, next.to) > 1;
        if (vanishes) continue;
        const Eigen::Vector3d before = area_of(c);
        const Eigen::Vector3d after = area_of(c, vertex, place);
        if (before.dot(after) < 0.2 * before.norm() * after.norm()) return true;
      }
    }
    return false;
  }

  void collapse(const Collapse& next, const Eigen::Vector3d& place) {
    std::vector<int>& stays = faces_of_[index(next.to)];
    for (const int face : faces_of_[index(next.from)]) {
      Corners& c = corners_[index(face)];
      if (is_flat(c)) continue;
      std::ranges::replace(c, next.from, next.to);
      if (is_flat(c)) {
        --count_;
      } else {
        stays.push_back(face);
      }
    }
    faces_of_[index(next.from)].clear();
    std::erase_if(stays, [&](int face) { return is_flat(corners_[index(face)]); });
    positions_[index(next.to)] = place;
    quadrics_[index(next.to)] += quadrics_[index(next.from)];
    ++versions_[index(next.from)];
    ++versions_[index(next.to)];
    std::vector<int> neighbours;
    for (const int face : stays) {
      for (const int corner : corners_[index(face)]) {
        if (corner != next.to) neighbours.push_back(corner);
      }
    }
    std::ranges::sort(neighbours);
    neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    for (const int neighbour : neighbours) push(neighbour, next.to);
  }

  std::vector<Eigen::Vector3d> positions_;
  std::vector<Corners> corners_;  ///< of each triangle; two are one where it has vanished
  std::vector<std::vector<int>> faces_of_;
  std::vector<int> versions_;
  std::vector<Quadric> quadrics_;
  std::vector<std::pair<int, int>> edges_;  ///< before the first collapse
  std::priority_queue<Collapse> queue_;
  std::size_t count_ = 0;
};

}  // namespace

void simplify_triangles(std::vector<Triangle>& triangles, std::vector<std::size_t>& tags,
                        std::size_t most) {
  if (triangles.size() <= most) return;
  Surface surface(triangles, tags);
  surface.reduce(most);
  surface.give_back(triangles, tags);
}

}  // namespace treeline
