#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

#include "description/mjcf/read_bodies.hpp"

namespace treeline {
namespace {

/// Sections that move no body of the robot, or are read elsewhere.
constexpr std::array<std::string_view, 15> kKnown = {
    "compiler", "default",   "worldbody", "asset",   "equality", "actuator", "option", "visual",
    "size",     "statistic", "sensor",    "contact", "keyframe", "custom",   "tendon"};

class Model {
 public:
  Model(const std::string& path, Diagnostics& diagnostics) : reading_(path, diagnostics) {}

  std::optional<MjcfTree> read(const std::string& text) {
    const tinyxml2::XMLElement* const root = reading_.parse(text);
    if (root == nullptr) return std::nullopt;
    for (const tinyxml2::XMLElement* each : reading_.children(*root)) {
      if (std::string_view(each->Name()) == "default") reading_.read_defaults(*each, {});
    }
    sections_ = MjcfElement(*root, "", reading_).children();
    for (const MjcfElement& section : sections_) read_head(section);
    for (const MjcfElement& asset : inside("asset")) read_mjcf_asset(asset, compiler_, assets_);
    const char* const name = root->Attribute("model");
    tree_.model.name = name != nullptr && *name != '\0' ? name : "mujoco";
    read_bodies(all("worldbody"), compiler_, assets_, tree_);
    if (tree_.model.links.empty()) {
      reading_.report(Severity::error, *root, "the model has no <body>", "describe its bodies");
    }
    read_equalities(all("equality"), tree_);
    read_actuators(all("actuator"), compiler_, tree_);
    warn_of_tendons();
    reading_.report_counts();
    if (reading_.failed()) return std::nullopt;
    return std::move(tree_);
  }

 private:
  [[nodiscard]] std::vector<MjcfElement> all(std::string_view name) const {
    std::vector<MjcfElement> found;
    std::copy_if(sections_.begin(), sections_.end(), std::back_inserter(found),
                 [&](const MjcfElement& each) { return each.name() == name; });
    return found;
  }

  [[nodiscard]] std::vector<MjcfElement> inside(std::string_view name) const {
    std::vector<MjcfElement> found;
    for (const MjcfElement& section : all(name)) {
      for (const MjcfElement& each : section.children()) found.push_back(each);
    }
    return found;
  }

  void read_head(const MjcfElement& section) {
    if (section.name() == "compiler") read_compiler(section, compiler_);
    if (section.name() == "option") read_option(section);
    if (std::find(kKnown.begin(), kKnown.end(), section.name()) == kKnown.end()) {
      section.warn(fmt::format("<{}> is not read", section.name()), "");
    }
  }

  void read_option(const MjcfElement& option) {
    if (const auto g = option.numbers("gravity", 3, 3); !g.empty()) {
      tree_.hints.gravity = {g[0], g[1], g[2]};
    }
    for (const char* name : {"density", "viscosity"}) {
      if (option.number(name, 0) == 0) continue;
      option.warn(fmt::format("forces of a fluid, of which it gives the {}, are not read", name),
                  "add them under external_forces in the scene");
    }
    for (const MjcfElement& flag : option.children()) {
      if (flag.name() == "flag" && flag.is("gravity", "disable")) tree_.hints.gravity = {0, 0, 0};
    }
  }

  /// Warns of tendons that would move the robot. A tendon that only measures changes no motion.
  void warn_of_tendons() const {
    for (const MjcfElement& tendon : inside("tendon")) {
      for (const char* name : {"stiffness", "damping", "frictionloss", "armature", "range"}) {
        if (!tendon.has(name) || tendon.numbers(name, 1, 3) == std::vector<double>{0}) continue;
        tendon.warn(fmt::format("a tendon is not read, so its {} acts on no joint", name), "");
        break;
      }
    }
  }

  MjcfReading reading_;
  MjcfCompiler compiler_;
  MjcfAssets assets_;
  std::vector<MjcfElement> sections_;
  MjcfTree tree_;
};

}  // namespace

std::optional<MjcfTree> read_mjcf(const std::string& text, const std::string& path,
                                  Diagnostics& diagnostics) {
  return Model(path, diagnostics).read(text);
}

}  // namespace treeline
