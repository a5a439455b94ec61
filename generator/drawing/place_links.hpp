#pragma once

#include <Eigen/Geometry>
#include <span>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "interpreter/model.hpp"
#include "interpreter/points.hpp"

namespace treeline {

/// Finds the poses of a robot's links and a scene's points, by the interpreter.
class LinkPlacer {
 public:
  LinkPlacer(const Robot& robot, const Scene& scene);

  [[nodiscard]] int coordinates() const { return model_.nq; }
  /// The state that nothing displaces, moved into the joints' limits.
  [[nodiscard]] const std::vector<double>& home() const { return home_; }
  /// The joint of each coordinate.
  [[nodiscard]] const std::vector<std::string>& joints() const { return joints_; }
  /// Poses of the links in the world, in the robot's order.
  [[nodiscard]] std::vector<Eigen::Isometry3d> place(std::span<const double> q) const;
  /// Poses of the scene's operational points in the world.
  [[nodiscard]] std::vector<Eigen::Isometry3d> place_points(std::span<const double> q) const;

 private:
  interpreter::Model<double> model_;
  interpreter::Points<double> points_;
  std::vector<int> bodies_;  ///< of each link
  std::vector<double> home_;
  std::vector<std::string> joints_;
};

}  // namespace treeline
