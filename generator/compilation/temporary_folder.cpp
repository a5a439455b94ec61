#include "compilation/temporary_folder.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <fstream>
#include <string>
#include <system_error>

#include "interruption/clean_up.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPrefix = "treeline-check-";

/// Whether the path is a folder `treeline-check-PID-XXXXXX` that belongs to this user and is not a
/// link.
bool is_ours(const fs::path& path) {
  const std::string name = path.filename();
  const std::string_view prefix = kPrefix;
  if (!name.starts_with(prefix)) return false;
  const std::size_t dash = name.find('-', prefix.size());
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  if (dash == std::string::npos || dash == prefix.size() ||
      !std::all_of(name.begin() + static_cast<long>(prefix.size()),
                   name.begin() + static_cast<long>(dash), is_digit)) {
    return false;
  }
  struct stat found {};
  return lstat(path.c_str(), &found) == 0 && S_ISDIR(found.st_mode) && found.st_uid == geteuid();
}

/// Removes folders of runs that ended without doing so. Nobody holds the lock of such a folder.
void remove_stale(const fs::path& parent) {
  std::error_code ignored;
  for (fs::directory_iterator entry(parent, ignored), end; !ignored && entry != end;
       entry.increment(ignored)) {
    if (!is_ours(entry->path())) continue;
    std::string error;
    const auto guard = FolderGuard::try_lock(entry->path(), error);
    std::error_code not_removed;  // not important: the next run tries again
    if (guard) fs::remove_all(entry->path(), not_removed);
  }
}

void remove_stale_once(const fs::path& parent) {
  static const bool done = [&] {
    remove_stale(parent);
    return true;
  }();
  (void)done;
}

/// Folder for temporary files. A TMPDIR that is empty is none, as for most programs.
fs::path find_parent() {
  const char* const folder = std::getenv("TMPDIR");
  return folder != nullptr && *folder == '\0' ? fs::path("/tmp") : fs::temp_directory_path();
}

}  // namespace

TemporaryFolder::TemporaryFolder() {
  const fs::path parent = find_parent();
  remove_stale_once(parent);
  const Uninterrupted now;
  // Another run that starts now may take the folder for a stale one before its lock is held. Then
  // try again.
  for (int i = 0; i < 100 && !guard_; ++i) {
    std::string name = parent / (kPrefix + std::to_string(getpid()) + "-XXXXXX");
    if (mkdtemp(name.data()) == nullptr) {
      throw fs::filesystem_error("no temporary folder", parent,
                                 std::error_code(errno, std::generic_category()));
    }
    path_ = name;
    std::string error;
    guard_ = FolderGuard::try_lock(path_, error);
  }
  remove_on_signal(path_, Removal::with_content);
}

TemporaryFolder::~TemporaryFolder() {
  const Uninterrupted now;
  std::error_code ignored;  // what cannot be removed stays there
  fs::remove_all(path_, ignored);
  keep_on_signal(path_);
}

std::unique_ptr<TemporaryFolder> make_temporary_folder(Diagnostics& diagnostics) {
  try {
    return std::make_unique<TemporaryFolder>();
  } catch (const fs::filesystem_error& error) {
    diagnostics.add({Severity::error, error.path1().string(), 0, "",
                     "no temporary folder can be made: " + error.code().message(),
                     "set TMPDIR to a folder that exists, is yours to write and has space left"});
    return nullptr;
  }
}

bool write_work_file(const std::filesystem::path& path, const std::string& bytes,
                     Diagnostics& diagnostics) {
  std::error_code ignored;  // the stream tells
  std::filesystem::create_directories(path.parent_path(), ignored);
  std::ofstream stream(path, std::ios::binary);
  stream << bytes;
  stream.close();
  if (stream) return true;
  diagnostics.add({Severity::error, path, 0, "", "cannot be written to its end",
                   "free some space there, or name a folder with more: --output, TMPDIR"});
  return false;
}

}  // namespace treeline
