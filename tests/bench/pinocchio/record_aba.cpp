#include "pinocchio/record.hpp"
// The scalar comes first.
#include "bench/peers/pinocchio/aba.hpp"

namespace treeline::peer::pin {

std::string record_aba(const Solver<double>& s) {
  const auto nv = s.place.size();
  return record(s, {{s.position_count(), nv, nv}, nv}, aba<Recorded>);
}

}  // namespace treeline::peer::pin
