#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace treeline {

/// A lock on a folder, visible to other runs of this program. The system releases it when the
/// process ends for any reason. It leaves no file.
class FolderGuard {
 public:
  /// Tries to lock the folder. Returns nothing with an empty `error` if another run has locked or
  /// removed it, which may be temporary; nothing with the reason if the folder cannot be opened. A
  /// file system without locks counts as unlocked.
  static std::unique_ptr<FolderGuard> try_lock(const std::filesystem::path& folder,
                                               std::string& error);
  ~FolderGuard();
  FolderGuard(const FolderGuard&) = delete;
  FolderGuard& operator=(const FolderGuard&) = delete;

 private:
  explicit FolderGuard(int file) : file_(file) {}
  int file_;
};

}  // namespace treeline
