#include "emission/guard_headers.hpp"

#include <fmt/format.h>

#include <cctype>
#include <string_view>

namespace treeline {
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

}  // namespace treeline
