#include "passes/rewriter.hpp"

#include <utility>

#include "passes/rebuild.hpp"

namespace treeline {

Rewriter::Rewriter(const Program& program)
    : program_(program), rewritten_(without_graph(program)), values_(program.graph.nodes().size()) {
  rewritten_.graph.reserve(program.graph.nodes().size() + program.graph.nodes().size() / 8);
}

Expression Rewriter::copy(std::uint32_t node) const {
  const Node& old = program_.graph.nodes()[node];
  switch (old.op) {
    case Op::constant:
      return {Graph::current().intern(old, program_.graph.rest_of(node)), false};
    case Op::input:
      return Graph::current().input(program_.graph.inputs()[old.a]);
    case Op::add:
      return values_[old.a] + values_[old.b];
    case Op::sub:
      return values_[old.a] - values_[old.b];
    case Op::mul:
      return values_[old.a] * values_[old.b];
    case Op::div:
      return values_[old.a] / values_[old.b];
    case Op::neg:
      return Graph::current().without_sign(-values_[old.a]);
    case Op::sin:
      return sin(values_[old.a]);
    case Op::cos:
      return cos(values_[old.a]);
  }
  return {};
}

void Rewriter::enter(std::uint32_t node) {
  const auto& sections = program_.graph.sections();
  for (; next_section_ < sections.size() && sections[next_section_].first_node <= node;
       ++next_section_) {
    rewritten_.graph.begin_section(sections[next_section_].shared_title);
  }
}

/// Keeps the node's name. If the sign of the value changes back, the prefix `minus_` is removed.
void Rewriter::keep_name(std::uint32_t node) {
  constexpr std::string_view kMinus = "minus_";
  const std::string_view name = program_.graph.names().of(node);
  if (name.empty()) {
    return;
  }
  const Expression value = values_[node];
  if (value.negative() && name.starts_with(kMinus)) {
    rewritten_.graph.name(-value, name.substr(kMinus.size()));
  } else {
    rewritten_.graph.name(value, name);
  }
}

Program Rewriter::finish() {
  for (Result& result : rewritten_.results) {
    for (Expression& element : result.values) {
      const Expression value = values_[element.node()];
      element = element.negative() ? -value : value;
    }
  }
  rewritten_.graph.keep_lanes_of(program_.graph);
  for (std::size_t i = 0; i < program_.graph.lane_group_count(); ++i) {
    rewritten_.graph.add_lane_group(
        program_.graph.lane_group(i),
        [&values = values_](std::uint32_t node) { return values[node].node(); });
  }
  return std::move(rewritten_);
}

}  // namespace treeline
