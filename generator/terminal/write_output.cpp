#include "terminal/write_output.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "terminal/print_diagnostics.hpp"
#include "text/printable.hpp"

namespace treeline {

ExitCode write_output(const std::string& data, OutputForm form, ExitCode exit_code) {
  const std::string text = form == OutputForm::json ? printable_json(data) : printable_lines(data);
  errno = 0;
  const bool written =
      std::fwrite(text.data(), 1, text.size(), stdout) == text.size() && std::fflush(stdout) == 0;
  if (written) return exit_code;
  Diagnostics diagnostics;
  diagnostics.add({Severity::error, "standard output", 0, "",
                   "cannot be written to its end: " + std::generic_category().message(errno),
                   "free some space there, or send the output elsewhere"});
  print_diagnostics(diagnostics);
  return kBadInput;
}

void print_message(const std::string& text) {
  (void)std::fwrite(text.data(), 1, text.size(), stderr);
}

bool is_none_of(const std::string& path, const std::vector<std::string>& read,
                Diagnostics& diagnostics) {
  const bool is_read = std::any_of(read.begin(), read.end(), [&path](const std::string& input) {
    std::error_code none;  // of files that are not there
    return std::filesystem::is_regular_file(path, none) &&
           std::filesystem::equivalent(path, input, none);
  });
  if (!is_read) return true;
  diagnostics.add({Severity::error, path, 0, "", "this file is read, and is not written over",
                   "name another file to write"});
  return false;
}

bool can_write(const std::string& path, Diagnostics& diagnostics) {
  namespace fs = std::filesystem;
  std::error_code none;  // of what is not there
  const fs::path folder = fs::absolute(path, none).parent_path();
  const fs::path place = fs::exists(path, none) ? fs::path(path) : folder;
  if (!fs::is_directory(path, none) && access(place.c_str(), W_OK) == 0) return true;
  diagnostics.add({Severity::error, path, 0, "", "cannot be written",
                   "name a file in a folder that exists and is yours to write"});
  return false;
}

bool may_write(const std::string& path, const std::vector<std::string>& read,
               Diagnostics& diagnostics) {
  if (path.empty() || path == "-") return true;
  return is_none_of(path, read, diagnostics) && can_write(path, diagnostics);
}

bool write_output_file(const std::string& path, const std::string& data, Diagnostics& diagnostics,
                       const std::vector<std::string>& read) {
  if (!is_none_of(path, read, diagnostics)) return false;
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  const bool opened = stream.is_open();
  stream << data;
  stream.close();
  if (stream) return true;
  const std::string error = std::generic_category().message(errno);
  std::error_code ignored;
  if (opened && std::filesystem::is_regular_file(path, ignored)) {
    // Half a file looks like a whole one.
    std::filesystem::remove(std::filesystem::canonical(path, ignored), ignored);
  }
  if (path.empty()) {
    diagnostics.add({Severity::error, "", 0, "", "the name of a file to write is empty",
                     "name the file, or leave the option out"});
    return false;
  }
  diagnostics.add({Severity::error, path, 0, "", "cannot be written to its end: " + error,
                   "name a file in a folder that exists, is yours to write and has space left"});
  return false;
}

}  // namespace treeline
