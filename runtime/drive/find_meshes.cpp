#include "drive/find_meshes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <fstream>
#include <optional>
#include <system_error>

#include "drive/find_package.hpp"
#include "drive/stl_form.hpp"

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

/// Whether a path, without links and `..`, lies in a folder, which may have both.
bool lies_below(const fs::path& path, const fs::path& folder) {
  std::error_code error;
  const fs::path base = fs::canonical(folder, error);
  if (error) return false;
  const auto parted = std::mismatch(base.begin(), base.end(), path.begin(), path.end());
  return parted.first == base.end();
}

/// Why an STL of triangles cannot be whole; empty if it can. One in words is not looked at.
std::string reason_of_cut(const fs::path& path, std::uintmax_t size) {
  std::string head(StlForm::kHead, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return stl_form(head, size).problem;
}

ServedMesh refuse(std::string problem, std::string remedy) {
  return {{}, {}, std::move(problem), std::move(remedy)};
}

/// A file that may be shown, if it is a mesh.
ServedMesh look_at(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) {
    return refuse("there is no file " + path.string(),
                  "Copy the meshes there, or look at the name in the URDF.");
  }
  if (!is_mesh(path)) {
    return refuse("its name does not end with .stl, .dae, .obj, .glb or .gltf",
                  "Convert it to one of these.");
  }
  std::string extension = path.extension().string();
  if (extension.size() == 4 && (extension[1] | 0x20) == 's') {
    std::string cut = reason_of_cut(path, fs::file_size(path, error));
    if (!cut.empty()) return refuse(std::move(cut), "Copy or export it again.");
  }
  return {{}, path.string(), {}, {}};
}

/// `file` if it lies in one of the folders. Whether it is there is not told where it does not.
ServedMesh find_in(const fs::path& file, const std::vector<fs::path>& folders) {
  std::error_code error;
  const fs::path path = fs::weakly_canonical(file, error);
  const bool permitted = !error && std::ranges::any_of(folders, [&](const fs::path& folder) {
    return lies_below(path, folder);
  });
  if (permitted) return look_at(path);
  return refuse("it lies outside of " + folders.front().string(),
                "If its folder is meant: --mesh-folder " + path.parent_path().string() + ".");
}

ServedMesh find_in_package(std::string_view name, const fs::path& folder,
                           const MeshPlaces& places) {
  const std::size_t slash = std::min(name.find('/'), name.size());
  const FoundPackage package = find_package(std::string(name.substr(0, slash)), folder, places);
  if (package.folder.empty()) return refuse(package.problem, package.remedy);
  const fs::path rest = fs::path(name.substr(slash)).relative_path();
  const bool leaves = std::ranges::find(rest, "..") != rest.end();
  if (package.installed && !leaves) return look_at(package.folder / rest);
  std::vector<fs::path> folders = {package.folder};
  folders.insert(folders.end(), places.folders.begin(), places.folders.end());
  return find_in(package.folder / rest, folders);
}

/// `%20` and the like, as addresses have them.
std::string decode(std::string_view address) {
  std::string plain;
  for (std::size_t i = 0; i < address.size(); ++i) {
    unsigned byte = 0;
    const char* const digits = address.data() + i + 1;
    if (address[i] == '%' && i + 2 < address.size() &&
        std::from_chars(digits, digits + 2, byte, 16).ptr == digits + 2) {
      plain += static_cast<char>(byte);
      i += 2;
    } else {
      plain += address[i];
    }
  }
  return plain;
}

ServedMesh find_mesh(std::string_view name, const fs::path& folder, const MeshPlaces& places) {
  constexpr std::string_view kPackage = "package://";
  constexpr std::string_view kFile = "file://";
  if (name.starts_with(kPackage)) {
    return find_in_package(name.substr(kPackage.size()), folder, places);
  }
  std::vector<fs::path> folders = {folder};
  folders.insert(folders.end(), places.folders.begin(), places.folders.end());
  if (name.starts_with(kFile)) {
    name.remove_prefix(kFile.size());
    if (name.starts_with("localhost/")) name.remove_prefix(std::string_view("localhost").size());
    return find_in(folder / decode(name), folders);
  }
  if (name.find("://") != std::string_view::npos) {
    return refuse("only package:// and file:// are read", "Name a file, or a package's.");
  }
  return find_in(folder / name, folders);
}

}  // namespace

std::vector<ServedMesh> find_meshes(std::string_view urdf, const fs::path& folder,
                                    const MeshPlaces& places) {
  std::error_code error;
  const fs::path here = fs::absolute(folder.empty() ? fs::path(".") : folder, error);
  std::vector<ServedMesh> meshes;
  for (const std::string& name : mesh_names(urdf)) {
    meshes.push_back(find_mesh(name, here, places));
    meshes.back().uri = name;
  }
  return meshes;
}

}  // namespace treeline::drive
