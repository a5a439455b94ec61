#include "emission/print_expression.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace treeline {
bool ExpressionPrinter::is_atom(std::uint32_t node) const {
  return operation(graph_.nodes()[node].op).operands == 0 || !names_[node].empty();
}

std::string ExpressionPrinter::reference(std::uint32_t node) const {
  const Node& what = graph_.nodes()[node];
  if (what.op == Op::constant && names_[node].empty()) {
    const std::string text = syntax_.literal(what.value);
    return what.value < 0 ? fmt::format("({})", text) : text;
  }
  if (what.op == Op::input) {
    return graph_.inputs()[what.a];
  }
  return names_[node].empty() ? formula(node) : names_[node];
}

std::string ExpressionPrinter::atom(std::uint32_t node) const {
  return is_atom(node) ? reference(node) : fmt::format("({})", reference(node));
}

/// Languages group a + b + c as (a + b) + c and binds * and / tighter: all else needs parentheses.
std::string ExpressionPrinter::operand(std::uint32_t node, Op user, bool is_right) const {
  const std::string text = reference(node);
  const bool user_is_sum = is_sum(user);
  const bool own_is_sum = is_sum(graph_.nodes()[node].op);
  const bool loose = user_is_sum && !own_is_sum && syntax_.parentheses == Parentheses::needed;
  const bool alike = user_is_sum == own_is_sum && !is_right;
  const bool binds = is_atom(node) || (syntax_.parentheses != Parentheses::all && (loose || alike));
  return binds ? text : fmt::format("({})", text);
}

std::string ExpressionPrinter::formula(std::uint32_t node) const {
  const Node& what = graph_.nodes()[node];
  if (what.op == Op::neg) {
    return fmt::format("{}{}", syntax_.sign(what.op), atom(what.a));
  }
  if (operation(what.op).operands != 2) {
    throw std::logic_error("only operations with two operands are printed as formulas");
  }
  return fmt::format("{} {} {}", operand(what.a, what.op, false), syntax_.sign(what.op),
                     operand(what.b, what.op, true));
}

std::string ExpressionPrinter::signed_reference(Expression value) const {
  const std::string text = reference(value.node());
  if (!value.negative()) {
    return text;
  }
  const std::string_view minus = syntax_.sign(Op::neg);
  return is_atom(value.node()) ? fmt::format("{}{}", minus, text)
                               : fmt::format("{}({})", minus, text);
}

}  // namespace treeline
