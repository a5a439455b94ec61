// Would catch: a reduction that differs from run to run, tears a closed surface open, joins what
// belongs to two links, drops a border, or has no end. How near it stays: meshes_test.py.
#include "drawing/simplify_triangles.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>

namespace treeline {
namespace {

/// A wavy sheet of 2 n n triangles over the unit square.
std::vector<Triangle> sheet(int n, double height) {
  const auto at = [&](int i, int j) {
    const double x = static_cast<double>(i) / n;
    const double y = static_cast<double>(j) / n;
    return Eigen::Vector3d(x, y, height * std::sin(6 * x) * std::cos(5 * y));
  };
  std::vector<Triangle> triangles;
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      triangles.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}, {}});
      triangles.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}, {}});
    }
  }
  return triangles;
}

/// A ball of 8 n n triangles: an octahedron, whose sides are cut.
std::vector<Triangle> ball(int n, const Eigen::Vector3d& center) {
  std::vector<Triangle> triangles;
  for (const double x : {1.0, -1.0}) {
    for (const double y : {1.0, -1.0}) {
      for (const double z : {1.0, -1.0}) {
        const auto at = [&](int i, int j) {
          return Eigen::Vector3d(center +
                                 Eigen::Vector3d(x * i, y * j, z * (n - i - j)).normalized());
        };
        const auto add = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                             const Eigen::Vector3d& c) {
          triangles.push_back(x * y * z > 0 ? Triangle{{a, b, c}, {}} : Triangle{{a, c, b}, {}});
        };
        for (int i = 0; i < n; ++i) {
          for (int j = 0; i + j < n; ++j) {
            add(at(i, j), at(i + 1, j), at(i, j + 1));
            if (i + j + 1 < n) add(at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
          }
        }
      }
    }
  }
  return triangles;
}

/// How often each directed edge is one of a triangle.
std::map<std::array<double, 6>, int> directed_edges(const std::vector<Triangle>& triangles) {
  std::map<std::array<double, 6>, int> edges;
  for (const Triangle& triangle : triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector3d& a = triangle.corners[i];
      const Eigen::Vector3d& b = triangle.corners[(i + 1) % 3];
      ++edges[{a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}];
    }
  }
  return edges;
}

TEST(SimplifyTriangles, LeavesAClosedSurfaceClosed) {
  for (const std::size_t most : {1000U, 300U, 60U}) {
    std::vector<Triangle> triangles = ball(16, {3, 4, 5});
    std::vector<std::size_t> tags(triangles.size(), 0);
    simplify_triangles(triangles, tags, most);
    EXPECT_LE(triangles.size(), most);
    EXPECT_GE(triangles.size(), most - 2);
    const auto edges = directed_edges(triangles);
    for (const auto& [edge, times] : edges) {
      const auto back = edges.find({edge[3], edge[4], edge[5], edge[0], edge[1], edge[2]});
      ASSERT_NE(back, edges.end());
      ASSERT_EQ(back->second, times);
    }
  }
}

// A flat sheet needs two triangles, and its border stays.
TEST(SimplifyTriangles, KeepsABorder) {
  std::vector<Triangle> triangles = sheet(20, 0);
  std::vector<std::size_t> tags(triangles.size(), 0);
  simplify_triangles(triangles, tags, 8);
  double area = 0;
  for (const auto& [corners, color] : triangles) {
    area += 0.5 * (corners[1] - corners[0]).cross(corners[2] - corners[0]).z();
  }
  EXPECT_LE(triangles.size(), 8U);
  EXPECT_NEAR(area, 1, 1e-9);
}

// A flat sheet beside a ball: the ball needs the triangles. Both touch, and stay two.
TEST(SimplifyTriangles, SpendsTrianglesOnWhatIsCurved) {
  std::vector<Triangle> triangles = sheet(30, 0);
  std::vector<std::size_t> tags(triangles.size(), 7);
  const auto round = ball(12, {0, 0, 1});
  triangles.insert(triangles.end(), round.begin(), round.end());
  tags.resize(triangles.size(), 2);
  simplify_triangles(triangles, tags, 200);
  ASSERT_EQ(triangles.size(), tags.size());
  const auto flat = std::ranges::count(tags, 7U);
  EXPECT_GE(flat, 2);
  EXPECT_LE(flat, 20);
  EXPECT_EQ(flat + std::ranges::count(tags, 2U), static_cast<std::ptrdiff_t>(tags.size()));
}

TEST(SimplifyTriangles, IsTheSameEachTimeAndEnds) {
  for (const std::size_t most : {0U, 100U}) {
    const auto reduced = [&] {
      std::vector<Triangle> triangles = sheet(25, 0.1);
      std::vector<std::size_t> tags(triangles.size(), 0);
      simplify_triangles(triangles, tags, most);
      return directed_edges(triangles);
    };
    EXPECT_EQ(reduced(), reduced());
  }
}

}  // namespace
}  // namespace treeline
