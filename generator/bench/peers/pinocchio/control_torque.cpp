#include "bench/peers/pinocchio/control_torque.hpp"

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

void call_control_torque(void* solver, const double* const* in, double* out) {
  control_torque(*static_cast<Solver<double>*>(solver), in, out);
}

}  // namespace treeline::peer::pin
