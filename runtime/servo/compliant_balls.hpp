#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace treeline::servo {

/// Material of balls, felt where they touch.
struct BallMaterial {
  double stiffness = 5e4;  ///< N/m, along the normal and across it
  double damping = 40.0;   ///< N s/m
  double friction = 0.8;   ///< largest tangential force as a share of the normal force
};

/// A ball that moves, world axes.
struct MovingBall {
  std::array<double, 3> center{};    ///< m
  std::array<double, 3> velocity{};  ///< of its centre, m/s
  std::array<double, 3> spin{};      ///< rad/s
};

/// Contact of a ball with another one, world axes.
struct BallTouch {
  std::array<double, 3> normal{};   ///< unit vector out of the other ball
  std::array<double, 3> point{};    ///< m
  std::array<double, 3> force{};    ///< on this ball, N; the other one feels the opposite
  std::array<double, 3> sliding{};  ///< velocity of its matter against the other's, tangential, m/s
  double depth = 0.0;               ///< m, positive where they touch
  double pressure = 0.0;            ///< force along the normal, N
};

/// N balls, such as fingertips, that touch one other ball: they push it and never pull. Across the
/// normal each contact is a spring that the sliding of its two bodies stretches until friction is
/// used up (Cundall & Strack, Geotechnique 29, 1979), so that balls stick, roll and slip. Nothing
/// is held by a constraint.
template <int N>
class CompliantBalls {
 public:
  static constexpr auto kCount = static_cast<std::size_t>(N);
  using Balls = std::array<MovingBall, kCount>;
  using Touches = std::array<BallTouch, kCount>;

  CompliantBalls(const std::array<double, kCount>& radii, double other_radius,
                 const BallMaterial& material) noexcept
      : radii_(radii), other_radius_(other_radius), material_(material) {}

  /// Springs are stretched as the last call of `stretch_springs` left them.
  Touches touches(const Balls& balls, const MovingBall& other) const noexcept {
    Touches result;
    for (std::size_t i = 0; i < kCount; ++i) {
      result[i] = meet(balls[i], radii_[i], other);
      BallTouch& touch = result[i];
      if (!(touch.pressure > 0.0)) continue;
      std::array<double, 3> across = stretches_[i];
      remove_part(touch.normal, across);
      for (std::size_t k = 0; k < 3; ++k) {
        across[k] = -material_.stiffness * across[k] - material_.damping * touch.sliding[k];
      }
      shorten(material_.friction * touch.pressure, across);
      for (std::size_t k = 0; k < 3; ++k) {
        touch.force[k] = touch.pressure * touch.normal[k] + across[k];
      }
    }
    return result;
  }

  /// Lets `seconds` pass for the springs. To be called after each step of an integration.
  void stretch_springs(double seconds, const Balls& balls, const MovingBall& other) noexcept {
    for (std::size_t i = 0; i < kCount; ++i) {
      const BallTouch touch = meet(balls[i], radii_[i], other);
      if (!(touch.depth > 0.0)) {
        stretches_[i] = {};
        continue;
      }
      for (std::size_t k = 0; k < 3; ++k) stretches_[i][k] += seconds * touch.sliding[k];
      remove_part(touch.normal, stretches_[i]);
      slipped_ += shorten(material_.friction * touch.depth, stretches_[i]);
    }
  }

  /// Way that contacts have slipped, all together, m.
  double slipped() const noexcept { return slipped_; }

 private:
  using Vector = std::array<double, 3>;

  static double product(const Vector& a, const Vector& b) noexcept {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }
  static void remove_part(const Vector& normal, Vector& v) noexcept {
    const double part = product(normal, v);
    for (std::size_t k = 0; k < 3; ++k) v[k] -= part * normal[k];
  }
  /// Shortens a vector to a length. Returns by how much.
  static double shorten(double most, Vector& v) noexcept {
    const double length = std::sqrt(product(v, v));
    if (!(length > most)) return 0.0;
    for (double& entry : v) entry *= most / length;
    return length - most;
  }
  static Vector velocity_at(const Vector& point, const MovingBall& ball) noexcept {
    const Vector& w = ball.spin;
    const Vector r = {point[0] - ball.center[0], point[1] - ball.center[1],
                      point[2] - ball.center[2]};
    return {ball.velocity[0] + w[1] * r[2] - w[2] * r[1],
            ball.velocity[1] + w[2] * r[0] - w[0] * r[2],
            ball.velocity[2] + w[0] * r[1] - w[1] * r[0]};
  }

  /// Contact of two balls, and the force along its normal.
  BallTouch meet(const MovingBall& ball, double radius, const MovingBall& other) const noexcept {
    BallTouch touch;
    for (std::size_t k = 0; k < 3; ++k) touch.normal[k] = ball.center[k] - other.center[k];
    const double distance = std::sqrt(product(touch.normal, touch.normal));
    touch.depth = radius + other_radius_ - distance;
    for (std::size_t k = 0; k < 3; ++k) {
      touch.normal[k] /= distance;
      touch.point[k] = other.center[k] + (other_radius_ - 0.5 * touch.depth) * touch.normal[k];
    }
    const Vector mine = velocity_at(touch.point, ball), its = velocity_at(touch.point, other);
    for (std::size_t k = 0; k < 3; ++k) touch.sliding[k] = mine[k] - its[k];
    const double parting = product(touch.normal, touch.sliding);
    remove_part(touch.normal, touch.sliding);
    if (touch.depth > 0.0) {
      const double force = material_.stiffness * touch.depth - material_.damping * parting;
      touch.pressure = std::max(0.0, force);
    }
    return touch;
  }

  std::array<double, kCount> radii_;
  double other_radius_;
  BallMaterial material_;
  std::array<Vector, kCount> stretches_{};
  double slipped_ = 0.0;
};

}  // namespace treeline::servo
