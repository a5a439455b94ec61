#include "description/read_robots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include "description/parse_yaml.hpp"
#include "description/read_robot_text.hpp"
#include "description/read_scene_point.hpp"
#include "description/read_urdf.hpp"
#include "description/scene_element.hpp"
#include "description/scene_queries.hpp"
#include "text/identifier.hpp"
#include "text/read_text_file.hpp"

namespace treeline {
namespace {

namespace fs = std::filesystem;

constexpr const char* kEntry = "write {name: left, urdf: arm.urdf, pose: {xyz: [0, 0.5, 0]}}";

std::optional<YAML::Node> parse_quietly(const std::string& text) {
  Diagnostics ignored;
  auto document = parse_yaml(text, "", ignored);
  if (document && !document->IsMap()) return std::nullopt;
  return document;
}

class Reader {
 public:
  Reader(const std::string& scene_path, Diagnostics& diagnostics)
      : folder_(fs::path(scene_path == "-" ? "" : scene_path).parent_path()),
        diagnostics_(diagnostics) {}

  void read(const SceneElement& item) {
    const SceneFields fields = item.fields({"name", "urdf", "pose", "base"});
    PlacedRobot placed;
    placed.name = read_name(item, fields);
    const auto file = read_file(item, fields);
    if (!file || !fits(item, parsed_[*file])) return;
    placed.robot = parsed_[*file];
    read_base(item, fields, placed);
    found_.robots.push_back(std::move(placed));
    found_.file_of_robot.push_back(*file);
  }

  SceneRobots take() { return std::move(found_); }

 private:
  std::string read_name(const SceneElement& item, const SceneFields& fields) {
    const auto found = fields.find("name");
    if (found == fields.end()) {
      item.error("the key \"name\" is missing", kEntry);
      return {};
    }
    const auto name = found->second.text();
    if (!name) return {};
    if (!is_identifier(*name)) {
      found->second.error(fmt::format("\"{}\" cannot be a name in emitted code", *name),
                          fmt::format("write {}", identifier_from(*name)));
    } else if (*name == kWorldLink) {
      found->second.error("this is what all robots stand in", "give the robot another name");
    } else if (!names_.insert(*name).second) {
      found->second.error(fmt::format("the name \"{}\" is already taken by a robot", *name),
                          "give each a name of its own, also where they share a URDF");
    }
    return *name;
  }

  /// Index of the URDF; nothing where it, or what is said of it, has a fault.
  std::optional<std::size_t> read_file(const SceneElement& item, const SceneFields& fields) {
    const auto found = fields.find("urdf");
    if (found == fields.end()) {
      item.error("the key \"urdf\" is missing", kEntry);
      return std::nullopt;
    }
    const auto name = found->second.text();
    if (!name) return std::nullopt;
    if (*name == "-") {
      found->second.error("standard input holds no more than one file",
                          "name the URDF relative to the scene's folder");
      return std::nullopt;
    }
    const std::string path = (folder_ / *name).lexically_normal().string();
    const auto same = [&](const InputFile& file) { return file.path == path; };
    const auto known = std::find_if(found_.files.begin(), found_.files.end(), same);
    if (known != found_.files.end()) {
      return static_cast<std::size_t>(known - found_.files.begin());
    }
    return parse(*name, path, found->second);
  }

  std::optional<std::size_t> parse(const std::string& name, const std::string& path,
                                   const SceneElement& element) {
    if (failed_.contains(path)) return std::nullopt;
    auto text = read_robot_text(path, diagnostics_);
    auto robot = text ? parse_robot(*text, diagnostics_) : std::nullopt;
    if (!robot) {
      failed_.insert(path);
      element.error("this robot cannot be read, see above",
                    "paths are relative to the folder of the scene");
      return std::nullopt;
    }
    const fs::path written = name;
    found_.files.push_back(
        {written.is_absolute() ? written.filename().string() : name, path, std::move(text->urdf)});
    parsed_.push_back(std::move(*robot));
    return parsed_.size() - 1;
  }

  /// Whether all robots up to this one are together no larger than one may be; an error at the
  /// first that is too many.
  bool fits(const SceneElement& item, const Robot& robot) {
    const bool fitted = links_ < kMostLinks;
    links_ += robot.links.size();
    if (links_ < kMostLinks) return true;
    if (fitted) {
      item.error(
          fmt::format("with this robot there are {} links, more than {}", links_, kMostLinks - 1),
          "list fewer robots");
    }
    return false;
  }

  static void read_base(const SceneElement& item, const SceneFields& fields, PlacedRobot& placed) {
    if (const auto base = fields.find("base"); base != fields.end()) {
      placed.base = base->second.choice({"fixed", "floating"}) == 1 ? Base::floating : Base::fixed;
    } else {
      placed.base = default_base(placed.robot);
      if (placed.base == Base::floating) {
        item.note(fmt::format("nothing is said of this robot's base, which floats, for {}",
                              why_floating(placed.robot)),
                  "write base: floating or base: fixed to choose");
      }
    }
    const auto pose = fields.find("pose");
    if (pose == fields.end()) return;
    placed.pose = read_origin(pose->second);
    if (placed.base == Base::floating) {
      pose->second.error("a floating base has its pose in q, not in the scene",
                         "leave out pose, or write base: fixed");
    }
  }

  fs::path folder_;
  Diagnostics& diagnostics_;
  SceneRobots found_;
  std::vector<Robot> parsed_;  ///< by file
  std::size_t links_ = 0;      ///< of all robots so far
  std::set<std::string> names_, failed_;
};

}  // namespace

bool is_scene_text(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (first == std::string::npos || text[first] == '<') return false;
  return parse_quietly(text).has_value();
}

bool lists_robots(const std::string& scene_text) {
  const auto document = parse_quietly(scene_text);
  return document && (*document)["robots"];
}

std::optional<SceneRobots> read_robots(const std::string& scene_text, const std::string& scene_path,
                                       Diagnostics& diagnostics) {
  const std::string shown = shown_path(scene_path);
  const auto document = parse_yaml(scene_text, shown, diagnostics);
  if (!document) return std::nullopt;
  SceneReading reading{shown, diagnostics, alias_lines(scene_text)};
  const SceneElement list((*document)["robots"], "robots", reading);
  Reader reader(scene_path, diagnostics);
  const std::vector<SceneElement> items = list.items();
  if (items.empty()) list.error("no robot is listed", kEntry);
  for (const SceneElement& item : items) reader.read(item);
  SceneRobots found = reader.take();
  if (reading.failed) return std::nullopt;
  return found;
}

}  // namespace treeline
