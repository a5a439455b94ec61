#include <algorithm>
#include <vector>

#include "passes/passes.hpp"
#include "passes/rebuild.hpp"

namespace treeline {
namespace {

int latency(Op op) {
  switch (op) {
    case Op::add:
    case Op::sub:
    case Op::mul:
      return 3;
    case Op::div:
      return 13;
    case Op::sin:
    case Op::cos:
    case Op::neg:
    case Op::constant:
    case Op::input:
      break;
  }
  return 0;
}

}  // namespace

int critical_path(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  const Marks live = find_live(program);
  std::vector<int> done(nodes.size(), 0);  // cycle in which each value is ready
  int longest = 0;
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (!live[i]) continue;
    const Node& node = nodes[i];
    const int operands = operation(node.op).operands;
    int start = operands > 0 ? done[node.a] : 0;
    if (operands > 1) start = std::max(start, done[node.b]);
    done[i] = start + latency(node.op);
    longest = std::max(longest, done[i]);
  }
  return longest;
}

}  // namespace treeline
