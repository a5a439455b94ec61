#include "recursion/methods/choose_dependents.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "recursion/methods/lambda_inverse.hpp"
#include "recursion/methods/loop_rows.hpp"
#include "recursion/methods/mass_matrix.hpp"
#include "recursion/methods/ordinary_states.hpp"

namespace treeline {
namespace {

/// Largest remainder of a column that counts as zero, as a share of the rows' scaled entries.
const Digits50 kResidue("1e-30");

/// Pivots of the rows and inertias of the velocities in ordinary states.
struct OrdinaryInertia {
  OrdinaryPivots rows;                          ///< pivots of C M^-1 C^T
  std::vector<std::vector<double>> velocities;  ///< diagonal entries of M, by velocity
};

OrdinaryInertia look_at_states(const Mechanism& mechanism) {
  OrdinaryInertia found;
  found.velocities.resize(static_cast<std::size_t>(mechanism.nv()));
  const auto constants = unposed<double>(mechanism, LawPoints::operational);
  for (int state = 0; state < kOrdinaryStates; ++state) {
    const auto posed = pose(constants, LawPoints::operational, ordinary_state(mechanism, state));
    const auto M = mass_matrix(posed.tree, posed.X);
    for (std::size_t v = 0; v < M.rows(); ++v) found.velocities[v].push_back(M(v, v));
    found.rows.add(
        lambda_inverse_by_factors(posed.tree, posed.X, loop_jacobian(posed.tree, posed.X)));
  }
  return found;
}

/// By velocity, the power of two next to 1 / sqrt(M_vv): the same on every host. Empty if some
/// velocity moves nothing.
std::vector<Digits50> velocity_scales(const OrdinaryInertia& ordinary) {
  std::vector<Digits50> scales;
  for (const std::vector<double>& inertias : ordinary.velocities) {
    const double inertia = median(inertias);
    if (!(inertia > 0)) return {};
    scales.emplace_back(std::exp2(std::round(-0.5 * std::log2(inertia))));
  }
  return scales;
}

/// How many velocities M may couple each velocity with: those inward and outward of its joints.
std::vector<int> count_coupled(const Mechanism& mechanism) {
  std::vector<int> counts(static_cast<std::size_t>(mechanism.nv()));
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const auto own = static_cast<std::size_t>(mechanism.links[i].v_index);
    for (int j = mechanism.links[i].parent; j >= 0;
         j = mechanism.links[static_cast<std::size_t>(j)].parent) {
      ++counts[own];
      ++counts[static_cast<std::size_t>(mechanism.links[static_cast<std::size_t>(j)].v_index)];
    }
  }
  return counts;
}

/// Velocities in the order in which they are preferred as dependent ones.
std::vector<int> preference(const Mechanism& mechanism) {
  const std::vector<int> counts = count_coupled(mechanism);
  std::vector<int> order(counts.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(), [&counts](int a, int b) {
    const int of_a = counts[static_cast<std::size_t>(a)],
              of_b = counts[static_cast<std::size_t>(b)];
    return of_a != of_b ? of_a < of_b : a > b;
  });
  return order;
}

/// [C scaled | 1] of the rows that are kept.
Digits50Rows scaled_rows(const Mechanism& mechanism, const std::vector<std::size_t>& rows,
                         const std::vector<Digits50>& scales) {
  const auto nv = static_cast<Eigen::Index>(scales.size());
  const auto count = static_cast<Eigen::Index>(rows.size());
  Digits50Rows C = Digits50Rows::Zero(count, nv + count);
  for (Eigen::Index r = 0; r < count; ++r) {
    const auto& coupling = mechanism.couplings[rows[static_cast<std::size_t>(r)]];
    for (const auto& part : coupling.parts) {
      C(r, part.v_index) += Digits50(part.factor) * scales[static_cast<std::size_t>(part.v_index)];
    }
    C(r, nv + r) = 1;
  }
  return C;
}

/// G and S from the rows that Gauss-Jordan elimination leaves.
void read_off(const ReducedRows& reduced, const std::vector<Digits50>& scales,
              CoupledVelocities& coupled) {
  const auto count = static_cast<Eigen::Index>(reduced.pivots.size());
  const auto nv = static_cast<Eigen::Index>(scales.size());
  coupled.G = Digits50Rows::Zero(count, nv - count);
  coupled.S = Digits50Rows::Zero(count, count);
  for (Eigen::Index k = 0; k < count; ++k) {
    const Digits50& own = scales[coupled.dependent[static_cast<std::size_t>(k)]];
    for (Eigen::Index i = 0; i < nv - count; ++i) {
      const std::size_t v = coupled.independent[static_cast<std::size_t>(i)];
      const Digits50 share = snapped(reduced.rows(k, static_cast<Eigen::Index>(v)), Digits50(1));
      coupled.G(k, i) = -share * own / scales[v];
    }
    for (Eigen::Index r = 0; r < count; ++r) {
      coupled.S(k, r) = snapped(reduced.rows(k, nv + r), Digits50(1)) * own;
    }
  }
}

}  // namespace

std::optional<CoupledVelocities> choose_dependents(const Mechanism& mechanism) {
  if (mechanism.couplings.empty() || !mechanism.loops.empty() || !mechanism.constraints.empty()) {
    return std::nullopt;
  }
  const OrdinaryInertia ordinary = look_at_states(mechanism);
  const std::vector<Digits50> scales = velocity_scales(ordinary);
  if (scales.empty()) return std::nullopt;
  CoupledVelocities coupled;
  for (std::size_t r = 0; r < mechanism.couplings.size(); ++r) {
    if (!ordinary.rows.is_dependent(r)) coupled.rows.push_back(r);
  }
  const ReducedRows reduced =
      reduce(scaled_rows(mechanism, coupled.rows, scales), preference(mechanism), kResidue);
  if (reduced.pivots.size() < coupled.rows.size()) return std::nullopt;
  for (const int pivot : reduced.pivots) {
    coupled.dependent.push_back(static_cast<std::size_t>(pivot));
  }
  for (std::size_t v = 0; v < scales.size(); ++v) {
    if (std::count(coupled.dependent.begin(), coupled.dependent.end(), v) == 0) {
      coupled.independent.push_back(v);
    }
  }
  read_off(reduced, scales, coupled);
  return coupled;
}

}  // namespace treeline
