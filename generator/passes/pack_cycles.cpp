#include "passes/pack_cycles.hpp"

namespace treeline {

PackCycles::PackCycles(const std::vector<Node>& nodes, const std::vector<LanePack>& packs,
                       const std::vector<int>& pack_of)
    : nodes_(nodes), packs_(packs), pack_of_(pack_of), state_(nodes.size(), State::unseen) {}

std::optional<std::size_t> PackCycles::next() {
  Stack stack;
  for (; root_ < nodes_.size(); ++root_) {
    stack.emplace_back(root_, false);
    while (!stack.empty()) {
      const auto [node, finished] = stack.back();
      stack.pop_back();
      if (finished) {
        close(node);
      } else if (state_[node] == State::open) {
        const std::size_t pack = open_packs_.back();
        forget_open();
        return pack;
      } else if (state_[node] == State::unseen) {
        open(node, stack);
      }
    }
  }
  return std::nullopt;
}

/// Calls `visit` for each node that is computed together with `node`, and for `node` itself.
template <class Visit>
void PackCycles::for_each_in_unit(std::uint32_t node, Visit visit) const {
  if (pack_of_[node] == kNoPack) {
    visit(node);
    return;
  }
  for (const std::uint32_t member : packs_[static_cast<std::size_t>(pack_of_[node])]) {
    if (member != 0) visit(member);  // 0 is an empty lane
  }
}

void PackCycles::open(std::uint32_t node, Stack& stack) {
  open_units_.push_back(node);
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

void PackCycles::close(std::uint32_t node) {
  for_each_in_unit(node, [&](std::uint32_t member) { state_[member] = State::done; });
  open_units_.pop_back();
  if (pack_of_[node] != kNoPack) open_packs_.pop_back();
}

/// Units that are done stay as they are: no cycle passes through them, and packs are only taken
/// apart.
void PackCycles::forget_open() {
  for (const std::uint32_t node : open_units_) {
    for_each_in_unit(node, [&](std::uint32_t member) { state_[member] = State::unseen; });
  }
  open_units_.clear();
  open_packs_.clear();
}

}  // namespace treeline
