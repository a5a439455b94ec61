#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <stdexcept>

#include "program/expression.hpp"
#include "program/hash_word.hpp"

namespace treeline {

/// Number of lanes that hold a node.
inline int count_lanes(std::span<const std::uint32_t> lanes) {
  return static_cast<int>(lanes.size()) -
         static_cast<int>(std::count(lanes.begin(), lanes.end(), kNoNode));
}

inline constexpr std::size_t kMostLanes = 8;  // that a scene may ask for

/// Nodes by lane, as in a LanePack, but without memory of their own: there are several for every
/// operation that is tried in lanes.
class Lanes {
 public:
  Lanes() = default;
  explicit Lanes(std::size_t width) : size_(width) {
    if (width > kMostLanes) throw std::logic_error("more lanes than a register has");
  }
  explicit Lanes(std::span<const std::uint32_t> nodes) : Lanes(nodes.size()) {
    std::copy(nodes.begin(), nodes.end(), nodes_.begin());
  }

  [[nodiscard]] const std::uint32_t* begin() const { return nodes_.data(); }
  [[nodiscard]] const std::uint32_t* end() const { return nodes_.data() + size_; }
  [[nodiscard]] std::uint32_t* begin() { return nodes_.data(); }
  [[nodiscard]] std::uint32_t* end() { return nodes_.data() + size_; }
  [[nodiscard]] std::size_t size() const { return size_; }
  [[nodiscard]] std::uint32_t& operator[](std::size_t lane) { return nodes_[lane]; }
  [[nodiscard]] std::uint32_t operator[](std::size_t lane) const { return nodes_[lane]; }
  bool operator==(const Lanes&) const = default;

 private:
  std::array<std::uint32_t, kMostLanes> nodes_{};  // those beyond `size_` are kNoNode
  std::size_t size_ = 0;
};

/// Whether `pack` holds these nodes as they are to be read: as many lanes, and each node in its
/// place. Limbs of several numbers make packs of several widths, and no expression mixes these.
inline bool stands_in_place(std::span<const std::uint32_t> nodes,
                            std::span<const std::uint32_t> pack) {
  return std::equal(
      nodes.begin(), nodes.end(), pack.begin(), pack.end(),
      [](std::uint32_t node, std::uint32_t held) { return node == kNoNode || node == held; });
}

/// Returns the values in the lanes, each once.
inline Lanes distinct(const Lanes& lanes) {
  Lanes places(lanes.size());
  std::size_t count = 0;
  for (const std::uint32_t node : lanes) {
    const auto* const last = places.begin() + count;
    if (node != kNoNode && std::find(places.begin(), places.begin() + count, node) == last) {
      places[count++] = node;
    }
  }
  return Lanes(std::span<const std::uint32_t>(places).first(count));
}

/// For maps by `Lanes`.
struct HashOfLanes {
  std::size_t operator()(const Lanes& lanes) const {
    std::uint64_t hash = lanes.size();
    for (const std::uint32_t node : lanes) hash = hash_word(hash, node);
    return static_cast<std::size_t>(hash);
  }
};

}  // namespace treeline
