#include "pinocchio/rnea.hpp"

#include "pinocchio/calls.hpp"

namespace treeline::bench::pin {

void call_rnea(void* solver, const double* const* in, double* out) {
  rnea(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::bench::pin
