#include "program/print.hpp"

#include <fmt/format.h>

#include <iterator>

#include "program/format_literal.hpp"

namespace treeline {
namespace {

std::string reference(Expression value) {
  return fmt::format("{}%{}", value.negative() ? "-" : "", value.node());
}

/// The sign between or before operands, as formulas have it; empty without operands.
std::string_view sign_of(Op op) {
  switch (op) {
    case Op::add:
      return "+";
    case Op::sub:
    case Op::neg:
      return "-";
    case Op::mul:
      return "*";
    case Op::div:
      return "/";
    case Op::sin:
    case Op::cos:
      return operation(op).name;
    default:
      return {};
  }
}

/// Right-hand side of a node's line in the text.
std::string formula(const Graph& graph, const Node& node) {
  switch (node.op) {
    case Op::constant:
      return format_literal(node.value);
    case Op::input:
      return graph.inputs()[node.a];
    case Op::sin:
    case Op::cos:
      return fmt::format("{} %{}", sign_of(node.op), node.a);
    default:
      return fmt::format("%{} {} %{}", node.a, sign_of(node.op), node.b);
  }
}

/// Text inside a node of the drawing: its operation, and its name if it has one.
std::string label(const Graph& graph, std::uint32_t index) {
  const Node& node = graph.nodes()[index];
  const std::string_view name = graph.names().of(index);
  const std::string what =
      operation(node.op).operands > 0 ? std::string(sign_of(node.op)) : formula(graph, node);
  return name.empty() ? what : fmt::format("{}\\n{}", what, name);
}

/// Calls visit(name of the result with index, value) for every element of every result.
template <class Visit>
void for_each_result(const Program& program, Visit visit) {
  for (const Result& result : program.results) {
    for (std::size_t i = 0; i < result.values.size(); ++i) {
      visit(fmt::format("{}[{}]", result.argument.name, i), result.values[i]);
    }
  }
}

}  // namespace

std::string print_text(const Program& program) {
  const Graph& graph = program.graph;
  std::string text = fmt::format("; {}: {}\n", program.name, program.equation);
  auto section = graph.sections().begin();
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    for (; section != graph.sections().end() && section->first_node <= i; ++section) {
      text += fmt::format("; {}\n", print(section->title()));
    }
    const std::string_view name = graph.names().of(i);
    text += fmt::format("%{} = {}{}{}\n", i, formula(graph, graph.nodes()[i]),
                        name.empty() ? "" : "  ; ", name);
  }
  for_each_result(program, [&](const std::string& name, Expression value) {
    text += fmt::format("{} = {}\n", name, reference(value));
  });
  return text;
}

std::string print_dot(const Program& program) {
  const Graph& graph = program.graph;
  std::string text = fmt::format("digraph {} {{\n  rankdir=LR;\n", program.name);
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    const Node& node = graph.nodes()[i];
    text += fmt::format("  n{} [label=\"{}\"];\n", i, label(graph, i));
    if (operation(node.op).operands >= 1) {
      text += fmt::format("  n{} -> n{};\n", node.a, i);
    }
    if (operation(node.op).operands == 2) {
      text += fmt::format("  n{} -> n{};\n", node.b, i);
    }
  }
  for_each_result(program, [&](const std::string& name, Expression value) {
    text += fmt::format("  \"{0}\" [shape=box];\n  n{1} -> \"{0}\"{2};\n", name, value.node(),
                        value.negative() ? " [label=\"-\"]" : "");
  });
  return text + "}\n";
}

}  // namespace treeline
