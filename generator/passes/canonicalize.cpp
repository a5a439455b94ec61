#include <utility>
#include <vector>

#include "passes/passes.hpp"
#include "passes/rebuild.hpp"
#include "passes/rewriter.hpp"

namespace treeline {
namespace {

/// Orders the live nodes: operands before users, left before right, in the order of the results.
std::vector<std::uint32_t> order_by_depth(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  std::vector<bool> placed(nodes.size(), false);
  std::vector<std::uint32_t> order;
  std::vector<std::pair<std::uint32_t, bool>> stack;
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) {
      stack.emplace_back(value.node(), false);
      while (!stack.empty()) {
        const auto [node, operands_done] = stack.back();
        stack.pop_back();
        if (placed[node]) {
          continue;
        }
        if (operands_done) {
          placed[node] = true;
          order.push_back(node);
          continue;
        }
        stack.emplace_back(node, true);
        const int operands = operation(nodes[node].op).operands;
        if (operands == 2) {
          stack.emplace_back(nodes[node].b, false);
        }
        if (operands >= 1) {
          stack.emplace_back(nodes[node].a, false);
        }
      }
    }
  }
  return order;
}

}  // namespace

Program canonicalize(const Program& program) {
  const Program ordered = rebuild(program, order_by_depth(program));
  return eliminate_dead(
      Rewriter(ordered).run([](std::uint32_t node, const Rewriter& r) { return r.copy(node); }));
}

Program eliminate_dead(const Program& program) {
  const Marks live = find_live(program);
  std::vector<std::uint32_t> order;
  for (std::uint32_t i = 0; i < live.size(); ++i) {
    if (live[i]) {
      order.push_back(i);
    }
  }
  return rebuild(program, order);
}

}  // namespace treeline
