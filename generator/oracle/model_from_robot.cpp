#include "oracle/model_from_robot.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "description/noise.hpp"
#include "description/robot_queries.hpp"
#include "description/rotation.hpp"
#include "interpreter/digits50.hpp"
#include "interpreter/joint_parts.hpp"

namespace treeline {
namespace {

/// Adds the links of a robot to a model, one after another, depth-first.
template <class Scalar>
class ModelBuilder {
 public:
  ModelBuilder(const Robot& robot, const Scene& scene)
      : robot_(as_asked(robot, scene)), scene_(scene) {
    using Vector3 = interpreter::Vector3<Scalar>;
    model_.gravity =
        Vector3(Scalar(scene.gravity[0]), Scalar(scene.gravity[1]), Scalar(scene.gravity[2]));
    interpreter::Body<Scalar> root;
    root.kind = scene.base == Base::floating ? interpreter::JointKind::floating
                                             : interpreter::JointKind::fixed;
    add_links(root);
    resolve_mimics();
  }

  [[nodiscard]] const interpreter::Model<Scalar>& model() const { return model_; }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  static interpreter::Vector3<Scalar> position(const Pose& pose) {
    return {Scalar(pose.xyz[0]), Scalar(pose.xyz[1]), Scalar(pose.xyz[2])};
  }

  static interpreter::JointKind kind(JointType type) {
    switch (type) {
      case JointType::revolute:
      case JointType::continuous:
        return interpreter::JointKind::revolute;
      case JointType::prismatic:
        return interpreter::JointKind::prismatic;
      case JointType::planar:
        return interpreter::JointKind::planar;
      case JointType::floating:
        return interpreter::JointKind::floating;
      case JointType::ball:
        return interpreter::JointKind::spherical;
      case JointType::fixed:
        break;
    }
    return interpreter::JointKind::fixed;
  }

  /// Sets the inertia about the link frame's origin, from the one about the centre of mass.
  static void set_inertia(const Inertial& inertial, interpreter::Body<Scalar>& body) {
    const auto R = rotation_from_rpy<Scalar>(inertial.origin.rpy);
    interpreter::Matrix3<Scalar> J;
    J << Scalar(inertial.ixx), Scalar(inertial.ixy), Scalar(inertial.ixz),  //
        Scalar(inertial.ixy), Scalar(inertial.iyy), Scalar(inertial.iyz),   //
        Scalar(inertial.ixz), Scalar(inertial.iyz), Scalar(inertial.izz);
    body.mass = Scalar(inertial.mass);
    body.com = position(inertial.origin);
    const auto C = interpreter::cross_matrix(body.com);
    body.inertia = R * J * R.transpose() - body.mass * (C * C);
  }

  void add_links(const interpreter::Body<Scalar>& root) {
    std::vector<int> body_of_link(robot_.links.size());
    body_of_link[index(robot_.root)] = place_link(robot_.root, root);
    for (const int j : joints_depth_first(robot_)) {
      const Joint& joint = robot_.joints[index(j)];
      body_of_link[index(joint.child)] =
          place_link(joint.child, body_behind(j, body_of_link[index(joint.parent)]));
    }
  }

  int place_link(int link, interpreter::Body<Scalar> body) {
    const Link& file_link = robot_.links[index(link)];
    body.name = file_link.name;
    if (file_link.inertial) set_inertia(*file_link.inertial, body);
    return body.mimics ? add_mimic(body) : interpreter::add_body(model_, body);
  }

  int add_mimic(const interpreter::Body<Scalar>& body) {
    model_.bodies.push_back(body);
    return model_.size() - 1;
  }

  interpreter::Body<Scalar> body_behind(int j, int parent) {
    const Joint& joint = robot_.joints[index(j)];
    interpreter::Body<Scalar> body;
    body.parent = parent;
    body.kind = kind(joint.type);
    body.R_parent_joint = rotation_from_rpy<Scalar>(joint.origin.rpy);
    body.p_parent_joint = position(joint.origin);
    if (info_of(joint.type).has_axis) {
      body.axis = unit_axis<Scalar>(joint.axis);
    }
    if (const auto own = scene_.armature.find(joint.name); own != scene_.armature.end()) {
      body.armature = Scalar(own->second);
    }
    add_friction_and_spring(joint.name, body);
    follow_mimics(j, body);
    body_of_joint_[j] = model_.size();
    return body;
  }

