#include "bench/peers/pinocchio/rnea.hpp"

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

void call_rnea(void* solver, const double* const* in, double* out) {
  rnea(*static_cast<Solver<double>*>(solver), in, out);
}

void call_gravity(void* solver, const double* const* in, double* out) {
  gravity(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::peer::pin
