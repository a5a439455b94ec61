#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "drawing/solids.hpp"

namespace treeline {

/// From where the robot is seen, in parallel projection.
struct View {
  double azimuth = 0.75;    ///< of the camera about z, from x towards y, rad
  double elevation = 0.25;  ///< of the camera above the horizontal, rad
  double width = 240;       ///< of one picture, pixels
  std::string close_up;     ///< link whose neighbourhood is shown; empty: everything is
};

/// Parallel projection of the world onto a picture, whose origin is its upper left corner.
class Camera {
 public:
  /// Pictures count in fifths of a pixel, so that whole numbers are exact enough.
  static constexpr double kUnits = 5;

  explicit Camera(const View& view);

  [[nodiscard]] bool sees(const Eigen::Vector3d& normal) const { return normal.dot(towards_) > 0; }
  [[nodiscard]] double nearness(const Eigen::Vector3d& point) const { return point.dot(towards_); }

  /// A place in the picture, and a length; whole units.
  [[nodiscard]] Eigen::Vector2i place(const Eigen::Vector3d& point) const;
  [[nodiscard]] std::vector<Eigen::Vector2i> place(
      const std::vector<Eigen::Vector3d>& points) const;
  [[nodiscard]] int length(double meters) const;

  /// Makes a ball part of what has to be in the picture.
  void include(const Eigen::Vector3d& point, double radius);
  /// Chooses scale and place so that all that was included fits.
  void fit();
  /// Height of the picture without its caption, pixels.
  [[nodiscard]] double height() const { return height_; }

  /// Colour of a surface in light from above the camera's left.
  [[nodiscard]] std::string shade(const Color& color, const Eigen::Vector3d& normal) const;
  /// Colour of a ball.
  [[nodiscard]] std::string lit(const Color& color) const {
    return shade(color, (towards_ + up_).normalized());
  }

 private:
  double width_;
  Eigen::Vector3d towards_, right_, up_;
  Eigen::AlignedBox2d seen_;
  double scale_ = 1, left_ = 0, top_ = 0, height_ = 0;
};

}  // namespace treeline
