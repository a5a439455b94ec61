#include "mechanism/build_mechanism.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "description/noise.hpp"
#include "description/robot_queries.hpp"
#include "description/rotation.hpp"
#include "description/snap_angles.hpp"
#include "description/with_rotors.hpp"
#include "mechanism/build_steps.hpp"
#include "mechanism/digits50_from_file.hpp"

namespace treeline {
namespace {

/// Cyclic permutation of the axes that takes z to `axis`.
Digits50Matrix3 z_to(StepAxis axis) {
  if (axis == StepAxis::z) return Digits50Matrix3::Identity();
  Digits50Matrix3 z_to_x = Digits50Matrix3::Zero();
  z_to_x(0, 2) = z_to_x(1, 0) = z_to_x(2, 1) = 1;
  return axis == StepAxis::x ? z_to_x : z_to_x.transpose();
}

/// Adds links depth-first. A `LinkPlace` tells on which moving link a URDF frame is, and with
/// which pose.
class Builder {
 public:
  Builder(const Robot& robot, const Scene& scene) {
    const NoiseLimits limits = noise_limits(robot, scene);
    mechanism_.file = robot.file;
    mechanism_.resolution = resolution_of(limits);
    robot_ =
        without_noise(with_snapped_angles(robot, scene.snap_angles), limits, &mechanism_.noise);
    robot_ = with_rotors(std::move(robot_), scene);
    scene_ = without_noise(scene, limits, &mechanism_.noise);
    mechanism_.noise.insert(mechanism_.noise.end(), scene.taken_exact.begin(),
                            scene.taken_exact.end());
    first_coordinate_.assign(robot_.joints.size(), {-1, -1});
    places_.resize(robot_.links.size());
  }

  Mechanism build() {
    mechanism_.gravity = scene_.gravity;
    mechanism_.implicit_friction = scene_.implicit_friction;
    mechanism_.singular = scene_.singular;
    mechanism_.real = scene_.real;
    LinkPlace base;
    if (scene_.base == Base::floating) {
      base = add_floating_base(robot_.links[static_cast<std::size_t>(robot_.root)].name, base);
    }
    add_links(base);
    share_mimicked_coordinates();
    place_scene({robot_, scene_, places_, first_coordinate_}, mechanism_);
    for (std::size_t i = 0; i < mechanism_.links.size(); ++i) {
      MovingLink& link = mechanism_.links[i];
      link.radius = radius_of_gyration(nominal_inertia(mechanism_, static_cast<int>(i)));
      resolve_inertia(mechanism_, link);
    }
    for (const MechanismPoint& frame : mechanism_.link_frames) {
      const Inertia& matter = mechanism_.links[static_cast<std::size_t>(frame.link)].inertia;
      mechanism_.link_matter.push_back(transformed(matter, inverse(frame.pose)));
    }
    if (scene_.inputs.base_parameters) take_base_parameters(mechanism_);
    add_drives(scene_, mechanism_);
    return std::move(mechanism_);
  }

 private:
  /// Resolution of the files' numbers. A wider limit set by the scene applies only to single
  /// numbers of the files.
  static Resolution resolution_of(const NoiseLimits& limits) {
    if (limits.angle == 0) return {Digits50("1e-40"), 0};  // squares of 1e-17 count too
    return {kResolution, Digits50(limits.length) * kResolution / limits.angle};
  }

  Digits50Pose resolve(const Digits50Pose& pose, const std::string& element) {
    return resolved_as(pose, element, mechanism_);
  }

  /// Rotation that takes z to the joint's axis, if it has one.
  Digits50Matrix3 axis_rotation(const Joint& joint, const std::string& element) {
    if (!info_of(joint.type).has_axis) return Digits50Matrix3::Identity();
    return resolve({rotation_from_z_to(unit_axis<Digits50>(joint.axis)), Digits50Vector3::Zero()},
                   element + "/axis")
        .R;
  }

  void add_links(const LinkPlace& base) {
    visit_link(robot_.root, base);
    for (const int j : joints_depth_first(robot_)) {
      const Joint& joint = robot_.joints[static_cast<std::size_t>(j)];
      visit_link(joint.child, place_behind(joint, places_[static_cast<std::size_t>(joint.parent)]));
    }
  }

