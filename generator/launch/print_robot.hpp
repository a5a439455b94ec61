#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"
#include "description/surroundings.hpp"
#include "emission/emit.hpp"
#include "generation/generate_code.hpp"
#include "mechanism/mechanism.hpp"
#include "text/diagnostic.hpp"

namespace treeline {

/// The source that joins the generated functions with the loop: a struct for `drive::DriveLoop`.
std::string print_robot(const Robot& robot, const Scene& control, const Generation& generation,
                        const Scene& links, const std::optional<Scene>& ground);

/// Whether constraints hold the robot to the world, so that its base needs no ideal forces.
bool is_held_to_world(const Scene& scene);

/// Whether the robot's dynamics are those of `drive::ClosedLoops`.
inline bool is_closed(const Scene& scene) {
  return scene.holds_rows();
}

/// Velocities without a motor: of `passive` joints, and of a floating base that is held to the
/// world.
std::vector<int> unmotored_velocities(const Scene& scene, const Mechanism& mechanism);

/// Members of a driven robot whose loops are closed or that is held to the world, beside those of
/// its tree. `links` is the scene of its links' frames.
std::string print_closed_loops(const Scene& control, const Mechanism& mechanism,
                               const Scene& links);

/// Whether a held link, with all that is fixed to it, has a point among `touches` that may touch
/// the ground.
bool has_sole(const Robot& robot, const std::string& link, const std::vector<SceneTouch>& touches);

/// Members of a driven robot that stands on a ground: the points of its feet that may touch it, in
/// the frames of `constraints` to the world, and the ground's friction.
std::string print_soles(const Robot& robot, const Scene& ground, const Scene& control);

/// Generated code of one name, whose files are in the folder of that name.
struct CompiledPart {
  std::string name;
  const Generation* generation = nullptr;
};

/// Compiles the parts and `robot.cpp`, which all lie in `work` beside `runtime/`, and links them to
/// a shared library in `work`, whose path is returned; empty after an error. A library that an
/// earlier run made of the same bytes is taken instead, see `folder_of_kept_libraries`. `progress`
/// receives the number of sources that are done and of all.
std::filesystem::path compile_robot(const std::vector<CompiledPart>& parts,
                                    const std::filesystem::path& work,
                                    const std::function<void(int, int)>& progress,
                                    Diagnostics& diagnostics);

}  // namespace treeline
