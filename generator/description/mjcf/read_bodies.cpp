#include "description/mjcf/read_bodies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "description/flat/made_names.hpp"

namespace treeline {
namespace {

using Eigen::Isometry3d;

constexpr const char* kSave =
    "load the model in MuJoCo and save it by mj_saveLastXML, which writes plain bodies";

/// An element of a body, and the pose of the `<frame>` in which it stands.
struct Placed {
  MjcfElement element;
  Isometry3d frame;
};

/// The elements of a body, with those of its frames.
void list_elements(const MjcfElement& body, const Isometry3d& frame, const MjcfCompiler& compiler,
                   std::vector<Placed>& list) {
  for (const MjcfElement& child : body.children()) {
    if (child.name() == "frame") {
      list_elements(child, frame * read_mjcf_pose(child, compiler), compiler, list);
    } else {
      list.push_back({child, frame});
    }
  }
}

bool is_joint(const MjcfElement& element) {
  return element.name() == "joint" || element.name() == "freejoint";
}

bool is_free(const MjcfElement& element) {
  return element.name() == "freejoint" || (is_joint(element) && element.is("type", "free"));
}

class Bodies {
 public:
  Bodies(const MjcfCompiler& compiler, const MjcfAssets& assets, MjcfTree& result)
      : compiler_(compiler), assets_(assets), result_(result) {}

  void read(const std::vector<MjcfElement>& worlds) {
    std::vector<Placed> tops;
    for (const MjcfElement& world : worlds) {
      list_elements(world, Isometry3d::Identity(), compiler_, tops);
    }
    for (const Placed& top : tops) take_names(top.element);
    const Placed* const root = find_floating(tops);
    result_.hints.floats = root != nullptr;
    result_.tree.has_world = root == nullptr;
    result_.bodies["world"] = -1;
    if (root != nullptr) read_body(*root, -1, Isometry3d::Identity());
    for (const Placed& top : tops) {
      if (top.element.name() != "body") read_in_world(top);
      if (top.element.name() != "body" || &top == root) continue;
      if (root == nullptr && top.element.text("mocap") != "true") {
        read_body(top, -1, Isometry3d::Identity());
      } else {
        top.element.note("it is not part of the robot and is passed over", "");
        if (compiler_.settotalmass > 0) passed_over_ += weigh(top);
      }
    }
    if (compiler_.settotalmass > 0) scale_masses();
  }

 private:
  /// Names that the file gives come first, those that are made must differ.
  void take_names(const MjcfElement& element) {
    if (const auto name = element.find("name")) {
      (is_joint(element) ? joint_names_ : link_names_).take(*name);
    }
    for (const MjcfElement& child : element.children()) {
      if (child.name() == "body" || child.name() == "frame" || is_joint(child)) take_names(child);
    }
  }

  [[nodiscard]] bool moves(const MjcfElement& body) const {
    std::vector<Placed> parts;
    list_elements(body, Isometry3d::Identity(), compiler_, parts);
    return std::any_of(parts.begin(), parts.end(), [&](const Placed& part) {
      return is_joint(part.element) || (part.element.name() == "body" && moves(part.element));
    });
  }

  /// The body that is all that moves, and moves freely; null: there is none.
  const Placed* find_floating(const std::vector<Placed>& tops) {
    const Placed* found = nullptr;
    for (const Placed& top : tops) {
      if (top.element.name() != "body" || !moves(top.element)) continue;
      if (found != nullptr) return nullptr;
      found = &top;
    }
    if (found == nullptr) return nullptr;
    std::vector<Placed> parts;
    list_elements(found->element, Isometry3d::Identity(), compiler_, parts);
    const bool floats = std::any_of(parts.begin(), parts.end(),
                                    [](const Placed& part) { return is_free(part.element); });
    return floats ? found : nullptr;
  }

  void read_in_world(const Placed& part) {
    if (part.element.name() == "site") read_site(part, -1);
    refuse(part.element);
  }

