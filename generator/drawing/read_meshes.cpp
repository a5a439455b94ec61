#include <set>

#include "drawing/read_visuals.hpp"
#include "drawing/simplify_triangles.hpp"

namespace treeline {
namespace {

/// Reads a mesh and reduces it by itself, since all together may not fit into memory.
Mesh read_reduced(const std::string& path, std::size_t most) {
  Mesh mesh = read_mesh(path);
  std::vector<std::size_t> tags(mesh.triangles.size(), 0);
  simplify_triangles(mesh.triangles, tags, most);
  return mesh;
}

/// Reduces the triangles of all visuals together, so that each gets what its form needs.
void simplify_all(std::vector<Visual>& visuals, std::size_t most) {
  std::vector<Triangle> triangles;
  std::vector<std::size_t> tags;
  for (std::size_t i = 0; i < visuals.size(); ++i) {
    triangles.insert(triangles.end(), visuals[i].triangles.begin(), visuals[i].triangles.end());
    tags.resize(triangles.size(), i);
    visuals[i].triangles.clear();
  }
  simplify_triangles(triangles, tags, most);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    visuals[tags[t]].triangles.push_back(triangles[t]);
  }
}

}  // namespace

std::vector<UnreadMesh> read_meshes(std::vector<Visual>& visuals,
                                    const std::map<std::string, std::string>& paths,
                                    std::size_t most) {
  std::map<std::string, Mesh> meshes;
  std::set<std::string> seen;  // links
  for (Visual& visual : visuals) {
    const auto path = paths.find(visual.file);
    if (visual.kind != VisualKind::mesh || path == paths.end()) continue;
    const auto [mesh, is_new] = meshes.try_emplace(visual.file);
    if (is_new) mesh->second = read_reduced(path->second, most);
    const Eigen::Affine3d scale(Eigen::Scaling(visual.size));
    for (const Triangle& triangle : mesh->second.triangles) {
      visual.triangles.push_back(moved(triangle, scale));
    }
    if (!visual.triangles.empty()) seen.insert(visual.link);
  }
  std::erase_if(visuals, [&](const Visual& visual) {
    return visual.stands_in && seen.contains(visual.link);
  });
  simplify_all(visuals, most);
  std::vector<UnreadMesh> unread;
  for (const auto& [file, mesh] : meshes) {
    if (!mesh.problem.empty()) unread.push_back({file, mesh.problem, mesh.remedy});
  }
  return unread;
}

}  // namespace treeline
