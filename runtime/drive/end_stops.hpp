#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "core/ldlt.hpp"
#include "servo/integrate.hpp"

namespace treeline::drive {

/// Stops at the limits of position of a simulated robot's joints. A joint beyond its limit is led
/// back like a spring of 200 rad/s with critical damping, whatever it weighs, by a force that only
/// pushes. A joint that meets the stop at 5 rad/s goes 9 mrad beyond and leaves it with an eighth
/// of its speed, unless something presses it there; then it rests at the limit. All joints at their
/// stops are solved together, so that a chain that rests on many of them does not swing. A joint
/// that begins beyond its limit has its stop there; the stop moves back with the joint.
template <class F>
class EndStops {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;

  /// `lower` and `upper` (nq) may be infinite; null: no stops.
  EndStops(const servo::FloatingJoints<nq, nv>& floating, const double* lower, const double* upper,
           const double (&q)[nq]) noexcept {
    int iq = 0;
    int iv = 0;
    for (int k = 0; k <= nq - nv; ++k) {
      const int end = k < nq - nv ? floating[static_cast<std::size_t>(k)] : nq;
      for (; lower != nullptr && upper != nullptr && iq < end; ++iq, ++iv) {
        stops_[static_cast<std::size_t>(iv)] = {
            iq, lower[iq], upper[iq], std::fmin(lower[iq], q[iq]), std::fmax(upper[iq], q[iq])};
      }
      iq = end + 7;
      iv += 6;
    }
  }

  /// Adds the forces of the stops to `tau`, and to `qdd` what they accelerate. `move(tau, qdd)` is
  /// the robot's forward dynamics here.
  template <class Move>
  void push(const double (&q)[nq], const double (&qd)[nv], const Move& move, double (&tau)[nv],
            double (&qdd)[nv]) const noexcept {
    Touching touching;
    if (!find_touching(q, qd, touching)) return;
    double mobility[nv * nv] = {};
    find_mobility(touching, move, tau, qdd, mobility);
    double forces[nv];
    while (!solve(mobility, qdd, touching, forces)) {
    }
    for (int i = 0; i < nv; ++i) tau[i] += touching.side[i] * forces[i];
    move(tau, qdd);
  }

  /// A stop beyond the limit follows the joint back.
  void follow(const double (&q)[nq]) noexcept {
    for (Stop& stop : stops_) {
      if (stop.coordinate < 0) continue;
      const double place = q[stop.coordinate];
      stop.lower = std::fmin(stop.limit_lower, std::fmax(stop.lower, place));
      stop.upper = std::fmax(stop.limit_upper, std::fmin(stop.upper, place));
    }
  }

 private:
  struct Stop {
    int coordinate = -1;  ///< -1: part of a floating joint
    double limit_lower = 0.0, limit_upper = 0.0;
    double lower = 0.0, upper = 0.0;
  };
  /// Direction in which the stop of each joint pushes, +1 or -1, or 0 where it does not touch, and
  /// the acceleration in that direction which leads back.
  struct Touching {
    double side[nv] = {};
    double wanted[nv] = {};
  };

  bool find_touching(const double (&q)[nq], const double (&qd)[nv],
                     Touching& touching) const noexcept {
    constexpr double kFrequency = 200.0;  // rad/s
    bool any = false;
    for (int i = 0; i < nv; ++i) {
      const Stop& stop = stops_[static_cast<std::size_t>(i)];
      if (stop.coordinate < 0) continue;
      const double below = stop.lower - q[stop.coordinate];
      const double above = q[stop.coordinate] - stop.upper;
      if (!(below > 0.0 || above > 0.0)) continue;
      any = true;
      touching.side[i] = below > 0.0 ? 1.0 : -1.0;
      touching.wanted[i] = kFrequency * kFrequency * std::fmax(below, above) -
                           2.0 * kFrequency * touching.side[i] * qd[i];
    }
    return any;
  }

  /// Accelerations of joints at stops under unit forces of them, from forward dynamics, which is
  /// affine in the forces.
  template <class Move>
  static void find_mobility(const Touching& touching, const Move& move, const double (&tau)[nv],
                            const double (&qdd)[nv], double (&mobility)[nv * nv]) noexcept {
    for (int j = 0; j < nv; ++j) {
      if (touching.side[j] == 0.0) continue;
      double pushed[nv];
      double moved[nv];
      for (int i = 0; i < nv; ++i) pushed[i] = tau[i];
      pushed[j] += touching.side[j];
      move(pushed, moved);
      for (int i = 0; i < nv; ++i) {
        mobility[i * nv + j] = touching.side[i] * (moved[i] - qdd[i]);
      }
    }
  }

  /// Forces under which the joints that touch accelerate as wanted. Where one would have to pull,
  /// its stop is let go and false is returned; each time there are fewer.
  static bool solve(const double (&mobility)[nv * nv], const double (&qdd)[nv], Touching& touching,
                    double (&forces)[nv]) noexcept {
    double A[nv * nv] = {};
    double scale = 0.0;
    for (int i = 0; i < nv; ++i) {
      if (touching.side[i] != 0.0) scale = std::fmax(scale, mobility[i * nv + i]);
    }
    for (int i = 0; i < nv; ++i) {
      const bool touches = touching.side[i] != 0.0;
      forces[i] = touches ? touching.wanted[i] - touching.side[i] * qdd[i] : 0.0;
      for (int j = 0; touches && j <= i; ++j) {
        A[i * nv + j] = touching.side[j] != 0.0 ? mobility[i * nv + j] : 0.0;
      }
      // Of joints that a closed loop connects, stops share what they carry.
      A[i * nv + i] += touches ? 1e-9 * scale : 1.0;
    }
    (void)core::ldlt_factor<nv>(A);
    core::ldlt_solve<nv>(A, forces);
    bool all_push = true;
    for (int i = 0; i < nv; ++i) {
      if (forces[i] >= 0.0) continue;
      all_push = false;
      forces[i] = touching.side[i] = 0.0;
    }
    return all_push;
  }

  std::array<Stop, static_cast<std::size_t>(nv)> stops_{};
};

}  // namespace treeline::drive