  /// What makes bodies or moves them is not read; unknown elements may be slips.
  static void refuse(const MjcfElement& element) {
    constexpr std::array<std::string_view, 4> kMakers = {"composite", "flexcomp", "replicate",
                                                         "attach"};
    constexpr std::array<std::string_view, 8> kOthers = {"body", "inertial", "joint",  "freejoint",
                                                         "geom", "site",     "camera", "light"};
    const auto is_among = [&](const auto& names) {
      return std::find(names.begin(), names.end(), element.name()) != names.end();
    };
    if (is_among(kMakers)) {
      element.error(fmt::format("<{}> is not read", element.name()), kSave);
    } else if (!is_among(kOthers)) {
      element.warn(fmt::format("<{}> is not read", element.name()), "");
    }
  }

  int add_link(const std::string& name, const Isometry3d& initial) {
    result_.model.links.push_back({name, std::nullopt, {}});
    result_.initial.push_back(initial);
    return static_cast<int>(result_.model.links.size()) - 1;
  }

  [[nodiscard]] std::string name_of(int link) const {
    return link < 0 ? "world" : result_.model.links[static_cast<std::size_t>(link)].name;
  }

  void read_body(const Placed& body, int parent, const Isometry3d& parent_initial) {
    const MjcfElement& element = body.element;
    const Isometry3d pose = body.frame * read_mjcf_pose(element, compiler_);
    const Isometry3d initial = parent_initial * pose;
    result_.model.length =
        std::max(result_.model.length, initial.translation().cwiseAbs().maxCoeff());
    const auto given = element.find("name");
    const std::string name = given ? *given : link_names_.make(name_of(parent) + "_child");
    std::vector<Placed> parts;
    list_elements(element, Isometry3d::Identity(), compiler_, parts);
    const bool is_root = parent < 0 && !result_.tree.has_world;
    if (element.number("gravcomp", 0) != 0) {
      element.warn("its gravity is compensated by gravcomp, which is not read", "");
    }
    const int link = is_root ? add_link(name, initial) : hang(parts, name, parent, pose, initial);
    result_.bodies[name] = link;
    const bool jointed = std::any_of(parts.begin(), parts.end(),
                                     [](const Placed& part) { return is_joint(part.element); });
    if (is_root || jointed || moving_.contains(parent)) moving_.insert(link);
    FlatLink contents = read_contents(element, parts, moving_.contains(link));
    FlatLink& flat = result_.model.links[static_cast<std::size_t>(link)];
    flat.inertial = std::move(contents.inertial);
    flat.shapes = std::move(contents.shapes);
    for (const Placed& part : parts) {
      if (part.element.name() == "body") read_body(part, link, initial);
      if (part.element.name() == "site") read_site(part, link);
      if (is_root && is_joint(part.element)) warn_of_forces(part.element, false);
      refuse(part.element);
    }
  }

  /// Adds the body's joints, one after the other, and its link at their end.
  int hang(const std::vector<Placed>& parts, const std::string& name, int parent,
           const Isometry3d& pose, const Isometry3d& initial) {
    std::vector<const Placed*> joints;
    for (const Placed& part : parts) {
      if (is_joint(part.element)) joints.push_back(&part);
    }
    Isometry3d from_parent = pose;
    int before = parent;
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const bool last = j + 1 == joints.size();
      MjcfJoint read = read_mjcf_joint(joints[j]->element, joints[j]->frame, compiler_);
      FlatJoint& joint = read.joint;
      const auto given = joints[j]->element.find("name");
      joint.name = given ? *given : joint_names_.make(name + "_joint");
      joint.parent = before;
      // A free joint has its place in the world, not in its body's place at the beginning.
      joint.in_parent =
          joint.type == "floating" ? Isometry3d::Identity() : from_parent * read.place;
      // The body is as the file has it where the coordinate is `ref`.
      joint.in_child = last ? read.place * read.moved_back.inverse() : Isometry3d::Identity();
      from_parent = read.moved_back * read.place.inverse();
      joint.child = add_link(last ? name : link_names_.make(joint.name + "_link"), initial);
      before = joint.child;
      if (read.spring) result_.hints.springs[joint.name] = *read.spring;
      result_.joints[joint.name] = result_.tree.joints.size();
      result_.ref.push_back(read.ref);
      result_.tree.joints.push_back(std::move(joint));
    }
    return joints.empty() ? hold(joint_names_.make(name + "_fixed"), name, parent, pose, initial)
                          : before;
  }