  void visit_link(int index, const LinkPlace& place) {
    const Link& link = robot_.links[static_cast<std::size_t>(index)];
    places_[static_cast<std::size_t>(index)] = place;
    Inertia& carrier = place.link < 0
                           ? mechanism_.world
                           : mechanism_.links[static_cast<std::size_t>(place.link)].inertia;
    if (has_parameters_as_input(scene_, link.name)) return;
    const Inertia own = link.inertial ? digits50_inertia(*link.inertial) : Inertia{};
    carrier = carrier + transformed(own, place.pose);
    if (link.inertial && (place.link < 0 || carrier_name(place) != link.name)) {
      mechanism_.notes.push_back(
          {"lump", link.name,
           fmt::format("{} kg lumped with {}", link.inertial->mass, carrier_name(place))});
    }
  }

  [[nodiscard]] std::string carrier_name(const LinkPlace& place) const {
    return place.link < 0 ? "the fixed base"
                          : mechanism_.links[static_cast<std::size_t>(place.link)].name;
  }

  LinkPlace place_behind(const Joint& joint, const LinkPlace& parent) {
    const std::string& link = robot_.links[static_cast<std::size_t>(joint.child)].name;
    const std::string element = fmt::format("robot/joint[{}]", joint.name);
    LinkPlace before{parent.link,
                     resolve(parent.pose * digits50_pose(joint.origin), element + "/origin")};
    const Digits50Matrix3 to_axis = axis_rotation(joint, element);
    const std::optional<Digits50> held = held_value(joint);
    LinkPlace behind = before;
    if (held) {
      behind.pose = resolve(before.pose * displaced(joint.type, to_axis, *held), element);
      mechanism_.notes.push_back(
          {"lump", link,
           fmt::format("joint {} held at {}", joint.name, static_cast<double>(*held))});
    } else if (info_of(joint.type).moves()) {
      behind = add_joint(joint, link, before, to_axis);
    }
    return behind;
  }

  static Digits50Pose displaced(JointType type, const Digits50Matrix3& to_axis,
                                const Digits50& value) {
    Digits50Pose pose;
    if (info_of(type).slides()) {
      pose.p = to_axis.col(2) * value;
    } else {
      pose.R = to_axis * rotation_z_by(value) * to_axis.transpose();
    }
    return pose;
  }

  /// Adds a joint and the link behind it. Returns the place of the child's URDF frame.
  LinkPlace add_joint(const Joint& joint, const std::string& link, const LinkPlace& before,
                      const Digits50Matrix3& to_axis) {
    const JointTypeInfo& type = info_of(joint.type);
    const FirstCoordinate first{mechanism_.nq(), mechanism_.nv()};
    if (!joint.mimic) {
      first_coordinate_[index_of(joint)] = first;
      const bool limited = joint.limits.has_value() && type.has_one_freedom();
      add_coordinates(type, joint.name, limited ? *joint.limits : Limits{});
    }
    const LinkPlace behind = add_steps(type, {joint.name, link}, first, before, to_axis);
    mechanism_.links.back().spins = joint.spins;
    if (joint.mimic) {
      mechanism_.links.back().mimics = true;
      mimics_.push_back({last_link(), &joint});
    }
    return behind;
  }

  void add_coordinates(const JointTypeInfo& type, const std::string& joint, const Limits& limits) {
    for (const JointCoordinate& coordinate : type.coordinates) {
      mechanism_.coordinates.push_back(
          {joint, coordinate.meaning, coordinate.kind, limits.lower, limits.upper});
    }
    for (const char* velocity : type.velocities) {
      mechanism_.velocities.push_back(joint + velocity);
    }
  }

  struct JointNames {
    std::string joint, link;
  };

  /// Adds the steps of a joint with massless links between them. Returns the place of the child's
  /// URDF frame on the last.
  LinkPlace add_steps(const JointTypeInfo& type, const JointNames& names,
                      const FirstCoordinate& first, const LinkPlace& before,
                      const Digits50Matrix3& to_axis) {
    FirstCoordinate next = first;
    LinkPlace place{before.link, before.pose * Digits50Pose{to_axis, Digits50Vector3::Zero()}};
    for (const JointTypeStep& step : type.steps) {
      const Digits50Matrix3 axis = z_to(step.axis);
      MovingLink moving = new_link(names.link + step.suffix, names.joint, place);
      static_cast<JointStep&>(moving) = step.motion;
      moving.placement = resolve(place.pose * Digits50Pose{axis, Digits50Vector3::Zero()},
                                 fmt::format("robot/joint[{}]", names.joint));
      moving.q_index = step.motion.continues_joint() ? first.q : next.q;
      moving.v_index = next.v;
      next.q += step.motion.coordinates();
      next.v += step.motion.velocities();
      mechanism_.links.push_back(moving);
      place = {last_link(), {axis.transpose(), Digits50Vector3::Zero()}};
    }
    place.pose.R = place.pose.R * to_axis.transpose();
    return place;
  }

