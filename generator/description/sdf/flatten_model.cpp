#include "description/sdf/flatten_model.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <sdf/Element.hh>
#include <sdf/Frame.hh>
#include <sdf/Joint.hh>
#include <sdf/JointAxis.hh>
#include <sdf/Link.hh>
#include <utility>

namespace treeline {
namespace {

/// SDF writes 1e16 for no limit.
double or_infinite(double bound) {
  constexpr double kNone = 1e15;
  if (std::abs(bound) < kNone) return bound;
  return std::copysign(std::numeric_limits<double>::infinity(), bound);
}

/// SDF writes -1 for no limit, too.
double or_unlimited(double bound) {
  return bound < 0 ? std::numeric_limits<double>::infinity() : or_infinite(bound);
}

FlatInertial read_inertial(const sdf::Link& link) {
  const auto& given = link.Inertial();
  const auto diagonal = given.MassMatrix().DiagonalMoments();
  const auto products = given.MassMatrix().OffDiagonalMoments();
  return {given.MassMatrix().Mass(),
          to_isometry(given.Pose()),
          diagonal.X(),
          products.X(),
          products.Y(),
          diagonal.Y(),
          products.Z(),
          diagonal.Z()};
}

/// A model, what names of its elements begin with, and its pose in the whole one.
struct Scope {
  const sdf::Model* model = nullptr;
  std::string prefix;
  Eigen::Isometry3d at;
};

class Flattening {
 public:
  Flattening(const std::string& file, Diagnostics& diagnostics)
      : file_(file), diagnostics_(diagnostics) {}

  std::optional<FlatModel> run(const sdf::Model& model) {
    flat_.name = model.Name();
    list_scopes({&model, "", Eigen::Isometry3d::Identity()});
    for (const Scope& scope : scopes_) add_links(scope);
    put_first(model);
    for (std::size_t i = 0; i < flat_.links.size(); ++i) {
      places_[flat_.links[i].name] = static_cast<int>(i);
    }
    for (const Scope& scope : scopes_) add_joints(scope);
    for (const Scope& scope : scopes_) add_frames(scope);
    if (failed_) return std::nullopt;
    warn_of_unstated();
    return std::move(flat_);
  }

 private:
  void add(Severity severity, const std::string& element, const std::string& fault,
           const std::string& remedy) {
    failed_ = failed_ || severity == Severity::error;
    diagnostics_.add({severity, file_, 0, "sdf/model/" + element, fault, remedy});
  }

  /// The pose that an element has in its model; an error where it cannot be resolved.
  template <class Entity>
  Eigen::Isometry3d pose_of(const Entity& entity, const std::string& element,
                            const std::string& in = "__model__") {
    ignition::math::Pose3d pose;
    for (const sdf::Error& error : entity.SemanticPose().Resolve(pose, in)) {
      add(Severity::error, element, "libsdformat: " + error.Message(), "mend its <pose>");
    }
    return to_isometry(pose);
  }

  /// The model and all that are nested in it, each before those.
  void list_scopes(const Scope& scope) {
    scopes_.push_back(scope);
    for (std::uint64_t i = 0; i < scope.model->ModelCount(); ++i) {
      const sdf::Model& nested = *scope.model->ModelByIndex(i);
      const std::string name = scope.prefix + nested.Name();
      list_scopes({&nested, name + "::", scope.at * pose_of(nested, "model[" + name + "]")});
    }
  }

  void add_links(const Scope& scope) {
    for (std::uint64_t i = 0; i < scope.model->LinkCount(); ++i) {
      const sdf::Link& link = *scope.model->LinkByIndex(i);
      const std::string name = scope.prefix + link.Name();
      if (!link.Element()->HasElement("inertial")) unstated_.push_back(name);
      flat_.links.push_back({name, read_inertial(link), read_shapes(link)});
      poses_[name] = scope.at * pose_of(link, "link[" + name + "]");
      flat_.length = std::max(flat_.length, poses_[name].translation().cwiseAbs().maxCoeff());
    }
  }

  void warn_of_unstated() {
    if (unstated_.empty()) return;
    add(Severity::warning, "link",
        fmt::format("without <inertial> a link has 1 kg and 1 kg m^2 in SDF: {}",
                    fmt::join(unstated_, ", ")),
        "state masses and inertias");
  }

  void put_first(const sdf::Model& model) {
    const auto canonical = model.CanonicalLinkAndRelativeName();
    const auto found =
        std::find_if(flat_.links.begin(), flat_.links.end(),
                     [&](const FlatLink& each) { return each.name == canonical.second; });
    if (canonical.first != nullptr && found != flat_.links.end()) {
      std::rotate(flat_.links.begin(), found, found + 1);
    }
  }

