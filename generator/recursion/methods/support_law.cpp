#include <memory>
#include <utility>
#include <vector>

#include "recursion/methods/ordinary_states.hpp"
#include "recursion/methods/supported_control_torque.hpp"
#include "recursion/methods/task_law.hpp"

namespace treeline {
namespace {

/// Ordinary states of a robot that constraints support.
class SupportedStates {
 public:
  explicit SupportedStates(const Mechanism& mechanism) : passive_(mechanism.passive) {
    anchored_ = static_cast<std::size_t>(mechanism.anchored_rows());
    held_ = static_cast<std::size_t>(mechanism.held_rows());
    const auto constants = unposed<double>(mechanism, LawPoints::operational);
    for (int state = 0; state < kOrdinaryStates; ++state) {
      posed_.push_back(pose(constants, LawPoints::operational, ordinary_state(mechanism, state)));
      rows_.push_back(jacobian_of(posed_.back()));
      columns_.push_back(columns_of(rows_.back(), passive_));
    }
  }

  [[nodiscard]] OrdinaryPivots forces() const {
    OrdinaryPivots sizes;
    const auto weights = held_weights(tree(), anchored_);
    for (const auto& columns : columns_) sizes.add(weighted_square(columns, weights, held_));
    return sizes;
  }

  [[nodiscard]] OrdinaryPivots locked() const {
    OrdinaryPivots sizes;
    for (std::size_t s = 0; s < posed_.size(); ++s) {
      const auto K = factor_ldlt(locked_inertia(posed_[s]));
      sizes.add(leading_block(mobility_of_rows(K, columns_[s]), held_));
    }
    return sizes;
  }

  [[nodiscard]] OrdinaryPivots rows(const SupportRules& rules) const {
    OrdinaryPivots sizes;
    for (std::size_t s = 0; s < posed_.size(); ++s) {
      auto A = lambda_inverse_by_factors(posed_[s].tree, posed_[s].X, rows_[s]);
      std::vector<double> diagonal;
      for (std::size_t k = 0; k < A.rows(); ++k) diagonal.push_back(A(k, k));
      if (rules.passive_moves) {
        PassiveMotion<double>(locked_inertia(posed_[s]), columns_[s], rules, {}).subtract_from(A);
      }
      sizes.add(A, diagonal);
    }
    return sizes;
  }

  [[nodiscard]] std::size_t anchored() const { return anchored_; }
  [[nodiscard]] std::size_t held() const { return held_; }
  [[nodiscard]] const Tree<double>& tree() const { return posed_.front().tree; }

 private:
  [[nodiscard]] DenseMatrix<double> jacobian_of(const Posed<double>& posed) const {
    const auto tasks = task_points(posed.tree, {}, world_poses(posed.tree, posed.X));
    return jacobian_with_loops(posed.tree, posed.X, tasks, anchored_,
                               loop_jacobian(posed.tree, posed.X));
  }
  [[nodiscard]] DenseMatrix<double> locked_inertia(const Posed<double>& posed) const {
    return block_of_velocities(mass_matrix(posed.tree, posed.X), passive_);
  }

  std::vector<int> passive_;
  std::size_t anchored_ = 0, held_ = 0;  ///< rows held to the world, and all that are held
  std::vector<Posed<double>> posed_;
  std::vector<DenseMatrix<double>> rows_, columns_;  ///< J, and its columns of passive joints
};

SupportRules support_rules(const Mechanism& mechanism) {
  const BoundedInverseShape shape = inverse_inertia_shape(mechanism.real);
  const SupportedStates states(mechanism);
  SupportRules rules;
  rules.held = states.held();
  const OrdinaryPivots forces = states.forces();
  const bool comes_and_goes = !mechanism.inputs.active.empty();
  rules.passive_moves =
      !mechanism.passive.empty() && (rules.held == 0 || comes_and_goes || forces.has_dependent());
  if (rules.held > 0) rules.forces = {shape.power, forces.borders(shape)};
  if (rules.passive_moves && rules.held > 0) {
    rules.locked = {shape.power, states.locked().borders(shape)};
  }
  rules.rows = {shape.power, states.rows(rules).borders(
                                 inverse_inertia_shape(mechanism.real, mechanism.singular))};
  const auto free = always_free(states.tree());
  for (std::size_t k = 0; k < rules.rows.borders.size(); ++k) {
    const bool exact = mechanism.singular == SingularTasks::exact;
    const bool held_alone = k < states.anchored() && free[k];
    if (k < rules.held ? held_alone : exact) rules.rows.borders[k] = 0;
  }
  return rules;
}

}  // namespace

std::shared_ptr<const TaskLaw> TaskLaws::supported() {
  const SupportRules rules = support_rules(*mechanism_);
  TaskLaw law;
  law.kind = TaskLaw::Kind::supported;
  law.mechanism = mechanism_;
  law.rule = rules.rows;
  for (const PivotRule* next : {&rules.locked, &rules.forces}) {
    law.rule.borders.insert(law.rule.borders.end(), next->borders.begin(), next->borders.end());
  }
  return std::make_shared<const TaskLaw>(std::move(law));
}

SupportRules split_rules(const TaskLaw& law) {
  const auto held = static_cast<std::ptrdiff_t>(law.mechanism->held_rows());
  // The rows of points, of which some are held, and those of loops.
  const std::ptrdiff_t rows = law.mechanism->task_rows() + held - law.mechanism->anchored_rows();
  const auto passive = static_cast<std::ptrdiff_t>(law.mechanism->passive.size());
  const auto first = law.rule.borders.begin();
  const auto last = law.rule.borders.end();
  const std::ptrdiff_t locked = held > 0 ? last - first - rows - passive : 0;
  const int power = law.rule.power;
  return {{power, {first, first + rows}},
          {power, {first + rows, first + rows + locked}},
          {power, {first + rows + locked, last}},
          static_cast<std::size_t>(held),
          passive > 0 && (held == 0 || locked > 0)};
}

}  // namespace treeline