  LinkPlace add_floating_base(const std::string& link, const LinkPlace& before) {
    const JointTypeInfo& type = info_of(JointType::floating);
    add_coordinates(type, "base", Limits{});
    return add_steps(type, {"base", link}, {0, 0}, before, Digits50Matrix3::Identity());
  }

  static MovingLink new_link(const std::string& link, const std::string& joint,
                             const LinkPlace& before) {
    MovingLink moving;
    moving.name = link;
    moving.joint = joint;
    moving.parent = before.link;
    return moving;
  }

  /// Gives mimic joints the coordinate that they share. A mimic may precede the joint that it
  /// follows, so this happens at the end. Chains of mimics multiply: q = k1 (k2 q0 + o2) + o1.
  void share_mimicked_coordinates() {
    for (const auto& [index, follower] : mimics_) {
      MovingLink& link = mechanism_.links[static_cast<std::size_t>(index)];
      Digits50 multiplier = 1;
      const Joint* joint = follower;
      for (; joint->mimic; joint = &mimicked(*joint)) {
        link.offset += multiplier * Digits50(joint->mimic->offset);
        multiplier *= Digits50(joint->mimic->multiplier);
      }
      const FirstCoordinate shared = first_coordinate_[index_of(*joint)];
      link.multiplier = static_cast<double>(multiplier);
      if (link.kind == JointKind::revolute)
        link.offset = resolved(link.offset, mechanism_.resolution);
      link.q_index = shared.q;
      link.v_index = shared.v;
    }
  }

  /// Value at which the scene holds the joint, or the joint that it mimics. Nothing if the joint is
  /// free.
  [[nodiscard]] std::optional<Digits50> held_value(const Joint& joint) const {
    const auto locked = scene_.locked.find(joint.name);
    if (locked != scene_.locked.end()) {
      return Digits50(locked->second);
    }
    if (!joint.mimic) {
      return std::nullopt;
    }
    const std::optional<Digits50> followed = held_value(mimicked(joint));
    return followed ? std::optional<Digits50>(Digits50(joint.mimic->multiplier) * *followed +
                                              Digits50(joint.mimic->offset))
                    : std::nullopt;
  }

  [[nodiscard]] const Joint& mimicked(const Joint& joint) const {
    return robot_.joints[static_cast<std::size_t>(joint.mimic->joint)];
  }

  [[nodiscard]] std::size_t index_of(const Joint& joint) const {
    return static_cast<std::size_t>(&joint - robot_.joints.data());
  }
  [[nodiscard]] int last_link() const { return static_cast<int>(mechanism_.links.size()) - 1; }

  Mechanism mechanism_;
  Robot robot_;
  Scene scene_;
  std::vector<FirstCoordinate> first_coordinate_;
  std::vector<std::pair<int, const Joint*>> mimics_;
  std::vector<LinkPlace> places_;
};

}  // namespace

Mechanism build_mechanism(const Robot& robot, const Scene& scene) {
  return Builder(robot, scene).build();
}

Mechanism mechanism_in_frames_of_files(const Robot& robot, const Scene& scene) {
  Mechanism mechanism = build_mechanism(robot, scene);
  keep_angles(mechanism, scene.accuracy);
  return mechanism;
}

Mechanism reduced_mechanism(const Robot& robot, const Scene& scene, Inertias inertias) {
  Mechanism mechanism = build_mechanism(robot, scene);
  const bool regroup = inertias == Inertias::regrouped;
  if (regroup) regroup_inertias(mechanism);
  place_frames(mechanism);
  if (regroup) {
    // A prismatic link whose frame was shifted has a second moment again.
    const std::vector<ReductionNote> notes = mechanism.notes;
    regroup_inertias(mechanism);
    mechanism.notes = notes;
  }
  keep_angles(mechanism, scene.accuracy);
  return mechanism;
}

}  // namespace treeline
