#include <filesystem>

#include "cli/print_outputs.hpp"

namespace treeline {
namespace {

std::string escaped(const std::string& path) {
  std::string text;
  for (const char c : std::filesystem::absolute(path).lexically_normal().string()) {
    if (c == ' ' || c == '#') text += '\\';
    if (c == '$') text += '$';
    text += c;
  }
  return text;
}

}  // namespace

std::string print_depfile(const std::string& target, const std::vector<std::string>& files) {
  std::string text = escaped(target) + ":";
  for (const std::string& file : files) text += " \\\n  " + escaped(file);
  return text + "\n";
}

}  // namespace treeline
