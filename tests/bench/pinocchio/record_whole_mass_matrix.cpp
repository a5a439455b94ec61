#include "pinocchio/record_whole_mass_matrix.hpp"

#include <pinocchio/algorithm/crba.hpp>

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

std::string record_whole_mass_matrix(const Solver<double>& s) {
  return record(s, {{s.position_count()}, s.place.size() * s.place.size()}, whole_mass_matrix);
}

}  // namespace treeline::peer::pin
