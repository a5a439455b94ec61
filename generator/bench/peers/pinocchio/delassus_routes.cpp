#include "bench/peers/pinocchio/delassus_routes.hpp"

#include "bench/peers/pinocchio/calls.hpp"

namespace treeline::peer::pin {

void call_lambda_inverse_by_efpa(void* solver, const double* const* in, double* out) {
  lambda_inverse_by_efpa(*static_cast<ContactSolver*>(solver), in, out);
}

void call_lambda_inverse_by_pv(void* solver, const double* const* in, double* out) {
  lambda_inverse_by_pv(*static_cast<ContactSolver*>(solver), in, out);
}

std::shared_ptr<void> make_contact_solver(const Solver<double>& solver) {
  return std::make_shared<ContactSolver>(solver);
}

}  // namespace treeline::peer::pin
