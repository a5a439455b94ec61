#pragma once

#include <pinocchio/algorithm/rnea.hpp>

#include "bench/peers/pinocchio/solver.hpp"

namespace treeline::peer::pin {

template <class Scalar>
void rnea(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_motion(in);
  s.store(pinocchio::rnea(s.model, s.data, s.q, s.qd, s.drive), out);
}

template <class Scalar>
void gravity(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_position(in[0]);
  s.store(pinocchio::computeGeneralizedGravity(s.model, s.data, s.q), out);
}

}  // namespace treeline::peer::pin
