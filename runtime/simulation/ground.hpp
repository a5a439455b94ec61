#pragma once

#include <string>
#include <vector>

#include "simulation/touch.hpp"

namespace treeline::simulation {

/// The part of a link's shape that reaches a plane first: balls of one radius about some points,
/// which are corners where it is 0, or the rims of disks about them.
struct GroundShape {
  int body = interpreter::kWorld;
  std::string link;                ///< for messages
  std::vector<Vector3> points;     ///< in the body's frame, m
  double radius = 0;               ///< m
  Vector3 axis = Vector3::Zero();  ///< unit vector along the disks' axis; zero: balls
};

/// The range of a joint of one freedom; its ends may be infinite.
struct JointRange {
  int q = 0, v = 0;  ///< first coordinate and velocity of the joint
  double lower = 0, upper = 0;
};

/// The most points that touch the ground at once.
inline constexpr int kMostGroundContacts = 16;

/// Points of a robot near the ground, and joints near their stops.
struct GroundTouches {
  std::vector<Touch> touches;  ///< the deepest first, joints last
  std::vector<double> speeds;  ///< m/s upward, or rad/s on the way out
  int left_out = 0;            ///< points in the ground, and joints, beyond the most that count
};

/// What counts as near a surface: what is nearer than a margin, or was before a step at the speed
/// that it has now. In a flight a light foot under a strong motor turns away from a ground on which
/// it stands.
struct Nearness {
  double margin = 0;  ///< m or rad
  double step = 0;    ///< s

  /// `gap` is the distance, `speed` that away from the surface.
  [[nodiscard]] bool has(double gap, double speed) const {
    return gap < margin || gap - step * speed < margin;
  }
};

/// The ground z < 0, and what of a robot may touch it; and the stops of its joints. Links that
/// cannot move touch nothing.
class Ground {
 public:
  Ground(const Model& model, std::vector<GroundShape> shapes, std::vector<JointRange> ranges = {},
         int most = kMostGroundContacts);

  /// Whether any link that moves has a shape.
  [[nodiscard]] bool is_in_reach() const { return !shapes_.empty(); }
  /// The points that are near: of links that move as one at most four, the lowest and those that
  /// span most; of all the deepest. And the joints that are near the ends of their ranges.
  [[nodiscard]] GroundTouches touches(const Model& model, const State& state,
                                      const Nearness& near) const;
  /// The lowest point of all; its shape is an index into `shapes`.
  [[nodiscard]] Touch lowest(const Model& model, const Vector& q) const;
  [[nodiscard]] const std::vector<GroundShape>& shapes() const { return shapes_; }

 private:
  std::vector<GroundShape> shapes_;  ///< shapes of one group after each other
  std::vector<int> groups_;          ///< of each shape: the body that carries it
  std::vector<JointRange> ranges_;
  int most_;
};

}  // namespace treeline::simulation