  void add_friction_and_spring(const std::string& joint, interpreter::Body<Scalar>& body) const {
    if (const auto own = scene_.joint_friction.find(joint); own != scene_.joint_friction.end()) {
      body.damping = Scalar(own->second.damping);
      body.friction = Scalar(own->second.friction);
      if (own->second.friction > 0) body.slip_speed = Scalar(own->second.width);
    }
    if (const auto own = scene_.joint_springs.find(joint); own != scene_.joint_springs.end()) {
      body.stiffness = Scalar(own->second.stiffness);
      body.rest = Scalar(own->second.rest);
    }
  }

  /// Composes the chain of mimic tags from joint `j` to the joint at its end, which is no mimic or
  /// is locked.
  void follow_mimics(int j, interpreter::Body<Scalar>& body) {
    int leader = j;
    while (!scene_.locked.contains(robot_.joints[index(leader)].name) &&
           robot_.joints[index(leader)].mimic) {
      const Mimic& mimic = *robot_.joints[index(leader)].mimic;
      body.offset += body.multiplier * Scalar(mimic.offset);
      body.multiplier *= Scalar(mimic.multiplier);
      leader = mimic.joint;
    }
    const auto locked = scene_.locked.find(robot_.joints[index(leader)].name);
    if (locked != scene_.locked.end()) {
      lock(body, body.multiplier * Scalar(locked->second) + body.offset);
    } else if (leader != j) {
      body.mimics = true;
      leader_of_body_[model_.size()] = leader;
    }
  }

  /// Fixes a joint of one degree of freedom at a displacement.
  static void lock(interpreter::Body<Scalar>& body, const Scalar& at) {
    if (body.kind == interpreter::JointKind::prismatic) {
      body.p_parent_joint += body.R_parent_joint * (body.axis * at);
    } else {
      body.R_parent_joint = (body.R_parent_joint * turn(body.axis, at)).eval();
    }
    body.kind = interpreter::JointKind::fixed;
    body.multiplier = Scalar(1);
    body.offset = Scalar(0);
  }

  /// Rotation by `angle` about the axis `n`, by Rodrigues' formula. A quarter turn that a file
  /// gives as a double is exact.
  static interpreter::Matrix3<Scalar> turn(const interpreter::Vector3<Scalar>& n,
                                           const Scalar& angle) {
    const double as_double = static_cast<double>(angle);
    using std::cos;
    using std::sin;
    SinCos<Scalar> sc{Scalar(sin(angle)), Scalar(cos(angle))};
    if (Scalar(as_double) == angle) sc = sin_cos_of_file_angle<Scalar>(as_double);
    const auto N = interpreter::cross_matrix(n);
    return interpreter::Matrix3<Scalar>::Identity() + sc.sin * N + (Scalar(1) - sc.cos) * (N * N);
  }

  void resolve_mimics() {
    for (const auto& [body, leader] : leader_of_body_) {
      const auto& own = model_.bodies[index(body_of_joint_.at(leader))];
      model_.bodies[index(body)].q = own.q;
      model_.bodies[index(body)].v = own.v;
    }
  }

