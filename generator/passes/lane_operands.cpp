#include "passes/lane_operands.hpp"

namespace treeline {
namespace {

int likeness(const Graph& graph, std::uint32_t x, std::uint32_t y) {
  if (x == y) {
    return 4;
  }
  if (graph.lane_group_of(x) >= 0 && graph.lane_group_of(x) == graph.lane_group_of(y)) {
    return 3;
  }
  return graph.nodes()[x].op == graph.nodes()[y].op ? 1 : 0;
}

}  // namespace

void lane_operands(const Graph& graph, std::span<const std::uint32_t> lanes,
                   std::span<std::uint32_t> left, std::span<std::uint32_t> right) {
  const Node* first = nullptr;
  for (std::size_t lane = 0; lane < lanes.size(); ++lane) {
    left[lane] = right[lane] = kNoNode;
    if (lanes[lane] == kNoNode) {
      continue;
    }
    Node node = graph.nodes()[lanes[lane]];
    if (first == nullptr) {
      first = &graph.nodes()[lanes[lane]];
    }
    if (operation(node.op).commutes &&
        likeness(graph, node.a, first->b) + likeness(graph, node.b, first->a) >
            likeness(graph, node.a, first->a) + likeness(graph, node.b, first->b)) {
      std::swap(node.a, node.b);
    }
    left[lane] = node.a;
    right[lane] = operation(node.op).operands == 2 ? node.b : kNoNode;
  }
}

LaneOperands lane_operands(const Graph& graph, const LanePack& lanes) {
  LaneOperands operands{LanePack(lanes.size(), kNoNode), LanePack(lanes.size(), kNoNode)};
  lane_operands(graph, lanes, operands.a, operands.b);
  return operands;
}

}  // namespace treeline
