#include "pinocchio/record.hpp"
// The scalar comes first.
#include "bench/peers/pinocchio/control_torque.hpp"

namespace treeline::peer::pin {

std::string record_control_torque(const Solver<double>& s) {
  const auto nv = s.place.size();
  const auto rows = static_cast<std::size_t>(s.rows());
  return record(s, {{s.position_count(), nv, nv, rows}, nv}, control_torque<Recorded>);
}

}  // namespace treeline::peer::pin
