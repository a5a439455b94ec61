#include <fmt/format.h>

#include "inspect/inspect_robot.hpp"

namespace treeline {
namespace {

/// Quotes a text for the DOT language.
std::string quoted(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string print_link(std::size_t index, const LinkReport& link) {
  std::string label = quoted(link.name);
  if (link.has_inertial) label += fmt::format("\\n{:.5g} kg", link.mass);
  const char* color = link.unphysical ? ", color=red" : "";
  return fmt::format("  link{} [label=\"{}\"{}];\n", index, label, color);
}

std::string print_joint(std::size_t index, const LinkReport& link) {
  const bool follows = link.motion.ends_with("follows");
  const char* style = !link.moves ? "dashed" : follows ? "dotted" : "solid";
  return fmt::format("  link{} -> link{} [label=\"{}\\n{}\", style={}];\n", link.parent, index,
                     quoted(link.joint), quoted(link.motion), style);
}

}  // namespace

std::string print_dot(const Report& report) {
  std::string text = fmt::format("digraph \"{}\" {{\n  node [shape=box];\n", quoted(report.robot));
  for (std::size_t i = 0; i < report.links.size(); ++i) text += print_link(i, report.links[i]);
  for (std::size_t i = 0; i < report.links.size(); ++i) {
    if (report.links[i].parent >= 0) text += print_joint(i, report.links[i]);
  }
  return text + "}\n";
}

}  // namespace treeline
