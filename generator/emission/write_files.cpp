#include "emission/write_files.hpp"

#include <algorithm>
#include <cerrno>
#include <fstream>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

#include "emission/compare_files.hpp"
#include "emission/print_manifest.hpp"
#include "interruption/clean_up.hpp"
#include "interruption/folder_guard.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

bool fail(const fs::path& path, const std::string& fault, Diagnostics& diagnostics) {
  diagnostics.add(
      {Severity::error, path.string(), 0, "", fault,
       "Check that the folder is yours to write and has space left, and that no name is too "
       "long."});
  return false;
}

/// The folder that is written to, locked against other runs. Where it is new it goes again unless
/// something comes to lie in it.
class LockedFolder {
 public:
  explicit LockedFolder(fs::path path) : path_(std::move(path)) {}
  ~LockedFolder() {
    if (!is_new_) return;
    const Uninterrupted now;
    std::error_code ignored;
    fs::remove(path_, ignored);  // which does nothing to a folder that holds something
    keep_on_signal(path_);
  }
  LockedFolder(const LockedFolder&) = delete;
  LockedFolder& operator=(const LockedFolder&) = delete;

  /// Waits for other runs, at most so long.
  bool lock(std::chrono::milliseconds patience, Diagnostics& diagnostics) {
    constexpr std::chrono::milliseconds kPause{20};
    std::string error;
    for (auto waited = kPause * 0; !guard_; waited += kPause) {
      if (!make(diagnostics)) return false;
      guard_ = FolderGuard::try_lock(path_, error);
      if (guard_) break;
      if (!error.empty()) return fail(path_, error, diagnostics);
      if (waited >= patience) return complain(diagnostics);
      std::this_thread::sleep_for(kPause);
    }
    return true;
  }

 private:
  bool make(Diagnostics& diagnostics) {
    const Uninterrupted now;
    std::error_code error;
    if (fs::create_directories(path_, error)) {
      is_new_ = true;
      remove_on_signal(path_, Removal::if_empty);
    }
    std::error_code ignored;
    if (!error && fs::is_directory(path_, ignored)) return true;
    const bool is_file = fs::exists(path_, ignored) && !fs::is_directory(path_, ignored);
    return fail(path_, is_file ? "this is a file, not a folder" : error.message(), diagnostics);
  }

  bool complain(Diagnostics& diagnostics) const {
    diagnostics.add({Severity::error, path_.string(), 0, "",
                     "another run of this program is writing to the folder",
                     "Wait for it or end it, then run this again; or name another --output."});
    return false;
  }

  fs::path path_;
  bool is_new_ = false;
  std::unique_ptr<FolderGuard> guard_;
};

/// A folder inside the target that is gone, with what is in it, when this ends. Only who holds the
/// target's lock makes it: if it is there, a run that was killed has left it.
class StagingFolder {
 public:
  explicit StagingFolder(const fs::path& target) : path_(target / kStagingName) {
    const Uninterrupted now;
    fs::remove_all(path_, error_);
    fs::create_directory(path_, error_);
    remove_on_signal(path_, Removal::with_content);
  }
  ~StagingFolder() {
    const Uninterrupted now;
    fs::remove_all(path_, error_);
    keep_on_signal(path_);
  }
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }
  [[nodiscard]] const std::error_code& error() const { return error_; }

 private:
  static constexpr const char* kStagingName = ".treeline-part";
  fs::path path_;
  std::error_code error_;
};

/// Writes a file and returns what went wrong; empty: nothing.
std::string write_file(const fs::path& path, const std::string& text) {
  errno = 0;
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  return stream.good() ? "" : std::generic_category().message(errno);
}

const GeneratedFile& find_file(const std::vector<GeneratedFile>& files, const std::string& name) {
  return *std::find_if(files.begin(), files.end(),
                       [&](const GeneratedFile& file) { return file.name == name; });
}

/// The manifest last: until it is in place the old one still lists all that may have to go.
std::vector<FileDifference> order_changes(std::vector<FileDifference> changes) {
  std::stable_partition(changes.begin(), changes.end(),
                        [](const FileDifference& change) { return change.name != kManifestName; });
  return changes;
}

bool stage(const std::vector<FileDifference>& changes, const std::vector<GeneratedFile>& files,
           const fs::path& target, const fs::path& staging, Diagnostics& diagnostics) {
  for (const FileDifference& change : changes) {
    if (change.difference == Difference::left_over) continue;
    const std::string error = write_file(staging / change.name, find_file(files, change.name).text);
    if (!error.empty()) {
      return fail(target / change.name, "the file cannot be written to its end: " + error,
                  diagnostics);
    }
  }
  return true;
}

/// All or nothing, as far as the system lets renaming succeed.
bool move_into_place(const std::vector<FileDifference>& changes, const fs::path& target,
                     const fs::path& staging, Diagnostics& diagnostics) {
  const Uninterrupted now;
  std::error_code error;
  for (const FileDifference& change : changes) {
    if (change.difference == Difference::left_over) {
      fs::remove(target / change.name, error);
    } else {
      fs::rename(staging / change.name, target / change.name, error);
    }
    if (error) return fail(target / change.name, error.message(), diagnostics);
  }
  return true;
}

}  // namespace

bool write_files(const fs::path& directory, const std::vector<GeneratedFile>& files,
                 Diagnostics& diagnostics, std::chrono::milliseconds patience) {
  fs::path target = directory.lexically_normal();
  target = target.has_filename() ? target : target.parent_path();
  if (target.empty()) {
    diagnostics.add({Severity::error, "", 0, "--output", "the name of the folder is empty",
                     "Name the folder to write to."});
    return false;
  }
  if (compare_files(target, files).empty()) return true;
  LockedFolder locked(target);
  if (!locked.lock(patience, diagnostics)) return false;
  const auto changes = order_changes(compare_files(target, files));
  if (changes.empty()) return true;
  const StagingFolder staging(target);
  if (staging.error()) {
    return fail(target, "nothing can be written to it: " + staging.error().message(), diagnostics);
  }
  return stage(changes, files, target, staging.path(), diagnostics) &&
         move_into_place(changes, target, staging.path(), diagnostics);
}

}  // namespace treeline
