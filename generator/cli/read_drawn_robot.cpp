#include "cli/read_drawn_robot.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "drawing/read_visuals.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

void add_meshes(const RobotFiles& files, const drive::MeshPlaces& places, std::size_t triangles,
                std::vector<Visual>& visuals, Diagnostics& diagnostics) {
  std::vector<drive::ServedMesh> found = find_meshes_of(visuals, files, places);
  std::map<std::string, std::string> paths;
  for (const drive::ServedMesh& mesh : found) {
    if (!mesh.path.empty()) paths[mesh.uri] = mesh.path;
  }
  for (UnreadMesh& unread : read_meshes(visuals, paths, triangles)) {
    *std::ranges::find(found, unread.file, &drive::ServedMesh::uri) = {
        unread.file, "", std::move(unread.problem), std::move(unread.remedy)};
  }
  warn_of_missing(found, "shown", diagnostics);
}

}  // namespace

std::vector<Visual> read_all_shapes(const RobotFiles& files, ShapeReader reader,
                                    Diagnostics& diagnostics) {
  if (!files.urdf.empty()) return reader(files.urdf_text, shown_path(files.urdf), diagnostics);
  const SceneRobots& listed = files.scene_robots;
  std::vector<std::vector<Visual>> of_files;
  for (const InputFile& file : listed.files) {
    of_files.push_back(reader(file.text, file.path, diagnostics));
  }
  std::vector<Visual> visuals;
  for (std::size_t i = 0; i < listed.robots.size(); ++i) {
    for (Visual visual : of_files[listed.file_of_robot[i]]) {
      visual.link.insert(0, listed.robots[i].name + "/");
      if (visual.kind == VisualKind::mesh) visual.file.insert(0, listed.robots[i].name + "/");
      visuals.push_back(std::move(visual));
    }
  }
  return visuals;
}

std::vector<drive::ServedMesh> find_meshes_of(const std::vector<Visual>& shapes,
                                              const RobotFiles& files,
                                              const drive::MeshPlaces& places) {
  std::vector<drive::ServedMesh> found = find_all_meshes(files, places);
  std::erase_if(found, [&](const drive::ServedMesh& mesh) {
    return std::ranges::find(shapes, mesh.uri, &Visual::file) == shapes.end();
  });
  return found;
}

std::optional<DrawnRobot> read_drawn_robot(const std::string& urdf, const std::string& scene,
                                           const drive::MeshPlaces& places, std::size_t triangles,
                                           Diagnostics& diagnostics) {
  Diagnostics own;
  auto read = read_robot_files(urdf, scene, own);
  auto parsed = read ? parse_scene_of(*read, own) : std::nullopt;
  // What is worth a warning about dynamics is not about a picture.
  for (const Diagnostic& diagnostic : own.list()) {
    if (diagnostic.severity == Severity::error) diagnostics.add(diagnostic);
  }
  if (!parsed) return std::nullopt;
  auto visuals = read_all_shapes(read->files, read_visuals, diagnostics);
  add_meshes(read->files, places, triangles, visuals, diagnostics);
  auto surroundings = surroundings_of(read->files.scene_text, read->robot);
  return DrawnRobot{std::move(read->robot), std::move(*parsed), std::move(visuals),
                    std::move(surroundings), list_paths(read->files)};
}

}  // namespace treeline
