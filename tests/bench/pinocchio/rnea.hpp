#pragma once

#include <pinocchio/algorithm/rnea.hpp>

#include "pinocchio/solver.hpp"

namespace treeline::bench::pin {

template <class Scalar>
void rnea(Solver<Scalar>& s, const Scalar* const* in, Scalar* out) {
  s.load_motion(in);
  s.store(pinocchio::rnea(s.model, s.data, s.q, s.qd, s.drive), out);
}

}  // namespace treeline::bench::pin
