#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "emission/print_expression.hpp"
#include "program/program.hpp"

namespace treeline {

/// Prints the packs of a program, see `pack_lanes`: one statement on `Lanes` for each.
class LanePrinter {
 public:
  /// Gives the packed nodes in `names` the names of their lanes: `w_lanes[2]`.
  LanePrinter(const Program& program, std::vector<std::string>& names);

  [[nodiscard]] bool is_packed(std::uint32_t node) const { return pack_of_[node] >= 0; }
  /// Whether `node` is the first of its pack in the order of emission.
  [[nodiscard]] bool is_first(std::uint32_t node) const;
  /// The statement that computes the pack of `node`.
  [[nodiscard]] std::string statement(std::uint32_t node,
                                      const ExpressionPrinter& expressions) const;

 private:
  [[nodiscard]] const LanePack& pack_of(std::uint32_t node) const {
    return program_.packs[static_cast<std::size_t>(pack_of_[node])];
  }
  [[nodiscard]] std::string operand(const LanePack& nodes,
                                    const ExpressionPrinter& expressions) const;

  const Program& program_;
  std::vector<int> pack_of_, lane_of_;
  std::vector<std::string> pack_names_;
};

}  // namespace treeline
