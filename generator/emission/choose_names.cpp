#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "emission/body_steps.hpp"
#include "text/identifier.hpp"

namespace treeline {
namespace {

std::string make_unique(std::string name, std::set<std::string>& taken) {
  const std::string stem = name;
  for (int i = 2; !taken.insert(name).second; ++i) {
    name = fmt::format("{}_{}", stem, i);
  }
  return name;
}

/// The name of an element of a result: `tau_2`, `M_0_3`.
std::string element_name(const Argument& argument, std::size_t element) {
  const auto cols = static_cast<std::size_t>(argument.cols);
  return cols == 1 ? fmt::format("{}_{}", argument.name, element)
                   : fmt::format("{}_{}_{}", argument.name, element / cols, element % cols);
}

/// `sin_q_2` for the sine of an input or of an angle with a name; else empty.
std::string trigonometric_name(const Graph& graph, const Node& node,
                               const std::vector<std::string>& names) {
  if (operation(node.op).operands != 1) {
    return "";
  }
  const Node& angle = graph.nodes()[node.a];
  const std::string what = angle.op == Op::input ? graph.inputs()[angle.a] : names[node.a];
  return what.empty() ? "" : make_identifier(fmt::format("{} {}", operation(node.op).name, what));
}

/// Finds names of nodes: from the trace, as sine or cosine of an angle or of a sum of angles, or as
/// a result; empty for nodes without one.
std::vector<std::string> find_own_names(const Program& program) {
  const Graph& graph = program.graph;
  std::vector<std::string> names = find_angle_sums(program);
  for (const Result& result : program.results) {
    for (std::size_t i = 0; i < result.values.size(); ++i) {
      std::string& name = names[result.values[i].node()];
      name = name.empty() ? element_name(result.argument, i) : name;
    }
  }
  for (std::uint32_t i = 0; i < names.size(); ++i) {
    if (graph.names().contains(i)) {
      names[i] = make_identifier(std::string(graph.names().of(i)));
    } else if (names[i].empty()) {
      names[i] = trigonometric_name(graph, graph.nodes()[i], names);
    }
  }
  return names;
}

/// A name in three parts, `f`, `13`, `_x`: the number is the first in it.
struct NumberedName {
  explicit NumberedName(const std::string& name) {
    const auto is_digit = [](unsigned char c) { return std::isdigit(c) != 0; };
    const auto begin = std::find_if(name.begin(), name.end(), is_digit);
    const auto end = std::find_if_not(begin, name.end(), is_digit);
    symbol.assign(name.begin(), begin);
    number.assign(begin, end);
    rest.assign(end, name.end());
  }
  std::string symbol, number, rest;
};

/// One name for the lanes of a pack: `f8_15_x` for `f8_x` and `f15_x`. Empty where they do not
/// differ in their first number alone.
std::string join_lane_names(const std::vector<std::string>& lanes) {
  const NumberedName first(lanes.front());
  std::string numbers = first.number;
  for (std::size_t i = 1; i < lanes.size(); ++i) {
    const NumberedName lane(lanes[i]);
    const bool is_alike = lane.symbol == first.symbol && lane.rest == first.rest;
    if (!is_alike || lane.number.empty() || lane.number == first.number) return "";
    numbers += "_" + lane.number;
  }
  return first.symbol + numbers + first.rest;
}

/// Leaves a pack one name, that of its first node.
void name_packs(const Program& program, std::vector<std::string>& names,
                std::vector<bool>& wanted) {
  for (const LanePack& pack : program.packs) {
    LanePack nodes = pack;
    std::erase(nodes, kNoNode);
    std::vector<std::string> lanes;
    for (const std::uint32_t node : nodes) {
      lanes.push_back(std::exchange(names[node], ""));
      wanted[node] = false;
    }
    const std::uint32_t first = *std::min_element(nodes.begin(), nodes.end());
    names[first] = join_lane_names(lanes);
    wanted[first] = true;
  }
}

}  // namespace

std::string make_identifier(std::string_view text) {
  std::string name;
  for (const char c : text) {
    const bool plain = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (plain) {
      name += c;
    } else if (!name.empty() && name.back() != '_') {
      name += '_';
    }
  }
  while (!name.empty() && name.back() == '_') {
    name.pop_back();
  }
  if (name.empty() || std::isdigit(static_cast<unsigned char>(name.front())) != 0) {
    name = std::string("v").append(name);
  }
  return is_identifier(name) ? name : name + "_value";
}

std::map<std::uint32_t, std::string> name_constants(const Program& program,
                                                    std::set<std::string>& taken) {
  std::map<std::uint32_t, std::string> names;
  if (program.constants == nullptr) return names;
  const std::vector<Node>& nodes = program.graph.nodes();
  for (std::uint32_t i = 0; i < nodes.size(); ++i) {
    if (nodes[i].op != Op::constant) continue;
    const auto known = program.constants->find(nodes[i].value);
    if (known == program.constants->end()) continue;
    names[i] = make_unique(make_identifier(known->second), taken);
  }
  return names;
}

std::vector<std::string> choose_names(const Program& program, std::vector<bool> wanted,
                                      std::set<std::string> reserved) {
  std::vector<std::string> names = find_own_names(program);
  name_packs(program, names, wanted);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!wanted[i]) {
      names[i].clear();
    } else if (!names[i].empty()) {  // all of these before any neutral name is given
      names[i] = make_unique(names[i], reserved);
    }
  }
  int count = 0;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (wanted[i] && names[i].empty())
      names[i] = make_unique(fmt::format("t{}", ++count), reserved);
  }
  return names;
}

}  // namespace treeline
