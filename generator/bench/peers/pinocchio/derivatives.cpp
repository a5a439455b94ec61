#include "bench/peers/pinocchio/derivatives.hpp"

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

void call_rnea_derivatives(void* solver, const double* const* in, double* out) {
  rnea_derivatives(*static_cast<Solver<double>*>(solver), in, out);
}

void call_aba_derivatives(void* solver, const double* const* in, double* out) {
  aba_derivatives(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::peer::pin
