#include "drive/find_meshes.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>
#include <system_error>

namespace treeline::drive {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostMeshes = 4096;

std::string unescape(std::string_view text) {
  constexpr std::array<std::pair<std::string_view, char>, 5> kEntities = {
      {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};
  std::string plain;
  while (!text.empty()) {
    const auto entity = std::find_if(kEntities.begin(), kEntities.end(),
                                     [text](const auto& e) { return text.starts_with(e.first); });
    plain += entity != kEntities.end() ? entity->second : text.front();
    text.remove_prefix(entity != kEntities.end() ? entity->first.size() : 1);
  }
  return plain;
}

/// The value of the attribute `filename` in a tag.
std::optional<std::string> filename_of(std::string_view tag) {
  constexpr std::string_view kName = "filename";
  std::size_t at = tag.find(kName);
  if (at == std::string_view::npos) return std::nullopt;
  at = tag.find_first_of("\"'", at + kName.size());
  if (at == std::string_view::npos) return std::nullopt;
  const std::size_t end = tag.find(tag[at], at + 1);
  if (end == std::string_view::npos) return std::nullopt;
  return unescape(tag.substr(at + 1, end - at - 1));
}

std::vector<std::string> mesh_names(std::string_view urdf) {
  std::vector<std::string> names;
  for (std::size_t at = urdf.find("<mesh");
       at != std::string_view::npos && names.size() < kMostMeshes;
       at = urdf.find("<mesh", at + 1)) {
    const std::size_t end = urdf.find('>', at);
    if (end == std::string_view::npos) break;
    const auto name = filename_of(urdf.substr(at, end - at));
    if (name && std::find(names.begin(), names.end(), *name) == names.end()) {
      names.push_back(*name);
    }
  }
  return names;
}

bool is_mesh(const fs::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  constexpr std::array kMeshes = {".stl", ".dae", ".obj", ".glb", ".gltf"};
  return std::find(kMeshes.begin(), kMeshes.end(), extension) != kMeshes.end();
}

/// `file` below `root`, if it is a mesh and really lies there.
std::string find_below(const fs::path& root, const fs::path& file) {
  std::error_code error;
  const fs::path base = fs::canonical(root, error);
  if (error || file.is_absolute()) return {};
  const fs::path path = fs::canonical(base / file, error);
  if (error || !is_mesh(path) || !fs::is_regular_file(path, error)) return {};
  const auto parted = std::mismatch(base.begin(), base.end(), path.begin(), path.end());
  return parted.first == base.end() ? path.string() : std::string();
}

fs::path find_package(const std::string& name, const fs::path& folder,
                      const std::map<std::string, fs::path>& packages) {
  const auto given = packages.find(name);
  if (given != packages.end()) return given->second;
  std::error_code error;
  fs::path above = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error || name.empty() || name == "." || name == "..") return {};
  for (; above.has_relative_path(); above = above.parent_path()) {
    if (above.filename() == name) return above;
    if (fs::is_directory(above / name, error)) return above / name;
  }
  return {};
}

}  // namespace

std::vector<ServedMesh> find_meshes(std::string_view urdf, const fs::path& folder,
                                    const std::map<std::string, fs::path>& packages) {
  constexpr std::string_view kPackage = "package://";
  std::vector<ServedMesh> meshes;
  for (const std::string& name : mesh_names(urdf)) {
    std::string path;
    if (name.starts_with(kPackage)) {
      const std::string rest = name.substr(kPackage.size());
      const std::size_t slash = rest.find('/');
      if (slash != std::string::npos) {
        const fs::path root = find_package(rest.substr(0, slash), folder, packages);
        if (!root.empty()) path = find_below(root, rest.substr(slash + 1));
      }
    } else {
      path = find_below(folder.empty() ? fs::path(".") : folder, name);
    }
    meshes.push_back({name, path});
  }
  return meshes;
}

}  // namespace treeline::drive
