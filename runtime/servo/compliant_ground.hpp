#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace treeline::servo {

/// Material of a ground, felt at each of the points that touch it.
struct GroundMaterial {
  double stiffness = 1e7;   ///< N/m, along the normal and along the plane
  double damping = 2000.0;  ///< N s/m
  double friction = 0.7;    ///< largest tangential force as a share of the normal force
};

/// The plane z = 0, which pushes N points out of it and never pulls them in. Where a point touches
/// it, it sticks by a spring along the plane, until friction is used up and the spring's end slides
/// along (Cundall & Strack, Geotechnique 29, 1979). So a foot of several points can tip, slip and
/// lift. Nothing is held by a constraint.
template <int N>
class CompliantGround {
 public:
  using Vectors = std::array<std::array<double, 3>, static_cast<std::size_t>(N)>;

  explicit CompliantGround(const GroundMaterial& material) noexcept : material_(material) {}

  /// Forces (N) on points at `x` (m) with velocities `v` (m/s), world axes, z up. Springs end where
  /// the last call of `slide_springs` left them.
  Vectors forces(const Vectors& x, const Vectors& v) const noexcept {
    Vectors result{};
    for (std::size_t i = 0; i < x.size(); ++i) {
      const double depth = -x[i][2];
      const double normal = material_.stiffness * depth - material_.damping * v[i][2];
      if (!(depth > 0.0) || !(normal > 0.0)) continue;
      for (std::size_t k = 0; k < 2; ++k) {
        const double stretch = touching_[i] ? x[i][k] - ends_[i][k] : 0.0;
        result[i][k] = -material_.stiffness * stretch - material_.damping * v[i][k];
      }
      const double tangential = std::hypot(result[i][0], result[i][1]);
      const double most = material_.friction * normal;
      for (std::size_t k = 0; k < 2; ++k) {
        if (tangential > most) result[i][k] *= most / tangential;
      }
      result[i][2] = normal;
    }
    return result;
  }

  /// Lets the springs' ends slide to where friction holds them, and lets go of points in the air.
  /// To be called after each step of an integration.
  void slide_springs(const Vectors& x) noexcept {
    for (std::size_t i = 0; i < x.size(); ++i) {
      const bool touches = x[i][2] < 0.0;
      if (touches && !touching_[i]) ends_[i] = {x[i][0], x[i][1]};
      touching_[i] = touches;
      if (!touches) continue;
      const double stretch = std::hypot(x[i][0] - ends_[i][0], x[i][1] - ends_[i][1]);
      const double most = material_.friction * -x[i][2];
      if (!(stretch > most)) continue;
      slipped_ += stretch - most;
      for (std::size_t k = 0; k < 2; ++k) {
        ends_[i][k] = x[i][k] - most / stretch * (x[i][k] - ends_[i][k]);
      }
    }
  }

  /// Way that the ends of all springs have slid, m.
  double slipped() const noexcept { return slipped_; }

 private:
  GroundMaterial material_;
  std::array<std::array<double, 2>, static_cast<std::size_t>(N)> ends_{};
  std::array<bool, static_cast<std::size_t>(N)> touching_{};
  double slipped_ = 0.0;
};

}  // namespace treeline::servo
