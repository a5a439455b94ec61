#include "emission/compare_files.hpp"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <optional>

#include "emission/print_manifest.hpp"

namespace treeline {
namespace {

std::optional<std::string> read_file(const std::filesystem::path& path) {
  std::ifstream stream(path, std::ios::binary);
  if (!stream) {
    return std::nullopt;
  }
  return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace

std::vector<FileDifference> compare_files(const std::filesystem::path& directory,
                                          const std::vector<GeneratedFile>& files) {
  std::vector<FileDifference> differences;
  for (const GeneratedFile& file : files) {
    const auto present = read_file(directory / file.name);
    if (!present) {
      differences.push_back({file.name, Difference::missing});
    } else if (*present != file.text) {
      differences.push_back({file.name, Difference::changed});
    }
  }
  for (const std::string& name :
       read_manifest_files(read_file(directory / kManifestName).value_or(""))) {
    const bool is_made = std::any_of(files.begin(), files.end(),
                                     [&](const GeneratedFile& file) { return file.name == name; });
    const bool is_plain =
        std::filesystem::path(name).filename() == name && name != "." && name != "..";
    if (!is_made && is_plain && std::filesystem::exists(directory / name)) {
      differences.push_back({name, Difference::left_over});
    }
  }
  std::sort(differences.begin(), differences.end(),
            [](const FileDifference& a, const FileDifference& b) { return a.name < b.name; });
  return differences;
}

}  // namespace treeline
