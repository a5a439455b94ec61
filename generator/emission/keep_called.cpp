#include "emission/keep_called.hpp"

#include <algorithm>
#include <cstddef>
#include <set>
#include <sstream>

#include "emission/parse_loops.hpp"

namespace treeline {
namespace {

/// Whether the text has the name as a word; a function's where it is called, since members may have
/// names of functions.
bool names(std::string_view text, const LoopDeclaration& item) {
  for (std::size_t at = 0; (at = text.find(item.name, at)) != text.npos; at += item.name.size()) {
    if (at > 0 && is_of_word(text[at - 1])) continue;
    const char next = at + item.name.size() < text.size() ? text[at + item.name.size()] : ' ';
    if (item.is_function ? next == '(' || next == '<' : !is_of_word(next)) return true;
  }
  return false;
}

/// Moves what `text` names, and what that names in turn, from `left` to `kept`.
void keep_named(std::string_view text, std::vector<const LoopDeclaration*>& left,
                std::set<const LoopDeclaration*>& kept) {
  std::vector<const LoopDeclaration*> found;
  std::erase_if(left, [&](const LoopDeclaration* item) {
    const bool is_named = names(text, *item);
    if (is_named) found.push_back(item);
    return is_named;
  });
  kept.insert(found.begin(), found.end());
  for (const LoopDeclaration* item : found) keep_named(item->text, left, kept);
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

std::string join_callers(std::span<const Program> programs,
                         const std::function<std::string(const Program&)>& print_body,
                         const std::vector<GeneratedFile>& tables) {
  std::string text;
  for (const Program& program : programs) {
    if (program.loops) text += print_body(program);
  }
  for (const GeneratedFile& file : tables) text += file.text;
  return text;
}

void keep_called(std::string_view callers, std::vector<LoopHeader>& headers) {
  std::vector<const LoopDeclaration*> left;
  std::set<const LoopDeclaration*> kept;
  for (const LoopHeader& header : headers) {
    for (const LoopDeclaration& item : header.items) left.push_back(&item);
  }
  keep_named(callers, left, kept);
  for (LoopHeader& header : headers) {
    std::vector<LoopDeclaration> items;
    for (LoopDeclaration& item : header.items) {
      if (kept.count(&item) > 0) items.push_back(std::move(item));
    }
    header.items = std::move(items);
  }
  for (const LoopHeader& gone : headers) {
    if (!gone.items.empty()) continue;
    for (LoopHeader& header : headers) pass_over(gone, header);
  }
  std::erase_if(headers, [](const LoopHeader& header) { return header.items.empty(); });
}

}  // namespace treeline
