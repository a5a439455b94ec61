#include "choice/base_parameter_domain.hpp"

#include <algorithm>
#include <cmath>

#include "recursion/parameters/base_parameters.hpp"

namespace treeline {
namespace {

/// Twice what the file says of a link with what is fixed to it.
SceneInertia ranges_of(const MechanismInertia& link) {
  SceneInertia ranges{link.frame.name};
  const auto mass = static_cast<double>(link.nominal.mass);
  if (!(mass > 0)) return ranges;
  const auto first = static_cast<double>(Digits50(sqrt(Digits50(link.nominal.h.squaredNorm()))));
  const auto second = static_cast<double>(Digits50(link.nominal.Sigma.trace()));
  ranges.mass = 2 * mass;
  const double reach = 2 * (first / mass + std::sqrt(std::abs(second) / mass));
  if (reach > 0) ranges.reach = reach;
  return ranges;
}

}  // namespace

BaseDomain base_parameter_domain(const Mechanism& mechanism) {
  BaseDomain domain;
  for (const MechanismInertia& link : mechanism.inputs.base) {
    domain.bodies.push_back(ranges_of(link));
  }
  const auto found = base_parameters_of(mechanism);
  for (const ModelParameter& parameter : found->parameters) {
    if (parameter.is_of_body()) continue;
    const auto stated = static_cast<double>(value_in_files(parameter, mechanism));
    domain.drives.push_back(stated > 0 ? 2 * stated : kUnstatedDrive);
  }
  for (const BaseParameter& base : found->base) {
    auto& row = domain.rows.emplace_back();
    for (const auto& [number, coefficient] : base.combination) {
      row.emplace_back(number, static_cast<double>(coefficient));
    }
  }
  return domain;
}

void add_base_parameters(const Mechanism& mechanism, Domain& domain) {
  if (mechanism.inputs.base.empty()) return;
  domain.base = base_parameter_domain(mechanism);
  std::vector<double> parts = inertia_sizes(domain.base.bodies);
  parts.insert(parts.end(), domain.base.drives.begin(), domain.base.drives.end());
  std::vector<double>& sizes = domain.sizes[symbol_of(Quantity::base_parameters)];
  for (const auto& row : domain.base.rows) {
    double size = 0;
    for (const auto& [number, coefficient] : row) size += std::abs(coefficient) * parts[number];
    sizes.push_back(size);
  }
}

}  // namespace treeline
