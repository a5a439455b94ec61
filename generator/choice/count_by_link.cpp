#include "choice/count_by_link.hpp"

#include "passes/rebuild.hpp"
#include "program/find_sections.hpp"

namespace treeline {
namespace {

bool is_operation(Op op) {
  return op == Op::add || op == Op::sub || op == Op::mul || op == Op::div;
}

}  // namespace

std::vector<int> count_by_link(const Program& program, std::size_t links) {
  const Graph& graph = program.graph;
  const Marks live = find_live(program);
  std::vector<int> counts(links + 1, 0);
  const auto sections = find_sections(graph);
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    const int number = sections[i] == nullptr ? 0 : sections[i]->title().link;
    const std::size_t link = number > 0 ? static_cast<std::size_t>(number) - 1 : links;
    counts[link] += live[i] && is_operation(graph.nodes()[i].op) ? 1 : 0;
  }
  return counts;
}

}  // namespace treeline
