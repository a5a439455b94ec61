#include "bench/peers/pinocchio/cholesky_route.hpp"

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

void call_crba(void* solver, const double* const* in, double* out) {
  crba(*static_cast<Solver<double>*>(solver), in, out);
}

void call_crba_in_world_axes(void* solver, const double* const* in, double* out) {
  crba_in_world_axes(*static_cast<Solver<double>*>(solver), in, out);
}

void call_lambda_inverse_by_cholesky(void* solver, const double* const* in, double* out) {
  lambda_inverse_by_cholesky(*static_cast<Solver<double>*>(solver), in, out);
}

void call_lambda_by_cholesky(void* solver, const double* const* in, double* out) {
  lambda_by_cholesky(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::peer::pin
