#include "pinocchio/record.hpp"
// The scalar comes first.
#include "pinocchio/aba.hpp"

namespace treeline::bench::pin {

std::string record_aba(const Solver<double>& s) {
  const auto nv = s.place.size();
  return record(s, {{s.position_count(), nv, nv}, nv}, aba<Recorded>);
}

}  // namespace treeline::bench::pin
