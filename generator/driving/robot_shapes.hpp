#pragma once

#include <string>
#include <utility>
#include <vector>

#include "drawing/place_links.hpp"
#include "drawing/read_visuals.hpp"
#include "launch/launch.hpp"

namespace treeline {

/// The boxes, cylinders and spheres by which a robot collides, where it has any, and what of it may
/// touch the ground it is driven on.
class RobotShapes {
 public:
  explicit RobotShapes(const LaunchedRobot& robot);

  /// Whether no two links come nearer to each other than 5 mm, or than they are at `other`. Links
  /// that at most two joints connect may: shapes meet where joints turn.
  [[nodiscard]] bool is_clear(const std::vector<double>& q, const std::vector<double>& other) const;
  /// z of the lowest point that may touch the ground; without a ground that of the lowest shape, or
  /// of the lowest frame of a link, m.
  [[nodiscard]] double lowest(const std::vector<double>& q) const;

 private:
  [[nodiscard]] std::vector<Visual> place(const std::vector<double>& q) const;
  [[nodiscard]] double least_distance(const std::vector<double>& q) const;

  LinkPlacer placer_;
  std::vector<Visual> shapes_;
  std::vector<std::size_t> links_;  ///< of each shape
  std::vector<SceneTouch> touches_;
  std::vector<std::size_t> touched_links_;  ///< of each touch
  std::vector<std::pair<std::size_t, std::size_t>> pairs_;
};

/// Distance between two boxes, cylinders or spheres with poses in the world, m; 0 if they overlap.
/// The algorithm of Gilbert, Johnson and Keerthi (1988).
double convex_distance(const Visual& a, const Visual& b);

/// z of the lowest point of a box, cylinder or sphere in the world, m.
double lowest_of(const Visual& shape);

}  // namespace treeline
