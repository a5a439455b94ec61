#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "cli/find_all_meshes.hpp"
#include "cli/read_drawn_robot.hpp"
#include "description/mesh/mesh.hpp"

namespace treeline {
namespace {

using Corners = std::vector<Eigen::Vector3d>;

/// The corners of a mesh that are outermost in some direction: of 400 directions spread evenly.
Corners outermost_corners(const std::vector<Triangle>& triangles) {
  constexpr int kDirections = 400;
  std::vector<std::size_t> chosen;
  Corners corners;
  for (const Triangle& triangle : triangles) {
    corners.insert(corners.end(), triangle.corners.begin(), triangle.corners.end());
  }
  for (int i = 0; i < kDirections && !corners.empty(); ++i) {
    const double z = 1 - (2 * i + 1.0) / kDirections;  // on a spiral by the golden angle
    const double turn = i * std::numbers::pi * (3 - std::sqrt(5.0));
    const double across = std::sqrt(1 - z * z);
    const Eigen::Vector3d direction(across * std::cos(turn), across * std::sin(turn), z);
    const auto is_nearer = [&](const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
      return direction.dot(a) < direction.dot(b);
    };
    const auto farthest = std::max_element(corners.begin(), corners.end(), is_nearer);
    chosen.push_back(static_cast<std::size_t>(farthest - corners.begin()));
  }
  std::sort(chosen.begin(), chosen.end());
  chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  Corners kept;
  for (const std::size_t i : chosen) kept.push_back(corners[i]);
  return kept;
}

Corners corners_of_box(const Eigen::Vector3d& size) {
  Corners corners;
  for (const double x : {-0.5, 0.5}) {
    for (const double y : {-0.5, 0.5}) {
      for (const double z : {-0.5, 0.5}) {
        corners.emplace_back(x * size.x(), y * size.y(), z * size.z());
      }
    }
  }
  return corners;
}

simulation::GroundShape ground_shape_of(const Visual& shape, const Corners& mesh) {
  simulation::GroundShape result;
  result.link = shape.link;
  switch (shape.kind) {
    case VisualKind::box:
      result.points = corners_of_box(shape.size);
      break;
    case VisualKind::sphere:
      result.points = {Eigen::Vector3d::Zero()};
      result.radius = shape.size.x();
      break;
    case VisualKind::cylinder:
      result.points = {{0, 0, -0.5 * shape.size.y()}, {0, 0, 0.5 * shape.size.y()}};
      result.radius = shape.size.x();
      result.axis = shape.pose.linear().col(2);
      break;
    case VisualKind::mesh:
      for (const auto& corner : mesh) result.points.emplace_back(corner.cwiseProduct(shape.size));
      break;
  }
  for (Eigen::Vector3d& point : result.points) point = shape.pose * point;
  return result;
}

/// Reads meshes, each once; of those that cannot be read the problem is left in `found`.
std::map<std::string, Corners> read_corners(std::vector<drive::ServedMesh>& found) {
  std::map<std::string, Corners> corners;
  for (drive::ServedMesh& mesh : found) {
    if (mesh.path.empty()) continue;
    Mesh read = read_mesh(mesh.path);
    corners[mesh.uri] = outermost_corners(read.triangles);
    if (!read.problem.empty()) {
      mesh = {mesh.uri, "", std::move(read.problem), std::move(read.remedy)};
    }
  }
  return corners;
}

}  // namespace

std::vector<simulation::GroundShape> read_ground_shapes(const RobotFiles& files,
                                                        const drive::MeshPlaces& places,
                                                        Diagnostics& diagnostics) {
  const std::vector<Visual> collisions = read_all_shapes(files, read_collisions, diagnostics);
  std::vector<drive::ServedMesh> found = find_meshes_of(collisions, files, places);
  auto meshes = read_corners(found);
  warn_of_missing(found, "felt by the ground", diagnostics);
  std::vector<simulation::GroundShape> shapes;
  for (const Visual& collision : collisions) {
    shapes.push_back(ground_shape_of(collision, meshes[collision.file]));
    if (shapes.back().points.empty()) shapes.pop_back();
  }
  return shapes;
}

}  // namespace treeline
