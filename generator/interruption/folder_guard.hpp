#pragma once

#include <filesystem>
#include <memory>
#include <string>

namespace treeline {

/// A lock on a folder that other runs of this program see. The system opens it when the process
/// ends, however that comes about; it leaves no file.
class FolderGuard {
 public:
  /// Nothing where another run has the folder locked or has removed it, which may pass, with an
  /// empty `error`; nothing where it cannot be opened, with the reason. A file system without locks
  /// counts as unlocked.
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
