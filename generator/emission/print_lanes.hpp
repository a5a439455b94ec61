#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emission/print_expression.hpp"
#include "passes/lane_operands.hpp"
#include "program/program.hpp"

namespace treeline {

/// Prints the packs of a program, see `pack_lanes`: statements on lanes. A pack that only one
/// other reads, each lane in its place, is written inside that one's statement; a compiler may fuse
/// a product and a sum of one expression, and some fuse no others.
class LanePrinter {
 public:
  /// Gives the packed nodes in `names` the names of their lanes: `w_lanes[2]`.
  LanePrinter(const Program& program, const Syntax& syntax, std::vector<std::string>& names);

  [[nodiscard]] bool is_packed(std::uint32_t node) const { return pack_of_[node] >= 0; }
  /// Whether the statement of a pack stands where `node` is: the pack's first in the order of
  /// emission.
  [[nodiscard]] bool has_statement(std::uint32_t node) const;
  /// The nodes that one statement computes with `node`, itself among them.
  [[nodiscard]] LanePack beside(std::uint32_t node) const;
  /// The statement that computes the pack of `node`.
  [[nodiscard]] std::string statement(std::uint32_t node,
                                      const ExpressionPrinter& expressions) const;

 private:
  /// Width of one number for all lanes.
  static constexpr std::size_t kSpread = 1;
  struct Operand {
    std::string text;
    std::size_t width = kSpread;  ///< number of lanes
  };

  [[nodiscard]] std::size_t index_of(std::uint32_t node) const {
    return static_cast<std::size_t>(pack_of_[node]);
  }
  /// The pack that `nodes` are, lane by lane; -1: none.
  [[nodiscard]] int pack_in_place(const LanePack& nodes) const;
  void find_inner_packs();
  [[nodiscard]] Op op_of(std::size_t pack) const;
  [[nodiscard]] std::string formula(std::size_t pack, const ExpressionPrinter& expressions) const;
  /// An operand as calls take it: in as many lanes as the pack.
  [[nodiscard]] std::string in_lanes(const Operand& operand, std::size_t pack,
                                     const Syntax& syntax) const;
  /// Throws std::logic_error unless operands in lanes have as many as the pack.
  void expect_equal_widths(std::size_t pack, const Operand& a, const Operand& b) const;
  [[nodiscard]] Operand operand(const LanePack& nodes, Op user, bool is_right,
                                const ExpressionPrinter& expressions) const;

  const Program& program_;
  std::vector<int> pack_of_;
  std::vector<std::string> pack_names_;
  std::vector<LaneOperands> operands_;  // of each pack
  std::vector<bool> is_inner_;          // written inside another's statement
};

}  // namespace treeline
