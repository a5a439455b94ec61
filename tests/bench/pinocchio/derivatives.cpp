#include "pinocchio/derivatives.hpp"

#include "pinocchio/calls.hpp"

namespace treeline::bench::pin {

void call_rnea_derivatives(void* solver, const double* const* in, double* out) {
  rnea_derivatives(*static_cast<Solver<double>*>(solver), in, out);
}

void call_aba_derivatives(void* solver, const double* const* in, double* out) {
  aba_derivatives(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::bench::pin
