#include <algorithm>
#include <utility>
#include <vector>

#include "passes/passes.hpp"
#include "passes/rebuild.hpp"

namespace treeline {
namespace {

/// Estimates the number of registers that each node's expression tree needs if nothing is shared
/// (Sethi & Ullman 1970).
std::vector<int> estimate_registers(const std::vector<Node>& nodes) {
  std::vector<int> need(nodes.size(), 1);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    const int operands = operation(nodes[i].op).operands;
    if (operands == 1) {
      need[i] = need[nodes[i].a];
    } else if (operands == 2) {
      const int a = need[nodes[i].a];
      const int b = need[nodes[i].b];
      need[i] = a == b ? a + 1 : std::max(a, b);
    }
  }
  return need;
}

class Scheduler {
 public:
  explicit Scheduler(const Program& program)
      : nodes_(program.graph.nodes()),
        need_(estimate_registers(nodes_)),
        placed_(nodes_.size(), 0),
        pack_of_(nodes_.size(), nullptr) {
    for (const LanePack& pack : program.packs) {
      for (const std::uint32_t node : pack) {
        if (node != kNoNode) pack_of_[node] = &pack;
      }
    }
  }

  /// Places `root` after all operands that are not placed yet.
  void place(std::uint32_t root) {
    stack_.emplace_back(root, false);
    while (!stack_.empty()) {
      const auto [node, operands_done] = stack_.back();
      stack_.pop_back();
      if (placed_[node] != 0) {
        continue;
      }
      if (operands_done) {
        for_each_in_unit(node, [this](std::uint32_t member) {
          placed_[member] = 1;
          order_.push_back(member);
        });
        continue;
      }
      stack_.emplace_back(node, true);
      for_each_in_unit(node, [this](std::uint32_t member) { push_operands(nodes_[member]); });
    }
  }

  [[nodiscard]] const std::vector<std::uint32_t>& order() const { return order_; }

 private:
  /// Calls `visit` for the node, or for all of its pack: the lanes of a pack are computed together,
  /// after all their operands.
  template <class Visit>
  void for_each_in_unit(std::uint32_t node, Visit visit) const {
    if (pack_of_[node] == nullptr) {
      visit(node);
      return;
    }
    for (const std::uint32_t member : *pack_of_[node]) {
      if (member != kNoNode) visit(member);
    }
  }

  void push_operands(const Node& node) {
    const int operands = operation(node.op).operands;
    if (operands == 1) {
      stack_.emplace_back(node.a, false);
    } else if (operands == 2) {
      const bool a_first = need_[node.a] >= need_[node.b];
      stack_.emplace_back(a_first ? node.b : node.a, false);
      stack_.emplace_back(a_first ? node.a : node.b, false);
    }
  }

  const std::vector<Node>& nodes_;
  std::vector<int> need_;
  Marks placed_;
  std::vector<const LanePack*> pack_of_;               // by node; null for a single node
  std::vector<std::pair<std::uint32_t, bool>> stack_;  // node, whether its operands are done
  std::vector<std::uint32_t> order_;
};

/// Finds the live sines and cosines whose angles do not depend on another sine or cosine, in order
/// of creation.
std::vector<std::uint32_t> find_outer_trigonometry(const Program& program) {
  const std::vector<Node>& nodes = program.graph.nodes();
  const Marks live = find_live(program);
  std::vector<bool> depends(nodes.size(), false);
  std::vector<std::uint32_t> found;
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    const int operands = operation(nodes[i].op).operands;
    depends[i] = (operands >= 1 && depends[nodes[i].a]) || (operands == 2 && depends[nodes[i].b]);
    if (is_trigonometric(nodes[i].op)) {
      if (live[i] && !depends[i]) {
        found.push_back(i);
      }
      depends[i] = true;
    }
  }
  return found;
}

}  // namespace

Program schedule(const Program& program) {
  Scheduler scheduler(program);
  const std::vector<std::uint32_t> trigonometry = find_outer_trigonometry(program);
  for (const std::uint32_t node : trigonometry) {
    scheduler.place(program.graph.nodes()[node].a);
  }
  for (const std::uint32_t node : trigonometry) {
    scheduler.place(node);
  }
  const std::size_t head = scheduler.order().size();
  for (const ResultPlace& place : program.order) {
    scheduler.place(program.results[place.result].values[place.entry].node());
  }
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) {
      scheduler.place(value.node());
    }
  }
  return rebuild(program, interleave(program, scheduler.order(), head));
}

}  // namespace treeline
