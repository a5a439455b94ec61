#include "mechanism/build_mechanism.hpp"

#include <fmt/format.h>

#include <optional>
#include <utility>

#include "description/rotation.hpp"
#include "description/snap_angles.hpp"

namespace treeline {
namespace {

ExactPose exact_pose(const Pose& pose) {
  ExactPose result;
  result.R = rotation_from_rpy<Exact>(pose.rpy);
  for (int i = 0; i < 3; ++i) {
    result.p(i) = pose.xyz[static_cast<std::size_t>(i)];
  }
  return result;
}

/// Second moment of a body with inertia J about its centre of mass: Sigma = tr(J)/2 1 - J, carried
/// to the link's frame.
Inertia exact_inertia(const Inertial& body) {
  ExactMatrix3 J;
  J << body.ixx, body.ixy, body.ixz, body.ixy, body.iyy, body.iyz, body.ixz, body.iyz, body.izz;
  Inertia about_center;
  about_center.mass = body.mass;
  about_center.Sigma = J.trace() / 2 * ExactMatrix3::Identity() - J;
  return transformed(about_center, exact_pose(body.origin));
}

/// The shortest rotation that takes z to `axis`; half a turn about x where that is ambiguous.
ExactMatrix3 rotation_from_z_to(const ExactVector3& axis) {
  const Exact c = axis(2);
  if (snapped(Exact(c + 1), Exact(1)) == 0) {
    ExactMatrix3 half_turn = ExactMatrix3::Identity();
    half_turn(1, 1) = half_turn(2, 2) = -1;
    return half_turn;
  }
  // Rodrigues' formula about z x axis = (-axis_y, axis_x, 0).
  ExactMatrix3 K = ExactMatrix3::Zero();
  K(0, 2) = axis(0);
  K(1, 2) = axis(1);
  K(2, 0) = -axis(0);
  K(2, 1) = -axis(1);
  return ExactMatrix3::Identity() + K + K * K / (1 + c);
}

/// Rotation about z by an angle from a file, or one made of such; quarter turns are exact.
ExactMatrix3 rotation_z_by(const Exact& angle) {
  const double from_file = static_cast<double>(angle);
  if (Exact(from_file) != angle) {
    return rotation_z(angle);
  }
  return rotation_from_rpy<Exact>({0, 0, from_file});
}

/// Columns are z's cyclic companions: takes z to x, or z to y.
ExactMatrix3 z_to_x() {
  ExactMatrix3 R = ExactMatrix3::Zero();
  R(0, 2) = R(1, 0) = R(2, 1) = 1;
  return R;
}
ExactMatrix3 z_to_y() {
  return z_to_x().transpose();
}

/// Walks the tree depth-first. A `Place` says where a URDF frame is: on which moving link, and how.
class Builder {
 public:
  Builder(const Robot& robot, const Scene& scene)
      : robot_(with_snapped_angles(robot, scene.snap_angles)), scene_(scene) {
    children_.resize(robot.links.size());
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      children_[static_cast<std::size_t>(robot.joints[i].parent)].push_back(static_cast<int>(i));
    }
    first_coordinate_.assign(robot.joints.size(), {-1, -1});
    places_.resize(robot.links.size());
  }

  Mechanism build() {
    mechanism_.gravity = scene_.gravity;
    Place base;
    if (scene_.base == Base::floating) {
      base = add_floating(robot_.links[static_cast<std::size_t>(robot_.root)].name, "base", base);
    }
    visit_link(robot_.root, base);
    share_mimicked_coordinates();
    mechanism_.operational_points = points(scene_.operational_points);
    mechanism_.external_forces = points(scene_.external_forces);
    mechanism_.objects = objects();
    mechanism_.contacts = points(scene_.contacts);
    mechanism_.link_frames = link_frames();
    return std::move(mechanism_);
  }

 private:
  struct Place {
    int link = -1;
    ExactPose pose;
  };
  struct FirstCoordinate {
    int q, v;
  };

  void visit_link(int index, const Place& place) {
    const Link& link = robot_.links[static_cast<std::size_t>(index)];
    places_[static_cast<std::size_t>(index)] = place;
    Inertia& carrier = place.link < 0
                           ? mechanism_.world
                           : mechanism_.links[static_cast<std::size_t>(place.link)].inertia;
    const Inertia own = link.inertial ? exact_inertia(*link.inertial) : Inertia{};
    carrier = carrier + transformed(own, place.pose);
    if (link.inertial && (place.link < 0 || carrier_name(place) != link.name)) {
      mechanism_.notes.push_back(
          {"lump", link.name,
           fmt::format("{} kg lumped with {}", link.inertial->mass, carrier_name(place))});
    }
    for (const int joint : children_[static_cast<std::size_t>(index)]) {
      visit_joint(joint, place);
    }
  }

  [[nodiscard]] std::string carrier_name(const Place& place) const {
    return place.link < 0 ? "the fixed base"
                          : mechanism_.links[static_cast<std::size_t>(place.link)].name;
  }

