#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "drive/link_forces.hpp"
#include "drive/obstacle.hpp"
#include "drive/robot_library.hpp"
#include "servo/robot_proxy.hpp"

namespace treeline::drive {

/// Keeps guarded points away from obstacles by potential fields (Khatib 1986, "Real-time obstacle
/// avoidance for manipulators and mobile robots", section 6). Nothing is allocated.
///
/// The accelerations are those of unit masses: of a point, a = -grad U(x) - d rho' grad rho; of the
/// joints, qdd = J^T a. Added to the law of a joint or of a point, whose errors are e,
///     E = |e'|^2 / 2 + kp |e|^2 / 2 + U
/// does not grow while the goal rests: E' = -kv |e'|^2 - d rho'^2. So a point never comes nearer
/// than where U = E, as long as no torque is cut and the loop keeps its period.
template <class F>
class Avoidance {
 public:
  static constexpr int nv = F::kVelocities;
  static constexpr int kRoom = F::kPoints > 0 ? F::kPoints : 1;

  Avoidance(const Surroundings& surroundings, double period) noexcept
      : repulsion_(surroundings.repulsion) {
    // A loop follows a spring of unit mass up to about omega = 0.3 / period.
    repulsion_.largest_curvature = 0.1 / (period * period);
    nearest_.fill(std::numeric_limits<double>::infinity());
    if constexpr (F::kLinks > 0) {
      take(surroundings);
    }
  }

  /// Whether there is anything to stay away from.
  bool exists() const noexcept { return obstacle_count_ > 0 && guarded_count_ > 0; }

  /// Computes what the obstacles ask for in this state. `by_rows` points are pushed by
  /// `point_push`, all others by `joint_push`.
  void look(const servo::StateOf<F>& state, const std::array<bool, kRoom>& by_rows) noexcept {
    clear();
    links_.place(state.q);
    for (int k = 0; k < guarded_count_; ++k) {
      const GuardedPoint& point = guarded_[at(k)];
      double place[3];
      links_.place_of(point.link, point.on_link, place);
      for (int o = 0; o < obstacle_count_; ++o) {
        push(state, point, place, obstacles_[at(o)], point.point >= 0 && by_rows[at(point.point)]);
      }
    }
  }

  /// Whether an obstacle is within reach of a guarded point.
  bool pushes() const noexcept { return pushes_; }
  /// Joint accelerations to add, rad/s^2 or m/s^2.
  const double (&joint_push() const noexcept)[nv] { return joint_push_; }
  /// Acceleration of an operational point to add, m/s^2, world axes.
  const double (&point_push(int point) const noexcept)[3] { return point_push_[at(point)].a; }
  /// Distance of an operational point from the nearest avoided obstacle's surface, m; infinite
  /// where there is none.
  double nearest(int point) const noexcept { return nearest_[at(point)]; }

 private:
  struct Vector {
    double a[3] = {};
  };
  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

  void take(const Surroundings& given) noexcept {
    for (int i = 0; i < given.obstacle_count && obstacle_count_ < kMostObstacles; ++i) {
      if (given.obstacles[i].avoided) obstacles_[at(obstacle_count_++)] = given.obstacles[i];
    }
    for (int i = 0; i < given.guarded_count && guarded_count_ < kMostGuardedPoints; ++i) {
      guarded_[at(guarded_count_++)] = given.guarded[i];
    }
  }

  void clear() noexcept {
    pushes_ = false;
    for (double& a : joint_push_) a = 0.0;
    point_push_.fill({});
    nearest_.fill(std::numeric_limits<double>::infinity());
  }

  void push(const servo::StateOf<F>& state, const GuardedPoint& point, const double (&place)[3],
            const Obstacle& obstacle, bool by_rows) noexcept {
    double away[3];
    const double distance = distance_to(obstacle, place, away);
    if (point.point >= 0 && distance < nearest_[at(point.point)]) {
      nearest_[at(point.point)] = distance;
    }
    const Push asked = push_at(repulsion_, distance);
    if (!(asked.acceleration > 0.0)) return;
    pushes_ = true;
    double along[nv] = {};
    links_.joint_forces(state.q, point.link, place, away, along);
    double speed = 0.0;
    for (int i = 0; i < nv; ++i) speed += along[i] * state.qd[i];
    const double size = asked.acceleration - asked.damping * speed;
    for (int i = 0; by_rows && i < 3; ++i) point_push_[at(point.point)].a[i] += size * away[i];
    for (int i = 0; !by_rows && i < nv; ++i) joint_push_[i] += size * along[i];
  }

  Repulsion repulsion_;
  std::array<Obstacle, kMostObstacles> obstacles_{};
  std::array<GuardedPoint, kMostGuardedPoints> guarded_{};
  int obstacle_count_ = 0;
  int guarded_count_ = 0;
  LinkForces<F> links_;
  bool pushes_ = false;
  double joint_push_[nv] = {};
  std::array<Vector, kRoom> point_push_{};
  std::array<double, kRoom> nearest_{};
};

}  // namespace treeline::drive
