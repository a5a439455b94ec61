#include "emission/state_licence.hpp"

#include <array>
#include <string>
#include <string_view>

namespace treeline {
namespace {

/// Whoever ran the generator may use, change and pass on what it wrote without any condition.
constexpr std::string_view kLine = " SPDX-License-Identifier: 0BSD\n";

struct CommentOf {
  std::string_view ending, mark;
};

constexpr std::array<CommentOf, 19> kComments = {{{".c", "//"},
                                                  {".cl", "//"},
                                                  {".h", "//"},
                                                  {".cpp", "//"},
                                                  {".hpp", "//"},
                                                  {".ino", "//"},
                                                  {".rs", "//"},
                                                  {".mjs", "//"},
                                                  {".mts", "//"},
                                                  {".py", "#"},
                                                  {".pyi", "#"},
                                                  {".toml", "#"},
                                                  {".yml", "#"},
                                                  {".yaml", "#"},
                                                  {"Kconfig", "#"},
                                                  {"CMakeLists.txt", "#"},
                                                  {"Makefile", "#"},
                                                  {".cmake", "#"},
                                                  {"build", "#"}}};

}  // namespace

void state_licence(GeneratedFile& file) {
  for (const auto& [ending, mark] : kComments) {
    if (!file.name.ends_with(ending)) continue;
    const std::size_t head = file.text.starts_with("#!") ? file.text.find('\n') + 1 : 0;
    file.text.insert(head, std::string(mark) + std::string(kLine));
    return;
  }
}

}  // namespace treeline
