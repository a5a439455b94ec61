#include "bench/peers/pinocchio/constrained_dynamics.hpp"

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

void call_constrained_dynamics(void* solver, const double* const* in, double* out) {
  constrained_dynamics(*static_cast<ConstraintSolver*>(solver), in, out);
}

std::shared_ptr<void> make_constraint_solver(const Solver<double>& solver,
                                             const std::vector<Held>& held,
                                             const ProximalWay& way) {
  return std::make_shared<ConstraintSolver>(
      solver, held, pinocchio::ProximalSettings(way.accuracy, way.mu, way.iterations));
}

}  // namespace treeline::peer::pin
