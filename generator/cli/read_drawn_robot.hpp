#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/find_all_meshes.hpp"
#include "description/read_surroundings.hpp"
#include "drawing/read_visuals.hpp"

namespace treeline {

/// `read_visuals` or `read_collisions`.
using ShapeReader = std::vector<Visual> (*)(const std::string& urdf, const std::string& file,
                                            Diagnostics& diagnostics);

/// The shapes of all robots. Links and meshes of several are named as `join_robots` and
/// `find_all_meshes` name them.
std::vector<Visual> read_all_shapes(const RobotFiles& files, ShapeReader reader,
                                    Diagnostics& diagnostics);

/// The meshes among some shapes of all robots.
std::vector<drive::ServedMesh> find_meshes_of(const std::vector<Visual>& shapes,
                                              const RobotFiles& files,
                                              const drive::MeshPlaces& places);

/// Content of a picture, read from the files.
struct DrawnRobot {
  Robot robot;
  Scene scene;
  std::vector<Visual> visuals;
  SceneSurroundings surroundings;
  std::vector<std::string> files;  ///< that all this was read from
};

/// Reads a robot to be drawn, with meshes of at most `triangles` in all. Meshes that are missing or
/// cannot be read are a warning.
std::optional<DrawnRobot> read_drawn_robot(const std::string& urdf, const std::string& scene,
                                           const drive::MeshPlaces& places, std::size_t triangles,
                                           Diagnostics& diagnostics);

}  // namespace treeline
