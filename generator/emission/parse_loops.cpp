#include "emission/parse_loops.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace treeline {
namespace {

constexpr std::string_view kOpen = "namespace treeline::core::loops {\n";
constexpr std::string_view kClose = "}  // namespace treeline::core::loops\n";
constexpr std::string_view kTemplate = "template <";

std::string_view trimmed(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(' ');
  return begin == line.npos ? std::string_view() : line.substr(begin);
}

void append_word(std::string_view word, std::string& text) {
  if (!text.empty()) text += ' ';
  text += word;
}

/// Reads lines until one ends in `end`, as one line. Appends them to `source` as they are.
std::string read_until(std::istringstream& lines, std::string line, char end, std::string& source) {
  std::string text(trimmed(line));
  source += line + "\n";
  while (text.back() != end) {
    if (!std::getline(lines, line)) throw std::logic_error("loops over links: no end of " + text);
    append_word(trimmed(line), text);
    source += line + "\n";
  }
  return text;
}

/// Reads the lines of a body, and its end. Appends both to `source`.
std::string read_body(std::istringstream& lines, std::string& source) {
  std::string body;
  std::string line;
  while (std::getline(lines, line) && line != "}" && line != "};") body += line + "\n";
  source += body + line + "\n";
  return body;
}

/// Whether what precedes a comment ends a statement, a head or a block.
bool is_complete(std::string_view statement) {
  std::string_view code = statement.substr(0, statement.find("//"));
  while (code.ends_with(' ')) code.remove_suffix(1);
  if (code.empty()) return true;
  const bool closed =
      std::count(code.begin(), code.end(), '(') == std::count(code.begin(), code.end(), ')');
  return closed && std::string_view(";{}").find(code.back()) != std::string_view::npos;
}

}  // namespace

std::string LoopItem::name() const {
  const std::size_t end = is_struct() ? head.size() : head.find('(');
  std::size_t begin = end;
  while (begin > 0 && is_of_word(head[begin - 1])) --begin;
  return head.substr(begin, end - begin);
}

std::vector<LoopItem> parse_loops(std::string_view header) {
  const std::size_t open = header.find(kOpen);
  const std::size_t close = header.find(kClose);
  if (open == header.npos || close == header.npos) {
    throw std::logic_error("loops over links: a header is not in their namespace");
  }
  const std::size_t begin = open + kOpen.size();
  std::istringstream lines{std::string(header.substr(begin, close - begin))};
  std::vector<LoopItem> items;
  LoopItem item;
  for (std::string line; std::getline(lines, line);) {
    if (line.empty()) continue;
    if (line.starts_with("//")) {
      item.comment += line + "\n";
      item.source += line + "\n";
    } else if (line.starts_with(kTemplate)) {
      const std::string whole = read_until(lines, line, '>', item.source);
      item.parameters = whole.substr(kTemplate.size(), whole.size() - kTemplate.size() - 1);
    } else {
      item.head = read_until(lines, line, '{', item.source);
      item.head.resize(item.head.size() - 2);  // without ` {`
      item.body = read_body(lines, item.source);
      items.push_back(std::exchange(item, {}));
    }
  }
  return items;
}

bool is_of_word(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::vector<std::string> join_statements(std::string_view text) {
  std::istringstream lines{std::string(text)};
  std::vector<std::string> statements;
  bool complete = true;
  for (std::string line; std::getline(lines, line);) {
    if (complete) {
      statements.push_back(line);
    } else {
      append_word(trimmed(line), statements.back());
    }
    complete = is_complete(statements.back());
  }
  return statements;
}

}  // namespace treeline
