// Stands in for trajectory_msgs, as its definition has it.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace trajectory_msgs::msg {
struct JointTrajectory {
  struct Point {
    std::vector<double> positions;
    struct {
      std::int32_t sec = 0;
      std::uint32_t nanosec = 0;
    } time_from_start;
  };
  std::vector<std::string> joint_names;
  std::vector<Point> points;
};
}  // namespace trajectory_msgs::msg
