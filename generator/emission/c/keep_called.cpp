#include "emission/c/keep_called.hpp"

#include <algorithm>
#include <cstddef>
#include <sstream>

#include "emission/c/parse_loops.hpp"

namespace treeline::c {
namespace {

/// Where the function begins that an item declares, if it is one.
std::size_t find_function(const std::string& item) {
  return std::min(item.find("static inline "), item.find("static TREELINE_LINK_INLINE\n"));
}

/// What an item declares: the function before its first parenthesis, or the type after its last
/// brace.
std::string declared_name(const std::string& item) {
  const std::size_t function = find_function(item);
  const std::size_t end = function != item.npos ? item.find('(', function) : item.rfind(';');
  std::size_t begin = end;
  while (begin > 0 && is_of_word(item[begin - 1])) --begin;
  return item.substr(begin, end - begin);
}

bool names(std::string_view text, const std::string& name) {
  for (std::size_t at = 0; (at = text.find(name, at)) != text.npos; at += name.size()) {
    const std::size_t end = at + name.size();
    if ((at == 0 || !is_of_word(text[at - 1])) && (end == text.size() || !is_of_word(text[end]))) {
      return true;
    }
  }
  return false;
}

/// Moves what `text` names, and what that names in turn, from `left` to `kept`.
void keep_named(std::string_view text, std::vector<std::string>& left,
                std::vector<std::string>& kept) {
  std::vector<std::string> found;
  std::erase_if(left, [&](const std::string& item) {
    const bool is_named = names(text, declared_name(item));
    if (is_named) found.push_back(item);
    return is_named;
  });
  for (const std::string& item : found) {
    kept.push_back(item);
    keep_named(item, left, kept);
  }
}

/// The lines of an opening that include other headers of loops.
std::vector<std::string> list_includes(const std::string& opening) {
  std::vector<std::string> includes;
  std::istringstream lines(opening);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("#include \"")) includes.push_back(line + "\n");
  }
  return includes;
}

/// Includes what `gone` does in place of it.
void pass_over(const LoopHeader& gone, LoopHeader& header) {
  const std::string line = "#include \"" + gone.name + "\"\n";
  const std::size_t at = header.opening.find(line);
  if (at == header.opening.npos) return;
  header.opening.erase(at, line.size());
  for (const std::string& include : list_includes(gone.opening)) {
    if (header.opening.find(include) == header.opening.npos) header.opening.insert(at, include);
  }
}

}  // namespace

void keep_called(std::string_view callers, std::vector<LoopHeader>& headers) {
  std::vector<std::string> left, kept;
  for (const LoopHeader& header : headers) {
    left.insert(left.end(), header.items.begin(), header.items.end());
  }
  keep_named(callers, left, kept);
  for (LoopHeader& header : headers) {
    std::erase_if(header.items, [&](const std::string& item) {
      return std::find(kept.begin(), kept.end(), item) == kept.end();
    });
  }
  for (const LoopHeader& gone : headers) {
    if (!gone.items.empty()) continue;
    for (LoopHeader& header : headers) pass_over(gone, header);
  }
  std::erase_if(headers, [](const LoopHeader& header) { return header.items.empty(); });
}

}  // namespace treeline::c
