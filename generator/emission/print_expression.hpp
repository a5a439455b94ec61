#pragma once

#include <string>
#include <vector>

#include "emission/syntax.hpp"
#include "program/program.hpp"

namespace treeline {

/// Prints nodes as expressions of a language in which + - * / bind as they do in C.
class ExpressionPrinter {
 public:
  /// `names` as from `choose_names`: a node with a name is referred to by it.
  ExpressionPrinter(const Graph& graph, const std::vector<std::string>& names, const Syntax& syntax)
      : graph_(graph), names_(names), syntax_(syntax) {}

  /// How an expression refers to the node's value: its name, an input, a literal, or its formula
  /// where it has no name.
  [[nodiscard]] std::string reference(std::uint32_t node) const;

  /// How an expression refers to the node as a factor: its `reference`, a formula in parentheses.
  [[nodiscard]] std::string atom(std::uint32_t node) const;

  /// The operation itself, with parentheses so that it is evaluated exactly as the graph has it.
  [[nodiscard]] std::string formula(std::uint32_t node) const;

  /// The value with its sign.
  [[nodiscard]] std::string signed_reference(Expression value) const;

  [[nodiscard]] const Syntax& syntax() const { return syntax_; }

 private:
  [[nodiscard]] bool is_atom(std::uint32_t node) const;
  [[nodiscard]] std::string operand(std::uint32_t node, Op user, bool is_right) const;

  const Graph& graph_;
  const std::vector<std::string>& names_;
  const Syntax& syntax_;
};

}  // namespace treeline
