#include "emission/write_files.hpp"

#include <algorithm>
#include <fstream>
#include <system_error>

#include "emission/compare_files.hpp"
#include "emission/print_manifest.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

bool fail(const fs::path& path, const std::string& fault, Diagnostics& diagnostics) {
  diagnostics.add({Severity::error, path.string(), 0, "", fault,
                   "Check that the folder exists, is yours to write and has space left."});
  return false;
}

/// A folder beside the target that is gone, with what is in it, when this ends.
class StagingFolder {
 public:
  explicit StagingFolder(const fs::path& target) {
    for (int i = 0; i < 100 && path_.empty(); ++i) {
      fs::path candidate = target;
      candidate += ".part" + std::to_string(i);
      if (fs::create_directory(candidate, error_)) {
        path_ = std::move(candidate);
      }
    }
  }
  ~StagingFolder() {
    if (!path_.empty()) {
      fs::remove_all(path_, error_);
    }
  }
  StagingFolder(const StagingFolder&) = delete;
  StagingFolder& operator=(const StagingFolder&) = delete;

  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
  std::error_code error_;
};

bool write_file(const fs::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  return stream.good();
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

}  // namespace

bool write_files(const fs::path& directory, const std::vector<GeneratedFile>& files,
                 Diagnostics& diagnostics) {
  std::error_code error;
  fs::path target = directory.lexically_normal();
  target = target.has_filename() ? target : target.parent_path();
  const auto changes = order_changes(compare_files(target, files));
  if (changes.empty()) {
    return true;
  }
  fs::create_directories(fs::absolute(target).parent_path(), error);
  const StagingFolder staging(target);
  if (staging.path().empty()) {
    return fail(target, "cannot make a folder beside it", diagnostics);
  }
  for (const FileDifference& change : changes) {
    if (change.difference != Difference::left_over &&
        !write_file(staging.path() / change.name, find_file(files, change.name).text)) {
      return fail(target / change.name, "cannot write the file", diagnostics);
    }
  }
  fs::create_directories(target, error);
  for (const FileDifference& change : changes) {
    if (change.difference == Difference::left_over) {
      fs::remove(target / change.name, error);
    } else {
      fs::rename(staging.path() / change.name, target / change.name, error);
    }
    if (error) {
      return fail(target / change.name, error.message(), diagnostics);
    }
  }
  return true;
}

}  // namespace treeline
