#include "pinocchio/record.hpp"
// The scalar comes first.
#include "bench/peers/pinocchio/cholesky_route.hpp"

namespace treeline::peer::pin {
namespace {

void whole_mass_matrix(Solver<Recorded>& s, const Recorded* const* in, Recorded* out) {
  s.load_position(in[0]);
  const auto& M = pinocchio::crba(s.model, s.data, s.q, pinocchio::Convention::LOCAL);
  for (const auto i : s.place) {
    for (const auto k : s.place) *out++ = i < k ? M(i, k) : M(k, i);
  }
}

}  // namespace

std::string record_mass_matrix(const Solver<double>& s) {
  return record(s, {{s.position_count()}, s.place.size() * s.place.size()}, whole_mass_matrix);
}

std::string record_lambda_inverse(const Solver<double>& s) {
  const auto rows = static_cast<std::size_t>(s.rows());
  return record(s, {{s.position_count()}, rows * rows}, lambda_inverse_by_cholesky<Recorded>);
}

std::string record_lambda(const Solver<double>& s) {
  const auto rows = static_cast<std::size_t>(s.rows());
  return record(s, {{s.position_count()}, rows * rows}, lambda_by_cholesky<Recorded>);
}

}  // namespace treeline::peer::pin
