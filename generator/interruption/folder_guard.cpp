#include "interruption/folder_guard.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

namespace treeline {
namespace {

std::string message(int error) {
  return std::generic_category().message(error);
}

/// Whether the open file is still the one at this path. The folder may have been removed and
/// created again.
bool is_at(int file, const std::filesystem::path& path) {
  struct stat opened {};
  struct stat there {};
  return fstat(file, &opened) == 0 && stat(path.c_str(), &there) == 0 &&
         opened.st_dev == there.st_dev && opened.st_ino == there.st_ino;
}

}  // namespace

std::unique_ptr<FolderGuard> FolderGuard::try_lock(const std::filesystem::path& folder,
                                                   std::string& error) {
  error.clear();
  const int file = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (file < 0) {
    if (errno != ENOENT) error = message(errno);
    return nullptr;
  }
  std::unique_ptr<FolderGuard> guard(new FolderGuard(file));
  const bool taken = flock(file, LOCK_EX | LOCK_NB) != 0 && errno == EWOULDBLOCK;
  return taken || !is_at(file, folder) ? nullptr : std::move(guard);
}

FolderGuard::~FolderGuard() {
  close(file_);
}

}  // namespace treeline