  int hold(const std::string& joint, const std::string& name, int parent, const Isometry3d& pose,
           const Isometry3d& initial) {
    FlatJoint fixed;
    fixed.name = joint;
    fixed.type = "fixed";
    fixed.parent = parent;
    fixed.child = add_link(name, initial);
    fixed.in_parent = pose;
    fixed.in_child = Isometry3d::Identity();
    result_.ref.push_back(0);
    result_.tree.joints.push_back(std::move(fixed));
    return result_.tree.joints.back().child;
  }

  /// Sites with names are links without mass, so that a scene can name them.
  void read_site(const Placed& site, int parent) {
    const auto name = site.element.find("name");
    if (!name || (parent < 0 && !result_.tree.has_world)) return;
    const Isometry3d pose = site.frame * read_mjcf_pose(site.element, compiler_);
    result_.sites[*name] = {parent, pose};
    const Isometry3d initial =
        (parent < 0 ? Isometry3d::Identity() : result_.initial[static_cast<std::size_t>(parent)]) *
        pose;
    hold(joint_names_.make(*name + "_at"),
         link_names_.make(link_names_.has(*name) ? *name + "_site" : *name), parent, pose, initial);
  }

  /// Mass and shapes, without a name. Where geoms count and none has mass, what is stated does.
  /// `moves`: a joint moves the body.
  FlatLink read_contents(const MjcfElement& body, const std::vector<Placed>& parts, bool moves) {
    MjcfMass mass;
    std::optional<FlatInertial> stated;
    FlatLink link;
    const bool weighs = moves || compiler_.settotalmass > 0;
    const bool from_geoms = compiler_.inertiafromgeom == "true";
    const bool states = std::any_of(parts.begin(), parts.end(), [](const Placed& part) {
      return part.element.name() == "inertial";
    });
    for (const Placed& part : parts) {
      if (part.element.name() == "inertial") stated = read_inertial(part.element, compiler_);
      if (part.element.name() != "geom") continue;
      const MjcfGeom geom(part.element, part.frame, compiler_, assets_, weighs);
      geom.add_shapes(link.shapes);
      if (from_geoms || (!states && compiler_.inertiafromgeom == "auto")) mass.add(geom.mass());
    }
    link.inertial = inertial_of(mass);
    if (!link.inertial) link.inertial = stated;
    bound_inertial(body, compiler_, link.inertial);
    return link;
  }

  /// Mass of a body that is passed over, with all that hangs on it, in kg.
  double weigh(const Placed& body) {
    std::vector<Placed> parts;
    list_elements(body.element, Isometry3d::Identity(), compiler_, parts);
    double sum = mass_of(read_contents(body.element, parts, false));
    for (const Placed& part : parts) {
      if (part.element.name() == "body") sum += weigh(part);
    }
    return sum;
  }

  static double mass_of(const FlatLink& link) { return link.inertial ? link.inertial->mass : 0; }

  /// Makes `settotalmass` the mass of all bodies of the file.
  void scale_masses() {
    double total = passed_over_;
    for (const FlatLink& link : result_.model.links) total += mass_of(link);
    for (FlatLink& link : result_.model.links) {
      if (link.inertial) scale_inertial(compiler_.settotalmass / total, *link.inertial);
    }
  }

  const MjcfCompiler& compiler_;
  const MjcfAssets& assets_;
  MjcfTree& result_;
  MadeNames link_names_, joint_names_;
  std::set<int> moving_;    ///< links
  double passed_over_ = 0;  ///< kg, of bodies that are not part of the robot
};

}  // namespace

void read_bodies(const std::vector<MjcfElement>& worlds, const MjcfCompiler& compiler,
                 const MjcfAssets& assets, MjcfTree& result) {
  Bodies(compiler, assets, result).read(worlds);
}

}  // namespace treeline
