#include "emission/generated_file.hpp"

#include <fmt/format.h>

#include <array>
#include <cctype>
#include <string>
#include <string_view>

#include "core/sha256.h"

namespace treeline {

std::string digest(std::string_view bytes) {
  TreelineSha256 hash;
  treeline_sha256_begin(&hash);
  treeline_sha256_absorb(&hash, bytes.data(), bytes.size());
  std::array<unsigned char, treeline_sha256_size> result{};
  treeline_sha256_finish(&hash, result.data());
  std::string text;
  for (const unsigned char byte : result) {
    text += fmt::format("{:02x}", byte);
  }
  return text;
}

namespace {

char in_other_case(char c) {
  const auto letter = static_cast<unsigned char>(c);
  return static_cast<char>(std::isupper(letter) != 0 ? std::tolower(letter) : std::toupper(letter));
}

/// `puma560`, `sin_cos.hpp`: `TREELINE_PUMA560_SIN_COS_HPP`. Two robots' files of one name must
/// not hide each other, those of robots `s` and `si` neither: a file is the robot's own where its
/// whole name stands before the rest. Nor those of `arm` and `Arm`, which is `aRM` here.
std::string guard_name(const std::string& robot, const std::string& file) {
  const bool own = file.starts_with(robot + ".") || file.starts_with(robot + "_");
  std::string name = (own ? "" : robot + "_") + file;
  for (char& c : name) {
    c = c == '.' ? '_' : in_other_case(c);
  }
  return "TREELINE_" + name;
}

}  // namespace

void guard_headers(const std::string& robot, std::vector<GeneratedFile>& files) {
  constexpr std::string_view kOnce = "#pragma once\n";
  for (GeneratedFile& file : files) {
    if (!file.text.starts_with(kOnce)) continue;
    const std::string name = guard_name(robot, file.name);
    file.text = fmt::format("#ifndef {0}\n#define {0}\n{1}\n#endif  // {0}\n", name,
                            file.text.substr(kOnce.size()));
  }
}

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
