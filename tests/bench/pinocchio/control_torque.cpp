#include "pinocchio/control_torque.hpp"

#include "pinocchio/calls.hpp"

namespace treeline::bench::pin {

void call_control_torque(void* solver, const double* const* in, double* out) {
  control_torque(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::bench::pin