  void visit_joint(int index, const Place& parent) {
    const Joint& joint = robot_.joints[static_cast<std::size_t>(index)];
    const std::string& link = robot_.links[static_cast<std::size_t>(joint.child)].name;
    Place before{parent.link, parent.pose * exact_pose(joint.origin)};
    const ExactMatrix3 to_axis = rotation_from_z_to(unit_axis<Exact>(joint.axis));
    const std::optional<Exact> held = held_value(joint);
    Place behind = before;
    if (held) {
      behind.pose = before.pose * displaced(joint.type, to_axis, *held);
      mechanism_.notes.push_back(
          {"lump", link,
           fmt::format("joint {} held at {}", joint.name, static_cast<double>(*held))});
    } else if (joint.type == JointType::floating) {
      behind = add_floating(link, joint.name, before);
    } else if (joint.type == JointType::planar) {
      behind = add_planar(joint, link, before, to_axis);
    } else if (joint.type == JointType::prismatic) {
      behind = add_axis(joint, link, JointKind::prismatic, before, to_axis);
    } else if (joint.type != JointType::fixed) {
      behind = add_axis(joint, link, JointKind::revolute, before, to_axis);
    }
    visit_link(joint.child, behind);
  }

  static ExactPose displaced(JointType type, const ExactMatrix3& to_axis, const Exact& value) {
    ExactPose pose;
    if (type == JointType::prismatic) {
      pose.p = to_axis.col(2) * value;
    } else {
      pose.R = to_axis * rotation_z_by(value) * to_axis.transpose();
    }
    return pose;
  }

  /// A link whose z is the joint's axis; returns where the child's URDF frame is on it.
  Place add_axis(const Joint& joint, const std::string& link, JointKind kind, const Place& before,
                 const ExactMatrix3& to_axis) {
    const bool angle = kind == JointKind::revolute;
    if (!joint.mimic) {
      first_coordinate_[index_of(joint)] = {mechanism_.nq(), mechanism_.nv()};
      const Limits limits = joint.limits.value_or(unlimited());
      mechanism_.coordinates.push_back(
          {joint.name, angle ? "angle, rad" : "displacement, m", limits.lower, limits.upper});
      mechanism_.velocities.push_back(joint.name + (angle ? ", rad/s" : ", m/s"));
    }
    MovingLink moving = new_link(link, joint.name, before);
    moving.kind = kind;
    moving.seat = snapped(before.pose * ExactPose{to_axis, ExactVector3::Zero()});
    moving.q_index = mechanism_.nq() - 1;
    moving.v_index = mechanism_.nv() - 1;
    moving.mimics = joint.mimic.has_value();
    mechanism_.links.push_back(moving);
    if (joint.mimic) {
      mimics_.push_back({last_link(), &joint});
    }
    return {last_link(), {to_axis.transpose(), ExactVector3::Zero()}};
  }

  /// Prismatic x, prismatic y, revolute z, with massless links between: q = x, y, theta.
  Place add_planar(const Joint& joint, const std::string& link, const Place& before,
                   const ExactMatrix3& to_axis) {
    first_coordinate_[index_of(joint)] = {mechanism_.nq(), mechanism_.nv()};
    const ExactPose plane = before.pose * ExactPose{to_axis, ExactVector3::Zero()};
    const std::array<ExactMatrix3, 3> axes{z_to_x(), z_to_y(), ExactMatrix3::Identity()};
    const std::array<const char*, 3> names{"x", "y", "theta"};
    Place place{before.link, plane};
    for (std::size_t i = 0; i < 3; ++i) {
      const bool angle = i == 2;
      MovingLink moving = new_link(angle ? link : link + "_" + names[i], joint.name, place);
      moving.kind = angle ? JointKind::revolute : JointKind::prismatic;
      moving.seat = snapped(place.pose * ExactPose{axes[i], ExactVector3::Zero()});
      moving.q_index = mechanism_.nq();
      moving.v_index = mechanism_.nv();
      mechanism_.coordinates.push_back(
          {joint.name, std::string(names[i]) + (angle ? ", rad" : ", m")});
      mechanism_.velocities.push_back(joint.name + " " + names[i] + (angle ? ", rad/s" : ", m/s"));
      mechanism_.links.push_back(moving);
      place = {last_link(), {axes[i].transpose(), ExactVector3::Zero()}};
    }
    place.pose.R = place.pose.R * to_axis.transpose();
    return place;
  }

  Place add_floating(const std::string& link, const std::string& joint, const Place& before) {
    MovingLink moving = new_link(link, joint, before);
    moving.kind = JointKind::floating;
    moving.seat = snapped(before.pose);
    moving.q_index = mechanism_.nq();
    moving.v_index = mechanism_.nv();
    for (const char* part : {"position x, m", "position y, m", "position z, m", "quaternion x",
                             "quaternion y", "quaternion z", "quaternion w"}) {
      mechanism_.coordinates.push_back({joint, part});
    }
    for (const char* part : {"linear x, m/s", "linear y, m/s", "linear z, m/s", "angular x, rad/s",
                             "angular y, rad/s", "angular z, rad/s"}) {
      mechanism_.velocities.push_back(joint + " " + part);
    }
    mechanism_.links.push_back(moving);
    return {last_link(), {}};
  }

