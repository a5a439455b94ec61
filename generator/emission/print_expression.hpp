#pragma once

#include <string>
#include <vector>

#include "program/program.hpp"

namespace treeline {

/// Prints nodes as C++ expressions.
class ExpressionPrinter {
 public:
  /// `names` as from `choose_names`: a node with a name is referred to by it.
  ExpressionPrinter(const Graph& graph, const std::vector<std::string>& names,
                    bool single_precision)
      : graph_(graph), names_(names), single_precision_(single_precision) {}

  /// How an expression refers to the node's value: its name, an input, a literal, or its formula
  /// where it has no name.
  [[nodiscard]] std::string reference(std::uint32_t node) const;

  /// The same, in parentheses where it is a formula.
  [[nodiscard]] std::string atom(std::uint32_t node) const;

  /// The operation itself, with parentheses so that C++ evaluates it exactly as the graph has it.
  [[nodiscard]] std::string formula(std::uint32_t node) const;

  /// The value with its sign.
  [[nodiscard]] std::string signed_reference(Expression value) const;

 private:
  [[nodiscard]] bool is_atom(std::uint32_t node) const;
  [[nodiscard]] std::string operand(std::uint32_t node, Op user, bool is_right) const;

  const Graph& graph_;
  const std::vector<std::string>& names_;
  bool single_precision_;
};

}  // namespace treeline
