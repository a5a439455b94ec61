#include "program/section_title.hpp"

#include <fmt/format.h>

#include "program/find_sections.hpp"

namespace treeline {

std::string print(const SectionTitle& title) {
  if (title.link == 0) return title.step;
  return fmt::format("link {} ({}), {}", title.link, title.link_name, title.step);
}

std::vector<const Graph::Section*> find_sections(const Graph& graph) {
  std::vector<const Graph::Section*> sections(graph.nodes().size(), nullptr);
  const Graph::Section* open = nullptr;
  auto next = graph.sections().begin();
  for (std::size_t i = 0; i < sections.size(); ++i) {
    for (; next != graph.sections().end() && next->first_node <= i; ++next) open = &*next;
    sections[i] = open;
  }
  return sections;
}

}  // namespace treeline
