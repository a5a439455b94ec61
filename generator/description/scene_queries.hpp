#pragma once

#include <array>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "description/robot.hpp"
#include "description/scene.hpp"

namespace treeline {

/// Names of a point's rows in scenes: along and about the axes.
inline constexpr std::array kRowNames = {"x", "y", "z", "rx", "ry", "rz"};

/// What messages and texts call it.
inline constexpr const char* kCenterOfMass = "the centre of mass";

/// The rows of the point that are controlled, in their order: "x y rz".
std::string list_rows(const ScenePoint& point, std::string_view between = " ");

/// The effective mass (kg; kg m^2 in rows of rotation) beyond which each row is relaxed of the
/// task, as the emitted code's Real has it; empty where the scene does not ask for damping.
std::vector<double> effective_mass_limits(const Scene& scene);

/// Kind of the base where no scene states it: fixed; floating where the file says so, or where no
/// joint moves and there is mass, as of drones and single bodies, which could not move at all
/// otherwise.
Base default_base(const Robot& robot);

/// Why `default_base` is floating: `the file says so` or `no joint moves`.
const char* why_floating(const Robot& robot);

/// The file that messages of a scene name: its own, without one the robot's.
const std::string& file_of_scene(const Scene& scene, const Robot& robot);

/// Whether the text of a scene has a key, such as `functions`; false for one that cannot be parsed.
bool states_key(const std::string& scene_text, const std::string& key);

/// The coordinates that move something: for each the joint that owns it (index into Robot::joints,
/// or `kFloatingBase`) with its degrees of freedom.
using Freedoms = std::map<int, int>;
inline constexpr int kFloatingBase = -1;

/// Sum over the owners: entries of qd.
int count(const Freedoms& freedoms);

/// All coordinates of the robot in the scene: fixed, locked and mimic joints own none.
Freedoms find_freedoms(const Robot& robot, const Scene& scene);

/// Coordinates that move a link in the world. A mimic joint counts as the joint that it follows.
Freedoms find_freedoms_of_link(const Robot& robot, const Scene& scene, const std::string& link);

/// Coordinates that move an operational point: all may move the centre of mass.
Freedoms find_freedoms_of(const Robot& robot, const Scene& scene, const ScenePoint& point);

/// Whether some joint between two links moves.
bool moves_against(const Robot& robot, const Scene& scene, const std::string& link,
                   const std::string& other);

}  // namespace treeline