  void add_joints(const Scope& scope) {
    for (std::uint64_t i = 0; i < scope.model->JointCount(); ++i) {
      add_joint(*scope.model->JointByIndex(i), scope.prefix, scope.at);
    }
  }

  void add_joint(const sdf::Joint& joint, const std::string& prefix, const Eigen::Isometry3d& at) {
    const std::string element = fmt::format("joint[{}]", prefix + joint.Name());
    FlatJoint flat;
    flat.name = prefix + joint.Name();
    flat.type = joint.Element()->Get<std::string>("type");
    if (flat.type == "screw" || flat.type == "gearbox") {
      add(Severity::error, element, fmt::format("a joint of type {} is not read", flat.type),
          "write two joints, and their relation under couplings in the scene");
      return;
    }
    std::string parent, child;
    (void)joint.ResolveParentLink(parent);  // its faults were found when the file was read
    (void)joint.ResolveChildLink(child);
    flat.parent = place_of_link(parent, prefix);
    flat.child = place_of_link(child, prefix);
    place(at * pose_of(joint, element), flat);
    for (unsigned k = 0; k < 2; ++k) {
      if (joint.Axis(k) != nullptr && flat.type != "fixed" && flat.type != "ball") {
        flat.axes.push_back(read_axis(*joint.Axis(k), element));
      }
    }
    read_rotor(joint, flat);
    flat_.joints.push_back(std::move(flat));
  }

  /// Poses of a joint's frame in those of its links.
  void place(const Eigen::Isometry3d& pose, FlatJoint& joint) const {
    const auto in = [&](int link) -> Eigen::Isometry3d {
      if (link < 0) return pose;
      return poses_.at(flat_.links[static_cast<std::size_t>(link)].name).inverse() * pose;
    };
    joint.in_parent = in(joint.parent);
    joint.in_child = in(joint.child);
  }

  [[nodiscard]] int place_of_link(const std::string& name, const std::string& prefix) const {
    const auto found = places_.find(prefix + name);
    return name == "world" || found == places_.end() ? -1 : found->second;
  }

  FlatAxis read_axis(const sdf::JointAxis& axis, const std::string& element) {
    ignition::math::Vector3d direction;
    for (const sdf::Error& error : axis.ResolveXyz(direction)) {
      add(Severity::error, element, "libsdformat: " + error.Message(), "mend its <axis>");
    }
    if (axis.SpringStiffness() != 0) {
      add(Severity::warning, element,
          fmt::format("its spring of {} N m/rad or N/m is not read", axis.SpringStiffness()),
          "state it under joint_springs in the scene");
    }
    return {Eigen::Vector3d(direction.X(), direction.Y(), direction.Z()),
            or_infinite(axis.Lower()),
            or_infinite(axis.Upper()),
            or_unlimited(axis.Effort()),
            or_unlimited(axis.MaxVelocity()),
            axis.Damping(),
            axis.Friction(),
            0};
  }

  static void read_rotor(const sdf::Joint& joint, FlatJoint& flat) {
    for (const char* name : {"drake:rotor_inertia", "drake:gear_ratio"}) {
      if (!joint.Element()->HasElement(name)) continue;
      flat.rotor.emplace_back(name, joint.Element()->GetElement(name)->Get<std::string>());
    }
  }

  /// Frames are links without mass, so that a scene can name them.
  void add_frames(const Scope& scope) {
    for (std::uint64_t i = 0; i < scope.model->FrameCount(); ++i) {
      const sdf::Frame& frame = *scope.model->FrameByIndex(i);
      const std::string name = scope.prefix + frame.Name();
      std::string body;
      (void)frame.ResolveAttachedToBody(body);
      const int parent = place_of_link(body, scope.prefix);
      if (parent < 0) continue;
      const Eigen::Isometry3d pose = scope.at * pose_of(frame, "frame[" + name + "]");
      FlatJoint fixed;
      fixed.name = "at::" + name;
      fixed.type = "fixed";
      fixed.parent = parent;
      fixed.child = static_cast<int>(flat_.links.size());
      poses_[name] = pose;
      flat_.links.push_back({name, std::nullopt, {}});
      place(pose, fixed);
      flat_.joints.push_back(std::move(fixed));
    }
  }

  const std::string& file_;
  Diagnostics& diagnostics_;
  std::vector<Scope> scopes_;
  FlatModel flat_;
  std::map<std::string, int> places_;
  std::map<std::string, Eigen::Isometry3d> poses_;  ///< of links in the model, all joints at zero
  std::vector<std::string> unstated_;               ///< links without `<inertial>`
  bool failed_ = false;
};

}  // namespace

std::optional<FlatModel> flatten_model(const sdf::Model& model, const std::string& file,
                                       Diagnostics& diagnostics) {
  return Flattening(file, diagnostics).run(model);
}

}  // namespace treeline
