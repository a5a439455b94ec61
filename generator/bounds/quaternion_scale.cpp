#include "bounds/quaternion_scale.hpp"

#include <set>
#include <string>
#include <vector>

#include "functions/quantity.hpp"

namespace treeline::bounds {
namespace {

/// Appends the terms of a sum, including those of its operands that are sums.
void append_terms(const Graph& graph, std::uint32_t node, std::vector<std::uint32_t>& terms) {
  const Node& n = graph.nodes()[node];
  if (n.op != Op::add) {
    terms.push_back(node);
    return;
  }
  append_terms(graph, n.a, terms);
  append_terms(graph, n.b, terms);
}

}  // namespace

bool is_quaternion_scale(const Graph& graph, std::uint32_t node) {
  constexpr double kSmallest = 0x1p-90;
  const Node& n = graph.nodes()[node];
  if (n.op != Op::div || graph.nodes()[n.a].op != Op::constant || graph.nodes()[n.a].value != 2) {
    return false;
  }
  std::vector<std::uint32_t> terms;
  append_terms(graph, n.b, terms);
  std::set<std::uint32_t> squared;
  int constants = 0;
  for (const std::uint32_t i : terms) {
    const Node& term = graph.nodes()[i];
    if (term.op == Op::constant && term.value > 0 && term.value < kSmallest) {
      ++constants;
      continue;
    }
    const bool square = term.op == Op::mul && term.a == term.b;
    if (!square || graph.nodes()[term.a].op != Op::input) return false;
    const std::string& name = graph.inputs()[graph.nodes()[term.a].a];
    const auto quantity = quantity_of_input(name);
    if (quantity != Quantity::q && quantity != Quantity::tool_orientation) return false;
    squared.insert(term.a);
  }
  return squared.size() == 4 && constants == 1 && terms.size() == 5;
}

}  // namespace treeline::bounds
