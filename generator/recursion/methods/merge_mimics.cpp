#include "recursion/methods/merge_mimics.hpp"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <random>
#include <set>
#include <utility>

#include "recursion/algebra/row_space.hpp"
#include "recursion/methods/energy_regressor.hpp"

namespace treeline {
namespace {

constexpr std::uint64_t kSeed = 1;
/// States beyond as many as there are parameters.
constexpr std::size_t kMoreStates = 8;

/// Whether each moving link carries, or is carried by, joints that share a coordinate. Other links
/// can be removed from the tree in turn, each with the parameters that its coordinates reveal.
std::vector<bool> links_about_mimics(const Mechanism& mechanism) {
  std::set<int> shared;
  for (const MovingLink& link : mechanism.links) {
    if (link.mimics) shared.insert(link.v_index);
  }
  std::vector<bool> behind(mechanism.links.size(), false), before = behind;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    const MovingLink& link = mechanism.links[i];
    behind[i] = shared.contains(link.v_index) ||
                (link.parent >= 0 && behind[static_cast<std::size_t>(link.parent)]);
  }
  for (std::size_t i = mechanism.links.size(); i-- > 0;) {
    const MovingLink& link = mechanism.links[i];
    before[i] = before[i] || behind[i];
    if (before[i] && link.parent >= 0) before[static_cast<std::size_t>(link.parent)] = true;
  }
  return before;
}

/// Numbers between -1 and 1, the same on every host.
class Numbers {
 public:
  std::vector<Digits50> draw(int count) {
    std::vector<Digits50> drawn;
    for (int i = 0; i < count; ++i) {
      const auto bits = static_cast<double>(engine_() >> 11);
      drawn.emplace_back(bits * 0x1p-52 - 1);
    }
    return drawn;
  }

 private:
  std::mt19937_64 engine_{kSeed};
};

/// Kinetic energies, and potential energies less those at the first state, of unit parameters: two
/// rows for each state but the first.
Digits50Rows sample_energies(const Mechanism& mechanism,
                             const std::vector<ModelParameter>& columns) {
  const auto tree = tree_of<Digits50>(mechanism);
  const std::size_t states = columns.size() + kMoreStates;
  Digits50Rows rows(static_cast<Eigen::Index>(2 * states),
                    static_cast<Eigen::Index>(columns.size()));
  Numbers numbers;
  std::vector<Digits50> first;
  for (std::size_t s = 0; s <= states; ++s) {
    std::vector<Digits50> q = numbers.draw(mechanism.nq());
    for (Digits50& each : q) each *= 3;
    const std::vector<Digits50> qd = numbers.draw(mechanism.nv());
    const auto X = joint_transforms<Digits50>(tree, q);
    const std::vector<Digits50> E = energy_regressor<Digits50>(tree, X, qd, columns).values();
    if (s == 0) first.assign(E.begin() + static_cast<std::ptrdiff_t>(columns.size()), E.end());
    for (std::size_t k = 0; s > 0 && k < columns.size(); ++k) {
      const auto row = static_cast<Eigen::Index>(2 * (s - 1)),
                 column = static_cast<Eigen::Index>(k);
      rows(row, column) = E[k];
      rows(row + 1, column) = E[columns.size() + k] - first[k];
    }
  }
  return rows;
}

/// The rows' columns, each divided by its length.
Digits50Row normalize_columns(Digits50Rows& rows) {
  Digits50Row lengths(rows.cols());
  for (Eigen::Index k = 0; k < rows.cols(); ++k) {
    const Digits50 length = sqrt(Digits50(rows.col(k).squaredNorm()));
    lengths(k) = length > 0 ? length : Digits50(1);
    rows.col(k) /= lengths(k);
  }
  return lengths;
}

/// Whether the parameter is of matter that mimic joints move or carry, or of the rotor of such a
/// joint. `about_mimics`: which links those are.
bool is_about_mimics(const ModelParameter& parameter, const Mechanism& mechanism,
                     const std::vector<bool>& about_mimics) {
  if (parameter.kind == ModelParameter::Kind::inertial) {
    const int link = mechanism.link_frames[parameter.frame].link;
    return about_mimics[static_cast<std::size_t>(link)];
  }
  if (parameter.kind != ModelParameter::Kind::rotor) return false;
  for (std::size_t i = 0; i < mechanism.links.size(); ++i) {
    if (mechanism.links[i].v_index == parameter.v && about_mimics[i]) return true;
  }
  return false;
}

/// Adds the columns that are no pivots to the base parameter of a row that is, by their shares.
void add_shares(const ReducedRows& felt, std::size_t row, const Digits50Row& lengths,
                const std::vector<BaseParameter>& all, BaseParameter& base) {
  for (Eigen::Index k = 0; k < lengths.size(); ++k) {
    const bool is_base =
        std::count(felt.pivots.begin(), felt.pivots.end(), static_cast<int>(k)) > 0;
    const Digits50 share = snapped(felt.rows(static_cast<Eigen::Index>(row), k), Digits50(1));
    if (is_base || share == 0) continue;
    const Digits50 factor = share * lengths(k) / lengths(felt.pivots[row]);
    for (const auto& [parameter, coefficient] : all[static_cast<std::size_t>(k)].combination) {
      base.combination[parameter] += factor * coefficient;
    }
  }
}

}  // namespace

void merge_mimics(const Mechanism& mechanism, const Digits50& tolerance, BaseParameters& found) {
  const auto about_mimics = links_about_mimics(mechanism);
  const auto rest =
      std::stable_partition(found.base.begin(), found.base.end(), [&](const BaseParameter& base) {
        return is_about_mimics(found.parameters[base.parameter], mechanism, about_mimics);
      });
  const auto count = static_cast<std::size_t>(rest - found.base.begin());
  if (count == 0) return;
  std::vector<ModelParameter> columns;
  for (std::size_t k = 0; k < count; ++k) {
    columns.push_back(found.parameters[found.base[k].parameter]);
  }
  std::vector<int> order(count);
  std::iota(order.begin(), order.end(), 0);
  Digits50Rows energies = sample_energies(mechanism, columns);
  const Digits50Row lengths = normalize_columns(energies);
  const ReducedRows felt = reduce(std::move(energies), order, tolerance);
  std::vector<BaseParameter> merged(rest, found.base.end());
  for (std::size_t row = 0; row < felt.pivots.size(); ++row) {
    BaseParameter base = found.base[static_cast<std::size_t>(felt.pivots[row])];
    add_shares(felt, row, lengths, found.base, base);
    merged.push_back(std::move(base));
  }
  std::sort(merged.begin(), merged.end(),
            [](const auto& a, const auto& b) { return a.parameter < b.parameter; });
  found.base = std::move(merged);
}

}  // namespace treeline
