#include "launch/launch.hpp"

#include <fmt/format.h>

#include <fstream>
#include <utility>

#include "compilation/temporary_folder.hpp"
#include "emission/generated_file.hpp"
#include "emission/write_files.hpp"
#include "launch/describe_robot.hpp"
#include "launch/driven_scenes.hpp"
#include "launch/print_robot.hpp"
#include "launch/runtime_headers.hpp"
#include "trial/generate_tried.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;
using Tell = std::function<void(const std::string&)>;

/// The generated code of all scenes. That of the links is absent where nothing can be pulled, that
/// of the ground where there is none.
struct Parts {
  Scene control, links;
  std::optional<Scene> ground;
  Generation control_code;
  std::optional<Generation> link_code, ground_code;
};

std::optional<Parts> generate_parts(const LaunchInput& input, const Tell& tell,
                                    Diagnostics& diagnostics) {
  Parts parts;
  parts.control = control_scene(input.robot, input.scene, diagnostics);
  if (diagnostics.has_errors()) return std::nullopt;
  parts.links = link_scene(input.robot, parts.control);
  if (input.surroundings.ground) {
    parts.ground =
        ground_scene(input.robot, parts.control, *input.surroundings.ground, diagnostics);
  }
  if (diagnostics.has_errors()) return std::nullopt;
  const auto tell_function = [&tell](const std::string& function) {
    tell("generating " + function);
  };
  Scene generated = parts.control;
  if (is_closed(generated)) generated.damped.reset();  // `drive::ClosedLoops` damps by itself
  auto made = generate_tried(input.robot, generated, {}, {{}, tell_function}, diagnostics);
  if (!made || !made->failed.empty()) return std::nullopt;
  parts.control_code = std::move(made->generation);
  if (parts.ground) {
    auto ground = generate_tried(input.robot, *parts.ground, {}, {{}, tell_function}, diagnostics);
    if (!ground || !ground->failed.empty()) return std::nullopt;
    parts.ground_code = std::move(ground->generation);
  }
  if (parts.links.operational_points.empty()) return parts;
  Diagnostics of_links;  // what is said of the links has been said of the robot
  auto links = generate_tried(input.robot, parts.links, {}, {{}, tell_function}, of_links);
  if (links && links->failed.empty()) {
    parts.link_code = std::move(links->generation);
  } else {
    parts.links.operational_points.clear();
  }
  return parts;
}

std::optional<drive::RobotDescription> describe(const LaunchInput& input, const Parts& parts,
                                                Diagnostics& diagnostics) {
  drive::RobotDescription description =
      describe_robot(input.robot, parts.control, parts.links, parts.control_code.mechanism);
  if (!describe_surroundings(input.surroundings, parts.control, description, diagnostics)) {
    return std::nullopt;
  }
  description.on_ground = parts.ground.has_value();
  description.checksum = checksum_of(input.urdf_text, input.scene_text);
  description.urdf = input.urdf_text;
  return description;
}

bool write_parts(const LaunchInput& input, const Parts& parts, const fs::path& work,
                 Diagnostics& diagnostics) {
  bool written = write_files(work / parts.control.name, parts.control_code.files, diagnostics);
  if (parts.link_code) {
    written = write_files(work / parts.links.name, parts.link_code->files, diagnostics) && written;
  }
  if (parts.ground_code) {
    written =
        write_files(work / parts.ground->name, parts.ground_code->files, diagnostics) && written;
  }
  for (const auto& [name, text] : launch_templates::kIncluded) {
    written = written && write_work_file(work / "runtime" / name, std::string(text), diagnostics);
  }
  return written && write_work_file(work / "robot.cpp",
                                    print_robot(input.robot, parts.control, parts.control_code,
                                                parts.links, parts.ground),
                                    diagnostics);
}

fs::path compile_parts(const Parts& parts, const fs::path& work, const Tell& tell,
                       Diagnostics& diagnostics) {
  std::vector<CompiledPart> compiled = {{parts.control.name, &parts.control_code}};
  if (parts.link_code) compiled.push_back({parts.links.name, &*parts.link_code});
  if (parts.ground_code) compiled.push_back({parts.ground->name, &*parts.ground_code});
  return compile_robot(
      compiled, work,
      [&tell](int done, int total) { tell(fmt::format("compiled {}/{}", done, total)); },
      diagnostics);
}

}  // namespace

std::string checksum_of(const std::string& urdf_text, const std::string& scene_text) {
  return digest(urdf_text + '\0' + scene_text).substr(0, 16);
}

std::optional<LaunchedRobot> launch(
    const LaunchInput& input, const std::function<bool(const drive::RobotDescription&)>& accepts,
    const Tell& tell, Diagnostics& diagnostics) {
  const auto parts = generate_parts(input, tell, diagnostics);
  if (!parts) return std::nullopt;
  auto description = describe(input, *parts, diagnostics);
  if (!description || !accepts(*description)) return std::nullopt;
  auto folder = make_temporary_folder(diagnostics);
  if (!folder || !write_parts(input, *parts, folder->path(), diagnostics)) return std::nullopt;
  const fs::path path = compile_parts(*parts, folder->path(), tell, diagnostics);
  if (path.empty()) return std::nullopt;
  auto library = DrivenLibrary::load(path, diagnostics);
  if (!library) return std::nullopt;
  return LaunchedRobot{std::move(*description), std::move(folder), std::move(*library), input.robot,
                       parts->control};
}

}  // namespace treeline