  const Robot robot_;
  const Scene& scene_;
  interpreter::Model<Scalar> model_;
  std::map<int, int> body_of_joint_;
  std::map<int, int> leader_of_body_;
};

}  // namespace

template <class Scalar>
interpreter::Model<Scalar> model_from_robot(const Robot& robot, const Scene& scene) {
  return ModelBuilder<Scalar>(robot, scene).model();
}

template <class Scalar>
std::vector<int> passive_velocities(const interpreter::Model<Scalar>& model, const Robot& robot,
                                    const Scene& scene) {
  std::set<std::string> links;
  for (const Joint& joint : robot.joints) {
    const auto& names = scene.passive;
    if (std::find(names.begin(), names.end(), joint.name) == names.end()) continue;
    links.insert(robot.links[static_cast<std::size_t>(joint.child)].name);
  }
  std::set<int> velocities;
  for (const auto& body : model.bodies) {
    const bool floats = body.kind == interpreter::JointKind::floating;
    if (!floats && !links.contains(body.name)) continue;
    for (int i = 0; i < interpreter::velocity_count(body.kind); ++i) velocities.insert(body.v + i);
  }
  return {velocities.begin(), velocities.end()};
}

template <class Scalar>
interpreter::Points<Scalar> points_from_scene(const interpreter::Model<Scalar>& model,
                                              const std::vector<ScenePoint>& scene_points) {
  interpreter::Points<Scalar> points;
  for (const ScenePoint& from : scene_points) {
    interpreter::OperationalPoint<Scalar> point;
    point.name = from.name;
    for (int i = 0; i < model.size(); ++i) {
      if (model.body(i).name == from.link) point.body = i;
    }
    point.R = rotation_from_rpy<Scalar>(from.origin.rpy);
    const auto& xyz = from.origin.xyz;
    point.p << Scalar(xyz[0]), Scalar(xyz[1]), Scalar(xyz[2]);
    point.axes =
        from.axes == Axes::world ? interpreter::PointAxes::world : interpreter::PointAxes::local;
    point.rows = from.rows;
    point.priority = from.priority;
    point.center_of_mass = from.center_of_mass;
    points.push_back(point);
  }
  return points;
}

template <class Scalar>
int find_body(const interpreter::Model<Scalar>& model, const std::string& link) {
  int body = 0;
  while (model.body(body).name != link) ++body;
  return body;
}

template <class Scalar>
interpreter::Loops<Scalar> loops_from_scene(const interpreter::Model<Scalar>& model,
                                            const Robot& robot, const Scene& scene) {
  interpreter::Loops<Scalar> loops;
  for (const SceneLoop& loop : scene.loops) {
    auto both = points_from_scene(model, {loop.first, loop.second});
    if (loop.second.link == kWorldEnd) both[1].body = interpreter::kWorld;
    loops.frames.push_back({both[0], both[1]});
    if (!loop.rolling) continue;
    auto& rolling = loops.frames.back().rolling.emplace();
    rolling.radius = Scalar(loop.rolling->radius);
    if (loop.rolling->axis) rolling.axis = unit_axis<Scalar>(*loop.rolling->axis);
    if (loop.rolling->on_radius) rolling.on_radius = Scalar(*loop.rolling->on_radius);
  }
  for (const SceneCoupling& from : scene.couplings) {
    interpreter::Coupling<Scalar> coupling{{}, Scalar(from.offset)};
    for (const auto& [name, factor] : from.parts) {
      const auto child = static_cast<std::size_t>(find_joint(robot, name)->child);
      const auto& body = model.body(find_body(model, robot.links[child].name));
      coupling.parts.push_back({body.q, body.v, Scalar(factor)});
    }
    loops.couplings.push_back(std::move(coupling));
  }
  return loops;
}

#define TREELINE_MODEL_INSTANCES(T)                                                              \
  template interpreter::Model<T> model_from_robot<T>(const Robot&, const Scene&);                \
  template std::vector<int> passive_velocities<T>(const interpreter::Model<T>&, const Robot&,    \
                                                  const Scene&);                                 \
  template interpreter::Points<T> points_from_scene<T>(const interpreter::Model<T>&,             \
                                                       const std::vector<ScenePoint>&);          \
  template int find_body<T>(const interpreter::Model<T>&, const std::string&);                   \
  template interpreter::Loops<T> loops_from_scene<T>(const interpreter::Model<T>&, const Robot&, \
                                                     const Scene&)

TREELINE_MODEL_INSTANCES(float);
TREELINE_MODEL_INSTANCES(double);
TREELINE_MODEL_INSTANCES(Digits50);
#undef TREELINE_MODEL_INSTANCES

template <class Scalar>
interpreter::ClosedChain<Scalar> chain_from_scene(const Robot& robot, const Scene& scene) {
  interpreter::ClosedChain<Scalar> chain;
  chain.robots.push_back(model_from_robot<Scalar>(robot, scene));
  const auto points = points_from_scene(chain.robots.front(), scene.operational_points);
  const auto vector = [](const std::array<double, 3>& xyz) {
    return interpreter::Vector3<Scalar>(Scalar(xyz[0]), Scalar(xyz[1]), Scalar(xyz[2]));
  };
  for (const SceneObject& from : scene.objects) {
    const Inertial& body = from.inertial;
    interpreter::GraspedObject<Scalar> object;
    object.name = from.name;
    object.mass = Scalar(body.mass);
    object.com = vector(body.origin.xyz);
    object.inertia << Scalar(body.ixx), Scalar(body.ixy), Scalar(body.ixz),  //
        Scalar(body.ixy), Scalar(body.iyy), Scalar(body.iyz),                //
        Scalar(body.ixz), Scalar(body.iyz), Scalar(body.izz);
    for (const SceneGrasp& grasp : from.grasps) {
      for (const auto& point : points) {
        if (point.name == grasp.point) {
          object.grasps.push_back(
              {0, point, rotation_from_rpy<Scalar>(grasp.origin.rpy), vector(grasp.origin.xyz)});
        }
      }
    }
    chain.objects.push_back(std::move(object));
  }
  return chain;
}

template interpreter::ClosedChain<double> chain_from_scene(const Robot&, const Scene&);
template interpreter::ClosedChain<Digits50> chain_from_scene(const Robot&, const Scene&);

}  // namespace treeline
