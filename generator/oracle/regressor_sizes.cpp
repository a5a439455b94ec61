#include <cmath>

#include "oracle/term_sizes.hpp"

// Sizes of regressors.

namespace treeline {
namespace {

using UnitKind = interpreter::UnitParameter::Kind;

}  // namespace

Eigen::MatrixXd TermSizes::inverse_dynamics_regressor(const std::vector<double>& qd,
                                                      const std::vector<double>& qdd) const {
  const auto& units = subject_.regressor;
  Eigen::MatrixXd Y =
      Eigen::MatrixXd::Zero(subject_.model.nv, static_cast<Eigen::Index>(units.size()));
  for (Eigen::Index k = 0; k < Y.cols(); ++k) {
    const auto& unit = units[static_cast<std::size_t>(k)];
    if (unit.kind != UnitKind::inertial) {
      const auto& joint = subject_.model.body(unit.body);
      const auto at = static_cast<std::size_t>(joint.v);
      const double m = std::abs(joint.multiplier);
      const double rate = unit.kind == UnitKind::rotor ? qdd[at] : qd[at];
      Y(joint.v, k) = unit.kind == UnitKind::coulomb ? m : m * m * std::abs(rate);
      continue;
    }
    const Columns own = columns(unit.body, 0);
    const Motion of = motion(own, qd, qdd);
    const double turning = of.alpha + of.w * of.w, field = of.a + subject_.model.gravity.norm();
    const bool is_mass = unit.entry == 0, is_first = unit.entry > 0 && unit.entry < 4;
    const double force = is_mass ? field : is_first ? turning : 0;
    const double moment = is_mass ? 0 : is_first ? field : turning;
    for (const Column& column : own) {
      Y(column.v, k) += column.lever * force + column.turn * moment;
    }
  }
  return Y;
}

Eigen::MatrixXd TermSizes::energy_regressor(const std::vector<double>& qd) const {
  const std::vector<double> none(qd.size(), 0);
  const auto& units = subject_.regressor;
  Eigen::MatrixXd E = Eigen::MatrixXd::Zero(2, static_cast<Eigen::Index>(units.size()));
  for (Eigen::Index k = 0; k < E.cols(); ++k) {
    const auto& unit = units[static_cast<std::size_t>(k)];
    if (unit.kind == UnitKind::viscous || unit.kind == UnitKind::coulomb) continue;
    if (unit.kind == UnitKind::rotor) {
      const auto& joint = subject_.model.body(unit.body);
      const double rate = joint.multiplier * qd[static_cast<std::size_t>(joint.v)];
      E(0, k) = rate * rate / 2;
      continue;
    }
    const Motion of = motion(columns(unit.body, 0), qd, none);
    const double gravity = subject_.model.gravity.norm();
    const bool is_mass = unit.entry == 0, is_first = unit.entry > 0 && unit.entry < 4;
    E(0, k) = is_mass ? of.v * of.v / 2 : is_first ? of.v * of.w : of.w * of.w / 2;
    E(1, k) = is_mass ? gravity * path_to(unit.body) : is_first ? gravity : 0;
  }
  return E;
}

}  // namespace treeline
