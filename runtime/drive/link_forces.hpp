#pragma once

namespace treeline::drive {

/// Places and forces at points of a robot's links, by the generated functions `link_frames` and
/// `link_inverse_dynamics` of F. Only where F::kLinks > 0.
template <class F>
class LinkForces {
 public:
  static constexpr int nv = F::kVelocities;
  static constexpr int kLinks = F::kLinks > 0 ? F::kLinks : 1;

  /// Computes where the links are, before the functions below.
  void place(const double (&q)[F::kCoordinates]) noexcept {
    if constexpr (F::kLinks > 0) {
      F::link_frames(q, positions_, rotations_);
      weighed_ = false;
    }
  }

  /// Place in the world of a point in the link's frame, m.
  void place_of(int link, const double (&on_link)[3], double (&place)[3]) const noexcept {
    const double* const R = rotations_ + 9 * link;
    for (int i = 0; i < 3; ++i) {
      place[i] = positions_[3 * link + i] + R[3 * i] * on_link[0] + R[3 * i + 1] * on_link[1] +
                 R[3 * i + 2] * on_link[2];
    }
  }

  /// J^T f: the joint forces that stand for the force `f` (world axes) on a link at `place`, from
  /// inverse dynamics with and without it.
  void joint_forces(const double (&q)[F::kCoordinates], int link, const double (&place)[3],
                    const double (&f)[3], double (&tau)[nv]) noexcept {
    if constexpr (F::kLinks > 0) {
      const double rest[nv] = {};
      if (!weighed_) {
        const double nothing[6 * F::kLinks] = {};
        F::link_inverse_dynamics(q, rest, rest, nothing, weight_);
        weighed_ = true;
      }
      double lever[3];
      for (int i = 0; i < 3; ++i) {
        lever[i] = place[i] - positions_[3 * link + i];
      }
      double forces[6 * F::kLinks] = {};
      double* const wrench = forces + 6 * link;
      for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3;
        const int k = (i + 2) % 3;
        wrench[i] = -f[i];
        wrench[3 + i] = -(lever[j] * f[k] - lever[k] * f[j]);
      }
      F::link_inverse_dynamics(q, rest, rest, forces, tau);
      for (int i = 0; i < nv; ++i) {
        tau[i] -= weight_[i];
      }
    }
  }

 private:
  double positions_[3 * kLinks] = {};
  double rotations_[9 * kLinks] = {};
  double weight_[nv] = {};
  bool weighed_ = false;
};

}  // namespace treeline::drive
