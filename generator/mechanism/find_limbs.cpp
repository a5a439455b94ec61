#include "mechanism/find_limbs.hpp"

#include <fmt/format.h>

#include <map>
#include <string>
#include <utility>

namespace treeline {
namespace {

/// A subtree as text, which is equal for subtrees of one shape, and its links in the order of that
/// text.
struct Subtree {
  std::string shape;
  std::vector<int> links;
};

using Children = std::vector<std::vector<int>>;  // by link; those of the world come last

Children find_children(const Mechanism& mechanism) {
  const std::size_t count = mechanism.links.size();
  Children children(count + 1);
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = mechanism.links[i].parent;
    children[parent < 0 ? count : static_cast<std::size_t>(parent)].push_back(static_cast<int>(i));
  }
  return children;
}

Subtree subtree_at(const Mechanism& mechanism, const Children& children, int root) {
  const auto index = static_cast<std::size_t>(root);
  const MovingLink& link = mechanism.links[index];
  const std::string ball =
      link.is_of_ball() ? fmt::format("b{}", static_cast<int>(link.ball)) : std::string();
  Subtree subtree{fmt::format("({}{}{}", static_cast<int>(link.kind), ball, link.mimics ? "m" : ""),
                  {root}};
  for (const int child : children[index]) {
    const Subtree inner = subtree_at(mechanism, children, child);
    subtree.shape += inner.shape;
    subtree.links.insert(subtree.links.end(), inner.links.begin(), inner.links.end());
  }
  subtree.shape += ")";
  return subtree;
}

/// Appends the families among the children of a link, then those farther out.
void append_families(const Mechanism& mechanism, const Children& children, std::size_t parent,
                     std::size_t most, std::vector<LimbFamily>& families) {
  if (children[parent].size() == 1) {  // alone, whatever its shape
    const auto only = static_cast<std::size_t>(children[parent].front());
    return append_families(mechanism, children, only, most, families);
  }
  std::map<std::string, LimbFamily> by_shape;
  for (const int child : children[parent]) {
    Subtree subtree = subtree_at(mechanism, children, child);
    by_shape[subtree.shape].limbs.push_back(std::move(subtree.links));
  }
  for (const auto& [shape, family] : by_shape) {
    if (family.limbs.size() > 1 && family.limbs.size() <= most) {
      families.push_back(family);
      continue;
    }
    for (const std::vector<int>& limb : family.limbs) {
      append_families(mechanism, children, static_cast<std::size_t>(limb.front()), most, families);
    }
  }
}

}  // namespace

std::vector<LimbFamily> find_limbs(const Mechanism& mechanism, int most) {
  std::vector<LimbFamily> families;
  append_families(mechanism, find_children(mechanism), mechanism.links.size(),
                  static_cast<std::size_t>(most), families);
  return families;
}

}  // namespace treeline
