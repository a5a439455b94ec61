#include "passes/pack_cycles.hpp"

#include <utility>

namespace treeline {
namespace {

using Stack = std::vector<std::pair<std::uint32_t, bool>>;  // node, whether its operands are done

/// Depth-first over units, packs and single nodes; meeting an open one again closes a cycle. The
/// graph itself has none, so the pack opened last is on it.
class CycleSearch {
 public:
  CycleSearch(const std::vector<Node>& nodes, const std::vector<LanePack>& packs,
              const std::vector<int>& pack_of)
      : nodes_(nodes), packs_(packs), pack_of_(pack_of), state_(nodes.size(), State::unseen) {}

  std::optional<std::size_t> run() {
    Stack stack;
    for (std::uint32_t root = 0; root < nodes_.size(); ++root) {
      stack.emplace_back(root, false);
      while (!stack.empty()) {
        const auto [node, finished] = stack.back();
        stack.pop_back();
        if (finished) {
          close(node);
        } else if (state_[node] == State::open) {
          return open_packs_.back();
        } else if (state_[node] == State::unseen) {
          open(node, stack);
        }
      }
    }
    return std::nullopt;
  }

 private:
  enum class State : char { unseen, open, done };

  /// The nodes that are computed together with `node`, itself included.
  template <class Visit>
  void for_each_in_unit(std::uint32_t node, Visit visit) const {
    if (pack_of_[node] == kNoPack) {
      visit(node);
      return;
    }
    for (const std::uint32_t member : packs_[static_cast<std::size_t>(pack_of_[node])]) {
      if (member != 0) visit(member);  // else an empty lane
    }
  }

  void open(std::uint32_t node, Stack& stack) {
    if (pack_of_[node] != kNoPack) {
      open_packs_.push_back(static_cast<std::size_t>(pack_of_[node]));
    }
    stack.emplace_back(node, true);
    for_each_in_unit(node, [&](std::uint32_t member) {
      state_[member] = State::open;
      const int operands = operation(nodes_[member].op).operands;
      if (operands >= 1) stack.emplace_back(nodes_[member].a, false);
      if (operands == 2) stack.emplace_back(nodes_[member].b, false);
    });
  }

  void close(std::uint32_t node) {
    for_each_in_unit(node, [&](std::uint32_t member) { state_[member] = State::done; });
    if (pack_of_[node] != kNoPack) open_packs_.pop_back();
  }

  const std::vector<Node>& nodes_;
  const std::vector<LanePack>& packs_;
  const std::vector<int>& pack_of_;
  std::vector<State> state_;
  std::vector<std::size_t> open_packs_;
};

}  // namespace

std::optional<std::size_t> find_pack_on_cycle(const std::vector<Node>& nodes,
                                              const std::vector<LanePack>& packs,
                                              const std::vector<int>& pack_of) {
  return CycleSearch(nodes, packs, pack_of).run();
}

}  // namespace treeline
