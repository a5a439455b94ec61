#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "description/flat/made_names.hpp"
#include "description/mjcf/read_bodies.hpp"

namespace treeline {
namespace {

using Eigen::Isometry3d;

constexpr const char* kInScene = "write it under couplings or constraints in the scene";

class Equalities {
 public:
  explicit Equalities(MjcfTree& tree) : tree_(tree) {}

  void read(const MjcfElement& element) {
    if (element.is("active", "false")) {
      element.note("it is not active and is passed over", "");
    } else if (element.name() == "joint") {
      read_joint(element);
    } else if (element.name() == "connect" || element.name() == "weld") {
      read_loop(element);
    } else {
      element.warn("it is not read: what it holds together moves freely", kInScene);
    }
  }

 private:
  FlatJoint* find(const MjcfElement& element, const char* attribute) {
    const auto found = tree_.joints.find(element.text(attribute));
    if (found != tree_.joints.end()) return &tree_.tree.joints[found->second];
    element.error(fmt::format("there is no joint \"{}\"", element.text(attribute)), "mend it");
    return nullptr;
  }

  [[nodiscard]] double ref_of(const FlatJoint& joint) const {
    return tree_.ref[tree_.joints.at(joint.name)];
  }

  /// y - y0 = a0 + a1 (x - x0), where x0 and y0 are the coordinates at the beginning.
  void read_joint(const MjcfElement& element) {
    auto a = element.numbers("polycoef", 1, 5);
    if (a.empty()) a = {0, 1};
    a.resize(5);
    FlatJoint* const follower = find(element, "joint1");
    const bool alone = !element.has("joint2");
    FlatJoint* const leader = alone ? nullptr : find(element, "joint2");
    if (follower == nullptr || (!alone && leader == nullptr)) return;
    const bool linear = a[2] == 0 && a[3] == 0 && a[4] == 0;
    if (alone) {
      element.warn("a joint that is held is not read as such",
                   fmt::format("write locked: {{{}: {}}} in the scene", follower->name,
                               a[0] + ref_of(*follower)));
    } else if (!linear || follower->mimic || follower->axes.empty() || leader->axes.empty()) {
      element.warn(linear ? "it is not read: the joint follows another already"
                          : "it is not read: the relation of its joints is not linear",
                   kInScene);
    } else {
      follower->mimic =
          FlatMimic{leader->name, a[1], ref_of(*follower) + a[0] - a[1] * ref_of(*leader)};
    }
  }

  /// A body, or the place of a site.
  std::optional<MjcfPlace> find_end(const MjcfElement& element, const char* body,
                                    const char* site) {
    if (const auto name = element.find(site)) {
      const auto found = tree_.sites.find(*name);
      if (found != tree_.sites.end()) return found->second;
      element.error(fmt::format("there is no site \"{}\" on the robot", *name), "mend it");
      return std::nullopt;
    }
    const auto found = tree_.bodies.find(element.text(body, "world"));
    if (found != tree_.bodies.end()) return MjcfPlace{found->second, Isometry3d::Identity()};
    element.note(fmt::format("the body \"{}\" is not part of the robot: this is passed over",
                             element.text(body)),
                 "");
    return std::nullopt;
  }

  [[nodiscard]] Isometry3d initial(int link) const {
    return link < 0 ? Isometry3d::Identity() : tree_.initial[static_cast<std::size_t>(link)];
  }

  void read_loop(const MjcfElement& element) {
    auto first = find_end(element, "body1", "site1");
    auto second = find_end(element, "body2", "site2");
    if (!first || !second) return;
    if (!tree_.tree.has_world && (first->link < 0 || second->link < 0)) {
      element.warn("what holds a floating base to the world is not read", kInScene);
      return;
    }
    if (!element.has("site1")) place(element, *first, *second);
    FlatJoint loop;
    loop.name = names_.make(element.text("name", element.name() == "weld" ? "weld" : "connect"));
    loop.type = element.name() == "weld" ? "fixed" : "ball";
    loop.parent = first->link;
    loop.child = second->link;
    loop.in_parent = first->in_link;
    loop.in_child = second->in_link;
    tree_.tree.loops.push_back(std::move(loop));
  }

  /// Bodies are held as they are at the beginning, or as `relpose` says.
  void place(const MjcfElement& element, MjcfPlace& first, MjcfPlace& second) const {
    if (const auto p = element.numbers("anchor", 3, 3); element.name() == "connect" && !p.empty()) {
      first.in_link.translation() = Eigen::Vector3d::Map(p.data());
    }
    const auto relative = element.numbers("relpose", 7, 7);
    const bool stated = !relative.empty() && std::any_of(relative.begin() + 3, relative.end(),
                                                         [](double each) { return each != 0; });
    if (element.name() == "weld" && stated) {
      first.in_link.translation() = Eigen::Vector3d::Map(relative.data());
      first.in_link.linear() = rotation_from_wxyz(relative.data() + 3);
    } else {
      second.in_link = initial(second.link).inverse() * initial(first.link) * first.in_link;
    }
  }

  MjcfTree& tree_;
  MadeNames names_;
};

}  // namespace

void read_equalities(const std::vector<MjcfElement>& sections, MjcfTree& tree) {
  Equalities equalities(tree);
  for (const MjcfElement& section : sections) {
    for (const MjcfElement& element : section.children()) equalities.read(element);
  }
}

}  // namespace treeline
