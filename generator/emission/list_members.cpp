#include "emission/list_members.hpp"

#include <algorithm>
#include <sstream>

#include "emission/adapt.hpp"

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

bool is_name(std::string_view word) {
  return !word.empty() && std::all_of(word.begin(), word.end(), belongs_to_word);
}

/// Whether a comment goes on in the next line. `in_comment`: the line begins in one.
bool ends_in_comment(const std::string& line, bool in_comment) {
  const std::size_t opened = line.rfind("/*");
  const std::size_t closed = line.rfind("*/");
  if (opened == line.npos) return in_comment && closed == line.npos;
  return closed == line.npos || closed < opened;
}

/// The comment of a declaration in one line, without its marks. `rest` is what follows the
/// declaration; the comment may go on in the lines from `next` on.
std::string join_comment(std::string rest, const std::vector<std::string>& lines,
                         std::size_t next) {
  const bool is_block = rest.find("/*") != rest.npos;
  const bool is_line = !is_block && rest.find("//") != rest.npos;
  const auto goes_on = [&](const std::string& line) {
    if (is_block) return rest.find("*/") == rest.npos;
    const std::size_t mark = line.find("//");
    return is_line && mark != line.npos && mark == line.find_first_not_of(' ');
  };
  while (next < lines.size() && goes_on(lines[next])) rest += " " + lines[next++];
  std::string text;
  std::istringstream words(rest);
  for (std::string word; words >> word;) {
    if (word == "//" || word == "/*" || word == "*/") continue;
    text += (text.empty() ? "" : " ") + word;
  }
  return text;
}

}  // namespace

std::vector<StructMember> list_members(const std::string& header, const std::string& type) {
  std::vector<StructMember> members;
  const std::vector<std::string> lines = lines_of(header, "struct " + type + " {");
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const std::size_t end = lines[i].find(';');
    if (end == std::string::npos) continue;
    const std::string declared = lines[i].substr(0, end);
    const std::size_t bracket = declared.find('[');
    std::istringstream words(declared.substr(0, bracket));
    StructMember member;
    std::string more;
    if (!(words >> member.type >> member.name) || words >> more) continue;
    if (!is_name(member.type) || !is_name(member.name)) continue;
    member.is_array = bracket != std::string::npos;
    member.meaning = join_comment(lines[i].substr(end + 1), lines, i + 1);
    members.push_back(std::move(member));
  }
  return members;
}

std::vector<HeaderEnumerator> list_enumerators(const std::string& header, const std::string& type) {
  std::vector<HeaderEnumerator> enumerators;
  int next = 0;
  bool in_comment = false;
  for (const std::string& line : lines_of(header, "enum " + type + " {")) {
    const bool is_comment = in_comment;
    in_comment = ends_in_comment(line, in_comment);
    if (is_comment) continue;
    std::istringstream words(line);
    std::string name, equals;
    std::getline(words >> std::ws, name, ' ');
    if (name.ends_with(',')) name.pop_back();
    if (!is_name(name)) continue;
    if (int value = 0; words >> equals >> value && equals == "=") next = value;
    enumerators.push_back({name, next++});
  }
  return enumerators;
}

}  // namespace treeline
