#include "emission/keep_named.hpp"

#include <algorithm>
#include <vector>

#include "emission/adapt.hpp"

namespace treeline {
namespace {

struct Block {
  std::string_view text;  ///< up to the next block
  std::string_view name;  ///< that it declares; empty: none
  int users = 0;
};

/// Takes the first line from a text.
std::string_view take_line(std::string_view& text) {
  const std::string_view line = text.substr(0, text.find('\n'));
  text.remove_prefix(std::min(line.size() + 1, text.size()));
  return line;
}

bool is_declared_name(std::string_view word) {
  return word.starts_with("tl_") || word.starts_with("Tl");
}

/// Finds the name that a block declares: the last word before its first bracket or semicolon.
std::string_view find_name(std::string_view block) {
  while (block.starts_with("//")) take_line(block);
  block = block.substr(0, block.find_first_of("({;"));
  while (block.ends_with(' ')) block.remove_suffix(1);
  std::size_t begin = block.size();
  while (begin > 0 && belongs_to_word(block[begin - 1])) --begin;
  block.remove_prefix(begin);
  return is_declared_name(block) ? block : std::string_view();
}

std::vector<Block> split_blocks(std::string_view text) {
  std::vector<Block> blocks;
  while (!text.empty()) {
    const std::size_t end = text.find("\n\n");
    const std::string_view block = end == text.npos ? text : text.substr(0, end + 2);
    blocks.push_back({block, find_name(block)});
    text.remove_prefix(block.size());
  }
  return blocks;
}

/// Adds the names that a line of code has, without its comment.
void add_names(std::string_view line, NameSet& names) {
  line = line.substr(0, line.find("//"));
  while (!line.empty()) {
    std::size_t end = 0;
    while (end < line.size() && belongs_to_word(line[end])) ++end;
    if (is_declared_name(line.substr(0, end))) names.emplace(line.substr(0, end));
    line.remove_prefix(std::max<std::size_t>(end, 1));
  }
}

/// Counts the user of these names for each block that it comes to.
void count_user(NameSet names, std::vector<Block>& blocks) {
  std::vector<bool> found(blocks.size(), false);
  for (bool grows = true; grows;) {
    grows = false;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      if (found[i] || !names.contains(blocks[i].name)) continue;
      found[i] = true;
      grows = true;
      ++blocks[i].users;
      for (std::string_view rest = blocks[i].text; !rest.empty();) {
        add_names(take_line(rest), names);
      }
    }
  }
}

/// A block that has one user.
std::string mark_own(std::string_view block) {
  std::string marked;
  while (block.starts_with("//")) marked += std::string(take_line(block)) + "\n";
  if (!block.starts_with("TL_")) return marked + std::string(block);
  return marked + "TL_OWN_" + std::string(block.substr(3));
}

}  // namespace

std::string keep_named(std::string_view text, std::span<const NameSet> users) {
  std::vector<Block> blocks = split_blocks(text);
  for (const NameSet& names : users) count_user(names, blocks);
  std::string kept;
  for (const Block& block : blocks) {
    if (block.name.empty() || block.users > 1) kept += block.text;
    if (block.users == 1) kept += mark_own(block.text);
  }
  return kept;
}

}  // namespace treeline
