#pragma once

#include <algorithm>

#include "drive/closed_loops.hpp"
#include "drive/link_forces.hpp"

namespace treeline::drive {

/// A frame of a link that the world holds: its rows among x y z rx ry rz.
struct WorldHold {
  int link = 0;             ///< among those of `LinkForces`
  double position[3] = {};  ///< of the frame in the link's, m
  double rotation[9] = {};  ///< of the frame in the link's
  bool rows[6] = {};
  bool local_axes = false;  ///< rows along the frame's axes, else the world's
};

/// Places in which a robot is held to the world, and their drift from there in a simulation. For
/// robots that nothing holds it is empty.
template <class F>
class HeldPlaces {
 public:
  static constexpr int nq = F::kCoordinates;
  static constexpr int nv = F::kVelocities;

  explicit HeldPlaces(const double (&q)[nq]) noexcept {
    if constexpr (kIsHeld) find_frames(q, put_);
  }

  /// Motion under joint forces, with the drift led back.
  void forward_dynamics(const double (&q)[nq], const double (&qd)[nv], const double (&tau)[nv],
                        double (&qdd)[nv]) const noexcept {
    if constexpr (kIsHeld) {
      double drift[F::kWorldRows];
      find_drift(q, drift);
      ClosedLoops<F>::forward_dynamics(q, qd, tau, drift, qdd);
    } else {
      F::forward_dynamics(q, qd, tau, qdd);
    }
  }

  static constexpr bool kIsHeld = [] {
    if constexpr (requires { F::kWorldRows; }) {
      return F::kWorldRows > 0;
    } else {
      return false;
    }
  }();
  static constexpr int kHolds = [] {
    if constexpr (kIsHeld) {
      return static_cast<int>(std::size(F::kWorldHolds));
    } else {
      return 1;
    }
  }();
  /// Where a hold is in the world.
  struct Frame {
    double p[3] = {};
    double R[9] = {};
  };

  static void find_frames(const double (&q)[nq], Frame (&frames)[kHolds]) noexcept {
    double positions[3 * F::kLinks];
    double rotations[9 * F::kLinks];
    F::link_frames(q, positions, rotations);
    for (int k = 0; k < kHolds; ++k) {
      const WorldHold& hold = F::kWorldHolds[k];
      const double* const R = rotations + 9 * hold.link;
      for (int i = 0; i < 3; ++i) {
        double& p = frames[k].p[i];
        p = positions[3 * hold.link + i];
        for (int j = 0; j < 3; ++j) {
          p += R[3 * i + j] * hold.position[j];
          double& r = frames[k].R[3 * i + j];
          r = 0.0;
          for (int n = 0; n < 3; ++n) r += R[3 * i + n] * hold.rotation[3 * n + j];
        }
      }
    }
  }

 private:
  /// By row: the way of the frame's origin, and the sine of its turn.
  void find_drift(const double (&q)[nq], double* drift) const noexcept {
    Frame now[kHolds];
    find_frames(q, now);
    for (int k = 0; k < kHolds; ++k) {
      const double* const R = now[k].R;
      const double* const R0 = put_[k].R;
      double off[6];  // world axes
      for (int i = 0; i < 3; ++i) {
        const int a = (i + 1) % 3;
        const int b = (i + 2) % 3;
        off[i] = now[k].p[i] - put_[k].p[i];
        off[3 + i] = 0.0;
        for (int j = 0; j < 3; ++j) {  // of R R0^T the part that is not symmetric
          off[3 + i] += 0.5 * (R[3 * b + j] * R0[3 * a + j] - R[3 * a + j] * R0[3 * b + j]);
        }
      }
      const WorldHold& hold = F::kWorldHolds[k];
      for (int row = 0; row < 6; ++row) {
        if (!hold.rows[row]) continue;
        const double* const part = off + (row < 3 ? 0 : 3);
        const int i = row % 3;
        *drift++ =
            hold.local_axes ? R[i] * part[0] + R[3 + i] * part[1] + R[6 + i] * part[2] : part[i];
      }
    }
  }

  Frame put_[kHolds];
};

}  // namespace treeline::drive
