#include <map>
#include <utility>

#include "passes/passes.hpp"
#include "passes/rebuild.hpp"

namespace treeline {
namespace {

constexpr int kNoLimb = -1;   // independent of the limb
constexpr int kSeveral = -2;  // depends on more than one limb

/// For families of `limbs` limbs: the node that each node becomes if every limb is exchanged for
/// the next one, and the limb to which each node belongs.
class Exchange {
 public:
  Exchange(const Program& program, std::uint32_t limbs)
      : graph_(program.graph),
        limbs_(limbs),
        image_(graph_.nodes().size(), kNoNode),
        limb_(graph_.nodes().size(), kNoLimb) {
    find_leaves();
    for (std::uint32_t i = 1; i < image_.size(); ++i) {
      const Node& node = graph_.nodes()[i];
      if (operation(node.op).operands > 0) {
        image_[i] = image_of(node);
        limb_[i] = limb_of(node);
      }
    }
  }

  /// Node that takes the place of `node` after the exchange; 0 if there is none.
  [[nodiscard]] std::uint32_t image(std::uint32_t node) const { return image_[node]; }
  [[nodiscard]] int limb(std::uint32_t node) const { return limb_[node]; }

 private:
  void find_leaves() {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> constants;  // slot, limb
    std::map<std::string, std::uint32_t> inputs;
    for (std::uint32_t i = 1; i < image_.size(); ++i) {
      const Node& node = graph_.nodes()[i];
      const LimbConstant own = limb_constant(node);
      if (own.slot != 0) {
        constants.emplace(std::pair{own.slot, own.limb}, i);
      } else if (node.op == Op::input) {
        inputs.emplace(graph_.inputs()[node.a], i);
      }
      image_[i] = operation(node.op).operands == 0 ? i : kNoNode;  // limbs: see below
    }
    for (const auto& [place, node] : constants) {
      const LimbConstant own = limb_constant(graph_.nodes()[node]);
      const auto next = constants.find({own.slot, (own.limb + 1) % own.limbs});
      image_[node] = own.limbs == limbs_ && next != constants.end() ? next->second : kNoNode;
      limb_[node] = static_cast<int>(own.limb);
    }
    for (const Graph::LimbInputs& alike : graph_.limb_inputs()) {
      for (std::size_t k = 0; k < alike.size(); ++k) {
        const auto own = inputs.find(alike[k]);
        const auto next = inputs.find(alike[(k + 1) % alike.size()]);
        if (own != inputs.end()) {
          image_[own->second] =
              alike.size() == limbs_ && next != inputs.end() ? next->second : kNoNode;
          limb_[own->second] = static_cast<int>(k);
        }
      }
    }
  }

  [[nodiscard]] std::uint32_t image_of(const Node& node) const {
    const bool binary = operation(node.op).operands == 2;
    const std::uint32_t a = image_[node.a];
    const std::uint32_t b = binary ? image_[node.b] : kNoNode;
    if (a == kNoNode || (binary && b == kNoNode)) {
      return kNoNode;
    }
    const std::uint32_t straight = graph_.find({node.op, a, b, 0});
    return straight != kNoNode || !operation(node.op).commutes ? straight
                                                               : graph_.find({node.op, b, a, 0});
  }

  [[nodiscard]] int limb_of(const Node& node) const {
    const int a = limb_[node.a];
    const int b = operation(node.op).operands == 2 ? limb_[node.b] : kNoLimb;
    return a == kNoLimb ? b : b == kNoLimb || a == b ? a : kSeveral;
  }

  const Graph& graph_;
  std::uint32_t limbs_;
  std::vector<std::uint32_t> image_;
  std::vector<int> limb_;
};

std::size_t power_of_two(std::uint32_t least) {
  std::size_t places = 1;
  while (places < least) {
    places *= 2;
  }
  return places;
}

void append_groups(const Program& program, std::uint32_t limbs, std::vector<LanePack>& groups) {
  const Exchange exchange(program, limbs);
  const Marks live = find_live(program);
  std::vector<bool> done(live.size(), false);
  for (std::uint32_t i = 1; i < live.size(); ++i) {
    const int operands = operation(program.graph.nodes()[i].op).operands;
    if (!live[i] || done[i] || operands == 0 || exchange.image(i) == i) {
      continue;
    }
    // A value that depends on several limbs takes the place of the first operation found.
    const auto first = exchange.limb(i) >= 0 ? static_cast<std::uint32_t>(exchange.limb(i)) : 0;
    LanePack group(power_of_two(limbs), kNoNode);
    int found = 0;
    std::uint32_t node = i;
    for (std::uint32_t k = 0; k < limbs && node != kNoNode && !done[node]; ++k) {
      done[node] = true;
      if (live[node]) {
        group[(first + k) % limbs] = node;
        ++found;
      }
      node = exchange.image(node);
    }
    if (found > 1) {
      groups.push_back(std::move(group));
    }
  }
}

}  // namespace

std::vector<LanePack> find_isomorphic_operations(const Program& program) {
  std::map<std::uint32_t, bool> sizes;
  for (const Graph::LimbInputs& alike : program.graph.limb_inputs()) {
    sizes[static_cast<std::uint32_t>(alike.size())] = true;
  }
  std::vector<LanePack> groups;
  for (const auto& [limbs, present] : sizes) {
    if (power_of_two(limbs) <= static_cast<std::size_t>(program.graph.lane_width())) {
      append_groups(program, limbs, groups);
    }
  }
  return groups;
}

}  // namespace treeline
