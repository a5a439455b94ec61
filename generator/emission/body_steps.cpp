#include "emission/body_steps.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "emission/backend.hpp"
#include "emission/emitted_text.hpp"
#include "passes/rebuild.hpp"

namespace treeline {

std::string print_constants(const Adaptation& own, std::span<const Constant> constants) {
  const ConstantSyntax& syntax = backend_of(own.language).constants;
  std::string text(syntax.opening);
  for (const Constant& each : constants) {
    text += fmt::format(fmt::runtime(syntax.line), constant_name(own, each.name), each.value);
    text += &each == &constants.back() ? syntax.last : syntax.between;
    text += *each.comment != '\0' ? fmt::format("  // {}\n", each.comment) : "\n";
  }
  return text.append(syntax.closing);
}

std::string print_table(const std::string& declared, std::vector<std::string> entries,
                        std::size_t indentation) {
  if (entries.empty()) entries.emplace_back("0");
  return wrap_line(
      fmt::format("{}[{}] = {{{}}};", declared, entries.size(), fmt::join(entries, ", ")),
      indentation);
}

std::string print_sizes(const std::string& robot, const Adaptation& own, std::string_view header,
                        std::span<const Constant> sizes) {
  Adaptation filled = own;
  filled.words["TL_CONTRACT"] = robot;
  filled.words["TL_CONSTANTS"] = print_constants(own, sizes);
  return adapt(header, filled);
}

namespace {

/// Operations in one expression beyond which its parts get names.
constexpr int kLargestExpression = 8;

/// Whether each node is the value of a result.
std::vector<bool> find_result_nodes(const Program& program) {
  std::vector<bool> is_result(program.graph.nodes().size(), false);
  for (const Result& result : program.results) {
    for (const Expression& value : result.values) {
      is_result[value.node()] = true;
    }
  }
  return is_result;
}

}  // namespace

std::vector<bool> select_statements(const Program& program) {
  const Graph& graph = program.graph;
  const std::vector<int> uses = count_uses(program);
  const std::vector<bool> is_result = find_result_nodes(program);
  std::vector<int> written(graph.nodes().size(), 0);  // operations in the text of a reference
  std::vector<bool> selected(graph.nodes().size(), false);
  std::vector<bool> packed(graph.nodes().size(), false);
  for (const LanePack& pack : program.packs) {
    for (const std::uint32_t node : pack) {
      packed[node] = true;
    }
  }
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    const Node& node = graph.nodes()[i];
    const int operands = operation(node.op).operands;
    if (operands == 0 || uses[i] == 0) {
      continue;
    }
    int size = 1 + written[node.a] + (operands == 2 ? written[node.b] : 0);
    const bool stored_once = is_result[i] && uses[i] == 1;  // the store is its statement
    selected[i] = packed[i] || is_trigonometric(node.op) || graph.names().contains(i) ||
                  (uses[i] > 1) || (size >= kLargestExpression && !stored_once);
    written[i] = selected[i] ? 0 : size;
  }
  return selected;
}

}  // namespace treeline
