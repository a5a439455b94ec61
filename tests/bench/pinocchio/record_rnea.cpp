#include "pinocchio/record.hpp"
// The scalar comes first.
#include "bench/peers/pinocchio/rnea.hpp"

namespace treeline::peer::pin {

std::string record_rnea(const Solver<double>& s) {
  const auto nv = s.place.size();
  return record(s, {{s.position_count(), nv, nv}, nv}, rnea<Recorded>);
}

}  // namespace treeline::peer::pin
