#include <algorithm>
#include <filesystem>

#include "cli/print_outputs.hpp"
#include "emission/write_files.hpp"

namespace treeline {
namespace {

/// The folder where it lies. An empty name of the whole stays empty, which `write_files` refuses.
std::filesystem::path place_of(const std::string& output, const PackageFolder& folder) {
  if (folder.path.empty() || output.empty()) return output;
  return std::filesystem::path(output) / folder.path;
}

}  // namespace

std::vector<FileDifference> compare_folders(const std::string& output,
                                            const std::vector<PackageFolder>& folders) {
  std::vector<FileDifference> differences;
  for (const PackageFolder& folder : folders) {
    for (FileDifference each : compare_files(place_of(output, folder), folder.files)) {
      if (!folder.path.empty()) each.name.insert(0, folder.path + "/");
      differences.push_back(std::move(each));
    }
  }
  return differences;
}

bool write_folders(const std::string& output, const std::vector<PackageFolder>& folders,
                   Diagnostics& diagnostics) {
  return std::all_of(folders.begin(), folders.end(), [&](const PackageFolder& folder) {
    return write_files(place_of(output, folder), folder.files, diagnostics);
  });
}

std::size_t count_files(const std::vector<PackageFolder>& folders) {
  std::size_t count = 0;
  for (const PackageFolder& folder : folders) count += folder.files.size();
  return count;
}

}  // namespace treeline
