#include "compilation/keep_library.hpp"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>
#include <utility>

#include "compilation/compile_folder.hpp"
#include "emission/generated_file.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostLibraries = 32;
constexpr std::size_t kDigits = 32;  // of each of the two digests in a file's name
const std::string kEnding = ".so";

/// Variables by which compilers find headers and libraries, beside their flags.
constexpr std::array kSearchPaths = {"CPATH",        "C_INCLUDE_PATH",  "CPLUS_INCLUDE_PATH",
                                     "LIBRARY_PATH", "GCC_EXEC_PREFIX", "COMPILER_PATH"};

/// Texts one after the other, so that no two lists are alike.
void append(std::string& all, const std::string& text) {
  all += std::to_string(text.size()) + ':' + text;
}

std::string short_digest(const std::string& bytes) {
  return digest(bytes).substr(0, kDigits);
}

std::string without(std::string text, const std::string& part) {
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at)) {
    text.erase(at, part.size());
  }
  return text;
}

/// Whether the compiler or the linker reads it; other files there are what they write.
bool is_source(const fs::path& file) {
  constexpr std::array kEndings = {".cpp", ".hpp", ".h", ".map"};
  return std::ranges::find(kEndings, file.extension()) != kEndings.end();
}

fs::path absolute_path_of(const char* variable) {
  const fs::path path = environment_value(variable);
  return path.is_absolute() ? path : fs::path();
}

/// The file of that name, which ends in the digest of its bytes; empty where there is none.
fs::path find_kept(const fs::path& folder, const std::string& name) {
  std::error_code error;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    const std::string file = at->path().filename();
    if (file.starts_with(name + '-') && file.ends_with(kEnding)) return at->path();
  }
  return {};
}

void remove_oldest(const fs::path& folder) {
  std::error_code error;
  std::set<std::pair<fs::file_time_type, fs::path>> files;
  for (fs::directory_iterator at(folder, error), end; !error && at != end; at.increment(error)) {
    std::error_code gone;
    const auto used = fs::last_write_time(at->path(), gone);
    if (!gone && at->path().extension() == kEnding) files.emplace(used, at->path());
  }
  while (files.size() > kMostLibraries) {
    fs::remove(files.begin()->second, error);
    files.erase(files.begin());
  }
}

}  // namespace

fs::path folder_of_kept_libraries() {
  if (const char* const folder = std::getenv("TREELINE_CACHE"); folder != nullptr) {
    return *folder == '\0' ? fs::path() : fs::absolute(folder);
  }
  if (const fs::path cache = absolute_path_of("XDG_CACHE_HOME"); !cache.empty()) {
    return cache / "treeline";
  }
  const fs::path home = absolute_path_of("HOME");
  return home.empty() ? home : home / ".cache" / "treeline";
}

std::string identify_library(const Command& compiler, std::vector<Command> commands,
                             const Command& linking, const fs::path& work) {
  // Names the version, the target, the processor that -march=native means, and folders of headers.
  Command about_itself = compiler;
  about_itself.insert(about_itself.end(), {"-v", "-E", "-x", "c++", "/dev/null"});
  std::string all;
  append(all, run_commands({about_itself}, 1, work).front().output);
  for (const char* const variable : kSearchPaths) {
    append(all, environment_value(variable));
  }
  commands.push_back(linking);
  for (const Command& command : commands) {
    for (const std::string& word : command) append(all, without(word, work));
  }
  std::set<fs::path> sources;
  for (const auto& entry : fs::recursive_directory_iterator(work)) {
    if (is_source(entry.path())) sources.insert(entry.path());
  }
  for (const fs::path& source : sources) {
    append(all, without(source, work));
    append(all, read_file(source));
  }
  return short_digest(all);
}

bool take_kept_library(const fs::path& folder, const std::string& name,
                       const fs::path& destination) {
  const fs::path kept = find_kept(folder, name);
  if (kept.empty()) return false;
  std::error_code error;
  fs::copy_file(kept, destination, fs::copy_options::overwrite_existing, error);
  const bool whole =
      !error && kept.filename() == name + '-' + short_digest(read_file(destination)) + kEnding;
  if (whole) {
    fs::last_write_time(kept, fs::file_time_type::clock::now(), error);
  } else {
    fs::remove(kept, error);
  }
  return whole;
}

void keep_library(const fs::path& library, const fs::path& folder, const std::string& name) {
  std::error_code error;
  if (fs::create_directories(folder, error)) {
    fs::permissions(folder, fs::perms::owner_all, error);
  }
  // Under its name only once it is whole: other runs may look meanwhile.
  const fs::path written = folder / ("new-" + std::to_string(getpid()));
  fs::copy_file(library, written, fs::copy_options::overwrite_existing, error);
  if (!error) {
    fs::rename(written, folder / (name + '-' + short_digest(read_file(library)) + kEnding), error);
  }
  if (error) {
    fs::remove(written, error);
    return;
  }
  remove_oldest(folder);
}

}  // namespace treeline
