#pragma once

#include <pinocchio/algorithm/aba.hpp>

#include "bench/peers/pinocchio/solver.hpp"

namespace treeline::peer::pin {

template <class Scalar>
void aba(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_motion(in);
  s.store(pinocchio::aba(s.model, s.data, s.q, s.qd, s.drive, pinocchio::Convention::LOCAL), out);
}

template <class Scalar>
void aba_in_world_axes(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_motion(in);
  s.store(pinocchio::aba(s.model, s.data, s.q, s.qd, s.drive, pinocchio::Convention::WORLD), out);
}

/// M^-1. `out` receives its upper triangle.
template <class Scalar>
void minverse(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_position(in[0]);
  Eigen::Map<Matrix<Scalar>>(out, s.model.nv, s.model.nv) =
      pinocchio::computeMinverse(s.model, s.data, s.q);
}

}  // namespace treeline::peer::pin
