#include "bench/peers/pinocchio/aba.hpp"

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

void call_aba(void* solver, const double* const* in, double* out) {
  aba(*static_cast<Solver<double>*>(solver), in, out);
}

void call_aba_in_world_axes(void* solver, const double* const* in, double* out) {
  aba_in_world_axes(*static_cast<Solver<double>*>(solver), in, out);
}

void call_minverse(void* solver, const double* const* in, double* out) {
  minverse(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::peer::pin
