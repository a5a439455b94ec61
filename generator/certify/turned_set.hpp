#pragma once

#include <optional>
#include <string>
#include <vector>

#include "certify/bound_in_steps.hpp"

namespace treeline {

/// Rows of which some are turned by a pair (P, Q), for the sum of their squares:
/// row = P x + Q y + t with rows x, y of other values, and t that is added.
class TurnedSet {
 public:
  TurnedSet(StepBounds& proof, const std::vector<LinearRow>& rows, Values values, std::size_t pair);

  /// Bound of the sum of squares, proven in steps.
  GappaNumber bound();

 private:
  struct Turned {
    TurnedRow row;
    GappaNumber added;  ///< bound of t
  };
  [[nodiscard]] GappaNumber bound_added(const LinearRow& row, const TurnedRow& turned) const;
  [[nodiscard]] GappaNumber bound_roundings(const LinearRow& row) const;
  void add_roundings(std::uint32_t node, int factor, std::string& sum,
                     std::vector<std::string>& hypotheses) const;
  void pair_rows();
  [[nodiscard]] std::string print(const LinearRow& at_cosine, const LinearRow& at_sine) const;
  [[nodiscard]] std::string print_turned() const;
  [[nodiscard]] GappaNumber bound_turned() const;
  [[nodiscard]] GappaNumber bound_sum(const GappaNumber& turned) const;

  StepBounds& proof_;
  Values values_;
  std::size_t pair_;
  std::vector<Turned> turned_;
  std::vector<LinearRow> others_;  ///< rows that the pair does not turn
  std::vector<LinearRow> below_;   ///< all x and y, once for two mates
  std::vector<TurnedRow> alone_;   ///< rows without a mate
};

}  // namespace treeline
