#include <algorithm>
#include <cstdlib>
#include <vector>

#include "board/measure_objects.hpp"

namespace treeline {
namespace {

/// The quoted text behind `key` in a line; empty if there is none.
std::string_view quoted(std::string_view line, std::string_view key) {
  const std::size_t begin = line.find(key);
  if (begin == std::string_view::npos) return {};
  const std::size_t open = line.find('"', begin + key.size());
  const std::size_t close = line.find('"', open + 1);
  if (open == std::string_view::npos || close == std::string_view::npos) return {};
  return line.substr(open + 1, close - open - 1);
}

/// Bytes in a label such as `f()\nfile.cpp:3:5\n24 bytes (static)`. Stack that is not bounded, as
/// arrays of variable length need, counts as unknown.
std::optional<int> bytes_in(std::string_view label) {
  constexpr std::string_view kUnit = " bytes (";
  const std::size_t unit = label.find(kUnit);
  if (unit == std::string_view::npos) return std::nullopt;
  const std::string_view kind = label.substr(unit + kUnit.size());
  if (!kind.starts_with("static)") && !kind.starts_with("dynamic,bounded)")) return std::nullopt;
  const std::size_t before = label.rfind("\\n", unit);
  const std::size_t begin = before == std::string_view::npos ? 0 : before + 2;
  return std::atoi(std::string(label.substr(begin, unit - begin)).c_str());
}

class Sum {
 public:
  explicit Sum(const CallGraph& graph) : graph_(graph) {}

  /// Bytes from this function on; absent if it calls itself.
  std::optional<int> of(const std::string& symbol) {
    if (const auto known = known_.find(symbol); known != known_.end()) return known->second;
    if (std::find(path_.begin(), path_.end(), symbol) != path_.end()) return std::nullopt;
    path_.push_back(symbol);
    const std::optional<int> bytes = add(symbol);
    path_.pop_back();
    known_[symbol] = bytes;
    return bytes;
  }

  std::set<std::string> unknown;

 private:
  std::optional<int> add(const std::string& symbol) {
    const auto found = graph_.functions.find(symbol);
    if (found == graph_.functions.end() || !found->second.own_bytes) {
      unknown.insert(symbol);
      return 0;
    }
    int deepest = 0;
    for (const std::string& called : found->second.calls) {
      const std::optional<int> below = of(called);
      if (!below) return std::nullopt;
      deepest = std::max(deepest, *below);
    }
    return *found->second.own_bytes + deepest;
  }

  const CallGraph& graph_;
  std::map<std::string, std::optional<int>> known_;
  std::vector<std::string> path_;
};

}  // namespace

void read_call_graph(std::string_view text, CallGraph& graph) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    if (line.starts_with("node:")) {
      CallGraph::Node& node = graph.functions[std::string(quoted(line, "title:"))];
      const std::optional<int> bytes = bytes_in(quoted(line, "label:"));
      if (bytes) node.own_bytes = bytes;
    } else if (line.starts_with("edge:")) {
      graph.functions[std::string(quoted(line, "sourcename:"))].calls.emplace(
          quoted(line, "targetname:"));
    }
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

StackUse add_stack(const CallGraph& graph, const std::string& symbol) {
  Sum sum(graph);
  StackUse use;
  use.bytes = sum.of(symbol);
  use.unknown = std::move(sum.unknown);
  return use;
}

}  // namespace treeline
