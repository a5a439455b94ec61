#include "generation/count_by_link.hpp"

#include <charconv>
#include <string_view>

#include "passes/rebuild.hpp"

namespace treeline {
namespace {

/// The link of a section whose title is `link 3 (name), pass`; `links`: of none.
std::size_t link_of(std::string_view title, std::size_t links) {
  constexpr std::string_view kLink = "link ";
  if (!title.starts_with(kLink)) return links;
  title.remove_prefix(kLink.size());
  std::size_t number = 0;  // from 1
  std::from_chars(title.data(), title.data() + title.size(), number);
  return number >= 1 && number <= links ? number - 1 : links;
}

bool is_operation(Op op) {
  return op == Op::add || op == Op::sub || op == Op::mul || op == Op::div;
}

}  // namespace

std::vector<int> count_by_link(const Program& program, std::size_t links) {
  const Graph& graph = program.graph;
  const Marks live = find_live(program);
  std::vector<int> counts(links + 1, 0);
  std::size_t link = links;
  auto section = graph.sections().begin();
  for (std::uint32_t i = 0; i < graph.nodes().size(); ++i) {
    for (; section != graph.sections().end() && section->first_node <= i; ++section) {
      link = link_of(section->title(), links);
    }
    counts[link] += live[i] && is_operation(graph.nodes()[i].op) ? 1 : 0;
  }
  return counts;
}

}  // namespace treeline
