#include <algorithm>

#include "description/read_keys.hpp"

namespace treeline {
namespace {

double read_radius(const SceneElement& rolling, const SceneFields& parts) {
  const auto found = parts.find("radius");
  if (found == parts.end()) {
    rolling.error("the key \"radius\" is missing", "write rolling: {radius: 0.1}, m");
    return 1;
  }
  const double radius = found->second.number().value_or(1);
  if (radius > 0) return radius;
  found->second.error("a wheel's radius is positive", "give it in m");
  return 1;
}

void read_axis(const SceneFields& parts, SceneRolling& rolling) {
  const auto found = parts.find("axis");
  if (found == parts.end()) return;
  rolling.axis = found->second.three_numbers();
  if (rolling.axis && *rolling.axis == std::array{0.0, 0.0, 0.0}) {
    found->second.error("the axis has no direction", "write the wheel's axis in origin's frame");
    rolling.axis = {0, 1, 0};
  }
}

void read_other_ball(const SceneFields& parts, SceneRolling& rolling) {
  const auto found = parts.find("on_radius");
  if (found == parts.end()) return;
  rolling.on_radius = found->second.number().value_or(1);
  if (rolling.axis) {
    found->second.error("a disc rolls on planes alone", "remove axis, or on_radius");
  } else if (*rolling.on_radius == 0) {
    found->second.error("a ball of no size", "give its radius, or close a loop without rolling");
  } else if (*rolling.on_radius < 0 && -*rolling.on_radius <= rolling.radius) {
    found->second.error("the ball is not smaller than the bowl that it rolls in",
                        "give the bowl's radius, negative, larger than radius");
  }
}

void check_rows(const SceneElement& rolling, const SceneLoop& loop) {
  const auto& rows = loop.second.rows;
  if (rows[3] || rows[4]) {
    rolling.error("what rolls turns about x and y", "leave rx and ry out of rows");
  }
  const bool all = rows[0] && rows[1] && rows[2];
  if (loop.rolling->on_radius && (!all || rows[5])) {
    rolling.error("the normal of two balls turns with them", "leave out rows, for x, y, z");
  }
}

}  // namespace

void read_rolling(const SceneFields& fields, SceneLoop& loop) {
  const SceneElement& element = fields.at("rolling");
  const SceneFields parts = element.fields({"radius", "axis", "on_radius"});
  SceneRolling rolling;
  rolling.radius = read_radius(element, parts);
  read_axis(parts, rolling);
  read_other_ball(parts, rolling);
  loop.rolling = rolling;
  if (!fields.contains("rows")) {
    loop.first.rows = loop.second.rows = {true, true, true, false, false, false};
  }
  check_rows(element, loop);
}

}  // namespace treeline
