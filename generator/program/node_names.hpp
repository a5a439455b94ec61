#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace treeline {

/// Names of nodes. Every pass copies them, so all lie in one text.
class NodeNames {
 public:
  [[nodiscard]] bool contains(std::uint32_t node) const {
    return node < places_.size() && places_[node].length > 0;
  }
  /// Name of the node; empty if it has none. Valid until a name is added.
  [[nodiscard]] std::string_view of(std::uint32_t node) const {
    if (!contains(node)) return {};
    return std::string_view(text_).substr(places_[node].begin, places_[node].length);
  }
  /// Calls the node `prefix` and `name`, unless it has a name.
  void add(std::uint32_t node, std::string_view prefix, std::string_view name) {
    if (contains(node)) return;
    if (node >= places_.size()) places_.resize(std::size_t{node} + 1);
    places_[node] = {static_cast<std::uint32_t>(text_.size()),
                     static_cast<std::uint32_t>(prefix.size() + name.size())};
    text_.append(prefix).append(name);
    ++size_;
  }
  /// Number of nodes that have a name.
  [[nodiscard]] std::size_t size() const { return size_; }

 private:
  struct Place {
    std::uint32_t begin = 0, length = 0;
  };
  std::vector<Place> places_;  // by node
  std::string text_;
  std::size_t size_ = 0;
};

}  // namespace treeline
