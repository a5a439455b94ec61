#pragma once

#include <filesystem>
#include <memory>

#include "description/diagnostic.hpp"
#include "interruption/folder_guard.hpp"

namespace treeline {

/// A new folder among the system's temporary files, gone with all it holds when this is, or when a
/// signal ends the program (see `clean_up_on_signals`). What a run that was killed outright has
/// left behind goes when the next one makes its first folder.
class TemporaryFolder {
 public:
  /// Throws std::filesystem::filesystem_error when none can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<FolderGuard> guard_;  ///< tells other runs that this one lives
};

/// Nothing, and an error, when none can be made: TMPDIR leads nowhere, the disk is full.
std::unique_ptr<TemporaryFolder> make_temporary_folder(Diagnostics& diagnostics);

}  // namespace treeline