  static MovingLink new_link(const std::string& link, const std::string& joint,
                             const Place& before) {
    MovingLink moving;
    moving.name = link;
    moving.joint = joint;
    moving.parent = before.link;
    return moving;
  }

  /// A mimic may stand before the joint it follows, so coordinates are shared at the end. Chains
  /// multiply: q = k1 (k2 q0 + o2) + o1.
  void share_mimicked_coordinates() {
    for (const auto& [index, follower] : mimics_) {
      MovingLink& link = mechanism_.links[static_cast<std::size_t>(index)];
      Exact multiplier = 1;
      const Joint* joint = follower;
      for (; joint->mimic; joint = &mimicked(*joint)) {
        link.offset += multiplier * Exact(joint->mimic->offset);
        multiplier *= Exact(joint->mimic->multiplier);
      }
      const FirstCoordinate shared = first_coordinate_[index_of(*joint)];
      link.multiplier = static_cast<double>(multiplier);
      link.q_index = shared.q;
      link.v_index = shared.v;
    }
  }

  /// Where the scene holds a joint, itself or by the joint that it mimics.
  [[nodiscard]] std::optional<Exact> held_value(const Joint& joint) const {
    const auto locked = scene_.locked.find(joint.name);
    if (locked != scene_.locked.end()) {
      return Exact(locked->second);
    }
    if (!joint.mimic) {
      return std::nullopt;
    }
    const std::optional<Exact> followed = held_value(mimicked(joint));
    return followed ? std::optional<Exact>(Exact(joint.mimic->multiplier) * *followed +
                                           Exact(joint.mimic->offset))
                    : std::nullopt;
  }

  [[nodiscard]] const Joint& mimicked(const Joint& joint) const {
    return robot_.joints[static_cast<std::size_t>(joint.mimic->joint)];
  }

  [[nodiscard]] std::vector<MechanismPoint> points(const std::vector<ScenePoint>& wanted) const {
    std::vector<MechanismPoint> result;
    for (const ScenePoint& point : wanted) {
      for (std::size_t i = 0; i < robot_.links.size(); ++i) {
        if (robot_.links[i].name == point.link) {
          const ExactPose pose = places_[i].pose * exact_pose(point.origin);
          result.push_back(
              {point.name, places_[i].link, snapped(pose), point.axes, point.rows, point.priority});
        }
      }
    }
    return result;
  }

  /// Moving links with the name of their URDF link; those inside a planar joint have another.
  [[nodiscard]] std::vector<MechanismPoint> link_frames() const {
    std::vector<MechanismPoint> frames;
    for (std::size_t i = 0; i < mechanism_.links.size(); ++i) {
      for (std::size_t k = 0; k < robot_.links.size(); ++k) {
        const bool own = places_[k].link == static_cast<int>(i);
        if (own && robot_.links[k].name == mechanism_.links[i].name) {
          frames.push_back({robot_.links[k].name,
                            places_[k].link,
                            snapped(places_[k].pose),
                            Axes::local,
                            {true, true, true, true, true, true}});
        }
      }
    }
    return frames;
  }

  [[nodiscard]] std::vector<MechanismObject> objects() const {
    std::vector<MechanismObject> result;
    for (const SceneObject& object : scene_.objects) {
      result.push_back({object.name, snapped(exact_inertia(object.inertial)), {}});
      for (const SceneGrasp& grasp : object.grasps) {
        std::size_t point = 0;
        while (scene_.operational_points[point].name != grasp.point) {
          ++point;
        }
        result.back().grasps.push_back({point, snapped(exact_pose(grasp.origin))});
      }
    }
    return result;
  }

  static Limits unlimited() {
    const double infinity = std::numeric_limits<double>::infinity();
    return {-infinity, infinity, infinity, infinity};
  }
  [[nodiscard]] std::size_t index_of(const Joint& joint) const {
    return static_cast<std::size_t>(&joint - robot_.joints.data());
  }
  [[nodiscard]] int last_link() const { return static_cast<int>(mechanism_.links.size()) - 1; }

  const Robot robot_;
  const Scene& scene_;
  Mechanism mechanism_;
  std::vector<std::vector<int>> children_;
  std::vector<FirstCoordinate> first_coordinate_;
  std::vector<std::pair<int, const Joint*>> mimics_;
  std::vector<Place> places_;
};

}  // namespace

Mechanism build_mechanism(const Robot& robot, const Scene& scene) {
  return Builder(robot, scene).build();
}

Mechanism reduced_mechanism(const Robot& robot, const Scene& scene, Inertias inertias) {
  Mechanism mechanism = build_mechanism(robot, scene);
  const bool regroup = inertias == Inertias::regrouped;
  if (regroup) regroup_inertias(mechanism);
  seat_frames(mechanism);
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
