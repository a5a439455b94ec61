#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "interruption/folder_guard.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// A new folder among the system's temporary files. It is removed with its contents when this
/// object is destroyed, or when a signal ends the program (see `clean_up_on_signals`). Folders left
/// behind by a killed run are removed when the next run makes its first folder.
class TemporaryFolder {
 public:
  /// Throws std::filesystem::filesystem_error if no folder can be made.
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<FolderGuard> guard_;  ///< tells other runs that this one is alive
};

/// Makes a temporary folder. Returns nothing and reports an error if that fails, for instance
/// because TMPDIR does not exist or the disk is full.
std::unique_ptr<TemporaryFolder> make_temporary_folder(Diagnostics& diagnostics);

/// Writes a file, of a temporary folder or one that was named, and the folders that it is in.
/// Errors: it cannot be written to its end.
bool write_work_file(const std::filesystem::path& path, const std::string& bytes,
                     Diagnostics& diagnostics);

}  // namespace treeline
