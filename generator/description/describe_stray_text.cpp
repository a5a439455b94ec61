#include <fmt/format.h>

#include <algorithm>

#include "description/read_number.hpp"
#include "description/xml_faults.hpp"
#include "text/printable.hpp"

namespace treeline {
namespace {

constexpr std::string_view kLargeFile = "version https://git-lfs.github.com/";
constexpr std::size_t kLongestPath = 4096;  // of POSIX

/// Whether the text begins with this, in either case of letters.
bool begins_with(std::string_view text, std::string_view lower) {
  return text.size() >= lower.size() &&
         std::equal(lower.begin(), lower.end(), text.begin(), [](char a, char b) {
           return a == b || (b >= 'A' && b <= 'Z' && a == b - 'A' + 'a');
         });
}

/// One line that ends like the name of a robot's file.
bool is_path(std::string_view line) {
  if (line.size() > kLongestPath || line.find_first_of("<>\n") != std::string_view::npos) {
    return false;
  }
  for (const std::string_view end : {".urdf", ".URDF", ".xml", ".xacro"}) {
    if (line.size() > end.size() && line.substr(line.size() - end.size()) == end) return true;
  }
  return false;
}

}  // namespace

std::optional<StrayText> describe_stray_text(std::string_view text) {
  const std::string_view line = trimmed(text);
  if (line.substr(0, kLargeFile.size()) == kLargeFile) {
    return StrayText{"the file holds only a pointer of Git LFS to the robot's file",
                     "fetch the file itself: git lfs pull"};
  }
  if (begins_with(line, "<!doctype html") || begins_with(line, "<html")) {
    return StrayText{"the file holds a web page",
                     "save the robot's file itself, on GitHub by \"Raw\""};
  }
  if (is_path(line)) {
    return StrayText{fmt::format("the file holds only a path, {}: a symbolic link that was copied "
                                 "as text",
                                 printable(line)),
                     "name the file that it leads to"};
  }
  return std::nullopt;
}

}  // namespace treeline
