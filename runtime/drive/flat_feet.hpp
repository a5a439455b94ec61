#pragma once

#include <cmath>
#include <cstddef>
#include <type_traits>

#include "drive/ground.hpp"
#include "drive/held_places.hpp"

namespace treeline::drive {

/// Keeps the torque of a robot that stands on a ground within what its feet can push: each up, its
/// centre of pressure within the sole less a tenth of it on each side, and no tangential force
/// beyond friction. Forces follow from torques as if the feet stood, so they are linear, and what
/// asks for more is led towards the torque that holds the robot at rest. A foot that tips is light:
/// what is computed for the whole robot would throw it about.
///
/// F offers kSolePoints, points of the held links that may touch the ground, kSoleEnds, where those
/// of each hold end, and kFriction.
template <class F>
class FlatFeet {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;

  /// At `q` the robot stands.
  explicit FlatFeet(const double (&q)[nq]) noexcept {
    Frames frames;
    HeldPlaces<F>::find_frames(q, frames.all);
    double lowest = 1e9;
    for_each_point([&](int k, const SolePoint& point) {
      lowest = std::fmin(lowest, height_of(frames.all[k], point));
    });
    for_each_point([&](int k, const SolePoint& point) {
      constexpr double kLevel = 0.005;  // m
      if (height_of(frames.all[k], point) < lowest + kLevel) widen(frames.all[k], point, soles_[k]);
    });
  }

  void keep(const double (&q)[nq], const double (&qd)[nv], double (&tau)[nv]) const noexcept {
    const double none[nv] = {};
    double rest[nv];
    F::inverse_dynamics(q, none, none, rest);
    Frames frames;
    HeldPlaces<F>::find_frames(q, frames.all);
    Forces asked;
    Forces resting;
    find_forces(q, qd, tau, frames, asked);
    find_forces(q, qd, rest, frames, resting);
    double share = 1.0;
    for (int k = 0; k < kHolds; ++k) {
      double room[kLaws];
      double room_at_rest[kLaws];
      find_room(k, frames.all[k], asked.of[k], room);
      find_room(k, frames.all[k], resting.of[k], room_at_rest);
      for (int law = 0; law < kLaws; ++law) {
        if (room[law] >= 0.0) continue;
        const double from = std::fmax(room_at_rest[law], 0.0);
        share = std::fmin(share, from / (from - room[law]));
      }
    }
    for (int i = 0; i < nv; ++i) tau[i] = rest[i] + share * (tau[i] - rest[i]);
  }

 private:
  static constexpr int kHolds = HeldPlaces<F>::kHolds;
  static constexpr int kLaws = 9;  ///< up, four edges of the sole, four sides of the cone
  using Frame = typename HeldPlaces<F>::Frame;
  struct Frames {
    Frame all[kHolds];
  };
  /// Force and moment on the robot at each hold, world axes.
  struct Forces {
    double of[kHolds][6] = {};
  };
  /// How far a sole reaches along two axes of its frame, which are the world's x and y at the
  /// start.
  struct Sole {
    double along[2][3] = {};
    double low[2] = {1e9, 1e9};
    double high[2] = {-1e9, -1e9};
  };

  template <class Visit>
  static void for_each_point(Visit visit) noexcept {
    int i = 0;
    for (int k = 0; k < kHolds; ++k) {
      for (; i < F::kSoleEnds[k]; ++i) visit(k, F::kSolePoints[i]);
    }
  }

  static double height_of(const Frame& frame, const SolePoint& point) noexcept {
    const double* const R = frame.R;
    return frame.p[2] + R[6] * point.at[0] + R[7] * point.at[1] + R[8] * point.at[2] - point.radius;
  }

  static void widen(const Frame& frame, const SolePoint& point, Sole& sole) noexcept {
    for (int axis = 0; axis < 2; ++axis) {
      double place = 0.0;
      for (int i = 0; i < 3; ++i) {
        sole.along[axis][i] = frame.R[3 * axis + i];
        place += frame.R[3 * axis + i] * point.at[i];
      }
      sole.low[axis] = std::fmin(sole.low[axis], place);
      sole.high[axis] = std::fmax(sole.high[axis], place);
    }
  }

  static void find_forces(const double (&q)[nq], const double (&qd)[nv], const double (&tau)[nv],
                          const Frames& frames, Forces& forces) noexcept {
    double f[F::kHeldRows];
    double qdd[nv];
    const double none[2] = {};
    const double off[F::kWorldRows] = {};
    F::constrained_forward_dynamics(q, qd, tau, none, off, qdd, f);
    int next = 0;
    for (int k = 0; k < kHolds; ++k) {
      const WorldHold& hold = F::kWorldHolds[k];
      for (int row = 0; row < 6; ++row) {
        if (!hold.rows[row]) continue;
        const double size = f[next++];
        double* const part = forces.of[k] + (row < 3 ? 0 : 3);
        if (!hold.local_axes) {
          part[row % 3] += size;
          continue;
        }
        for (int i = 0; i < 3; ++i) part[i] += frames.all[k].R[3 * i + row % 3] * size;
      }
    }
  }

  /// By how much each law holds, N or N m; negative where it does not.
  void find_room(int k, const Frame& frame, const double (&force)[6],
                 double (&room)[kLaws]) const noexcept {
    constexpr double kMargin = 0.1;
    const Sole& sole = soles_[k];
    const double up = force[2];
    const double height = frame.p[2];
    // Of the centre of pressure, times the force that presses.
    const double to[2] = {-force[4] - height * force[0], force[3] - height * force[1]};
    int law = 0;
    room[law++] = up;
    for (int axis = 0; axis < 2; ++axis) {
      double along[2] = {};  // on the ground
      for (int i = 0; i < 3; ++i) {
        along[0] += frame.R[i] * sole.along[axis][i];
        along[1] += frame.R[3 + i] * sole.along[axis][i];
      }
      const double place = along[0] * to[0] + along[1] * to[1];
      const double edge = kMargin * (sole.high[axis] - sole.low[axis]);
      const bool is_held = (F::kWorldHolds[k].rows[3] || F::kWorldHolds[k].rows[4]) &&
                           sole.low[axis] < sole.high[axis];
      room[law++] = is_held ? place - (sole.low[axis] + edge) * up : 0.0;
      room[law++] = is_held ? (sole.high[axis] - edge) * up - place : 0.0;
      const double most = std::sqrt(0.5) * F::kFriction * up;
      room[law++] = most - force[axis];
      room[law++] = most + force[axis];
    }
  }

  Sole soles_[kHolds];
};

/// Whether a robot F is simulated standing on its feet.
template <class F>
inline constexpr bool kStands = kIsOnGround<F>&& HeldPlaces<F>::kIsHeld;

/// In the place of the feet of a robot that has none to stand on.
struct NoFeet {
  template <class Coordinates>
  explicit NoFeet(const Coordinates&) noexcept {}
};

template <class F>
using Feet = std::conditional_t<kStands<F>, FlatFeet<F>, NoFeet>;

}  // namespace treeline::drive
