#pragma once

#include <fmt/format.h>

#include <string>
#include <vector>

#include "random_mechanism.hpp"

/// Random robots with families of limbs, as files that people write: hands, legs, wheels.
namespace treeline::tests {

struct DrawnLimbs {
  std::string urdf, scene;
};

namespace detail {

/// Builds the text of a robot whose limbs are alike by shape and differ in every number.
class LimbWriter {
 public:
  explicit LimbWriter(Rng& rng) : rng_(rng) { add_link("trunk"); }

  /// Adds a chain to `parent`, with a joint for each of `types`; returns its last link.
  std::string add_chain(const std::string& parent, const std::string& name,
                        const std::vector<const char*>& types) {
    std::string last = parent;
    for (std::size_t i = 0; i < types.size(); ++i) {
      const std::string link = fmt::format("{}_{}", name, i);
      add_link(link);
      add_joint(types[i], last, link);
      last = link;
    }
    return last;
  }

  /// A family: so many limbs of one shape on one link. Returns their tips.
  std::vector<std::string> add_family(const std::string& parent, const std::string& name,
                                      int limbs) {
    std::vector<const char*> types(at(1 + rng_.below(3)));
    for (const char*& type : types) type = rng_.chance(0.8) ? "revolute" : "prismatic";
    std::vector<std::string> tips;
    for (int i = 0; i < limbs; ++i) {
      tips.push_back(add_chain(parent, fmt::format("{}{}", name, i), types));
    }
    return tips;
  }

  [[nodiscard]] std::string urdf() const {
    return "<robot name=\"limbed\">\n" + text_ + "</robot>\n";
  }

 private:
  void add_link(const std::string& name) {
    text_ += fmt::format(
        "<link name=\"{}\"><inertial><origin xyz=\"{} {} {}\"/><mass value=\"{}\"/><inertia "
        "ixx=\"{}\" iyy=\"{}\" izz=\"{}\" ixy=\"0\" ixz=\"0\" iyz=\"0.0001\"/></inertial></link>\n",
        name, length(), length(), length(), rng_.rounded(0.2, 3), rng_.rounded(0.02, 0.03),
        rng_.rounded(0.02, 0.03), rng_.rounded(0.02, 0.03));
  }
  void add_joint(const char* type, const std::string& parent, const std::string& child) {
    const std::array<double, 3> axis = random_axis(rng_, 0.8);
    text_ += fmt::format(
        "<joint name=\"{1}_joint\" type=\"{0}\"><parent link=\"{2}\"/><child link=\"{1}\"/>"
        "<origin xyz=\"{3} {4} {5}\" rpy=\"0 0 {6}\"/><axis xyz=\"{7} {8} {9}\"/>"
        "<limit lower=\"-1\" upper=\"1\" effort=\"10\" velocity=\"2\"/></joint>\n",
        type, child, parent, length(), length(), length(), rng_.rounded(-3, 3), axis[0], axis[1],
        axis[2]);
  }
  /// Often 0, as in files.
  double length() { return rng_.chance(0.3) ? 0 : rng_.rounded(-0.3, 0.3); }

  Rng& rng_;
  std::string text_;
};

/// A random part of `all`, at least one and at most `most`.
inline std::vector<std::string> some_of(Rng& rng, std::vector<std::string> all, int most) {
  for (int i = static_cast<int>(all.size()) - 1; i > 0; --i) {
    std::swap(all[at(i)], all[at(rng.below(i + 1))]);
  }
  all.resize(at(1 + rng.below(std::min(most, static_cast<int>(all.size())))));
  return all;
}

/// Lines of a scene's key that lists points at these links.
inline std::string list_points(Rng& rng, const char* key, const char* prefix,
                               const std::vector<std::string>& links, const char* more) {
  std::string text = fmt::format("{}:\n", key);
  for (const std::string& link : links) {
    text += fmt::format("  - {{name: {0}_{1}, link: {1}, origin: {{xyz: [0, 0, {2}]}}{3}}}\n",
                        prefix, link, rng.chance(0.5) ? 0 : 0.1, more);
  }
  return text;
}

inline std::string hold_feet(const std::vector<std::string>& links) {
  std::string text = "constraints:\n";
  for (const std::string& link : links) {
    text += fmt::format("  - {{name: foot_{0}, between: [{0}, world], contact: point}}\n", link);
  }
  return text;
}

inline std::string hold_box(const std::vector<std::string>& links) {
  std::string text =
      "objects:\n  - name: box\n    mass: 2\n"
      "    inertia: {ixx: 0.02, iyy: 0.03, izz: 0.04}\n    grasps:\n";
  for (std::size_t i = 0; i < links.size(); ++i) {
    text += fmt::format("      - {{point: point_{}, origin: {{xyz: [{}, {}, 0]}}}}\n", links[i],
                        i == 0 ? 0.1 : -0.1, i == 1 ? 0.2 : 0.0);
  }
  return text;
}

}  // namespace detail

/// Draws a robot from `seed`, with up to three families of two to eight limbs, one of which may sit
/// on another's limb as fingers on a hand, and a scene in `lanes` with points, contacts, feet or an
/// object at tips of them.
inline DrawnLimbs draw_limbs(std::uint64_t seed, int lanes) {
  Rng rng(seed);
  detail::LimbWriter writer(rng);
  std::vector<std::string> tips;
  std::string root = rng.chance(0.5) ? writer.add_chain("trunk", "spine", {"revolute"}) : "trunk";
  const int families = 1 + rng.below(3);
  for (int family = 0, left = 10; family < families && left > 1; ++family) {
    const int limbs = std::min(left, 2 + rng.below(7));
    const auto more = writer.add_family(root, fmt::format("limb{}", family), limbs);
    left -= limbs;
    tips.insert(tips.end(), more.begin(), more.end());
    root = rng.chance(0.4) ? more.front() : "trunk";
  }
  const bool floating = rng.chance(0.6);
  std::string scene =
      fmt::format("name: limbed\nbase: {}\nnoise: keep\nlanes: {}\nreal: {}\n",
                  floating ? "floating" : "fixed", lanes, rng.chance(0.5) ? "float" : "double");
  const auto points = detail::some_of(rng, tips, 3);
  const bool small = rng.chance(0.5);  // few rows of a task, or all
  scene += detail::list_points(rng, "operational_points", "point", points,
                               small ? ", rows: [x, y, z]" : "");
  const int contacts = rng.below(3);
  if (contacts > 0) {
    scene += detail::list_points(rng, "contacts", "contact", detail::some_of(rng, tips, 8), "");
  }
  if (floating && contacts < 2) scene += detail::hold_feet(detail::some_of(rng, tips, 4));
  if (!small && points.size() > 1 && contacts == 0) scene += detail::hold_box(points);
  return {writer.urdf(), scene};
}

}  // namespace treeline::tests
