#include "description/read_text_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>

namespace treeline {
namespace {

constexpr std::size_t kLargestFile = std::size_t{64} << 20U;

struct CloseFile {
  void operator()(std::FILE* file) const { (void)std::fclose(file); }
};

void report(const std::string& path, std::string fault, std::string remedy,
            Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, path, 0, "", std::move(fault), std::move(remedy)});
}

}  // namespace

std::optional<std::string> read_text_file(const std::string& path, Diagnostics& diagnostics) {
  std::error_code ignored;
  if (std::filesystem::is_directory(path, ignored)) {
    report(path, "this is a folder, not a file", "name the file inside it", diagnostics);
    return std::nullopt;
  }
  errno = 0;
  const std::unique_ptr<std::FILE, CloseFile> file(std::fopen(path.c_str(), "rb"));
  if (!file) {
    report(path, "cannot open the file: " + std::generic_category().message(errno),
           "check the path and the permissions", diagnostics);
    return std::nullopt;
  }
  std::string text;
  std::array<char, 65536> block;
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), file.get())) {
    text.append(block.data(), size);
    if (text.size() > kLargestFile) {
      report(path, "the file has more than 64 MiB", "name the robot's own file", diagnostics);
      return std::nullopt;
    }
  }
  if (std::ferror(file.get()) != 0) {
    report(path, "the file cannot be read to its end", "check the disk", diagnostics);
    return std::nullopt;
  }
  return text;
}

}  // namespace treeline
