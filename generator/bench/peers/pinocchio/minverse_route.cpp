#include "bench/peers/pinocchio/minverse_route.hpp"

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

void call_lambda_inverse_by_minverse(void* solver, const double* const* in, double* out) {
  lambda_inverse_by_minverse(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::peer::pin
