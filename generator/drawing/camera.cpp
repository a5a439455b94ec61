#include "drawing/camera.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace treeline {

Camera::Camera(const View& view)
    : width_(view.width),
      towards_(std::cos(view.elevation) * std::cos(view.azimuth),
               std::cos(view.elevation) * std::sin(view.azimuth), std::sin(view.elevation)),
      right_(-std::sin(view.azimuth), std::cos(view.azimuth), 0),
      up_(towards_.cross(right_)) {}

Eigen::Vector2i Camera::place(const Eigen::Vector3d& point) const {
  const Eigen::Vector2d pixels(left_ + scale_ * point.dot(right_), top_ - scale_ * point.dot(up_));
  return (kUnits * pixels).array().round().cast<int>();
}

std::vector<Eigen::Vector2i> Camera::place(const std::vector<Eigen::Vector3d>& points) const {
  std::vector<Eigen::Vector2i> places;
  for (const Eigen::Vector3d& point : points) places.push_back(place(point));
  return places;
}

int Camera::length(double meters) const {
  return static_cast<int>(std::lround(kUnits * scale_ * meters));
}

void Camera::include(const Eigen::Vector3d& point, double radius) {
  const Eigen::Vector2d middle(point.dot(right_), point.dot(up_));
  seen_.extend(Eigen::Vector2d(middle.array() - radius));
  seen_.extend(Eigen::Vector2d(middle.array() + radius));
}

void Camera::fit() {
  constexpr double kMargin = 10;        // around the robot, pixels
  constexpr double kTallest = 7.0 / 6;  // height of a picture, of its width
  constexpr double kLeast = 1e-6;       // m, of a robot that is a point
  const Eigen::Vector2d extent = seen_.sizes().cwiseMax(kLeast);
  scale_ =
      std::min((width_ - 2 * kMargin) / extent.x(), (kTallest * width_ - 2 * kMargin) / extent.y());
  height_ = std::round(scale_ * extent.y() + 2 * kMargin);
  left_ = 0.5 * width_ - scale_ * seen_.center().x();
  top_ = 0.5 * height_ + scale_ * seen_.center().y();
}

std::string Camera::shade(const Color& color, const Eigen::Vector3d& normal) const {
  const Eigen::Vector3d light = (towards_ + 0.9 * up_ - 0.5 * right_).normalized();
  constexpr double kSteps = 16;  // few colours, so that faces share them
  const double lit = std::round(kSteps * std::max(0.0, normal.dot(light))) / kSteps;
  const double share = 0.5 + 0.5 * lit;
  const auto part = [&](std::size_t i) {
    return static_cast<int>(std::lround(255 * share * std::clamp(color[i], 0.0, 1.0)));
  };
  return fmt::format("#{:02x}{:02x}{:02x}", part(0), part(1), part(2));
}

}  // namespace treeline
