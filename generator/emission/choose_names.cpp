#include "emission/choose_names.hpp"

#include <fmt/format.h>

#include <cctype>
#include <map>
#include <utility>

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

/// What a part of this element of a result is called after: `tau_2`, `M_0_3`.
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

/// For every node the name it has by itself: from the trace, of its angle, or as a result; else
/// empty.
std::vector<std::string> find_own_names(const Program& program) {
  const Graph& graph = program.graph;
  std::vector<std::string> names(graph.nodes().size());
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

/// For every node its own name, else that of the first value with a name that it is a part of.
std::vector<std::string> find_stems(const Program& program, std::vector<std::string> names) {
  const std::vector<Node>& nodes = program.graph.nodes();
  std::vector<std::string> stems(nodes.size());
  for (std::size_t i = nodes.size(); i-- > 0;) {
    stems[i] = names[i].empty() ? stems[i] : names[i];
    const int operands = operation(nodes[i].op).operands;
    if (operands >= 1) {  // the earliest user is visited last and wins
      stems[nodes[i].a] = stems[i];
    }
    if (operands == 2) {
      stems[nodes[i].b] = stems[i];
    }
  }
  return stems;
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

std::vector<std::string> choose_names(const Program& program, const std::vector<bool>& wanted,
                                      std::set<std::string> reserved) {
  std::vector<std::string> names = find_own_names(program);
  const std::vector<std::string> stems = find_stems(program, names);
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!wanted[i]) {
      names[i].clear();
    } else if (!names[i].empty()) {  // all of these before any part takes a name of theirs
      names[i] = make_unique(names[i], reserved);
    }
  }
  std::map<std::string, int> parts;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (wanted[i] && names[i].empty()) {
      names[i] = make_unique(fmt::format("{}_p{}", stems[i], ++parts[stems[i]]), reserved);
    }
  }
  return names;
}

}  // namespace treeline
