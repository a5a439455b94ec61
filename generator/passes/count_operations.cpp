#include "passes/count_operations.hpp"

#include <cstdint>

#include "passes/rebuild.hpp"
#include "program/ending.hpp"
#include "program/link_loops.hpp"

namespace treeline {
namespace {

/// Adds the operation of `node` to `count`. `angle_seen` marks the angles that have been counted.
void count_node(const Node& node, Marks& angle_seen, OperationCount& count) {
  switch (node.op) {
    case Op::add:
    case Op::sub:
      ++count.add;
      break;
    case Op::mul:
      ++count.mul;
      break;
    case Op::div:
      ++count.div;
      break;
    case Op::sin:
    case Op::cos:
      count.sin_cos += angle_seen[node.a] != 0 ? 0 : 1;
      angle_seen[node.a] = 1;
      break;
    case Op::neg:  // flips a bit, as does the sign of a result
    case Op::constant:
    case Op::input:
      break;
  }
}

}  // namespace

OperationCount count_operations(const Program& program) {
  if (program.loops) {
    const LinkLoops& loops = *program.loops;
    return {loops.adds, loops.muls, loops.divs, loops.sines};
  }
  if (program.ending) {
    OperationCount total = count_operations(program.ending->lines);
    const OperationCount& executed = program.ending->executed;
    total.add += executed.add;
    total.mul += executed.mul;
    total.div += executed.div;
    return total;
  }
  const std::vector<Node>& nodes = program.graph.nodes();
  Marks live(nodes.size(), 0), angle_seen(nodes.size(), 0);
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) live[value.node()] = 1;
  }
  OperationCount total;
  for (std::size_t i = nodes.size(); i-- > 0;) {  // users before their operands
    const int operands = operation(nodes[i].op).operands;
    if (live[i] == 0 || operands == 0) continue;
    live[nodes[i].a] = 1;
    if (operands == 2) live[nodes[i].b] = 1;
    count_node(nodes[i], angle_seen, total);
  }
  return total;
}

}  // namespace treeline
