// Stands in for geometry_msgs, as its definition has it.
#pragma once

#include <string>

namespace geometry_msgs::msg {
struct PoseStamped {
  struct {
    std::string frame_id;
  } header;
  struct {
    struct {
      double x = 0, y = 0, z = 0;
    } position;
    struct {
      double x = 0, y = 0, z = 0, w = 1;
    } orientation;
  } pose;
};
}  // namespace geometry_msgs::msg
