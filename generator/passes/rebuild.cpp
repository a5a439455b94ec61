#include "passes/rebuild.hpp"

#include <utility>

#include "program/find_sections.hpp"

namespace treeline {
namespace {

std::uint32_t copy_node(const Graph& from, std::uint32_t index,
                        const std::vector<std::uint32_t>& place, Graph& to) {
  Node node = from.nodes()[index];
  if (node.op == Op::input) {
    return to.input(from.inputs()[node.a]).node();
  }
  if (operation(node.op).operands > 0) {
    node.a = place[node.a];
    node.b = place[node.b];
  }
  return to.intern(node, from.rest_of(index));
}

/// Opens a section in `to` if `section` is not the open one.
class SectionWriter {
 public:
  SectionWriter(const Graph& from, Graph& to)
      : from_(from), to_(to), sections_(find_sections(from)) {}

  void enter(std::uint32_t node) {
    const Graph::Section* const section = sections_[node];
    if (operation(from_.nodes()[node].op).operands == 0 || section == open_) {
      return;
    }
    open_ = section;
    if (section == nullptr) {
      to_.begin_section(SectionTitle());
    } else {
      to_.begin_section(section->shared_title);
    }
  }

 private:
  const Graph& from_;
  Graph& to_;
  std::vector<const Graph::Section*> sections_;
  const Graph::Section* open_ = nullptr;
};

}  // namespace

Marks find_live(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  Marks live(nodes.size(), 0);
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) {
      live[value.node()] = 1;
    }
  }
  for (std::size_t i = nodes.size(); i-- > 0;) {
    const int operands = operation(nodes[i].op).operands;
    if (live[i] == 0 || operands == 0) continue;
    live[nodes[i].a] = 1;
    if (operands == 2) live[nodes[i].b] = 1;
  }
  return live;
}

std::vector<int> count_uses(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  const Marks live = find_live(program);
  std::vector<int> uses(nodes.size(), 0);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int operands = operation(nodes[i].op).operands;
    if (live[i] && operands >= 1) {
      ++uses[nodes[i].a];
    }
    if (live[i] && operands == 2) {
      ++uses[nodes[i].b];
    }
  }
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) {
      ++uses[value.node()];
    }
  }
  return uses;
}

Program without_graph(const Program& program) {
  return {program.name,    program.equation, program.route,    program.arguments,
          program.results, Graph(),          program.packs,    program.lane_moves,
          program.order,   program.law,      program.singular, program.constants,
          nullptr,         nullptr};  // loops are of the graph as it was traced
}

Program rebuild(const Program& program, std::span<const std::uint32_t> order) {
  const Graph& from = program.graph;
  Program rebuilt = without_graph(program);
  Graph& to = rebuilt.graph;
  to.reserve(order.size() + 1);
  std::vector<std::uint32_t> place(from.nodes().size(), 0);
  SectionWriter sections(from, to);
  for (const std::uint32_t i : order) {
    sections.enter(i);
    place[i] = copy_node(from, i, place, to);
    if (from.names().contains(i)) to.name({place[i], false}, from.names().of(i));
  }
  to.keep_lanes_of(from);
  for (std::size_t i = 0; i < from.lane_group_count(); ++i) {
    to.add_lane_group(from.lane_group(i), [&place](std::uint32_t node) { return place[node]; });
  }
  for (LanePack& pack : rebuilt.packs) {
    for (std::uint32_t& node : pack) {
      node = place[node];
    }
  }
  for (Result& result : rebuilt.results) {
    for (Expression& value : result.values) {
      value = {place[value.node()], value.negative()};
    }
  }
  return rebuilt;
}

}  // namespace treeline
