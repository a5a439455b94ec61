#include <algorithm>
#include <cstring>
#include <stdexcept>
#include <utility>

#include "program/expression.hpp"

namespace treeline {
namespace {

thread_local Graph* open_graph = nullptr;

constexpr std::size_t kChains = 1024;  // for nodes without operands
constexpr std::size_t kSlots = 2;      // per node

std::uint64_t bits(double value) {
  std::uint64_t result = 0;
  std::memcpy(&result, &value, sizeof result);
  return result;
}

std::size_t hash_of(const Node& node) {
  std::uint64_t hash = bits(node.value) ^ (static_cast<std::uint64_t>(node.a) << 32) ^ node.b ^
                       (static_cast<std::uint64_t>(node.op) << 56);
  hash = (hash ^ (hash >> 31)) * 0x9e3779b97f4a7c15U;
  return static_cast<std::size_t>(hash ^ (hash >> 29));
}

bool are_equal(const Node& a, const Node& b) {
  return a.op == b.op && a.a == b.a && a.b == b.b && bits(a.value) == bits(b.value);
}

}  // namespace

Graph::Graph() {
  intern({});
}

Graph Graph::for_trace(int lanes) {
  Graph graph;
  graph.lane_width_ = lanes;
  graph.merges_commuted_ = false;
  return graph;
}

Graph::Scope::Scope(Graph& graph) : previous_(std::exchange(open_graph, &graph)) {}
Graph::Scope::~Scope() {
  open_graph = previous_;
}

Graph& Graph::current() {
  if (open_graph == nullptr) {
    throw std::logic_error("an Expression was used while no Graph::Scope is open");
  }
  return *open_graph;
}

Expression Graph::input(std::string name) {
  const auto found = std::find(inputs_.begin(), inputs_.end(), name);
  const auto index = static_cast<std::uint32_t>(found - inputs_.begin());
  if (found == inputs_.end()) {
    inputs_.push_back(std::move(name));
  }
  return {intern({Op::input, index, 0, 0}), false};
}

std::uint32_t Graph::intern(Node node, double rest) {
  const std::size_t before = nodes_.size();
  const std::uint32_t index = index_.find_or_add(nodes_, node);
  if (rest != 0 && index == before) rests_.emplace_back(index, rest);
  return index;
}

double Graph::rest_of(std::uint32_t node) const {
  const auto found = std::lower_bound(rests_.begin(), rests_.end(), node,
                                      [](const std::pair<std::uint32_t, double>& each,
                                         std::uint32_t at) { return each.first < at; });
  return found != rests_.end() && found->first == node ? found->second : 0;
}

void Graph::name(Expression value, std::string_view identifier) {
  if (nodes_[value.node()].op == Op::constant) {
    return;
  }
  names_.add(value.node(), value.negative() ? "minus_" : "", identifier);
}

Expression Graph::without_sign(Expression value) {
  if (!value.negative()) {
    return value;
  }
  return {intern({Op::neg, value.node(), 0, 0}), false};
}

void Graph::align_lanes(std::span<Expression> values) {
  if (lane_width_ == 1) {
    return;
  }
  for (Expression& value : values) {
    const bool constant = nodes_[value.node()].op == Op::constant;
    if (!constant) {
      value = without_sign(value);
    }
    append_lane(constant ? kNoNode : value.node());
  }
  lane_group_ends_.push_back(lane_group_nodes_.size());
}

/// Appends a place to the group that is being added.
void Graph::append_lane(std::uint32_t node) {
  lane_group_nodes_.push_back(node);
  if (node == kNoNode) return;
  if (node >= lane_group_of_.size()) {
    lane_group_of_.resize(std::max(nodes_.size(), std::size_t{node} + 1), -1);
  }
  int& group = lane_group_of_[node];
  if (group < 0) group = static_cast<int>(lane_group_ends_.size());
}

void Graph::begin_section(SectionTitle title) {
  begin_section(std::make_shared<const SectionTitle>(std::move(title)));
}

void Graph::begin_section(std::shared_ptr<const SectionTitle> title) {
  sections_.push_back({static_cast<std::uint32_t>(nodes_.size()), std::move(title)});
}

// A node with operands is in the chain of the nodes that have the same later operand. Such chains
// are short, and they are in cache, because new nodes mostly use what has just been built. In a
// hash table each node would be somewhere else; waiting for memory took a fifth of the whole time.
// Constants and inputs are in one of `kChains` chains, chosen by their bits. `places_` starts with
// the heads of these chains. Two entries per node follow: the first node of the chain that the node
// heads, and the next node in its own chain.

void NodeIndex::reserve(const std::vector<Node>& nodes, std::size_t count) {
  grow(nodes, kSlots * (std::max(count, nodes.size()) - nodes.size()));
}

std::uint32_t NodeIndex::find_or_add(std::vector<Node>& nodes, const Node& node) {
  if (places_.size() < kChains + kSlots * (nodes.size() + 1)) grow(nodes, places_.size());
  std::uint32_t& place = places_[slot_of(nodes, node)];
  if (place == kNone) {
    place = static_cast<std::uint32_t>(nodes.size());
    nodes.push_back(node);
  }
  return place;
}

/// Index in `places_` at which the node's index is stored, or would be stored.
std::size_t NodeIndex::slot_of(const std::vector<Node>& nodes, const Node& node) const {
  const bool is_leaf = node.op == Op::constant || node.op == Op::input;
  std::size_t slot =
      is_leaf ? hash_of(node) % kChains : kChains + kSlots * std::max(node.a, node.b);
  while (places_[slot] != kNone && !are_equal(nodes[places_[slot]], node)) {
    slot = kChains + kSlots * places_[slot] + 1;
  }
  return slot;
}

/// Makes `places_` large enough for `nodes` and for `slots` further entries, at least those of one
/// node.
void NodeIndex::grow(const std::vector<Node>& nodes, std::size_t slots) {
  const std::size_t wanted = kChains + kSlots * nodes.size() + std::max(slots, kSlots);
  if (places_.size() < wanted) places_.resize(wanted, kNone);
}

}  // namespace treeline
