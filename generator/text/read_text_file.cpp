#include "text/read_text_file.hpp"

#include <array>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string_view>
#include <system_error>

namespace treeline {
namespace {

constexpr const char* kStandardInput = "-";
constexpr std::size_t kLargestFile = std::size_t{64} << 20U;

struct CloseFile {
  void operator()(std::FILE* file) const { (void)std::fclose(file); }
};

void report(const std::string& path, std::string fault, std::string remedy,
            Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, path, 0, "", std::move(fault), std::move(remedy)});
}

std::optional<std::string> read_to_end(std::FILE* file, const std::string& path,
                                       Diagnostics& diagnostics) {
  std::string text;
  std::array<char, 65536> block;
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), file)) {
    text.append(block.data(), size);
    if (text.size() > kLargestFile) {
      report(path, "the file has more than 64 MiB", "name the robot's own file", diagnostics);
      return std::nullopt;
    }
  }
  if (std::ferror(file) != 0) {
    report(path, "the file cannot be read to its end", "check the disk", diagnostics);
    return std::nullopt;
  }
  return text;
}

/// Encoding that the first bytes show and that no reader here understands; empty: none.
std::string_view name_encoding(std::string_view text) {
  using namespace std::string_view_literals;
  if (text.starts_with("\x1f\x8b"sv)) return "gzip";
  const bool is_utf16 = text.starts_with("\xff\xfe"sv) || text.starts_with("\xfe\xff"sv) ||
                        text.starts_with("<\0"sv) || text.starts_with("\0<"sv);
  return is_utf16 ? "UTF-16" : "";
}

/// The text, unless it is compressed or of another encoding, with an error.
std::optional<std::string> as_utf8(std::optional<std::string> text, const std::string& path,
                                   Diagnostics& diagnostics) {
  const std::string_view encoding = text ? name_encoding(*text) : "";
  if (encoding.empty()) return text;
  if (encoding == "gzip") {
    report(path, "the file is compressed by gzip", "unpack it with gunzip", diagnostics);
  } else {
    report(path, "the file is UTF-16 text", "save it as UTF-8 text", diagnostics);
  }
  return std::nullopt;
}

}  // namespace

std::string shown_path(const std::string& path) {
  return path == kStandardInput ? "standard input" : path;
}

bool can_read_both(const std::string& urdf, const std::string& scene, Diagnostics& diagnostics) {
  if (urdf != kStandardInput || scene != kStandardInput) return true;
  report("standard input", "the robot and the scene are both to come from it",
         "write one of the two into a file", diagnostics);
  return false;
}

std::optional<std::string> read_text_file(const std::string& path, Diagnostics& diagnostics) {
  if (path == kStandardInput) {
    return as_utf8(read_to_end(stdin, shown_path(path), diagnostics), shown_path(path),
                   diagnostics);
  }
  if (path.empty()) {
    report(path, "the name of a file to read is empty", "name the file", diagnostics);
    return std::nullopt;
  }
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
  return as_utf8(read_to_end(file.get(), path, diagnostics), path, diagnostics);
}

}  // namespace treeline
