#include "pinocchio/minverse_route.hpp"

#include "pinocchio/calls.hpp"

namespace treeline::bench::pin {

void call_lambda_inverse_by_minverse(void* solver, const double* const* in, double* out) {
  lambda_inverse_by_minverse(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::bench::pin
