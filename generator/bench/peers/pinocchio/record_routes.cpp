#include "bench/peers/pinocchio/record.hpp"
// The scalar comes first.
#include "bench/peers/pinocchio/aba.hpp"
#include "bench/peers/pinocchio/control_torque.hpp"
#include "bench/peers/pinocchio/derivatives.hpp"
#include "bench/peers/pinocchio/rnea.hpp"

namespace treeline::peer::pin {
namespace {

/// Arguments of a function of a motion, and so many results.
Shape of_motion(const Solver<double>& s, std::size_t results) {
  const auto nv = s.place.size();
  return {{s.position_count(), nv, nv}, results};
}

Shape of_position(const Solver<double>& s, std::size_t results) {
  return {{s.position_count()}, results};
}

std::size_t square(std::size_t n) {
  return n * n;
}

}  // namespace

std::string record_rnea(const Solver<double>& s) {
  return record(s, of_motion(s, s.place.size()), rnea<Recorded>);
}

std::string record_gravity(const Solver<double>& s) {
  return record(s, of_position(s, s.place.size()), gravity<Recorded>);
}

std::string record_aba(const Solver<double>& s) {
  return record(s, of_motion(s, s.place.size()), aba<Recorded>);
}

std::string record_crba(const Solver<double>& s) {
  return record(s, of_position(s, square(s.place.size())), crba<Recorded>);
}

std::string record_rnea_derivatives(const Solver<double>& s) {
  return record(s, of_motion(s, 3 * square(s.place.size())), rnea_derivatives<Recorded>);
}

std::string record_aba_derivatives(const Solver<double>& s) {
  return record(s, of_motion(s, 3 * square(s.place.size())), aba_derivatives<Recorded>);
}

std::string record_lambda_inverse(const Solver<double>& s) {
  const auto rows = static_cast<std::size_t>(s.rows());
  return record(s, of_position(s, square(rows)), lambda_inverse_by_cholesky<Recorded>);
}

std::string record_lambda(const Solver<double>& s) {
  const auto rows = static_cast<std::size_t>(s.rows());
  return record(s, of_position(s, square(rows)), lambda_by_cholesky<Recorded>);
}

std::string record_control_torque(const Solver<double>& s) {
  Shape shape = of_motion(s, s.place.size());
  shape.inputs.push_back(static_cast<std::size_t>(s.rows()));
  return record(s, shape, control_torque<Recorded>);
}

}  // namespace treeline::peer::pin
