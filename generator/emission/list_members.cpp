#include "emission/list_members.hpp"

#include <regex>
#include <sstream>

namespace treeline {
namespace {

/// The lines between `KEYWORD TYPE {` and the brace that ends it.
std::vector<std::string> lines_of(const std::string& header, const std::string& opening) {
  std::vector<std::string> lines;
  std::istringstream text(header);
  bool inside = false;
  for (std::string line; std::getline(text, line);) {
    if (inside && line.starts_with("}")) break;
    if (inside) lines.push_back(line);
    inside = inside || line.ends_with(opening);
  }
  return lines;
}

/// A comment in one line, without its marks. `rest` is what follows a declaration; the comment may
/// go on in the lines from `next` on.
std::string join_comment(std::string rest, const std::vector<std::string>& lines,
                         std::size_t next) {
  const bool is_block = rest.find("/*") != rest.npos;
  const bool is_line = !is_block && rest.find("//") != rest.npos;
  while (next < lines.size() && is_block && rest.find("*/") == rest.npos) rest += lines[next++];
  static const std::regex kGoesOn(R"(\s*//.*)");
  while (is_line && next < lines.size() && std::regex_match(lines[next], kGoesOn)) {
    rest += lines[next++];
  }
  static const std::regex kMarks(R"(/\*|\*/|//)");
  static const std::regex kBlanks(R"(\s+)");
  std::string text = std::regex_replace(rest, kMarks, " ");
  text = std::regex_replace(text, kBlanks, " ");
  const std::size_t first = text.find_first_not_of(' ');
  return first == text.npos ? "" : text.substr(first, text.find_last_not_of(' ') + 1 - first);
}

}  // namespace

std::vector<StructMember> list_members(const std::string& header, const std::string& type) {
  static const std::regex kMember(R"(\s*(\w+) (\w+)(\[[^\]]+\])?;(.*))");
  std::vector<StructMember> members;
  const std::vector<std::string> lines = lines_of(header, "struct " + type + " {");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    std::smatch parts;
    if (!std::regex_match(lines[i], parts, kMember)) continue;
    members.push_back({parts[1], parts[2], parts[3].matched, join_comment(parts[4], lines, i + 1)});
  }
  return members;
}

std::vector<HeaderEnumerator> list_enumerators(const std::string& header, const std::string& type) {
  static const std::regex kEnumerator(R"(\s*([A-Z][A-Z0-9_]+)(?: = (\d+))?(?:,.*|\s*/.*|))");
  std::vector<HeaderEnumerator> enumerators;
  int next = 0;
  for (const std::string& line : lines_of(header, "enum " + type + " {")) {
    std::smatch parts;
    if (!std::regex_match(line, parts, kEnumerator)) continue;
    if (parts[2].matched) next = std::stoi(parts[2]);
    enumerators.push_back({parts[1], next++});
  }
  return enumerators;
}

}  // namespace treeline
