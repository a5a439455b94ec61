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
      return limb_constant(old).slot == 0 ? Expression(old.value)
                                          : Expression(Graph::current().intern(old), false);
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
    rewritten_.graph.begin_section(sections[next_section_].title);
  }
}

/// Keeps the node's name. If the sign of the value changes back, the prefix `minus_` is removed.
void Rewriter::keep_name(std::uint32_t node) {
  constexpr std::string_view kMinus = "minus_";
  const auto found = program_.graph.names().find(node);
  if (found == program_.graph.names().end()) {
    return;
  }
  const Expression value = values_[node];
  const std::string_view name = found->second;
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
  for (Graph::LaneGroup group : program_.graph.lane_groups()) {
    for (std::uint32_t& node : group) {
      node = values_[node].node();
    }
    rewritten_.graph.add_lane_group(std::move(group));
  }
  return std::move(rewritten_);
}

}  // namespace treeline
