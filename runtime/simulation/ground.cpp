#include "simulation/ground.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "interpreter/instances.hpp"

namespace treeline::simulation {
namespace {

using Kinematics = interpreter::Kinematics<double>;

/// The outermost body at or before `body` whose joint moves; the world where there is none.
int carrier_of(const Model& model, int body) {
  while (body != interpreter::kWorld && model.body(body).kind == interpreter::JointKind::fixed) {
    body = model.body(body).parent;
  }
  return body;
}

/// Calls `on_point` with the points, world axes, of a shape that may touch a plane below: of a ball
/// the lowest, of a rim the lowest, the highest and the two between.
template <class OnPoint>
void visit_points(const GroundShape& shape, const Kinematics& k, OnPoint on_point) {
  const Matrix3& R = k.R_world[shape.body];
  const Vector3 down = -Vector3::UnitZ();
  Vector3 steepest = down;
  Vector3 level = Vector3::Zero();
  const bool is_rim = !shape.axis.isZero(0);
  if (is_rim) {
    const Vector3 axis = R * shape.axis;
    steepest = down - axis.dot(down) * axis;
    const Vector3 other = R * shape.axis.unitOrthogonal();  // where the disk lies flat
    steepest = steepest.norm() > 1e-9 ? steepest.normalized() : other;
    level = axis.cross(steepest);
  }
  for (const Vector3& point : shape.points) {
    const Vector3 middle = k.p_world[shape.body] + R * point;
    on_point(Vector3(middle + shape.radius * steepest));
    if (!is_rim) continue;
    on_point(Vector3(middle - shape.radius * steepest));
    on_point(Vector3(middle + shape.radius * level));
    on_point(Vector3(middle - shape.radius * level));
  }
}

/// The first point to keep: of those as low as the lowest the one farthest from their middle.
std::size_t first_extreme(const std::vector<Touch>& points) {
  constexpr double kSame = 1e-7;  // m
  double deepest = points.front().depth;
  Vector3 middle = Vector3::Zero();
  for (const Touch& point : points) {
    deepest = std::max(deepest, point.depth);
    middle += point.position / static_cast<double>(points.size());
  }
  std::size_t first = 0;
  double farthest = -1;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double apart = (points[i].position - middle).norm();
    if (points[i].depth < deepest - kSame || apart <= farthest) continue;
    first = i;
    farthest = apart;
  }
  return first;
}

/// Keeps at most four points: the lowest, the one farthest from it, and on either side of the line
/// between these the farthest from the line.
void keep_extremes(std::vector<Touch>& points) {
  constexpr double kSame = 1e-9;  // m
  if (points.empty()) return;
  const Touch first = points[first_extreme(points)];
  const auto farthest = [&](const auto& measure) {
    return *std::max_element(points.begin(), points.end(), [&](const Touch& a, const Touch& b) {
      return measure(a) < measure(b);
    });
  };
  const auto from_first = [&](const Touch& at) { return (at.position - first.position).norm(); };
  const Touch second = farthest(from_first);
  const Vector3 across =
      Vector3::UnitZ().cross(second.position - first.position).stableNormalized();
  const auto to_left = [&](const Touch& at) { return across.dot(at.position - first.position); };
  const auto to_right = [&](const Touch& at) { return -to_left(at); };
  const Touch left = farthest(to_left), right = farthest(to_right);
  points = {first};
  if (from_first(second) > kSame) points.push_back(second);
  if (to_left(left) > kSame) points.push_back(left);
  if (to_right(right) > kSame) points.push_back(right);
}

double upward_speed(const Touch& touch, const Kinematics& k) {
  const Matrix3& R = k.R_world[touch.body];
  const Vector3 arm = touch.position - k.p_world[touch.body];
  const Vector3 w = R * interpreter::angular(k.v[touch.body]);
  return (R * interpreter::linear(k.v[touch.body]) + w.cross(arm)).z();
}

Touch touch_of(int shape, int which, int body, const Vector3& point) {
  Touch touch;
  touch.shape = shape;
  touch.point = which;
  touch.body = body;
  touch.position = point;
  touch.depth = -point.z();
  return touch;
}

/// `outward` is 1 where the coordinate grows on the way out.
void add_stop(int velocity, int outward, double depth, double speed, GroundTouches& found) {
  if (found.touches.size() == kMostTouches) {
    found.left_out += depth > 0 ? 1 : 0;
    return;
  }
  Touch stop;
  stop.shape = -1 - velocity;
  stop.point = outward;
  stop.joint = velocity;
  stop.body = interpreter::kWorld;
  stop.normal = outward * Vector3::UnitX();
  stop.depth = depth;
  found.touches.push_back(stop);
  found.speeds.push_back(speed);
}

}  // namespace

Ground::Ground(const Model& model, std::vector<GroundShape> shapes, std::vector<JointRange> ranges,
               int most)
    : shapes_(std::move(shapes)), ranges_(std::move(ranges)), most_(most) {
  const auto carrier = [&](const GroundShape& shape) { return carrier_of(model, shape.body); };
  std::erase_if(shapes_,
                [&](const GroundShape& shape) { return carrier(shape) == interpreter::kWorld; });
  std::stable_sort(shapes_.begin(), shapes_.end(),
                   [&](const auto& a, const auto& b) { return carrier(a) < carrier(b); });
  for (const GroundShape& shape : shapes_) groups_.push_back(carrier(shape));
}

GroundTouches Ground::touches(const Model& model, const State& state, const Nearness& near) const {
  const auto k = interpreter::kinematics<double>(model, state.q, state.qd);
  GroundTouches found;
  std::vector<Touch> of_group;
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    const GroundShape& shape = shapes_[i];
    int which = 0;
    visit_points(shape, k, [&](const Vector3& point) {
      const Touch touch = touch_of(static_cast<int>(i), ++which, shape.body, point);
      if (near.has(point.z(), upward_speed(touch, k))) of_group.push_back(touch);
    });
    if (i + 1 < shapes_.size() && groups_[i + 1] == groups_[i]) continue;
    keep_extremes(of_group);
    found.touches.insert(found.touches.end(), of_group.begin(), of_group.end());
    of_group.clear();
  }
  std::stable_sort(found.touches.begin(), found.touches.end(),
                   [](const Touch& a, const Touch& b) { return a.depth > b.depth; });
  while (static_cast<int>(found.touches.size()) > most_) {
    found.left_out += found.touches.back().depth > 0 ? 1 : 0;
    found.touches.pop_back();
  }
  for (const Touch& touch : found.touches) found.speeds.push_back(upward_speed(touch, k));
  for (const JointRange& range : ranges_) {
    const double q = state.q[range.q];
    const double qd = state.qd[range.v];
    if (near.has(q - range.lower, qd)) add_stop(range.v, 1, range.lower - q, qd, found);
    if (near.has(range.upper - q, -qd)) add_stop(range.v, -1, q - range.upper, -qd, found);
  }
  return found;
}

Touch Ground::lowest(const Model& model, const Vector& q) const {
  const auto k = interpreter::kinematics<double>(model, q, Vector::Zero(model.nv));
  Touch lowest;
  lowest.depth = -std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < shapes_.size(); ++i) {
    visit_points(shapes_[i], k, [&](const Vector3& point) {
      if (-point.z() <= lowest.depth) return;
      lowest = touch_of(static_cast<int>(i), 0, shapes_[i].body, point);
    });
  }
  return lowest;
}

}  // namespace treeline::simulation
